# Flags for all of the project's own code. Nothing here may change a value: no -ffast-math, and
# contraction is off except where a kernel is built in its fast flavour (core/CMakeLists.txt).
# -fno-math-errno and -fno-trapping-math only drop side effects that nobody reads, so that square
# roots and selections become single instructions.
if(VERSORIUM_WEB AND NOT EMSCRIPTEN)
    message(FATAL_ERROR "This preset needs Emscripten: run scripts/build web, or "
        "emcmake cmake --preset web")
endif()
add_library(versorium_flags INTERFACE)
target_compile_options(versorium_flags INTERFACE
    -Wall -Wextra -Wno-psabi -fno-math-errno -fno-trapping-math
    -fvisibility=hidden -fvisibility-inlines-hidden)
# Numbers and registers share one template: its | and & join truth values on purpose.
target_compile_options(versorium_flags INTERFACE
    $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
# g++ 12 warns wrongly of overlapping and too long copies where it inlines std::string.
target_compile_options(versorium_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds>)
if(EMSCRIPTEN)
    target_compile_options(versorium_flags INTERFACE -msimd128)
    target_link_options(versorium_flags INTERFACE -sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=1048576)
endif()

# All code but the kernels (which choose for themselves): the baseline processor, no contraction.
add_library(versorium_exact INTERFACE)
target_compile_options(versorium_exact INTERFACE -ffp-contract=off)
# Whoever adds a value to an enumeration is led to every switch that must answer for it.
target_compile_options(versorium_exact INTERFACE -Werror=switch)
if(NOT EMSCRIPTEN AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(versorium_exact INTERFACE -march=x86-64-v2)
endif()
if(VERSORIUM_THREADS)
    find_package(Threads REQUIRED)
    target_compile_definitions(versorium_flags INTERFACE VERSORIUM_THREADS=1)
    if(EMSCRIPTEN)
        target_compile_options(versorium_flags INTERFACE -pthread)
        target_link_options(versorium_flags INTERFACE -pthread -Wno-pthreads-mem-growth)
    else()
        target_link_libraries(versorium_flags INTERFACE Threads::Threads)
    endif()
else()
    target_compile_definitions(versorium_flags INTERFACE VERSORIUM_THREADS=0)
endif()
if(VERSORIUM_SANITIZE)
    target_compile_options(versorium_flags INTERFACE
        -fsanitize=${VERSORIUM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(versorium_flags INTERFACE -fsanitize=${VERSORIUM_SANITIZE})
endif()
