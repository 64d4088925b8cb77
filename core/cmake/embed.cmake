# versorium_embed(<target> <name> <file> [<name> <file> …]) puts files into a library, where
# embedded("name") of base/embedded.h finds them. May be called several times in the directory of
# the target; a file may itself be made by the build. Plain C++ comes out, so that every compiler,
# Emscripten's too, takes it; a changed file is embedded anew.
set(VERSORIUM_EMBED_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/embed_file.cmake")

function(versorium_embed target)
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/embedded")
    get_property(names GLOBAL PROPERTY VERSORIUM_EMBEDDED_${target})
    if(NOT names)
        # Deferred arguments are expanded late, when this scope is gone; EVAL expands them now.
        cmake_language(EVAL CODE "cmake_language(DEFER CALL versorium_embed_table ${target})")
    endif()
    while(ARGN)
        list(POP_FRONT ARGN name file)
        string(SHA256 symbol "${name}")
        string(SUBSTRING "${symbol}" 0 16 symbol)
        if("${name}" IN_LIST names)
            message(FATAL_ERROR "${name} is embedded twice")
        endif()
        get_filename_component(file "${file}" ABSOLUTE)
        add_custom_command(OUTPUT "${folder}/${symbol}.cpp"
            COMMAND ${CMAKE_COMMAND} -D "INPUT=${file}" -D "OUTPUT=${folder}/${symbol}.cpp"
                -D "SYMBOL=${symbol}" -P "${VERSORIUM_EMBED_SCRIPT}"
            DEPENDS "${file}" "${VERSORIUM_EMBED_SCRIPT}"
            COMMENT "Embedding ${name}" VERBATIM)
        target_sources(${target} PRIVATE "${folder}/${symbol}.cpp")
        # A file of bytes takes no time; what is read before it would.
        set_source_files_properties("${folder}/${symbol}.cpp" PROPERTIES
            SKIP_PRECOMPILE_HEADERS ON UNITY_GROUP embedded)
        list(APPEND names "${name}")
    endwhile()
    set_property(GLOBAL PROPERTY VERSORIUM_EMBEDDED_${target} "${names}")
endfunction()

# The list of all embedded files of a target, in the order of their names.
function(versorium_embed_table target)
    get_property(names GLOBAL PROPERTY VERSORIUM_EMBEDDED_${target})
    list(SORT names)
    set(declarations "")
    set(rows "")
    foreach(name ${names})
        string(SHA256 symbol "${name}")
        string(SUBSTRING "${symbol}" 0 16 symbol)
        string(APPEND declarations "std::span<const unsigned char> file_${symbol}();\n")
        string(APPEND rows "    {\"${name}\", file_${symbol}},\n")
    endforeach()
    set(file "${CMAKE_CURRENT_BINARY_DIR}/embedded/table.cpp")
    file(CONFIGURE OUTPUT "${file}" @ONLY CONTENT [[
#include "base/embedded.h"

namespace versorium::embedded_files {
@declarations@
static const EmbeddedFile kFiles[] = {
@rows@};
std::span<const EmbeddedFile> table() { return kFiles; }
}  // namespace versorium::embedded_files
]])
    target_sources(${target} PRIVATE "${file}")
endfunction()
