# Third-party headers, as Debian's packages install them. The WebAssembly build must not see the
# native C library's headers, so it gets a folder with links to the header-only libraries alone.
set(VERSORIUM_INCLUDE_DIR "/usr/include" CACHE PATH "Where glm, stb and nlohmann stand")
add_library(versorium_packages INTERFACE)
foreach(name glm stb nlohmann)
    if(NOT EXISTS "${VERSORIUM_INCLUDE_DIR}/${name}")
        message(FATAL_ERROR "${VERSORIUM_INCLUDE_DIR}/${name} is missing: run scripts/setup, or "
            "install the packages that CONTRIBUTING.md lists")
    endif()
endforeach()
if(EMSCRIPTEN)
    set(links "${CMAKE_BINARY_DIR}/packages")
    file(MAKE_DIRECTORY "${links}")
    foreach(name glm stb nlohmann)
        file(CREATE_LINK "${VERSORIUM_INCLUDE_DIR}/${name}" "${links}/${name}" SYMBOLIC)
    endforeach()
    target_compile_options(versorium_packages INTERFACE "SHELL:-idirafter ${links}")
elseif(NOT VERSORIUM_INCLUDE_DIR STREQUAL "/usr/include")
    target_include_directories(versorium_packages SYSTEM INTERFACE "${VERSORIUM_INCLUDE_DIR}")
endif()
target_compile_definitions(versorium_packages INTERFACE JSON_NOEXCEPTION JSON_USE_IMPLICIT_CONVERSIONS=0
    GLM_FORCE_XYZW_ONLY)
