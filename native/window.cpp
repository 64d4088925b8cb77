// SPDX-License-Identifier: MIT
#include "window.h"

#define GLFW_INCLUDE_ES3
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <utility>

#include "computer.h"
#include "folders.h"
#include "imgui.h"
#include "imgui_impl_glfw.h"
#include "imgui_impl_opengl3.h"
#include "io/document.h"
#include "io/files.h"
#include "io/png.h"
#include "lesson/lesson.h"
#include "lesson/teacher_link.h"
#include "settings.h"
#include "ui/studio.h"

namespace versorium {
namespace {

constexpr double kIdle = 0.5;  // seconds between frames while nothing happens
// ImGui needs a few frames to come to rest after an event.
constexpr int kSettleFrames = 3;
constexpr std::size_t kOpenBytes = std::size_t{256} << 20;

class WindowHost final : public Host {
  public:
    explicit WindowHost(GLFWwindow* window)
        : window_(window), computer_([] { glfwPostEmptyEvent(); }) {}

    double now() const override { return glfwGetTime(); }
    void wake() override { glfwPostEmptyEvent(); }
    void wakeAfter(double seconds) override { due_ = std::min(due_, now() + seconds); }
    // How long the window may rest, and forgets it.
    double rest() { return std::clamp(std::exchange(due_, kNever) - now(), 0.001, kIdle); }
    std::string clipboard() override {
        const char* text = glfwGetClipboardString(window_);
        return text ? text : "";
    }
    void setClipboard(const std::string& text) override {
        glfwSetClipboardString(window_, text.c_str());
    }
    void requestWork(WorkRequest request) override { computer_.request(std::move(request)); }
    std::optional<WorkAnswer> takeAnswer() override { return computer_.take(); }
    void dropPicture(int view) override { computer_.drop(view); }
    void startExport(ExportRequest request) override {
        const std::string name = request.name;
        const bool clipboard = request.toClipboard;
        computer_.startExport(
            std::move(request),
            [name, clipboard](std::span<const unsigned char> bytes) -> Expected<std::string> {
                Expected<std::string> path = save(name, bytes);
                // GLFW's clipboard holds texts and nothing else.
                if (path && clipboard) *path += " (the clipboard of this window takes only text)";
                return path;
            });
    }
    void cancelExport() override { computer_.cancelExport(); }
    double exportProgress() const override { return computer_.exportProgress(); }
    std::optional<Expected<std::string>> takeExport() override { return computer_.takeExport(); }
    Expected<std::string> saveFile(const std::string& name,
                                   std::span<const unsigned char> bytes) override {
        return save(name, bytes);
    }
    Expected<Folder> listFolder(const std::string& path) override {
        return versorium::listFolder(path);
    }
    Expected<std::vector<unsigned char>> readFile(const std::string& path) override {
        return versorium::readFile(path, kOpenBytes);
    }
    std::string publicAddress() const override { return readSetting("public_url"); }
    void setFragment(const std::string& fragment) override { fragment_ = fragment; }
    std::string stored(const std::string& name) override { return readSetting(name); }
    void store(const std::string& name, const std::string& text) override {
        // Settings are a comfort: a folder that cannot be written must not stop the studio.
        if (const Status status = writeSetting(name, text); !status.ok())
            std::fprintf(stderr, "versorium: %s\n", status.message().c_str());
    }

    std::string preferredLanguage() const override {
        // As POSIX reads them: the first that is set.
        for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
            if (const char* value = std::getenv(name); value && *value) return value;
        return "en";
    }

  private:
    static Expected<std::string> save(const std::string& name,
                                      std::span<const unsigned char> bytes) {
        const std::string path = freePath(name);
        if (Status status = writeFileAtomically(path, bytes); !status.ok()) return status;
        return path;
    }

