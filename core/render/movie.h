// SPDX-License-Identifier: MIT
#pragma once
// The pictures of a motion (scene/animation.h), one after the other: each is the PNG that
// `versorium render` makes of the scene at that time.

#include "render/picture.h"
#include "scene/animation.h"

namespace versorium {

struct Movie {
    Animation animation;
    PictureOptions options;
};

// ErrorKind::data where the document is no animation, or not a right one.
Expected<Movie> movieFromDocument(const Document& document);
Document documentOfMovie(const Movie& movie);

// Animations that the program carries: "leaf", ….
std::vector<std::string> animationNames();
Expected<Movie> animationNamed(const std::string& name);

// "frame-00001.png": the first frame has number 1.
std::string frameName(int frame);
// The document that the frame's PNG carries.
Document frameDocument(const Movie& movie, int frame);
Expected<std::vector<unsigned char>> renderFrame(CpuRenderer& renderer, const Movie& movie,
                                                 int frame, Job& job);
// All frames in one ZIP archive, with the animation itself as "animation.json".
Expected<std::vector<unsigned char>> renderArchive(CpuRenderer& renderer, const Movie& movie,
                                                   Job& job);

}  // namespace versorium
