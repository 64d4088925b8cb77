// SPDX-License-Identifier: MIT
#pragma once
// What a step of a lesson shows, as changes against the step before: lines "key: value" that take
// one workspace to another.
//
//   preset: mandelbrot        begins anew from a preset
//   map: logistic             … from a map's or a typed formula's own view
//   link: v1:…                … from a link of the studio
//   views: both               parameters beside starting points; or parameters, starts, 1, 2, 4
//   c: -0.12 + 0.74i          a parameter in all views; also "-0.12, 0.74"
//   c.im: 0.7                 one number of it
//   point: 0.2, 0.1           where the orbit starts
//   roots: 0.5 0; -0.5 0      a list of roots: components, then a power that is not 1; or none
//   circle: 0.3, 0.1, 0.2     drops a circle: its middle in the plane, and its radius
//   pin: now                  sets the present parameters aside
//   shape: star(5, 1.4, 0.7)  the shape of a shape modulus
//   iterations: 300           any key of a scene, in all views; a dot leads inside:
//   colour.palette: viridis
//   left.slice.height: 0.5    the same in one view: left, right, or view3
//   orbit_steps: 40           any key of a workspace (docs of links): study.cycles: true
//
// A value is JSON where it can be read so, else numbers with commas, a complex number, or a text.

#include <string>
#include <vector>

#include "workspace/workspace.h"

namespace versorium {

struct StageLine {
    std::string key, value;
    int line = 0;
};

// "key: value" lines; blank ones and those that begin with # are left out.
Expected<std::vector<StageLine>> readLines(const std::string& text, int firstLine);

// "line 3: ", before what is wrong with it.
std::string atLine(int line);
// What stands between blanks, commas and ends of lines.
std::vector<std::string> splitWords(const std::string& text);

// ErrorKind::data names the line.
Expected<Workspace> changed(const Workspace& before, const std::vector<StageLine>& lines);

// "0.3", "-2i", "0.3 - 2i", "0.3, -2", "(0.3, -2)": one or more numbers; empty where it is none.
std::vector<double> numbersOf(const std::string& text);

}  // namespace versorium
