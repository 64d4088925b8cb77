// SPDX-License-Identifier: MIT
#pragma once
// A link by which a teacher hands out a lesson or a view, with what the learner may change. It can
// be read: the part behind the '#' is
//
//   lesson=1-orbits&step=2&language=es&theme=projector&rest=hidden&open=r,point&view=v1:…
//
//   lesson, step     one of the program's lessons, and the step that it begins with, from 1;
//                    without it the lesson goes on where the learner left it
//   view             a view in place of a lesson, as in a link of the studio
//   language, theme  of the studio, for this visit
//   rest             what becomes of controls that are not named: open, locked (seen, but they
//                    cannot be changed) or hidden; or step: those of the lesson's step are open,
//                    all others hidden
//   open, locked, hidden   ids of controls (ui/controls/controls.h), with commas between them

#include <map>
#include <optional>
#include <string>

#include "workspace/workspace.h"

namespace versorium {

enum class Access { open, locked, hidden };

struct TeacherLink {
    std::string lesson;
    std::optional<int> step;  // from 0
    std::string language, theme;
    Access rest = Access::open;
    bool byStep = false;
    std::map<std::string, Access> named;
    std::optional<Workspace> view;

    // Whether anything is kept from the learner.
    bool restricts() const;
    // Whether it says more than which step of which lesson is shown: then it stays the address.
    bool stays() const { return restricts() || view || !language.empty() || !theme.empty(); }
};

// Whether a fragment is such a link, rather than one of the studio.
bool isTeacherLink(const std::string& fragment);
// ErrorKind::usage where the view is too large for a link.
Expected<std::string> teacherLinkText(const TeacherLink& link);
// A step of a lesson, from 0, with nothing locked.
std::string lessonLink(const std::string& lesson, std::size_t step);
// ErrorKind::data names what it cannot read.
Expected<TeacherLink> parseTeacherLink(const std::string& fragment);
// A page's element that shows the studio at this address, for a web page or a learning platform.
std::string iframeOf(const std::string& address, const std::string& title);

}  // namespace versorium
