# versorium_unity(<target> <source>… [APART <source>…]) compiles the sources of each folder together,
# in groups: most of the time of a build goes into what headers bring along, the same in each file.
# So names in unnamed namespaces must differ within a folder; the compiler says when two do not.
# Sources that stand APART are compiled alone. The sanitized builds compile every file alone, so that
# one that misses an include is found.
option(VERSORIUM_UNITY "Compile the sources of each folder together" ON)
# As many as keep the time of a changed file below some ten seconds.
set(VERSORIUM_UNITY_SIZE 10)

function(versorium_unity target)
    if(NOT VERSORIUM_UNITY)
        return()
    endif()
    cmake_parse_arguments(PARSE_ARGV 1 unity "" "" APART)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    foreach(source IN LISTS unity_UNPARSED_ARGUMENTS)
        file(RELATIVE_PATH path "${CMAKE_CURRENT_SOURCE_DIR}" "${source}")
        if(path IN_LIST unity_APART)
            continue()
        endif()
        get_filename_component(folder "${path}" DIRECTORY)
        string(MAKE_C_IDENTIFIER "in_${folder}" group)
        if(NOT DEFINED count_${group})
            set(count_${group} 0)
        endif()
        math(EXPR part "${count_${group}} / ${VERSORIUM_UNITY_SIZE}")
        math(EXPR count_${group} "${count_${group}} + 1")
        set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group}_${part})
    endforeach()
endfunction()
