// SPDX-License-Identifier: MIT
#include "lesson/teacher_link.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "lesson/lesson.h"

namespace versorium {
namespace {

constexpr std::size_t kMostBytes = 4 * kLinkBytes;
constexpr std::size_t kMostNames = 1000;
constexpr std::array<const char*, 3> kAccessWords = {"open", "locked", "hidden"};

bool isPlain(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) || c == '-' || c == '_' || c == '.' || c == '~' || c == ':';
}

std::string encoded(const std::string& text) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (isPlain(c))
            result += c;
        else
            result += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
    return result;
}

int digitOf(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const int lower = std::tolower(static_cast<unsigned char>(c));
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::string decoded(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool coded = text[i] == '%' && i + 2 < text.size() && digitOf(text[i + 1]) >= 0 &&
                           digitOf(text[i + 2]) >= 0;
        result +=
            coded ? static_cast<char>(16 * digitOf(text[i + 1]) + digitOf(text[i + 2])) : text[i];
        if (coded) i += 2;
    }
    return result;
}

std::vector<std::string> parted(const std::string& text, char by) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(by, begin), text.size());
        if (end > begin) parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

Status takeRest(const std::string& value, TeacherLink& link) {
    link.byStep = value == "step";
    if (link.byStep) {
        link.rest = Access::hidden;
        return {};
    }
    const auto word = std::find(kAccessWords.begin(), kAccessWords.end(), value);
    if (word == kAccessWords.end())
        return Status::data("rest: must be open, locked, hidden or step, not \"" + value + "\"");
    link.rest = static_cast<Access>(word - kAccessWords.begin());
    return {};
}

Status takeStep(const std::string& value, TeacherLink& link) {
    if (value.empty() || value.size() > 3 ||
        !std::all_of(value.begin(), value.end(),
                     [](char c) { return std::isdigit(static_cast<unsigned char>(c)); }) ||
        std::stoi(value) < 1)
        return Status::data("step: must be a number from 1, not \"" + value + "\"");
    link.step = std::stoi(value) - 1;
    return {};
}

Status take(const std::string& key, const std::string& value, TeacherLink& link) {
    if (key == "lesson") {
        link.lesson = decoded(value);
        const std::vector<std::string> ids = lessonIds();
        if (std::find(ids.begin(), ids.end(), link.lesson) == ids.end())
            return Status::data("there is no lesson named \"" + link.lesson + "\" here");
        return {};
    }
    if (key == "step") return takeStep(value, link);
    if (key == "language") return link.language = decoded(value), Status();
    if (key == "theme") return link.theme = decoded(value), Status();
    if (key == "rest") return takeRest(value, link);
    if (key == "view") {
        Expected<Workspace> view = workspaceFromLink(decoded(value));
        if (!view) return view.status();
        link.view = std::move(*view);
        return {};
    }
    const auto word = std::find(kAccessWords.begin(), kAccessWords.end(), key);
    if (word == kAccessWords.end())
        return Status::data("\"" + key +
                            "\" is none of lesson, step, language, theme, rest, open, locked, "
                            "hidden and view");
    for (const std::string& name : parted(value, ',')) {
        if (link.named.size() == kMostNames) return Status::data("too many controls are named");
        link.named[decoded(name)] = static_cast<Access>(word - kAccessWords.begin());
    }
    return {};
}

}  // namespace

bool TeacherLink::restricts() const {
    return rest != Access::open || std::any_of(named.begin(), named.end(), [](const auto& entry) {
               return entry.second != Access::open;
           });
}

bool isTeacherLink(const std::string& fragment) {
    const std::string key = fragment.substr(0, fragment.find_first_of("=&:"));
    for (const char* known :
         {"lesson", "view", "step", "language", "theme", "rest", "open", "locked", "hidden"})
        if (key == known && fragment.size() > key.size() && fragment[key.size()] == '=')
            return true;
    return false;
}

Expected<std::string> teacherLinkText(const TeacherLink& link) {
    std::string text;
    const auto add = [&](const std::string& key, const std::string& value) {
        if (!value.empty()) text += (text.empty() ? "" : "&") + key + "=" + value;
    };
    add("lesson", encoded(link.lesson));
    if (!link.lesson.empty() && link.step) add("step", std::to_string(*link.step + 1));
    add("language", encoded(link.language));
    add("theme", encoded(link.theme));
    if (link.byStep)
        add("rest", "step");
    else if (link.rest != Access::open)
        add("rest", kAccessWords[static_cast<std::size_t>(link.rest)]);
    for (std::size_t k = 0; k < kAccessWords.size(); ++k) {
        std::string names;
        for (const auto& [name, access] : link.named)
            if (access == static_cast<Access>(k))
                names += (names.empty() ? "" : ",") + encoded(name);
        add(kAccessWords[k], names);
    }
    if (link.view) {
        Expected<std::string> view = workspaceToLink(*link.view);
        if (!view) return view;
        add("view", *view);
    }
    return text;
}

std::string lessonLink(const std::string& lesson, std::size_t step) {
    return "lesson=" + encoded(lesson) + "&step=" + std::to_string(step + 1);
}

Expected<TeacherLink> parseTeacherLink(const std::string& fragment) {
    if (fragment.size() > kMostBytes) return Status::data("the link is too long");
    TeacherLink link;
    for (const std::string& part : parted(fragment, '&')) {
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos)
            return Status::data("the link is damaged at \"" + part.substr(0, 40) + "\"");
        Status status = take(part.substr(0, equals), part.substr(equals + 1), link);
        if (!status.ok()) return status;
    }
    if (link.lesson.empty() && link.byStep)
        return Status::data("rest=step needs a lesson, whose steps name their controls");
    return link;
}

std::string iframeOf(const std::string& address, const std::string& title) {
    const auto escaped = [](const std::string& text) {
        std::string result;
        for (const char c : text)
            result += c == '&'   ? std::string("&amp;")
                      : c == '"' ? std::string("&quot;")
                      : c == '<' ? std::string("&lt;")
                                 : std::string(1, c);
        return result;
    };
    return "<iframe src=\"" + escaped(address) + "\" title=\"" + escaped(title) +
           "\" width=\"100%\" height=\"640\" style=\"border:0\" loading=\"lazy\" "
           "allow=\"fullscreen; clipboard-write\"></iframe>";
}

}  // namespace versorium
