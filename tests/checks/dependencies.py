#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The dependency rule: which room may include which, and what the core must never name.

A room may be parted: "ui/session" is a room within ui, with rules of its own beside those of ui.

dependencies.py [ROOT] reads tests/checks/dependencies.txt and every C++ file of core, native and web.
"""
import pathlib
import re
import sys

SUFFIXES = {".h", ".hpp", ".inc", ".c", ".cc", ".cpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
ANGLED = re.compile(r"^\s*#\s*include\s*<([^>]+)>", re.M)

# The core knows no platform, not even in a comment.
PLATFORM_WORDS = re.compile(r"__EMSCRIPTEN__|emscripten[./]|imgui|GLFW|\bGL(ES[23]?)?/gl|\bX11/", re.I)
# But for the rooms of the studio, which draw with them.
STUDIO_WORDS = {"gpu": {"gles3/gl"}, "ui": {"gles3/gl", "imgui"}}
STUDIO_HEADERS = {"ui": {"imgui.h", "imgui_internal.h"}}
# Parts of the studio that draw nothing.
WITHOUT_IMGUI = {"ui/host", "ui/session", "ui/controls"}
IMGUI_WORDS = re.compile(r"imgui|\bIm(?:Gui|Vec|Draw|Texture|U32|COL)\w*", re.I)
# No function of <cmath> whose last bit depends on the library: math/elementary.h has the project's.
INEXACT = (
    "exp exp2 expm1 log log2 log10 log1p sin cos tan asin acos atan atan2 sinh cosh tanh asinh "
    "acosh atanh pow cbrt hypot fma erf erfc tgamma lgamma"
).split()
INEXACT_CALL = re.compile(
    r"(?<![\w:])(?:std\s*::|::|__builtin_)\s*((?:%s)[fl]?)\b" % "|".join(INEXACT))
# What the page's compiler lacks; its tests are built by it as well.
MISSING = [
    (re.compile(r"\bstd\s*::\s*from_chars\b"), "is deleted for double in libc++ 13: use base/json.h"),
    (re.compile(r"\bstd\s*::\s*(?:bit_cast|format|jthread|ranges)\b"), "is not in libc++ 13"),
]
FORBIDDEN = [
    (INEXACT_CALL, "is a transcendental of <cmath>: use math/elementary.h"),
    *MISSING,
    (re.compile(r"\b(?:try\s*\{|catch\s*\(|throw\b)"), "is an exception: use base/status.h"),
]
FORBIDDEN_HEADERS = {
    "random": "draws other numbers with another library: use base/random.h",
    "math.h": "use <cmath> for what is exact and math/elementary.h for the rest",
    "iostream": "the core prints nothing",
    "format": "is not in libc++ 13",
    "ranges": "is not in libc++ 13",
}


def read_rules(path):
    """room -> rooms that it may include; a name must stand above the line that uses it."""
    rules, faults = {}, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        room, colon, names = line.partition(":")
        allowed = set(names.split())
        room = room.strip()
        if not colon:
            faults.append(f"{path}:{number}: \"{line}\" is not \"room: rooms\"")
            continue
        if allowed == {"*"}:
            allowed = {name for name in rules if name != "native" and "/" not in name}
        for name in sorted(allowed - rules.keys()):
            faults.append(f"{path}:{number}: {room} names {name}, which does not stand above it")
        if "/" in room and any(name.split("/")[0] != room.split("/")[0] for name in allowed):
            faults.append(f"{path}:{number}: {room} may name parts of its own room alone")
        rules[room] = allowed
    return rules, faults


def without_comments(text):
    """Comments become spaces, so that line numbers stay; strings and raw strings stay as they are."""
    token = re.compile(
        r'R"([^(\s\\]{0,16})\((?:.|\n)*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''
        r"|//[^\n]*|/\*(?:.|\n)*?\*/")

    def blank(match):
        found = match.group(0)
        return re.sub(r"[^\n]", " ", found) if found[0] == "/" else found

    return token.sub(blank, text)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def room_of(path, root):
    parts = path.relative_to(root).parts
    return parts[1] if parts[0] == "core" else parts[0]


def part_of(path, root):
    """"ui/session" of core/ui/session/x.h; nothing of a file that stands in no part."""
    parts = path.relative_to(root).parts
    return "/".join(parts[1:3]) if parts[0] == "core" and len(parts) > 3 else None


def check_parts(path, root, rules, code):
    """Within a room that has parts, each part includes only those that its rule names."""
    name, part = path.relative_to(root), part_of(path, root)
    if not part or not any(rule.startswith(part.split("/")[0] + "/") for rule in rules):
        return
    if part not in rules:
        yield f"{name}: the part {part} is not in tests/checks/dependencies.txt"
        return
    for match in INCLUDE.finditer(code):
        target = "/".join(match.group(1).split("/")[:2])
        if not match.group(1).startswith(part.split("/")[0] + "/") or target == part:
            continue
        where = f"{name}:{line_of(code, match.start(1))}"
        if target not in rules:
            yield f'{where}: "{match.group(1)}" stands above the parts: {part} must not include it'
        elif target not in rules[part]:
            yield f"{where}: {part} must not include {target}"
    if part in WITHOUT_IMGUI:
        for match in IMGUI_WORDS.finditer(code):
            yield f"{name}:{line_of(code, match.start())}: {part} knows no ImGui: {match.group(0)}"


def check_file(path, root, rules):
    name = path.relative_to(root)
    room = room_of(path, root)
    text = path.read_text(encoding="utf-8")
    code = without_comments(text)
    if room not in rules:
        yield f"{name}: the room {room} is not in tests/checks/dependencies.txt"
        return
    yield from check_parts(path, root, rules, code)
    for match in INCLUDE.finditer(code):
        target = match.group(1).split("/")[0] if "/" in match.group(1) else None
        where = f"{name}:{line_of(code, match.start(1))}"
        if room in ("native", "web") and (root / room / match.group(1)).is_file():
            continue  # its own
        if target is None or target in (".", ".."):
            if match.group(1) in STUDIO_HEADERS.get(room, ()):
                continue
            if path.relative_to(root).parts[0] == "core":
                yield f'{where}: "{match.group(1)}" is not rooted at core/'
        elif target not in rules:
            yield f'{where}: "{match.group(1)}" is of no room'
        elif target != room and target not in rules[room]:
            yield f"{where}: {room} must not include {target}"
    if path.relative_to(root).parts[0] != "core":
        return
    for match in PLATFORM_WORDS.finditer(text):
        if match.group(0).lower() in STUDIO_WORDS.get(room, ()):
            continue
        yield f"{name}:{line_of(text, match.start())}: {match.group(0)} has no place in core"
    for match in ANGLED.finditer(code):
        if match.group(1) in FORBIDDEN_HEADERS:
            where = f"{name}:{line_of(code, match.start(1))}"
            yield f"{where}: <{match.group(1)}> {FORBIDDEN_HEADERS[match.group(1)]}"
    for pattern, why in FORBIDDEN:
        if pattern is INEXACT_CALL and room in STUDIO_WORDS:
            continue  # where a mark is drawn on the screen is no result
        for match in pattern.finditer(code):
            yield f"{name}:{line_of(code, match.start())}: {match.group(0).strip()} {why}"


def check_test(path, root):
    code = without_comments(path.read_text(encoding="utf-8"))
    for pattern, why in MISSING:
        for match in pattern.finditer(code):
            yield f"{path.relative_to(root)}:{line_of(code, match.start())}: {match.group(0)} {why}"


def check(root):
    rules, faults = read_rules(root / "tests/checks/dependencies.txt")
    files = sorted(
        path for folder in ("core", "native", "web") for path in (root / folder).rglob("*")
        if path.suffix in SUFFIXES and path.is_file())
    for path in files:
        faults.extend(check_file(path, root, rules))
    for path in sorted((root / "tests").rglob("*")):
        if path.suffix in SUFFIXES:
            faults.extend(check_test(path, root))
    return files, faults


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    files, faults = check(root)
    for fault in faults:
        print(fault)
    if not files:
        print(f"{root} has no C++ files in core, native or web")
        return 1
    print(f"{len(files)} files, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
