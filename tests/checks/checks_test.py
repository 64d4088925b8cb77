#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The checks can fail: each is shown what it must find, and what it must leave alone."""
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import catalogue
import dependencies
import glyphs
import kernel_symbols
import map_names
import sizes
import texts
import tracked_files

HERE = pathlib.Path(__file__).resolve().parent


class Glyphs(unittest.TestCase):

    def faults(self, name, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            (root / "core/cmake").mkdir(parents=True)
            (root / "core/cmake/fonts.cmake").write_text(
                'string(JOIN "," letters\n    U+0020-007E U+00B0 U+2713)\n')
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            return glyphs.check(root)[1]

    def test_finds(self):
        self.assertEqual(len(self.faults("core/ui/a.cpp", 'f("\u2717 no");\n')), 1)
        self.assertEqual(len(self.faults("core/i18n/es.json", '{"a": "\u00f1"}\n')), 1)
        self.assertEqual(len(self.faults("lessons/1-a.en.md", "\u2192\n")), 1)

    def test_leaves_alone(self):
        self.assertEqual(self.faults("core/ui/a.cpp", 'f("\u2713 90\u00b0");  // \u2192\n'), [])


class Dependencies(unittest.TestCase):

    def faults(self, name, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            (root / "tests/checks").mkdir(parents=True)
            shutil.copy(HERE / "dependencies.txt", root / "tests/checks")
            path = root / name
            path.parent.mkdir(parents=True)
            path.write_text(text)
            return dependencies.check(root)[1]

    def test_finds(self):
        for name, text in [
            ("core/math/a.h", '#include "maps/catalogue.h"\n'),
            ("core/maps/deep/a.h", '  #  include "fields/evaluate.h"\n'),
            ("core/fields/a.h", '#include "colour/palette.h"\n'),
            ("core/shape/a.cpp", '#include "io/files.h"\n'),
            ("core/math/a.h", '#include "complex.h"\n'),
            ("native/a.h", '#include "nowhere/b.h"\n'),
            ("core/math/a.h", '#include "../math/complex.h"\n'),
            ("core/nowhere/a.h", "\n"),
            ("core/base/a.cpp", "#ifdef __EMSCRIPTEN__\n"),
            ("core/base/a.cpp", "// like ImGui\n"),
            ("core/base/a.cpp", "#include <GLFW/glfw3.h>\n"),
            ("core/base/a.cpp", "#include <GLES3/gl3.h>\n"),
            ("core/base/a.cpp", "double a = std::exp(1.0);\n"),
            ("core/base/a.cpp", "double a = std :: atan2 (1.0, 2.0);\n"),
            ("core/base/a.cpp", "double a = ::sin(1.0);\n"),
            ("core/base/a.cpp", "float a = std::powf(1, 2);\n"),
            ("core/base/a.cpp", "#include <random>\n"),
            ("core/base/a.cpp", "#include <math.h>\n"),
            ("core/base/a.cpp", "auto r = std::from_chars(a, b, c);\n"),
            ("core/base/a.cpp", "throw 1;\n"),
        ]:
            self.assertTrue(self.faults(name, text), text)

    def test_leaves_alone(self):
        for name, text in [
            ("core/maps/a.h", '#include "math/complex.h"\n#include "maps/b.h"\n'),
            ("core/base/a.cpp", "double a = std::sqrt(2.0) + exp(versorium::log(2.0));\n"),
            ("core/base/a.cpp", "// std::exp differs, and so does <random>\n"),
            ("core/base/a.cpp", "/* throw\n std::sin( */\n"),
            ("core/base/a.cpp", "double expected = stdexp(2);\n"),
            ("native/a.h", '#include "a.h"\n'),
            ("native/a.cpp", '#include "plate/plate.h"\ntry {} catch (int) {}\n'),
            ("web/a.cpp", "#include <emscripten/emscripten.h>\n"),
        ]:
            self.assertEqual(self.faults(name, text), [], text)

    def test_line_numbers(self):
        fault, = self.faults("core/base/a.cpp", "/* one\n two */\n#include \"maps/a.h\"\n")
        self.assertTrue(fault.startswith("core/base/a.cpp:3:"), fault)

    def test_no_cycle(self):
        rules, faults = dependencies.read_rules(HERE / "dependencies.txt")
        self.assertEqual(faults, [])
        for room, allowed in rules.items():
            for other in allowed:
                self.assertNotIn(room, rules[other])


class Catalogue(unittest.TestCase):

    def faults(self, header, listing):
        with tempfile.TemporaryDirectory() as folder:
            maps = pathlib.Path(folder) / "core/maps"
            maps.mkdir(parents=True)
            (maps / "a.h").write_text(header)
            (maps / "catalogue.txt").write_text(listing)
            return catalogue.check(pathlib.Path(folder))[1]

    HEADER = "struct One {\n    static constexpr MapInfo info{};\n};\ntemplate <class A>\n" \
             "struct Two {\n    static constexpr MapInfo info{};\n};\nstruct Other {};\n"

    def test_all(self):
        self.assertEqual(self.faults(self.HEADER, "# maps\na.h One\na.h Two<int>\n"), [])
        self.assertEqual(len(self.faults(self.HEADER, "a.h One\n")), 1)
        self.assertEqual(len(self.faults(self.HEADER, "a.h One\na.h Two<int>\na.h Other\n")), 1)


class MapNames(unittest.TestCase):
    HEADER = 'struct A {\n static constexpr MapInfo info{.name = "planar", .title = ""};\n};\n' \
             'struct B {\n static constexpr MapInfo info{\n.name = kC ? "power" : "other-map",};\n};\n'

    def faults(self, code, allowed=""):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("core/maps", "core/scene", "tests/checks"):
                (root / name).mkdir(parents=True)
            (root / "core/maps/a.h").write_text(self.HEADER)
            (root / "core/scene/a.cpp").write_text(code)
            (root / "tests/checks/map_names.txt").write_text(allowed)
            return map_names.check(root)[1]

    def test_finds(self):
        for code in ['if (info.name == "planar")', 'const char* a = "other-map";',
                     'auto* a = findMap("power");', 'if (scene.map != "power")',
                     'if (map.info.formula == "z^2 + c")', 'f("shape-modulus-quadratic");']:
            self.assertEqual(len(self.faults(code)), 1, code)

    def test_leaves_alone(self):
        for code in ['f("power", "planar presets");', '// "planar"\n', 'if (info.planarCoefficients)']:
            self.assertEqual(self.faults(code), [], code)

    def test_allowed(self):
        line = "core/scene/a.cpp planar # because\n"
        self.assertEqual(self.faults('f("planar");', line), [])
        self.assertEqual(len(self.faults('f();', line)), 1)
        self.assertEqual(len(self.faults('f();', "core/scene/a.cpp planar\n")), 1)


class Sizes(unittest.TestCase):

    def faults(self, code, allowed=""):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "core/scene").mkdir(parents=True)
            (root / "tests/checks").mkdir(parents=True)
            (root / "core/scene/a.cpp").write_text(code)
            (root / "tests/checks/sizes.txt").write_text(allowed)
            return sizes.check(root)[1]

    LONG = "    f();\n" * 80

    def test_finds(self):
        for head in ["void f() {", "template <int W, class B = A<int>>\nvoid f(B b = {}) {",
                     "namespace a {\nMACRO(x)\nnamespace {\nint A::f(int a) const {",
                     "struct A {\n  A(int a) : a_{a}, b_(a) {", "const T& table() {\n static const T t = [] {"]:
            closing = "}" * head.count("{")
            self.assertEqual(len(self.faults(head + "\n" + self.LONG + closing)), 1, head)
        self.assertEqual(len(self.faults("int a;\n" * 401)), 1)

    def test_leaves_alone(self):
        short = "void f() {\n" + "    f();\n" * 78 + "}\n"
        for code in [short, short * 4, "namespace a {\n" + short * 4 + "}",
                     "struct A {\n" + short * 4 + "};", '// void f() {\nconst char* a = "void f() {";\n' + short,
                     "constexpr T kTable[] = {\n" + "    {f(1)},\n" * 90 + "};"]:
            self.assertEqual(self.faults(code), [], code[:40])

    def test_allowed(self):
        long = "void f() {\n" + self.LONG + "}"
        self.assertEqual(self.faults(long, "core/scene/a.cpp f # because\n"), [])
        self.assertEqual(len(self.faults(long, "core/scene/a.cpp g # because\n")), 2)
        self.assertEqual(len(self.faults("", "core/scene/a.cpp f # because\n")), 1)
        self.assertEqual(len(self.faults(long, "core/scene/a.cpp f\n")), 2)


class KernelSymbols(unittest.TestCase):
    TABLES = "".join(f"0000 T versorium::{table}_v3_exact()\n"
                     for table in ("escape", "escape_float", "advance", "advance_dual"))

    def test_all(self):
        faults = lambda listing: list(kernel_symbols.faults_of(listing, "v3_exact"))
        self.assertEqual(faults(self.TABLES + "00 W versorium::v3_exact::f()\n00 t memcpy\n"), [])
        self.assertEqual(len(faults(self.TABLES + "00 W std::vector<int>::size() const\n")), 1)
        self.assertEqual(len(faults(self.TABLES + "00 W versorium::baseline::f()\n")), 1)
        self.assertEqual(faults(self.TABLES + "00 u versorium::Form::kPlaces\n"), [])
        self.assertEqual(len(faults(self.TABLES + "00 T versorium::v4_exact::f()\n")), 1)
        self.assertEqual(len(faults("")), 4)


class Texts(unittest.TestCase):

    def faults(self, code, entries, name="core/ui/a.cpp"):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            for path, text in [(name, code), ("core/i18n/es.json", entries)]:
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text, encoding="utf-8")
            return texts.check(root)[2]

    def test_finds(self):
        undo = '{"Undo": "Deshacer"}'
        for code, entries in [
            ('b(tr("Undo"), tr("Redo"));', undo),
            ('b(tr("Un" "do"));', "{}"),
            ('heading("Colours");', "{}"),
            ('all.choice("id", "label", now, {"one", "two"}, [] { f(); });', '{"label": "x", "one": "x"}'),
            ('context.say("It moved");', "{}"),
            ('f(trLater("Undo")); ImGui::Button("Undo");', undo),
            ('ImGui::TextDisabled("%s", tr("Undo")), ImGui::Text("So it is");', undo),
            ('const char* text = tr("Undo"), *other = "words of no function";', undo),
            ('return tr("Undo"), Status::usage("a shape is " + name + " here");', undo),
            ('b(tr("Undo"));', '{"Undo": "Deshacer", "Redo": "Rehacer"}'),
            ('b(tr("Undo"));', '{"Undo": "Deshacer", "Undo": "Otra vez"}'),
            ('b(tr("Undo"));', '{"Undo": " "}'),
            ('b(tr("Undo"));', '{"Undo": "Deshacer",}'),
            ('b(tr("{1} of {2} views", {a, b}));', '{"{1} of {2} views": "{1} vistas"}'),
            ('b(tr("%.2f pieces"));', '{"%.2f pieces": "%d trozos"}'),
        ]:
            self.assertEqual(len(self.faults(code, entries)), 1, code)

    def test_leaves_alone(self):
        for code, entries in [
            ('// ImGui::Button("Undo")\nb(tr("Undo"));', '{"Undo": "Deshacer"}'),
            ('heading("Colours"); explain("colour by"); PushID("palette editor");',
             '{"Colours": "Colores"}'),
            ('say(tr("{1} of {2} views", {a, b}));', '{"{1} of {2} views": "de {2} vistas, {1}"}'),
            ('b(tr("Un" "do")); ImGui::Button("##x"); ImGui::Button("+");', '{"Undo": "Deshacer"}'),
            ('f(trLater("Undo"), Status::usage("a " + (b ? "long" : "short") + " word, " + c));',
             '{"Undo": "Deshacer", "a long word, {1}": "x{1}", "a short word, {1}": "y{1}"}'),
        ]:
            self.assertEqual(self.faults(code, entries), [], code)


class TrackedFiles(unittest.TestCase):

    def test_all(self):
        faults = lambda name, text: list(tracked_files.check_text(name, text))
        begin = "// SPDX-License-Identifier: MIT\n"
        self.assertEqual(faults("core/a.h", begin + "#pragma once\n"), [])
        self.assertEqual(faults("a.md", "See tests/wor" "k/a and https://x.org/home/a\n"), [])
        self.assertEqual(len(faults("a.md", "It is in /wor" "k/main/a.\n")), 1)
        self.assertEqual(len(faults("a.sh", "curl https://registry.npm" "js.org/a\n")), 1)
        self.assertEqual(len(faults("core/a.cpp", "int a;\n")), 1)
        self.assertEqual(len(faults("core/a.h", begin + "int a;\n")), 1)
        self.assertEqual(len(faults("core/a.cpp", begin + "// TO" "DO\n")), 1)
        self.assertEqual(len(faults("core/a.cpp", begin + "int a; \n")), 1)


if __name__ == "__main__":
    unittest.main()
