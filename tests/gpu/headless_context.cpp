// SPDX-License-Identifier: MIT
#include "headless_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdlib>

namespace versorium {
namespace {

EGLDisplay display = EGL_NO_DISPLAY;
EGLSurface surface = EGL_NO_SURFACE;
EGLContext context = EGL_NO_CONTEXT;

EGLDisplay openDisplay() {
    const auto platformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platformDisplay) {
        const EGLDisplay surfaceless =
            platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (surfaceless != EGL_NO_DISPLAY && eglInitialize(surfaceless, nullptr, nullptr))
            return surfaceless;
    }
    const EGLDisplay usual = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    return usual != EGL_NO_DISPLAY && eglInitialize(usual, nullptr, nullptr) ? usual
                                                                             : EGL_NO_DISPLAY;
}

}  // namespace

std::string makeHeadlessContext() {
    if (display == EGL_NO_DISPLAY) {
        // Results must not depend on the GPU of the machine that runs the tests.
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
        display = openDisplay();
    }
    if (display == EGL_NO_DISPLAY) return "EGL opens no display";
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_ES3_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
        return "EGL has no configuration for OpenGL ES 3";
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) return "EGL makes no OpenGL ES 3 context";
    const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    surface = eglCreatePbufferSurface(display, config, size);
    if (!eglMakeCurrent(display, surface, surface, context))
        return "EGL does not make the context current";
    return "";
}

void loseHeadlessContext() {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
    context = EGL_NO_CONTEXT;
    surface = EGL_NO_SURFACE;
}

}  // namespace versorium
