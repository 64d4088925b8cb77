// SPDX-License-Identifier: MIT
#pragma once
// The texts of a plate with the facts of its panels put in.

#include <map>
#include <string>
#include <vector>

#include "base/status.h"

namespace versorium {

using Facts = std::map<std::string, std::string>;

struct PanelFacts {
    std::string panel;  // its name
    Facts facts;
};

// Replaces {name} and {panel.name}. Braces that belong to the markup (after _ ^ \hat \bold) stay.
// Fails with ErrorKind::usage on a name that is no fact, with the list of those that are.
Expected<std::string> substituteFacts(const std::string& text,
                                      const std::vector<PanelFacts>& panels);

}  // namespace versorium
