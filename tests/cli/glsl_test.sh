#!/usr/bin/env bash
# The reference compiler takes the shader of every map: glsl_test.sh VERSORIUM
set -euo pipefail
versorium=$1
if ! command -v glslangValidator >/dev/null; then
    echo "SKIPPED: glslangValidator is not there: run scripts/setup (package glslang-tools)"
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The validator must be able to refuse.
printf '#version 300 es\nprecision highp float;\nvoid main() { int a = 1.0; }\n' >"$folder/bad.frag"
if glslangValidator -S frag "$folder/bad.frag" >/dev/null; then
    echo "glslangValidator takes a shader that is wrong"
    exit 1
fi

names=$("$versorium" maps --json | python3 -c '
import json, sys
for map in json.load(sys.stdin): print(map["name"])')
count=0
failures=0
for name in $names; do
    shader=$folder/$name.frag
    "$versorium" glsl "$name" >"$shader"
    count=$((count + 1))
    if ! glslangValidator -S frag "$shader" >"$folder/log"; then
        echo "$name:"
        cat "$folder/log"
        failures=$((failures + 1))
    fi
done
echo "$count shaders, $failures refused"
((count > 0 && failures == 0))
