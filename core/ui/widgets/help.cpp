// SPDX-License-Identifier: MIT
#include "ui/widgets/help.h"

#include <cassert>
#include <string>

#include "i18n/language.h"
#include "imgui.h"

namespace versorium {
namespace {

struct Help {
    std::string_view control, text;
};

constexpr Help kHelp[] = {
    {"map", "Which map is iterated. Its formula stands below."},
    {"formula",
     "A map of your own: z is complex, q a quaternion, x real, and x' = …, y' = … the plane. Other "
     "names are parameters. Enter takes it."},
    {"no formula", "Takes the field away. The map stays as it is."},
    {"formula name", "What the formula is to be called in the list of maps."},
    {"save formula", "Keeps the formula under this name, for the list of maps and for Find."},
    {"forget formula", "Takes the formula out of the saved ones. The picture stays."},
    {"find", "Finds maps, presets, recent scenes and commands by any part of their name."},
    {"gallery", "Presets and the scenes of last time, as pictures."},
    {"open", "Opens a scene, a picture that carries one, a mesh, an image or a palette."},
    {"export dialog", "A picture or a plate of what is shown, as a PNG of any size."},
    {"lessons", "Lessons that lead through an idea: predict, try, see. Key: L"},
    {"lesson", "Opens this lesson where you left it."},
    {"open lesson", "A lesson that somebody else wrote: a file that ends in .md"},
    {"close lessons", "Closes this pane. What you have done is kept."},
    {"all lessons", "The list of lessons. What you have done in this one is kept."},
    {"answer choice", "Choose, then commit: the answer is shown after that."},
    {"answer", "Your prediction. Enter commits to it."},
    {"ring answer", "Takes the place where the ring stands in the view as your answer."},
    {"commit", "You stand by this answer: it is judged, and you see what it means."},
    {"show answer", "Shows the answer beside yours."},
    {"reveal scene", "The picture that belongs to the answer, and back to your own."},
    {"hint", "The next hint. Fewer is more."},
    {"reset step", "Everything as the teacher set this step up."},
    {"all controls", "Opens the whole studio. The step waits as you leave it."},
    {"back to step", "What you explored is left; the step is as you left it."},
    {"step back", "The step before. Key: Page Up"},
    {"step on", "The next step. Key: Page Down"},
    {"export step", "A figure plate of this picture with the step's text, as a PNG to take home."},
    {"save answers", "What you answered and reached, as a text to hand in."},
    {"save answers json", "The same for a program."},
    {"begin again", "Forgets what you did in this lesson."},
    {"control access", "Open, locked (seen, but it cannot be changed) or hidden."},
    {"link opens", "What the learner sees first."},
    {"link rest",
     "What becomes of all controls that are not named below. step: those of the lesson's step are "
     "open, the others hidden."},
    {"link theme", "The colours of the studio, such as those for a projector."},
    {"link language", "The language that the studio speaks."},
    {"copy teacher link", "Whoever opens this link gets the lesson or the view, with these locks."},
    {"copy frame", "A piece of HTML that shows the studio within a web page or a course."},
    {"close dialog", "Closes this window. Key: Escape"},
    {"strip tab",
     "The orbit as a series, a web or a diagram, in the place of the view; or the "
     "view."},
    {"view tab", "Shows this view."},
    {"sheet", "The map, its parameters, the slice and the colours; or the picture alone."},
    {"undo", "Takes back what was done last. Key: Ctrl Z"},
    {"pad", "Drag the point: right is the real part, up is i."},
    {"draw shape",
     "Draw an outline in a view, in one stroke or corner by corner: its Julia set appears. Key: D"},
    {"shape choice", "Shapes to begin with. Meshes, images and grids open by Ctrl O or by drop."},
    {"shape text",
     "The shape as a text: disc(r), star(points, outer, inner), box(x, y), polygon(x1, y1, …), "
     "union(a, b), translate(x, y, a) and more. Enter takes it."},
    {"as printed",
     "S eq 2 prints φ + β, by which β > 0 shrinks the shape; the authors compute φ − β. Shows "
     "both."},
    {"over space",
     "Another value of this number in some places: painted, or within a second shape."},
    {"paint", "A brush: drag in a view of starting points. Escape lays it down."},
    {"erase", "The brush takes paint away instead."},
    {"clear paint", "Takes all paint away."},
    {"brush value", "What the number becomes where you paint."},
    {"brush radius", "How far the brush reaches; towards its edge it fades along a cubic."},
    {"second shape", "A shape within which the number has another value."},
    {"second shape text", "The second shape as a text. Enter takes it."},
    {"no second shape", "Takes the second shape away."},
    {"overlay",
     "Colours over the views: amber where the number is above its usual value, blue below."},
    {"slice in space",
     "The slice in space, within the target shape. Drag the plane to move it, the ground to look "
     "from elsewhere; with Shift or the right button: tilt it."},
    {"slice offset", "How far the plane lies from the origin, along its normal."},
    {"straight slice", "A plane along two axes of space."},
    {"section", "Opens or closes this part."},
    {"plate of", "The views as they are, or one of the program's own plates, such as a figure's."},
    {"product or sum",
     "d from the product of the powers of z - root, as the paper says, or from their sum, as the "
     "authors' program in 2D has it. Roots, shape, α and β stay."},
    {"show roots", "Zeros as circles with their powers, poles as crosses. Drag them. Key: V"},
    {"add root", "Puts a root where the ring is. A double click in a view does as well."},
    {"remove root", "Takes this root away. Key: Delete, with the pointer over the view"},
    {"root part", "Where the root lies. In a view it can be dragged."},
    {"root power", "The exponent of z - root. The wheel over the root changes it."},
    {"random roots", "Draws all roots anew, in the box of the shape."},
    {"roots least", "The least number of roots."},
    {"roots most", "The largest number of roots."},
    {"power least", "The least power of a root. Negative powers are poles."},
    {"power most", "The largest power of a root."},
    {"whole powers", "Whole powers have no seams; real ones have."},
    {"arrangement",
     "even: anywhere. clustered: in small balls. spread: each as far from the others as may be."},
    {"region", "The box of the shape, or the ellipsoid within it."},
    {"clusters", "How many clusters there are."},
    {"cluster size", "The radius of a cluster, in half sides of the region."},
    {"seed", "The same seed gives the same roots, here and by versorium roots."},
    {"draw roots", "The roots of this seed take the place of those that are there."},
    {"next seed", "The roots of the next seed. Key: Shift S"},
    {"contact sheet", "Pictures of several seeds, one of which may be taken. Key: S"},
    {"candidate", "A click or Enter takes these roots. Arrow keys go from one to the next."},
    {"candidates", "How many candidates the sheet has."},
    {"more candidates", "The next seeds."},
    {"take candidate", "The roots of the framed picture become those of the map. Key: Enter"},
    {"show basins",
     "White: every orbit that starts here stays. Black: every one leaves. Whatever d is. Key: B"},
    {"drop circle",
     "A circle around 0. White: captured, black: escapes, cyan: the versor decides. Drag its line "
     "or its centre. Key: O"},
    {"circle radius", "The circle's radius. Its line in the view can be dragged."},
    {"remove circle", "Takes the circle away."},
    {"borders", "Left, right, bottom and top of the view, to be typed."},
    {"reset", "Back to the map's own value."},
    {"animate", "Lets this number run to and fro through its range. The space bar pauses."},
    {"to and fro", "Back again at the high end; without it, on from the low end anew."},
    {"number menu", "The range of this number, its exact value, and its animation."},
    {"range low", "Where the slider begins. A typed number may lie beyond."},
    {"range high", "Where the slider ends. A typed number may lie beyond."},
    {"range reset", "The range that the program proposes."},
    {"seconds", "How long it takes to run through the range and back."},
    {"exact value", "The number as precisely as it is kept. Drag it, or double click to type."},
    {"make axis", "This number runs along that axis of the set of parameters."},
    {"coefficient", "The coefficient of the term behind it. Drag it, or double click to type."},
    {"coefficient axis",
     "Makes this coefficient an axis of the set of parameters: the two clicked last are its axes."},
    {"optional terms", "Two terms more, for complex polynomials of degree 4."},
    {"planar presets", "Planar systems worth seeing, and their sets of parameters."},
    {"as complex map", "The same pictures by the complex polynomial that this system is."},
    {"as planar system", "The same pictures by g and h, real and imaginary part of f."},
    {"which critical point", "Each critical point has a set of parameters of its own."},
    {"start", "p*, where the orbits of this picture start. Drag its diamond in the other view."},
    {"nearest", "Moves p* to the nearest point of the picture where det J = 0."},
    {"cycles",
     "Fixed points and cycles in the picture: attracting a disc, repelling a ring, a saddle a "
     "cross."},
    {"most period", "Cycles of up to so many points. Drag, or double click to type."},
    {"cycle row",
     "How long the cycle is and what its neighbours do. A click starts the orbit there."},
    {"compared", "A second orbit beside the first one. Alt and a drag in a view move its start."},
    {"second start", "Where the second orbit starts."},
    {"diagram", "The attractor against one parameter: a bifurcation diagram."},
    {"diagram number", "The parameter that the diagram runs over."},
    {"diagram range", "The parameter at this end of the diagram. Drag, or double click to type."},
    {"diagram usual", "The range that the program proposes."},
    {"diagram fit", "The part of that range in which the orbit stays bounded."},
    {"bifurcation diagram",
     "Click or drag to choose the parameter, wheel to zoom, drag with the right button to move."},
    {"iterations",
     "N, the most steps of an orbit. One that stays within the escape radius for N steps counts "
     "as captured."},
    {"escape radius", "Beyond this distance from 0 an orbit has escaped."},
    {"motion", "What was recorded, or set by key frames: a line of time."},
    {"record", "What you do with the focused view becomes a motion, until you stop. Key: R"},
    {"motion first", "To the beginning of the motion."},
    {"play motion", "Plays the motion, or pauses it. Key: Shift R"},
    {"motion time", "Where in the motion we are, in seconds."},
    {"set key", "What is shown now becomes the key frame at this time. Key: K"},
    {"remove key", "Takes the chosen key frame away."},
    {"easing", "How the numbers go on from the chosen key frame to the next."},
    {"frame rate", "Pictures of a second, for exports."},
    {"save motion", "A file that opens here again; versorium animate makes a film of it."},
    {"export motion", "All pictures of the motion."},
    {"film kind", "Numbered PNGs in one archive, or a film."},
    {"time line", "Click to choose a key frame, drag to move it, or drag through the time."},
    {"layer", "An image behind the fractal or in front of it. Click for where it lies."},
    {"layer remove", "Takes the image away."},
    {"layer leaf", "A leaf, drawn by the program."},
    {"layer white", "A white sheet at the very back."},
    {"layer image", "An image file behind the fractal; numbered ones become the frames of a film."},
    {"layer drop", "What images that are opened, dropped or pasted become: a layer, or a shape."},
    {"axis", "Which number runs along this axis of the view."},
    {"height", "What the view shows from bottom to top. Smaller is deeper."},
    {"border", "Type the border of the view. The opposite border stays where it is."},
    {"start at the critical point",
     "A map of Julia sets: each point of this plane asks what becomes of the critical point."},
    {"field", "What is measured along each orbit."},
    {"scale", "How values are spread over the palette, such as by their logarithm."},
    {"range from", "The value at the beginning of the palette."},
    {"range to", "The value at the end of the palette."},
    {"own range", "Stretches the palette over a range of values of your own."},
    {"shift range", "Moves the palette along the values without stretching it."},
    {"stretch range", "Stretches the palette about its middle."},
    {"average versors",
     "The part of a thousand sets that hold each point, each with random roots: which points the "
     "shape decides, and which the versor."},
    {"average number", "The part of the sets that hold each point, for a number drawn at random."},
    {"no average", "Takes the ensemble away: the picture is that of the map alone again."},
    {"show average",
     "The part of the sets that hold a point, how far that may be off (standard error), or the "
     "map's own picture."},
    {"ensemble members", "How many sets are averaged. More go on from those that are counted."},
    {"ensemble seed", "Another seed is another sample; the same one gives the same bits."},
    {"ensemble set", "membership: what has not escaped. solid: what a mesh would hold."},
    {"random roots", "Draws the roots, and so the versor, anew for each set."},
    {"ensemble roots", "How many roots a set has, at least and at most."},
    {"ensemble whole", "Powers 1, 2, 3 …; without it any number between the two."},
    {"ensemble arrangement",
     "even: each root anywhere. clustered: around a few centres. spread: far from one another."},
    {"ensemble clusters", "How many clusters, and their size as a part of the region's."},
    {"ensemble region", "Roots fill the box, or the ball within it."},
    {"ensemble box", "The region is the box of the shape; without it, half extents of your own."},
    {"ensemble range", "A number of the map, drawn evenly from a range for each set."},
    {"ensemble disc", "A complex number of the map, drawn evenly from a disc for each set."},
    {"ensemble remove", "Draws this number no longer: it keeps its value."},
    {"contours", "Lines along which the average has these values."},
    {"contour levels", "Levels of your own, with commas between them. Enter takes them."},
    {"profile",
     "The mean of φ over circles of radius r against r: where r̂ is below r, orbits tend to fall."},
    {"profile plot", "The pointer tells the values at a radius."},
    {"outline", "A line round the set: membership is what never escapes, solid what is meshed."},
    {"edit palette", "Makes a palette of your own from this one, by its stops."},
    {"stops", "Drag a stop to move it, double click between two to add one, Delete removes it."},
    {"stop colour", "The colour of the chosen stop."},
    {"stop position", "Where the chosen stop lies, from 0 to 1."},
    {"delete stop", "Takes the chosen stop away. Two always remain."},
    {"add stop", "Puts a stop into the widest gap, with the colour that is there now."},
    {"turn stops", "Turns the whole palette round."},
    {"interior colour", "The colour of points that never escape."},
    {"copy palette", "The palette as JSON, for a file or for another scene."},
    {"orbit first", "To the beginning of the orbit."},
    {"orbit back", "One step back along the orbit. Key: ,"},
    {"orbit forward", "One step on along the orbit, which grows at its end. Key: ."},
    {"orbit last", "To the end of the orbit."},
    {"orbit steps", "How many steps of the orbit are drawn. Drag, or double click to type."},
    {"series", "Every component of z_n against n."},
    {"web", "The graph of f with the diagonal: up to the graph, across to the diagonal, again."},
    {"web diagram", "Click or drag to choose x_0. Each corner of the line is a step."},
    {"series diagram", "Click a step to choose it."},
    {"orbit row", "A click chooses this step: it is marked in the views."},
    {"copy table", "The orbit as a table for spreadsheets, columns parted by tabs."},
    {"arrows", "Draws arrows from points x of the view to f(x). Key: A"},
    {"export what", "One view, or all of them as the panels of one plate."},
    {"export kind",
     "A picture is the bare view. A plate adds axes, keys, a title and a caption, for print."},
    {"pixels wide", "The width of the picture; its height follows from the view."},
    {"samples", "Samples along each side of a pixel, averaged in linear light: 4 is very smooth."},
    {"plate width", "In millimetres: 89 and 178 are one and two columns of a journal."},
    {"plate dpi", "Pixels per inch. 300 is usual for print."},
    {"plate theme", "White paper for print, or a dark slide for projection."},
    {"plate title", "Whether the plate has its title."},
    {"plate caption", "Whether the plate has its caption and its last line."},
    {"export", "Computes the picture in double precision and saves it as a PNG."},
    {"copy image", "Computes the picture and puts it on the clipboard where there is a way."},
    {"cancel", "Stops the work. Nothing is written."},
    {"close", "Closes this. Key: Escape"},
    {"question", "Type any part of a name; Enter takes the first one."},
    {"found", "Enter or a click takes it."},
    {"preset", "Opens this scene. What is there now can be had back by undo."},
    {"folder", "The folder that is shown. A typed path opens with Enter."},
    {"file", "Opens this file, or goes into this folder."},
    {"language", "The language of the interface. Files, links and formulas stay as they are."},
};

void show(std::string_view english) {
    const std::string text = tr(english);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

}  // namespace

std::string_view helpOf(std::string_view control) {
    for (const Help& help : kHelp)
        if (help.control == control) return help.text;
    return {};
}

void explain(std::string_view control) {
    assert(!helpOf(control).empty());
    explainBy(helpOf(control));
}

void explainBy(std::string_view text) {
    static int shownIn = -1;  // the frame: where two items meet, the first one explains itself
    if (text.empty() || shownIn == ImGui::GetFrameCount()) return;
    const bool focused = ImGui::GetIO().NavVisible && ImGui::IsItemFocused();
    if (focused ||
        ImGui::IsItemHovered(ImGuiHoveredFlags_DelayNormal | ImGuiHoveredFlags_AllowWhenDisabled)) {
        shownIn = ImGui::GetFrameCount();
        show(text);
    }
}

}  // namespace versorium
