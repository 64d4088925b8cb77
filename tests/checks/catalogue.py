#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every map that a header of core/maps defines is in core/maps/catalogue.txt, and nothing else is.

A map is a struct with a `static constexpr MapInfo info`. catalogue.py [ROOT]
"""
import pathlib
import re
import sys

STRUCT = re.compile(r"^(?:struct|class)\s+(\w+)[^;]*?\{", re.M)
INFO = re.compile(r"\bstatic\s+constexpr\s+MapInfo\s+info\b")


def maps_of(header):
    """The structs of a header that have a MapInfo: the nearest struct that begins before it."""
    text = header.read_text(encoding="utf-8")
    structs = [(match.start(), match.group(1)) for match in STRUCT.finditer(text)]
    found = []
    for info in INFO.finditer(text):
        before = [name for start, name in structs if start < info.start()]
        found.append(before[-1] if before else "?")
    return found


def check(root):
    folder = root / "core/maps"
    listed = set()
    for line in (folder / "catalogue.txt").read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            header, name = line.split(None, 1)
            listed.add((header, re.match(r"\w+", name).group(0)))
    defined = {(header.name, name) for header in folder.glob("*.h") for name in maps_of(header)}
    faults = [
        f"core/maps/{header}: the map {name} is not in core/maps/catalogue.txt: add the line "
        f'"{header} {name}"' for header, name in sorted(defined - listed)
    ]
    faults += [
        f"core/maps/catalogue.txt: {name} of {header} is no struct with a MapInfo"
        for header, name in sorted(listed - defined)
    ]
    return defined, faults


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    defined, faults = check(root)
    for fault in faults:
        print(fault)
    print(f"{len(defined)} maps, {len(faults)} faults")
    return 1 if faults or not defined else 0


if __name__ == "__main__":
    sys.exit(main())
