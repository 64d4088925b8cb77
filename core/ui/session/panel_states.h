// SPDX-License-Identifier: MIT
#pragma once
// What a panel or a dialog remembers from one frame to the next, such as a text that is being
// typed. Each has a type of its own in its own file; nothing else of the studio knows it.

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace versorium {

class PanelStates {
  public:
    // The one state of this type; made by its defaults when it is first asked for.
    template <class State>
    State& of() {
        const void* key = &kKey<State>;
        for (const auto& [known, state] : all_)
            if (known == key) return *static_cast<State*>(state.get());
        auto made = std::make_shared<State>();
        all_.emplace_back(key, made);
        return *made;
    }

  private:
    template <class State>
    static inline char kKey = 0;  // its address tells the types apart
    std::vector<std::pair<const void*, std::shared_ptr<void>>> all_;
};

}  // namespace versorium
