// SPDX-License-Identifier: MIT
#pragma once
// A sheet of candidates for the versor d, to pick one from (S section 3.3.2; Fig 12: one r̂, several
// d): small pictures of the focused view with the roots of one seed each. The host makes them one
// by one, where it makes the gallery's.

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "ui/host/host.h"

namespace versorium {

struct StudioContext;

struct ContactSheet {
    static constexpr int kLeast = 3, kMost = 12;

    struct Candidate {
        int seed = 1;
        RootList roots;
        Size size{0, 0};
        std::vector<unsigned char> rgba;
        unsigned texture = 0;
        std::string message;  // why there is no picture
    };

    int count = 6;
    int at = 0;  // the candidate that keys and pointer have come to
    std::vector<Candidate> candidates;
    int asked = -1;  // whose picture is being made
    std::uint64_t id = kFirstId;

    void contextLost();
    void forget();  // the candidates, with their textures

  private:
    // Apart from the gallery's, which come by the same way.
    static constexpr std::uint64_t kFirstId = std::uint64_t{1} << 40;
};

// Candidates from this seed on; opens the sheet. Says why where there can be none.
void openContactSheet(StudioContext& context, int seed);
// True where the answer was the sheet's.
bool takeCandidate(StudioContext& context, WorkAnswer& answer);
// The candidate's roots become those of the map, and its seed the panel's.
void pickCandidate(StudioContext& context, int candidate);
// Has the next small picture made.
void askForCandidate(StudioContext& context);

}  // namespace versorium
