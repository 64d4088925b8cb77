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
shader=$folder/colours.frag
"$versorium" glsl quadratic --pass colours >"$shader"
count=$((count + 1))
if ! glslangValidator -S frag "$shader" >"$folder/log"; then
    echo "colours:"
    cat "$folder/log"
    failures=$((failures + 1))
fi
# What users type reaches the shader through the tape alone.
while IFS= read -r formula; do
    shader=$folder/formula.frag
    "$versorium" glsl "$formula" >"$shader"
    count=$((count + 1))
    if ! glslangValidator -S frag "$shader" >"$folder/log"; then
        echo "$formula:"
        cat "$folder/log"
        failures=$((failures + 1))
    fi
done <<'FORMULAS'
z^2 + c
z^3 - a*z + conj(c)
c*sin(z) + tan(z)/sinh(z) - cosh(tanh(z))
asin(z) + acos(z) + atan(z) + asinh(z) + acosh(z) + atanh(z)
log(z)*sqrt(z)^z + exp(c) - z^-3 + z^2.5 + z^n
if(abs(z) < 1 and not (re(z) >= 2 or im(z) == 3), z, 1 < 2 ? c : 0)
max(re(z), 1)*min(arg(z), 2) + floor(norm(z))*i + 1e30 + 1e-30 + 1e100
sqrt(2)*sin(1)*z + log(-1) + c
x' = 1 - a*x^2 + y, y' = b*x
x' = y, y' = atan2(y, x)^n + abs(x)^1.5; n: whole = 2
q^2 + c
exp(q)*log(c) + q^a - sin(q)/q.x*im(q) + i*j
r*x*(1 - x)
z^2 - 1
FORMULAS
echo "$count shaders, $failures refused"
((count > 0 && failures == 0))
