// SPDX-License-Identifier: MIT
#pragma once
// What the scenes of the open workspace are bound to (render/bind.h): the program of each view and
// of the orbit, and the distance grids that take time to make, which workers do.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fields/evaluate.h"
#include "render/bind.h"
#include "ui/session/open_workspace.h"

namespace versorium {

class BoundPrograms {
  public:
    BoundPrograms(const OpenWorkspace& open, Host& host) : open_(open), host_(host) {}

    // Null while a shape needs a grid that takes time to make.
    const OrbitProgram* program(int view);
    const OrbitProgram* orbitProgram();
    // z_0 … z_orbitSteps of the workspace's point; empty where there is no program.
    const std::vector<std::vector<double>>& orbit();
    Binder& binder() { return binder_; }

    // True where a grid has come that was asked for: what was bound is old then.
    bool takeGrid(const WorkAnswer& answer);

  private:
    struct Bound {
        std::uint64_t revision = 0;
        std::optional<OrbitProgram> program;
    };
    const OrbitProgram* bind(Bound& bound, const Scene& scene);
    void askForGrid(Scene scene);

    const OpenWorkspace& open_;
    Host& host_;
    Binder binder_;
    std::uint64_t gridAsked_ = 0;  // the request that is under way
    std::optional<Scene> gridFor_;
    std::string gridRefused_;  // the shape of which no grid can be made
    std::array<Bound, kMostViews + 1> bound_;
    std::uint64_t orbitRevision_ = 0;
    std::vector<std::vector<double>> orbit_;
};

}  // namespace versorium