    static constexpr double kNever = 1e300;
    GLFWwindow* window_;
    double due_ = kNever;
    mutable Computer computer_;
    std::string fragment_;
};

Status openInto(Studio& studio, const std::string& what) {
    const std::string fragment =
        what.substr(what.find('#') + 1);  // all of it where there is no '#'
    if (fragment.starts_with("v1:") || isTeacherLink(fragment))
        return studio.openFragment(fragment);
    const std::vector<std::string> lessons = lessonIds();
    if (std::find(lessons.begin(), lessons.end(), what) != lessons.end())
        return studio.openLesson(what, {});
    const std::vector<std::string> names = presetNames();
    if (std::find(names.begin(), names.end(), what) != names.end()) return studio.openPreset(what);
    const Expected<Bytes> bytes = readFile(what, kOpenBytes);
    if (!bytes && looksLikeFormula(what) && FormulaMap::make(what)) return studio.openFormula(what);
    if (!bytes)
        return bytes.status().in("\"" + what +
                                 "\" is no preset and no lesson, and as a file it does not open");
    return studio.openBytes(what, *bytes);
}

void dropped(GLFWwindow* window, int count, const char** paths) {
    auto* studio = static_cast<Studio*>(glfwGetWindowUserPointer(window));
    for (int k = 0; k < count; ++k)
        if (const Status status = openInto(*studio, paths[k]); !status.ok()) studio->tell(status);
}

Status writeScreenshot(GLFWwindow* window, const std::string& path) {
    Size size;
    glfwGetFramebufferSize(window, &size.width, &size.height);
    Raster<unsigned char> upside(size, 4), picture(size, 4);
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, upside.values().data());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 4; ++c)
                picture.at(x, y, c) = c == 3 ? 255 : upside.at(x, size.height - 1 - y, c);
    const Expected<std::vector<unsigned char>> bytes = encodePng(picture);
    if (!bytes) return bytes.status();
    return writeFileAtomically(path, *bytes);
}

// GLFW's window with everything in it; ended in the reverse order.
struct OpenWindow {
    GLFWwindow* handle = nullptr;
    ~OpenWindow() {
        if (handle) glfwDestroyWindow(handle);
        glfwTerminate();
    }
};

struct Gui {
    explicit Gui(GLFWwindow* window) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui_ImplGlfw_InitForOpenGL(window, true);
        ImGui_ImplOpenGL3_Init("#version 300 es");
    }
    ~Gui() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
};

std::string lastProblem() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason was given";
}

}  // namespace

Status runStudio(const WindowOptions& options) {
    if (!glfwInit())
        return Status::usage("there is no display for the studio's window (" + lastProblem() +
                             "). Without one, \"versorium render PRESET -o FILE.png\" and "
                             "\"versorium plate NAME -o FILE.png\" draw to files; "
                             "\"versorium --help\" lists all commands");
    OpenWindow window;
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    window.handle = glfwCreateWindow(options.width, options.height, "Versorium", nullptr, nullptr);
    if (!window.handle)
        return Status::usage("the studio needs OpenGL ES 3.0, and this display has none (" +
                             lastProblem() +
                             "). \"versorium render\" and \"versorium plate\" "
                             "draw to files without it");
    glfwMakeContextCurrent(window.handle);
    glfwSwapInterval(1);

    const Gui gui(window.handle);
    WindowHost host(window.handle);
    Studio studio(host);
    if (!options.open.empty())
        if (Status status = openInto(studio, options.open); !status.ok()) return status;
    glfwSetWindowUserPointer(window.handle, &studio);
    glfwSetDropCallback(window.handle, dropped);
    float scale = 0;
    int settle = kSettleFrames;
    while (!glfwWindowShouldClose(window.handle)) {
        if (studio.busy() || settle > 0) {
            glfwPollEvents();
            settle = std::max(0, settle - 1);
        } else {
            glfwWaitEventsTimeout(host.rest());
            settle = kSettleFrames;
        }
        float across = 1, down = 1;
        glfwGetWindowContentScale(window.handle, &across, &down);
        if (across != scale || studio.wantsPrepare()) {
            scale = across;
            studio.prepare(scale);
            ImGui_ImplOpenGL3_DestroyFontsTexture();
            ImGui_ImplOpenGL3_CreateFontsTexture();
        }
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        studio.frame();
        ImGui::Render();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window.handle, &width, &height);
        glViewport(0, 0, width, height);
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        if (!options.screenshot.empty()) {
            studio.stopAnimation();
            if (studio.finished()) return writeScreenshot(window.handle, options.screenshot);
        }
        glfwSwapBuffers(window.handle);
    }
    return {};
}

}  // namespace versorium
