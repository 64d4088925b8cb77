# The letters of plates: DejaVu (fonts-dejavu-core), cut by pyftsubset (fonttools) to what plates
# write, and embedded. Outlines and kerning stay; hints go, since glyphs are drawn from outlines.
set(VERSORIUM_FONT_DIR "/usr/share/fonts/truetype/dejavu" CACHE PATH "Where DejaVuSans.ttf stands")
find_program(VERSORIUM_PYFTSUBSET pyftsubset PATHS /usr/bin NO_CMAKE_FIND_ROOT_PATH)
if(NOT VERSORIUM_PYFTSUBSET)
    message(FATAL_ERROR "pyftsubset is missing: run scripts/setup (package fonttools), or set "
        "VERSORIUM_PYFTSUBSET")
endif()
# Latin-1, Latin Extended-A; circumflex, combining circumflex, macron, tilde and dot; Greek; spaces,
# dashes, quotes, primes; super- and subscripts; letterlike; arrows; operators; brackets; shapes;
# the mark of what is done. tests/checks/glyphs.py says what is shown and not here.
string(JOIN "," letters
    U+0020-007E U+00A0-017F U+02B0 U+02C6 U+0302 U+0303 U+0304 U+0307 U+0391-03C9 U+03D5 U+03F5
    U+2009 U+2010-2016 U+2018-201E U+2020-2022 U+2026 U+202F U+2032-2034
    U+2070-209C U+1D4D U+1D62-1D65 U+2C7C U+2102 U+210D U+2111 U+2113 U+2115 U+211A U+211C U+211D U+2124
    U+2190-2195 U+21A6 U+21D0-21D4 U+2200 U+2202 U+2203 U+2205-2209 U+220B U+220F U+2211-2213
    U+2215-221A U+221D U+221E U+2225 U+2227-222B U+2234 U+223C U+2243 U+2245 U+2248 U+2260 U+2261
    U+2264 U+2265 U+226A U+226B U+2282 U+2283 U+2286 U+2287 U+2295-2299 U+22A5 U+22C5 U+2308-230B
    U+25A0 U+25A1 U+25B2 U+25B3 U+25C6 U+25C7 U+25CB U+25CF U+2713 U+27E8 U+27E9 U+FFFD)

function(versorium_embed_fonts target)
    foreach(font Serif Serif-Bold Sans Sans-Bold SansMono)
        set(input "${VERSORIUM_FONT_DIR}/DejaVu${font}.ttf")
        if(NOT EXISTS "${input}")
            message(FATAL_ERROR "${input} is missing: run scripts/setup (package "
                "fonts-dejavu-core), or set VERSORIUM_FONT_DIR")
        endif()
        set(output "${CMAKE_CURRENT_BINARY_DIR}/fonts/DejaVu${font}.ttf")
        add_custom_command(OUTPUT "${output}"
            COMMAND ${CMAKE_COMMAND} -E make_directory "${CMAKE_CURRENT_BINARY_DIR}/fonts"
            COMMAND "${VERSORIUM_PYFTSUBSET}" "${input}" "--output-file=${output}"
                "--unicodes=${letters}" --no-hinting --desubroutinize --layout-features=kern
                --name-IDs=0,1,2,13,14 --notdef-outline --no-recalc-timestamp
                --drop-tables+=FFTM
            DEPENDS "${input}" "${VERSORIUM_FONTS_SCRIPT}"
            COMMENT "Cutting DejaVu ${font}" VERBATIM)
        versorium_embed(${target} "fonts/DejaVu${font}.ttf" "${output}")
    endforeach()
endfunction()
set(VERSORIUM_FONTS_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")
