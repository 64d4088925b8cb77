#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No function that is compiled for one instruction set can be linked into code for another.

kernel_symbols.py NM NAME=OBJECT,OBJECT…: every symbol of the OBJECTs that the linker could share
(global or weak) has the namespace NAME in its name, but for the functions that hand out the tables.
"""
import re
import subprocess
import sys


def faults_of(listing, name):
    tables = {f"versorium::{table}_{name}()"
              for table in ("escape", "escape_float", "advance", "advance_dual")}
    seen = set()
    for line in listing.splitlines():
        if not line or line.endswith(":"):
            continue  # nm names each file
        kind, symbol = re.match(r"(?:[0-9a-f]+)?\s+(\S)\s+(.*)", line).groups()
        # Constants hold the same bytes whoever made them; only code differs.
        if kind not in "TWi":
            continue  # local to the object, or data
        if symbol in tables:
            seen.add(symbol)
        elif not re.search(rf"\bversorium::{name}::", symbol):
            yield f"{name}: {kind} {symbol}"
    for missing in sorted(tables - seen):
        yield f"{name}: {missing} is not there"


def main():
    nm, *objects = sys.argv[1:]
    faults = []
    for item in objects:
        name, paths = item.split("=", 1)
        listing = subprocess.run([nm, "-C", "--defined-only", *paths.split(",")],
                                 check=True, text=True, stdout=subprocess.PIPE).stdout
        faults.extend(faults_of(listing, name))
    for fault in faults:
        print(fault)
    print(f"{len(objects)} kernels, {len(faults)} symbols shared with other code")
    return 1 if faults or not objects else 0


if __name__ == "__main__":
    sys.exit(main())
