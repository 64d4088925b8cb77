# Checks of the sources and of the objects; each is a program that can be run by hand as well.
find_program(VERSORIUM_PYTHON python3)
if(NOT VERSORIUM_PYTHON)
    message(FATAL_ERROR "python3 is missing: run scripts/setup, or configure with "
        "-DVERSORIUM_TESTS=OFF")
endif()
set(checks "${CMAKE_CURRENT_LIST_DIR}")
foreach(check dependencies catalogue glyphs map_names sizes tracked_files texts)
    versorium_test(check_${check} ${VERSORIUM_PYTHON} "${checks}/${check}.py" "${PROJECT_SOURCE_DIR}")
endforeach()
versorium_test(check_format "${checks}/format")
versorium_test(check_checks ${VERSORIUM_PYTHON} "${checks}/checks_test.py")

# Sanitizers add symbols of their own to every object.
if(NOT VERSORIUM_SANITIZE)
    get_property(kernels GLOBAL PROPERTY VERSORIUM_KERNELS)
    set(objects "")
    foreach(kernel IN LISTS kernels)
        list(APPEND objects "${kernel}=$<JOIN:$<TARGET_OBJECTS:versorium_kernels_${kernel}>,,>")
    endforeach()
    versorium_test(check_kernel_symbols ${VERSORIUM_PYTHON} "${checks}/kernel_symbols.py"
        ${CMAKE_NM} ${objects})
endif()
