# Puts the page together:
# cmake -DPAGE=… -DBUILT=… -DTHREADS=… -DDIST=… -DPYTHON=… -P assemble.cmake
# BUILT is the program without threads. THREADS is the one with them, which goes into threads/ where
# it was built. Programs are packed by gzip here, for many hosts send files as they are.
# index.html learns the length of each, the service worker all names, and both a hash of all.
file(REMOVE_RECURSE "${DIST}")
file(MAKE_DIRECTORY "${DIST}")

# The length of what came out, in `size`.
function(take_program from to size)
    set(packed "${to}/versorium_studio.packed")
    file(COPY "${from}/versorium_studio.mjs" DESTINATION "${to}")
    execute_process(COMMAND "${PYTHON}" -c "import gzip, pathlib, sys
source, target = map(pathlib.Path, sys.argv[1:])
target.write_bytes(gzip.compress(source.read_bytes(), 9, mtime=0))"
        "${from}/versorium_studio.wasm" "${packed}" COMMAND_ERROR_IS_FATAL ANY)
    file(SIZE "${packed}" length)
    set(${size} ${length} PARENT_SCOPE)
endfunction()
take_program("${BUILT}" "${DIST}" PROGRAM_SIZE)
set(THREADS_SIZE "")
if(EXISTS "${THREADS}/versorium_studio.wasm")
    take_program("${THREADS}" "${DIST}/threads" THREADS_SIZE)
    file(COPY "${THREADS}/versorium_studio.worker.js" DESTINATION "${DIST}/threads")
endif()
file(GLOB names RELATIVE "${PAGE}" "${PAGE}/*")
foreach(name IN LISTS names)
    file(COPY "${PAGE}/${name}" DESTINATION "${DIST}")
endforeach()

file(GLOB_RECURSE names RELATIVE "${DIST}" "${DIST}/*")
list(SORT names)
set(hashes "")
set(FILES "")
foreach(name IN LISTS names)
    file(SHA256 "${DIST}/${name}" hash)
    string(APPEND hashes "${name} ${hash}\n")
    if(NOT name STREQUAL service_worker.js)
        string(APPEND FILES "\"${name}\", ")
    endif()
endforeach()
string(SHA256 BUILD "${hashes}")
string(SUBSTRING "${BUILD}" 0 16 BUILD)
foreach(name index.html service_worker.js)
    configure_file("${PAGE}/${name}" "${DIST}/${name}" @ONLY)
endforeach()
