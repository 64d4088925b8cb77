#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The interface is complete in every language of core/i18n: each text that the studio or the page
shows has an entry, each entry is used, and both speak of the same places {1}, {2} …

Texts are found where they are written: in tr() and trLater(), in the functions that translate what
they are given (SINKS), in the tables of the core that the interface shows, and in words.tr() for
plates. A literal of words in core/ui that is none of these is a fault too, unless it is the name of a thing (NAMES).

texts.py [ROOT] lists the faults; with --missing LANGUAGE it prints what that language lacks, as JSON.
"""
import json
import pathlib
import re
import sys

from dependencies import line_of, without_comments

LITERAL = re.compile(r'"((?:\\.|[^"\\\n])*)"')
WORDS = re.compile(r"[A-Za-z]{2}")

# Functions of core/ui whose arguments, by their places, are translated within.
SINKS = {
    "tr": [0], "trLater": [0], "heading": [0], "section": [0], "labelled": [0], "named": [0],
    "choose": [0, 3, 4], "chooseName": [0, 4], "numberField": [2], "say": [0], "begin": [0],
    "all.number": [1], "all.choice": [1, 3], "all.toggle": [1], "all.colour": [1], "all.text": [1],
    "all.command": [1], "toolButton": [1], "radio": [0], "kind": [0], "tab": [0], "button": [0],
    "either": [0, 1], "dragged": [0], "gradientControls": [1], "chooseMore": [1],
    "collectGradient": [1], "colourField": [0], "said": [0], "row": [0, 1], "rowButton": [0], "label": [0],
}
SINKS_OF = {
    "controls.cpp": {"word": [1, 3]},
    "controls_motion.cpp": {"number": [1]},
    "controls_ensemble.cpp": {"more": [1]},
    "controls_versor.cpp": {"whole": [1], "real": [1]},
    "ensemble_panel.cpp": {"whole": [2], "real": [2]},
    "layers_panel.cpp": {"number": [1]},
    "roots_panel.cpp": {"wholeField": [5], "realField": [5]},
}
# Functions whose arguments are names of things: controls, settings, scenes, files.
NAMES = {
    "explain": [0], "helpOf": [0], "numberField": [1], "numberCell": [1], "InvisibleButton": [0],
    "all.number": [0], "all.choice": [0], "all.toggle": [0], "all.colour": [0], "all.text": [0],
    "all.command": [0], "PushID": [0], "BeginChild": [0], "BeginTable": [0], "BeginCombo": [0],
    "toolButton": [2], "radio": [1], "rowButton": [1], "button": [1], "either": [3], "dragged": [1], "step": [1],
    "choose": [1], "chooseName": [1], "chosenShape": [1], "shapeText": [1], "colourField": [2],
    "chooseMore": [2], "numberBox": [1], "more": [0], "whole": [0, 1, 3], "real": [0, 1, 3],
    "wholeField": [1], "realField": [1], "number": [0], "run": [0], "pressed": [0], "GetID": [0], "BeginPopup": [0],
}
# Raw widgets: a literal with letters in the place is a fault.
RAW = {
    "ImGui::" + name: [0] for name in (
        "Button SmallButton Checkbox RadioButton MenuItem Selectable TextUnformatted TextWrapped "
        "Text TextDisabled BulletText TreeNode TreeNodeEx CollapsingHeader Begin BeginPopupModal "
        "BeginMenu BeginTabItem SetTooltip InputInt InputText DragInt SliderInt LabelText "
        "SeparatorText TableSetupColumn ColorEdit3 ColorEdit4 Combo").split()
}
RAW.update({"ImGui::InputTextWithHint": [0, 1], "ImGui::BeginCombo": [0, 1], "ImGui::SliderInt": [0, 4],
            "ImGui::DragInt": [0, 5], "dragNumber": [0], "TextColored": [1], "drawText": [3]})
# What the interface shows of other rooms: file, and what stands before a text there.
TABLES = [
    ("core/maps/*.h", r"\.(?:title|help|source|label)\s*=\s*"),
    ("core/maps/formula_map.cpp", r"\.(?:title|help|source)\s*=\s*"),
    ("core/fields/field_names.cpp", r"\{FieldName::\w+,\s*wordOf\([^)]*\),\s*"),
    # The words of enumerations, but for those that only files have.
    ("core/*/*.h", r"struct EnumWords<(?!(?:Value|View|Answer|Document)Kind)[\w:]+> \{\s*static constexpr [^{]*\{"),
    ("core/ui/*/*.h", r"struct EnumWords<[\w:]+> \{\s*static constexpr [^{]*\{"),
    ("core/dynamics/cycles.cpp", r"const char\* wordOf\(CycleKind kind\) \{"),
]
# Where texts of plates are written, and how they are said there.
PLATES = ["core/scene/*.cpp", "core/plate/*.cpp", "core/workspace/*.cpp", "core/lesson/*.cpp"]
WORDS_OF_PLATES = {"words.tr": [0], "words_.tr": [0], "trLater": [0]}
# Not shown, or the same everywhere.
EXEMPT = {"layer", "what", "value", "Versorium", "star(5, 0.9, 0.45)", "Mark view ", "the CPU draws this: ",
          "begin export", "cancel export", "lesson step", "teacher reset", "view tab", "strip tab",
          "draw shape", "Page Up", "Page Down"}
# Rooms whose messages the studio shows by trMessage(), and the functions that make them, with the
# place of the message from the end. What the command line alone asks for is left out.
ROOMS = "base colour dynamics gpu io lesson render scene shape trace ui workspace".split()
MESSAGES = {"Status::usage": 0, "Status::data": 0, "Status::inputOutput": 0, "fail": -1, "say": -1}
OF_THE_COMMAND_LINE = re.compile(r"--set|averaged map|ensemble varies nothing")
# Names, and formulas in words, may be said otherwise in a language, or stay.
LISTS = {"roots", "poles", "own"}
# Messages that are put together in other ways, by the system or by the page's workers.
OTHERS = {
    "cannot read {1}: {2}", "cannot write {1}: {2}", "No such file or directory", "Permission denied",
    "Is a directory", "{1} (the clipboard of this window takes only text)",
    "line {1}: {2}", "the browser did not take the file", "the worker stopped", "the computation stopped: {1}",
}
MAY = ["lessons/presets/*.json", "lessons/animations/*.json", "lessons/plates/*.json"]


def plain(text):
    """The text of a C++ literal."""
    text = re.sub(r"\\u([0-9a-f]{4})", lambda m: chr(int(m.group(1), 16)), text)
    return re.sub(r"\\(.)", lambda m: {"n": "\n", "t": "\t"}.get(m.group(1), m.group(1)), text)


def arguments(code, start):
    """The arguments of the call whose parenthesis opens at start - 1, as (text, position)."""
    depth, at, begin, found = 1, start, start, []
    while at < len(code):
        literal = LITERAL.match(code, at) if code[at] == '"' else None
        if literal:
            at = literal.end()
            continue
        if code[at] == "'" and (quoted := re.compile(r"'(?:\\.|[^'\\\n])+'").match(code, at)):
            at = quoted.end()
            continue
        if code[at] in "([{":
            depth += 1
        elif code[at] in ")]}":
            depth -= 1
            if depth == 0:
                found.append((code[begin:at], begin))
                return found
        elif code[at] == "," and depth == 1:
            found.append((code[begin:at], begin))
            begin = at + 1
        at += 1
    return found


def literals(text, position):
    """Texts with their positions; literals that stand side by side are one."""
    found = []
    for match in LITERAL.finditer(text):
        said = plain(match.group(1))
        if found and text[found[-1][2]:match.start()].strip() == "":
            found[-1] = (found[-1][0] + said, found[-1][1], match.end())
        else:
            found.append((said, position + match.start(), match.end()))
    return [(said, where) for said, where, _ in found]


def calls(code, functions):
    """(function, place, argument, position) of every call of these."""
    for name, places in functions.items():
        for match in re.finditer(r"(?<![\w.:>])" + re.escape(name) + r"\(", code) if "." not in name \
                and "::" not in name else re.finditer(r"\b" + re.escape(name) + r"\(", code):
            given = arguments(code, match.end())
            for place in places:
                if place < len(given):
                    yield name, place, *given[place]
        if "." not in name and "::" not in name:  # as a member, too
            for match in re.finditer(r"(?:\.|->|ImGui::)" + re.escape(name) + r"\(", code):
                given = arguments(code, match.end())
                for place in places:
                    if place < len(given):
                        yield name, place, *given[place]


def words_of(text):
    return WORDS.search(re.sub(r"%[-0-9.]*[a-z]+|\{[1-9]\}|##.*", "", text)) is not None


class Found:
    """Texts of the interface: where each is said first; and the faults of how they are said."""

    def __init__(self):
        self.texts, self.may, self.faults = {}, set(), []

    def add(self, text, where):
        if words_of(text):
            self.texts.setdefault(text, where)


def read_ui(found, root, path):
    code = without_comments(path.read_text(encoding="utf-8"))
    name = path.relative_to(root)
    where = lambda position: f"{name}:{line_of(code, position)}"
    named = set()
    sinks = {**SINKS, **SINKS_OF.get(path.name, {})}
    for function, place, argument, position in calls(code, sinks):
        # What is put together within comes through tr() itself.
        whole = function in ("tr", "trLater") or not re.search(r"\btr\(", argument)
        for text, at in literals(argument, position):
            if whole:
                named.add(at)
                found.add(text, where(at))
    for _, _, argument, position in calls(code, NAMES):
        named.update(at for _, at in literals(argument, position))
    # {"Undo", "Ctrl Z", …}: commands with their keys.
    for match in re.finditer(r'\{"([^"]+)",\s*"([^"]*)",\s*\[', code):
        found.add(plain(match.group(1)), where(match.start()))
        named.update((match.start(1) - 1, match.start(2) - 1))
        found.may.add(plain(match.group(2)))
    if path.name == "help.cpp":
        for match in re.finditer(r'\{("[^"]+"),\s*(("(\\.|[^"\\])*"\s*)+)\}', code):
            text = "".join(said for said, _ in literals(match.group(2), 0))
            found.add(text, where(match.start(2)))
            named.add(match.start(1))
            named.update(at for _, at in literals(match.group(2), match.start(2)))
    for function, place, argument, position in calls(code, RAW):
        for text, at in literals(argument, position):
            if at not in named and words_of(text) and text not in EXEMPT:
                named.add(at)
                found.faults.append(f'{where(at)}: {function} shows "{text}" in English: '
                                    "give it through tr()")
    # Words, not put through anything.
    for text, at in literals(code, 0):
        if at in named or text in EXEMPT or text.startswith("##"): continue
        if not re.search(r"[A-Za-z]{2,}[,;:]? [A-Za-z]{2,}", text): continue
        before = code[max(0, at - 60):at]
        if re.search(r"(Status::\w+\(\s*|#include |\+\s*|\.alias = )$", before) or "Status::" in code[
                code.rfind(";", 0, at) + 1:at]:
            continue
        found.faults.append(f'{where(at)}: "{text}" is shown in English, or the name of a thing: '
                            "give it through tr(), or name its function in tests/checks/texts.py")


def parted(expression, sign):
    """What stands between these signs of an expression, outside of brackets and literals."""
    found, depth, at, begin = [], 0, 0, 0
    while at < len(expression):
        literal = LITERAL.match(expression, at) if expression[at] == '"' else None
        if literal:
            at = literal.end()
            continue
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(expression[at], 0)
        if depth == 0 and re.match(sign, expression[at:]) and expression[at - 1:at] != ":":
            found.append(expression[begin:at])
            begin = at + 1
        at += 1
    return found + [expression[begin:]]


def sentences_of(expression):
    """The sentences that a sum of literals and values makes: values become places {1}, {2} …, a
    choice between literals becomes sentences of their own."""
    chosen = parted(expression, r"\?")
    if len(chosen) == 2:
        for branch in parted(chosen[1], r":(?!:)"):
            yield from sentences_of(branch)
        return
    parts = [[""]]
    for term in (term.strip() for term in parted(expression, r"\+")):
        term = re.sub(r"^std::string\((.*)\)$", r"\1", term, flags=re.S)
        choice = re.fullmatch(r"\(?[^\"]*\?\s*((?:\"[^\"]*\"\s*)+):\s*((?:\"[^\"]*\"\s*)+)\)?", term)
        said = ["".join(text for text, _ in literals(part, 0)) for part in choice.groups()] if choice \
            else ["".join(text for text, _ in literals(term, 0))] if term.startswith('"') else ["\0"]
        parts.append(said)
    texts = [""]
    for said in parts:
        texts = [text + part for text in texts for part in said]
    for text in texts:
        # "where: what" is parted by trMessage() itself.
        text = re.sub("^\0+(?:: |(?=[a-z0-9\"`]))", "", text)
        count = iter(range(1, 10))
        yield re.sub("\0+", lambda _: f"{{{next(count)}}}", text)


def read_messages(found, root):
    for room in ROOMS:
        for path in sorted([*root.glob(f"core/{room}/**/*.cpp"), *root.glob(f"core/{room}/**/*.h")]):
            code = without_comments(path.read_text(encoding="utf-8"))
            # What stands in the places of messages may be said as well.
            found.may.update(text for text, _ in literals(code, 0) if " " in text)
            for name, place in MESSAGES.items():
                if name == "say" and room in ("ui", "lesson"): continue
                for match in re.finditer(r"\b" + name + r"\(", code):
                    given = arguments(code, match.end())
                    if not given or '"' not in given[place][0]: continue
                    where = f"{path.relative_to(root)}:{line_of(code, match.start())}"
                    for text in sentences_of(given[place][0]):
                        if len(re.sub(r"\{[1-9]\}", "", text)) >= 6 and not OF_THE_COMMAND_LINE.search(text):
                            found.add(text, where)


def read_tables(found, root):
    for pattern, before in TABLES:
        for path in sorted(root.glob(pattern)):
            code = without_comments(path.read_text(encoding="utf-8"))
            for match in re.finditer(before, code):
                if match.group(0).endswith("{"):
                    text = arguments(code, match.end())
                    parts = [part for part, _ in text]
                    said = [t for part in parts for t, _ in literals(part, 0)]
                else:
                    said = [t for t, _ in literals(*arguments(code, match.end())[0])]
                for text in said:
                    found.add(text, f"{path.relative_to(root)}:{line_of(code, match.start())}")
    for path in sorted(path for pattern in PLATES for path in root.glob(pattern)):
        code = without_comments(path.read_text(encoding="utf-8"))
        for _, _, argument, position in calls(code, WORDS_OF_PLATES):
            for text, at in literals(argument, position):
                found.add(text, f"{path.relative_to(root)}:{line_of(code, at)}")
    found.may.update(LISTS | OTHERS)
    for path in sorted(root.glob("core/maps/*.h")):
        found.may.update(re.findall(r'\.formula = "([^"]*)"', path.read_text(encoding="utf-8")))
    for pattern in MAY:
        found.may.update(path.stem for path in root.glob(pattern))
    for path in sorted(root.glob("core/colour/*.cpp")):
        found.may.update(re.findall(r'"([a-z][a-z-]+)"', path.read_text(encoding="utf-8")))
    for path in sorted([*root.glob("web/page/*.mjs"), *root.glob("web/*.cpp")]):
        code = path.read_text(encoding="utf-8")
        for _, _, argument, position in calls(code, {"tr": [0]}):
            for text, at in literals(argument, position):
                found.add(text, f"{path.relative_to(root)}:{line_of(code, at)}")
    page = root / "web/page/index.html"
    if page.is_file():
        for text in re.findall(r' data-(?:text|label)="([^"]*)"', page.read_text(encoding="utf-8")):
            found.add(text, str(page.relative_to(root)))


def early_texts(root):
    """What the page says before the program runs: language -> [(English, other)]."""
    words = root / "web/page/words.mjs"
    code = words.read_text(encoding="utf-8") if words.is_file() else ""
    early = {}
    for match in re.finditer(r"^  (\w\w): \{\n(.*?)^  \},", code, re.S | re.M):
        early[match.group(1)] = re.findall(r'"([^"]*)":\s*"([^"]*)"', match.group(2))
    return early


def places_of(text):
    return sorted(re.findall(r"\{[1-9]\}", text)), re.findall(r"%[-0-9.]*[a-z]", text.replace("% ", ""))


def check(root):
    found = Found()
    for path in sorted(root.glob("core/ui/**/*.cpp")) + sorted(root.glob("core/ui/**/*.h")):
        read_ui(found, root, path)
    read_tables(found, root)
    read_messages(found, root)
    faults = list(found.faults)
    languages = sorted((root / "core/i18n").glob("*.json"))
    for path in languages:
        name = path.relative_to(root)
        try:
            entries = json.loads(path.read_text(encoding="utf-8"), object_pairs_hook=list)
        except json.JSONDecodeError as error:
            faults.append(f"{name}: {error}")
            continue
        seen = {}
        for english, other in entries:
            if english in seen: faults.append(f'{name}: "{english}" stands twice')
            seen[english] = other
            if places_of(english) != places_of(other):
                faults.append(f'{name}: "{english}" and "{other}" have other places {{1}}, {{2}} …')
            if not other.strip(): faults.append(f'{name}: "{english}" is empty')
            if english not in found.texts and english not in found.may:
                faults.append(f'{name}: "{english}" is used nowhere: take it away')
        for english, other in early_texts(root).get(path.stem, []):
            if seen.get(english) != other:
                faults.append(f'web/page/words.mjs: "{english}" is said otherwise in {name}')
        for text, where in found.texts.items():
            if text not in seen: faults.append(f'{name}: "{text}" of {where} is missing')
    return found, languages, faults


def main():
    options = [argument for argument in sys.argv[1:] if not argument.startswith("--")]
    if "--missing" in sys.argv:
        language = options.pop(0)
    root = pathlib.Path(options[0] if options else ".").resolve()
    found, languages, faults = check(root)
    if "--missing" in sys.argv:
        have = json.loads((root / f"core/i18n/{language}.json").read_text(encoding="utf-8"))
        print(json.dumps({text: "" for text in found.texts if text not in have}, indent=2,
                         ensure_ascii=False))
        return 0
    for fault in faults:
        print(fault)
    print(f"{len(found.texts)} texts, {len(languages)} languages beside English, {len(faults)} faults")
    return 1 if faults or not found.texts or not languages else 0


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    sys.exit(main())
