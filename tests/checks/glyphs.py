#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every character that the program can show is in the embedded fonts: texts of the sources, of the
languages, of lessons, presets and plates against the list in core/cmake/fonts.cmake. That the faces
really have them is tested in tests/plate/glyphs_test.cpp.

glyphs.py [ROOT]
"""
import pathlib
import re
import sys

LITERAL = re.compile(r'"((?:\\.|[^"\\\n])*)"')
RANGE = re.compile(r"U\+([0-9A-F]+)(?:-([0-9A-F]+))?")
SHOWN = ("core/**/*.cpp", "core/**/*.h", "native/**/*.cpp", "core/i18n/*.json", "lessons/[0-9]*.md",
         "lessons/*/*.json")


def letters_of(root):
    text = (root / "core/cmake/fonts.cmake").read_text(encoding="utf-8")
    listed = text[text.index("string(JOIN"):]
    letters = set()
    for first, last in RANGE.findall(listed[:listed.index(")")]):
        letters.update(range(int(first, 16), int(last or first, 16) + 1))
    return letters


def shown_in(path):
    text = path.read_text(encoding="utf-8")
    if path.suffix not in (".cpp", ".h"):
        return text
    return "".join(LITERAL.findall("\n".join(line.split("//")[0] if line.lstrip().startswith("//")
                                             else line for line in text.splitlines())))


def check(root):
    letters, faults, files = letters_of(root), [], 0
    for pattern in SHOWN:
        for path in sorted(root.glob(pattern)):
            files += 1
            lacking = sorted({c for c in shown_in(path) if ord(c) > 126 and ord(c) not in letters})
            faults += [f"{path.relative_to(root)}: no font has \"{c}\" (U+{ord(c):04X}); add it to "
                       "core/cmake/fonts.cmake, or write another" for c in lacking]
    return files, faults


if __name__ == "__main__":
    count, found = check(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    print("\n".join(found + [f"{count} files, {len(found)} faults"]))
    sys.exit(1 if found or count == 0 else 0)
