# Makes maps/catalogue_maps.h from maps/catalogue.txt: the includes and the list of all maps.
function(versorium_catalogue list output)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${list}")
    file(STRINGS "${list}" lines REGEX "^[^#]")
    set(headers "")
    set(maps "")
    foreach(line IN LISTS lines)
        if(NOT line MATCHES "^([a-z0-9_]+\\.h) +(.+)$")
            message(FATAL_ERROR "${list}: \"${line}\" is not a header and a struct")
        endif()
        list(APPEND headers "#include \"maps/${CMAKE_MATCH_1}\"")
        list(APPEND maps "    ${CMAKE_MATCH_2}")
    endforeach()
    list(REMOVE_DUPLICATES headers)
    list(JOIN headers "\n" headers)
    list(JOIN maps ",\n" maps)
    file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT "// Made from core/maps/catalogue.txt.
#pragma once
@headers@

namespace versorium {

template <class...>
struct MapList {};

using AllMaps = MapList<
@maps@>;

}  // namespace versorium
")
endfunction()
