#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What no tracked file may hold: paths of one machine, hosts of packages, marks of unfinished work,
trailing white space; C++ begins with its licence, headers with #pragma once, scripts can be run.

tracked_files.py [ROOT]
"""
import pathlib
import re
import subprocess
import sys

TEXTS = [
    (re.compile(r"(?<![\w.:/}\"$*])/(?:work|home|root|Users)/[\w.]"), "a path of one machine"),
    (re.compile(r"\b(?:registry|registry-\w+)[.]npm\w+|\b(?:deb|ftp|security|packages|snapshot)[.]debian[.]"
                r"|\bpypi[.]org|pythonhosted[.]|nodesource[.]|archive[.]ubuntu|\bnpmjs[.]"
                r"|storage[.]googleapis|crates[.]io", re.I), "a host of packages"),
    (re.compile(r"\b(?:TO" r"DO|FIX" r"ME|XX" r"X)\b"), "a mark of unfinished work"),
]
CODE = {".h", ".cpp"}
# Input as others write it: line ends and characters are what they are there.
CORPUS = "tests/fuzz/corpus/"
BINARY = {".png", ".ttf", ".npy", ".f3d", ".wasm", ".stl", ".ply", ".zip", ".gz"}


def check_text(name, text):
    for pattern, what in TEXTS:
        for match in pattern.finditer(text):
            yield f"{name}:{text.count(chr(10), 0, match.start()) + 1}: {match.group(0)!r} is {what}"
    if name.startswith(CORPUS):
        return
    suffix = pathlib.PurePath(name).suffix
    if suffix in CODE and not text.startswith("// SPDX-License-Identifier: MIT\n"):
        yield f"{name}: the first line must be // SPDX-License-Identifier: MIT"
    if suffix == ".h" and "\n#pragma once\n" not in text[:120]:
        yield f"{name}: #pragma once must stand on the second line"
    if suffix != ".txt" and text and not text.endswith("\n"):
        yield f"{name}: no end of line at the end"
    for number, line in enumerate(text.split("\n"), 1):
        if line != line.rstrip() and suffix not in (".md", ".txt", ".csv", ".obj"):
            yield f"{name}:{number}: white space at the end"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    listing = subprocess.run(["git", "-C", str(root), "ls-files", "-s", "-z"], text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if listing.returncode != 0:
        print("SKIPPED: this folder is not a clone of the repository: git cannot list its files")
        return 77
    faults, count = [], 0
    for entry in filter(None, listing.stdout.split("\0")):
        mode, name = entry.split(" ", 1)[0], entry.split("\t", 1)[1]
        path = root / name
        if path.suffix in BINARY or not path.is_file():
            continue
        count += 1
        try:
            text = path.read_bytes().decode("latin-1" if name.startswith(CORPUS) else "utf-8")
        except UnicodeDecodeError:
            faults.append(f"{name}: not UTF-8")
            continue
        faults.extend(check_text(name, text))
        if text.startswith("#!") and mode != "100755":
            faults.append(f"{name}: begins with #! and cannot be run: git update-index --chmod=+x")
    for fault in faults:
        print(fault)
    print(f"{count} files, {len(faults)} faults")
    return 1 if faults or not count else 0


if __name__ == "__main__":
    sys.exit(main())
