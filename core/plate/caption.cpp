// SPDX-License-Identifier: MIT
#include "plate/caption.h"

#include <set>

namespace versorium {
namespace {

bool nameLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == '-';
}

// The length of the name in braces that begins at `at`, or 0 when these braces are markup.
std::size_t factLength(const std::string& text, std::size_t at) {
    const std::string before = text.substr(0, at);
    for (const char* command : {"_", "^", "\\hat", "\\bold", "\\"})
        if (before.ends_with(command)) return 0;
    std::size_t end = at + 1;
    while (end < text.size() && nameLetter(text[end])) ++end;
    const bool letter = at + 1 < end && text[at + 1] >= 'A';
    return letter && end < text.size() && text[end] == '}' ? end - at - 1 : 0;
}

const std::string* find(const std::string& name, const std::vector<PanelFacts>& panels) {
    const std::size_t dot = name.find('.');
    for (const PanelFacts& panel : panels) {
        if (const auto fact = panel.facts.find(name); fact != panel.facts.end())
            return &fact->second;
        if (dot == std::string::npos || panel.panel != name.substr(0, dot)) continue;
        if (const auto fact = panel.facts.find(name.substr(dot + 1)); fact != panel.facts.end())
            return &fact->second;
    }
    return nullptr;
}

}  // namespace

Expected<std::string> substituteFacts(const std::string& text,
                                      const std::vector<PanelFacts>& panels) {
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t length = text[at] == '{' ? factLength(text, at) : 0;
        if (length == 0) {
            out += text[at];
            continue;
        }
        const std::string name = text.substr(at + 1, length);
        const std::string* value = find(name, panels);
        if (!value) {
            std::set<std::string> known;
            for (const PanelFacts& panel : panels)
                for (const auto& fact : panel.facts) known.insert(fact.first);
            std::string all;
            for (const std::string& fact : known) all += (all.empty() ? "" : ", ") + fact;
            return Status::usage("{" + name +
                                 "} in a text of the plate is no fact of its panels; " +
                                 (all.empty() ? "they have none" : "there are: " + all));
        }
        out += *value;
        at += length + 1;
    }
    return out;
}

}  // namespace versorium
