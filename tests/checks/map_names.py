#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No file outside of core/maps knows a map by its name: what is special about one is a property of
its MapInfo (core/maps/map_info.h). map_names.txt says where a name may stand, and why.

map_names.py [ROOT]
"""
import pathlib
import re
import sys

from dependencies import SUFFIXES, line_of, without_comments

LITERAL = re.compile(r'"((?:\\.|[^"\\\n])*)"')
# `.name = …,` of a MapInfo, which may be a choice between two literals.
NAME = re.compile(r"\bMapInfo\s+info\s*\{\s*\.name\s*=([^,]*),")
# Names of maps that mean other things as well: only as maps are they faults.
ALSO_WORDS = {"power"}
COMPARED = re.compile(r"\b(?:info\.(?:name|formula)|\.\s*map|->\s*map|findMap)\s*(?:==|!=|\()\s*\"([^\"]*)\"")


def names_of(root):
    found = set()
    for header in sorted((root / "core/maps").glob("*.h")):
        for match in NAME.finditer(header.read_text(encoding="utf-8")):
            found.update(LITERAL.findall(match.group(1)))
    return found


def allowed_of(path):
    """(file, name) -> whether it was met."""
    allowed, faults = {}, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        what, mark, why = line.partition("#")
        if len(what.split()) != 2 or not why.strip():
            faults.append(f"tests/checks/map_names.txt:{number}: is not \"file name # why\"")
        else:
            allowed[tuple(what.split())] = False
    return allowed, faults


def names_in(code, names):
    """(name, position) of what is a fault in a file."""
    found = {}
    for match in LITERAL.finditer(code):
        text = match.group(1)
        if (text in names and text not in ALSO_WORDS) or text.startswith("shape-modulus"):
            found[match.start()] = text
    for match in COMPARED.finditer(code):
        found[match.start(1) - 1] = match.group(1)
    return sorted((position, name) for position, name in found.items())


def check(root):
    names = names_of(root)
    allowed, faults = allowed_of(root / "tests/checks/map_names.txt")
    files = sorted(
        path for folder in ("core", "native", "web") for path in (root / folder).rglob("*")
        if path.suffix in SUFFIXES and path.is_file() and root / "core/maps" not in path.parents)
    for path in files:
        name = str(path.relative_to(root))
        code = without_comments(path.read_text(encoding="utf-8"))
        for position, text in names_in(code, names):
            if (name, text) in allowed:
                allowed[name, text] = True
            else:
                faults.append(f"{name}:{line_of(code, position)}: \"{text}\" is one map's: ask a "
                              "property of its MapInfo")
    faults += [f"tests/checks/map_names.txt: {file} does not name \"{text}\" any more"
               for (file, text), met in allowed.items() if not met]
    return names, faults


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    names, faults = check(root)
    for fault in faults:
        print(fault)
    print(f"{len(names)} names of maps, {len(faults)} faults")
    return 1 if faults or not names else 0


if __name__ == "__main__":
    sys.exit(main())
