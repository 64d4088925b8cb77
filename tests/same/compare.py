# SPDX-License-Identifier: MIT
"""Fails when two programs do not print the same hashes of pictures and fields.

Run as: compare.py NATIVE_PROGRAM RUNNER SCRIPT: the second is run as "RUNNER SCRIPT".
"""

import os
import subprocess
import sys

native, runner, script = sys.argv[1:4]
if not os.path.exists(script):
    print(f"SKIPPED: {script} is not built; scripts/build web makes it")
    sys.exit(77)
ours = subprocess.run([native], capture_output=True, text=True, check=True).stdout.split("\n")
theirs = subprocess.run([runner, script], capture_output=True, text=True, check=False)
lines = theirs.stdout.split("\n")
different = [(a, b) for a, b in zip(ours, lines) if a != b]
for a, b in different:
    print("native:", a, "\n   web:", b)
if theirs.returncode != 0 or different or len(ours) != len(lines) or len(ours) < 20:
    print(theirs.stderr)
    sys.exit(f"{len(different)} of {len(ours)} hashes differ")
print(f"{len(ours) - 1} hashes of fields and pictures are the same")
for line in ours:
    if "PNG" in line:
        print(line)
