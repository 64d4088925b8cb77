// SPDX-License-Identifier: MIT
#include "ui/studio.h"

#include "imgui.h"

namespace versorium {

struct Studio::State {
    Host& host;
};

Studio::Studio(Host& host) : state_(new State{host}) {}
Studio::~Studio() = default;
void Studio::prepare(float) {}
void Studio::frame() { ImGui::Text("Versorium"); }
bool Studio::busy() const { return false; }
Status Studio::openPreset(const std::string&) { return {}; }
Status Studio::openBytes(const std::string&, std::span<const unsigned char>) { return {}; }
Status Studio::openFragment(const std::string&) { return {}; }
std::string Studio::fragment() const { return {}; }
void Studio::contextLost() {}

}  // namespace versorium
