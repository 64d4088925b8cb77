# Dear ImGui from its sources (scripts/setup fetches them), with its back ends for the window; the
# page has its own (ui/backend/gl_canvas.h).
set(VERSORIUM_IMGUI_DIR "${PROJECT_SOURCE_DIR}/.deps/imgui" CACHE PATH "Sources of Dear ImGui 1.90")
if(NOT EXISTS "${VERSORIUM_IMGUI_DIR}/imgui.cpp")
    message(FATAL_ERROR "${VERSORIUM_IMGUI_DIR}/imgui.cpp is missing: run scripts/setup, or set "
        "VERSORIUM_IMGUI_DIR")
endif()
set(imgui_sources imgui imgui_draw imgui_tables imgui_widgets)
if(NOT EMSCRIPTEN)
    list(APPEND imgui_sources backends/imgui_impl_glfw backends/imgui_impl_opengl3)
endif()
list(TRANSFORM imgui_sources PREPEND "${VERSORIUM_IMGUI_DIR}/")
list(TRANSFORM imgui_sources APPEND ".cpp")
add_library(versorium_imgui STATIC ${imgui_sources})
target_include_directories(versorium_imgui SYSTEM PUBLIC "${VERSORIUM_IMGUI_DIR}"
    "${VERSORIUM_IMGUI_DIR}/backends")
target_compile_definitions(versorium_imgui PUBLIC IMGUI_IMPL_OPENGL_ES3 IMGUI_DISABLE_OBSOLETE_FUNCTIONS
    IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_DEBUG_TOOLS)
target_compile_options(versorium_imgui PRIVATE -w -fno-exceptions)
target_link_libraries(versorium_imgui PUBLIC versorium_flags)
if(NOT EMSCRIPTEN)
    target_link_libraries(versorium_imgui PUBLIC glfw GLESv2)
endif()
