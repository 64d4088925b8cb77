// SPDX-License-Identifier: MIT
#pragma once
// The studio: everything between an ImGui frame and the core. The shell makes the ImGui context and
// its back ends, calls prepare() once, then frame() between ImGui::NewFrame and ImGui::Render.

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/status.h"
#include "ui/host/host.h"

namespace versorium {

class Studio {
  public:
    explicit Studio(Host& host);
    ~Studio();

    // Loads letters for a display of this scale (1: 96 dots per inch) and sets the theme. Call it
    // before the first frame and whenever the scale changes; the ImGui back end must then take the
    // atlas anew.
    void prepare(float scale);

    // One frame. All drawing goes into ImGui's lists; textures are those of ui/backend/texture.h.
    void frame();
    // The theme has changed: prepare() is due before the next frame.
    bool wantsPrepare() const;
    // Nothing moves, and every picture is as fine as it gets.
    bool finished() const;
    // How many pictures the views have shown so far, coarse ones too.
    int pictures() const;
    // True while something moves or is being waited for: the shell should draw on without events.
    bool busy() const;

    // A preset's name, or what a file holds (ui/session/open_file.h). On failure everything stays
    // as it was.
    Status openPreset(const std::string& name);
    Status openFormula(const std::string& text);
    Status openBytes(const std::string& name, std::span<const unsigned char> bytes);
    // The part of a link behind the '#', checked like any foreign input: a view, or what a teacher
    // hands out (lesson/teacher_link.h).
    Status openFragment(const std::string& fragment);
    // One of the program's lessons, at a step from 0, or where the learner left it.
    Status openLesson(const std::string& id, std::optional<std::size_t> step);
    std::string fragment() const;

    // What can be set and done, for controls outside of the window: ui/controls/controls.h.
    std::string controls() const;
    bool setControl(const std::string& id, const std::string& value);
    void focusView(int view);
    // The lesson's pane, for a host that draws it: ui/session/lessons.h.
    std::string lesson() const;
    bool lessonDo(const std::string& action, const std::string& value);
    std::string lessonRing() const;  // the ring's place as an answer; empty where none is asked for

    // Shows why something failed.
    void tell(const Status& status);
    void stopAnimation();
    // Two fingers of a touch screen: see StudioContext::pinch. False where no view is.
    bool pinch(float fromX, float fromY, float toX, float toY, double factor);

    // OpenGL's context was lost: forgets every name in it. Textures come back by themselves.
    void contextLost();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace versorium
