#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Functions of at most 80 lines, files of at most 400, but for those that sizes.txt has a reason
for. A longer one is to be cut along its meaning, or owes a line there.

sizes.py [ROOT]
"""
import pathlib
import re
import sys

from dependencies import SUFFIXES, line_of, without_comments

FUNCTION_LINES = 80
FILE_LINES = 400
FOLDERS = ("core", "native", "web")
TEXTS = SUFFIXES | {".js", ".mjs"}
# Blocks that hold functions; macros may stand before a namespace.
SCOPE = re.compile(r"^(?:class|struct|union|enum|extern)\b|(?:^|\n)\s*(?:inline\s+)?namespace\b[^()]*$")
LITERAL = re.compile(r'R"([^(\s\\]{0,16})\((?:.|\n)*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'')


def without_literals(code):
    return LITERAL.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), code)


def without_templates(head):
    """What stands behind template <…>."""
    while head.startswith("template"):
        depth, at = 0, head.find("<")
        while at < len(head):
            depth += {"<": 1, ">": -1}.get(head[at], 0)
            at += 1
            if depth == 0:
                break
        head = head[at:].lstrip()
    return head


def name_of(head):
    """The name of the function that a block with this head belongs to; None where it is no function."""
    head = without_templates(head)
    if SCOPE.search(head) or "(" not in head:
        return None
    before = head[:head.index("(")]
    if re.search(r"[^=!<>]=[^=]", before) and "operator" not in before:
        return None  # a value that is initialised
    found = re.search(r"([\w:~]+|operator\W+)\s*$", before)
    return found.group(1).strip() if found else None


def functions_of(text):
    """(name, line, lines) of every function, nested ones as parts of theirs."""
    code = without_literals(re.sub(r"(?m)^[ \t]*#(?:.*\\\n)*.*$", lambda match: re.sub(
        r"[^\n]", " ", match.group(0)), without_comments(text)))
    found, inside, depth, round_depth, begin = [], None, 0, 0, 0
    for at, sign in enumerate(code):
        if sign == "(":
            round_depth += 1
        elif sign == ")":
            round_depth -= 1
        elif sign == "{":
            depth += 1
            if inside is None and round_depth == 0:
                head = code[begin:at]
                name = name_of(re.sub(r"\b(?:public|private|protected)\s*:", "", head).strip())
                if name:
                    inside = (name, line_of(code, at - len(head.lstrip())), depth)
            if round_depth == 0:
                begin = at + 1
        elif sign == "}":
            if inside and depth == inside[2]:
                found.append((inside[0], inside[1], line_of(code, at) - inside[1] + 1))
                inside = None
            depth -= 1
            if round_depth == 0:
                begin = at + 1
        elif sign == ";" and round_depth == 0:
            begin = at + 1
    return found


def allowed_of(path):
    allowed, faults = {}, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        what, mark, why = line.partition("#")
        if len(what.split()) not in (1, 2) or not why.strip():
            faults.append(f"tests/checks/sizes.txt:{number}: is not \"file [function] # why\"")
        else:
            allowed[tuple(what.split())] = False
    return allowed, faults


def check(root):
    allowed, faults = allowed_of(root / "tests/checks/sizes.txt")
    files = sorted(path for folder in FOLDERS for path in (root / folder).rglob("*")
                   if path.suffix in TEXTS and path.is_file())
    for path in files:
        name = str(path.relative_to(root))
        text = path.read_text(encoding="utf-8")
        long = []
        if text.count("\n") > FILE_LINES:
            long.append(((name,), f"{name}: {text.count(chr(10))} lines"))
        if path.suffix in SUFFIXES:
            long += [((name, function), f"{name}:{line}: {function} has {lines} lines")
                     for function, line, lines in functions_of(text) if lines > FUNCTION_LINES]
        for key, said in long:
            if key in allowed:
                allowed[key] = True
            else:
                faults.append(f"{said}: cut it, or say why not in tests/checks/sizes.txt")
    faults += [f"tests/checks/sizes.txt: {' '.join(key)} is short enough now: take it away"
               for key, met in allowed.items() if not met]
    return files, faults


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    files, faults = check(root)
    for fault in faults:
        print(fault)
    print(f"{len(files)} files, {len(faults)} faults")
    return 1 if faults or not files else 0


if __name__ == "__main__":
    sys.exit(main())
