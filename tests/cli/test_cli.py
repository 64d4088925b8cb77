# SPDX-License-Identifier: MIT
"""The command line as a user meets it: results, round trips, and what happens to bad input.

Run as: test_cli.py PROGRAM [unittest arguments]
"""

import array
import json
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
import zipfile

PROGRAM = os.path.abspath(sys.argv.pop(1))
USAGE, DATA, INPUT_OUTPUT = 2, 65, 74


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_program(self, *arguments, stdin=b""):
        return subprocess.run(
            [PROGRAM, *arguments], input=stdin, capture_output=True, timeout=120, check=False
        )

    def good(self, *arguments, stdin=b""):
        result = self.run_program(*arguments, stdin=stdin)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        self.assertEqual(result.stderr, b"", "nothing on stderr without a terminal")
        return result.stdout

    def refused(self, code, *arguments, says=(), stdin=b""):
        """One clear line, the right exit code, and nothing left behind."""
        before = sorted(os.listdir(self.folder))
        result = self.run_program(*arguments, stdin=stdin)
        message = result.stderr.decode()
        self.assertEqual(result.returncode, code, message)
        for word in (says,) if isinstance(says, str) else says:
            self.assertIn(word, message)
        if code != USAGE or message.startswith("versorium:"):
            self.assertEqual(message.count("\n"), 1, message)
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        return message

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

    def numbers(self, name):
        """The shape and the values of an .npy file of doubles."""
        content = self.read(name)
        self.assertEqual(content[:8], b"\x93NUMPY\x01\x00")
        (length,) = struct.unpack("<H", content[8:10])
        head = content[10 : 10 + length].decode()
        self.assertIn("'<f8'", head)
        values = array.array("d", content[10 + length :])
        return head, values


class Results(CommandLine):
    def test_lists(self):
        maps = json.loads(self.good("maps", "--json"))
        self.assertGreaterEqual(len(maps), 20)
        self.assertIn("mandelbulb", [one["name"] for one in maps])
        for command in ("palettes", "plates", "presets"):
            self.assertGreater(len(json.loads(self.good(command, "--json"))), 4)
        schema = json.loads(self.good("schema"))
        self.assertIn("iterations", schema["properties"])

    def test_every_value_is_listed_and_can_be_set(self):
        rows = json.loads(self.good("values", "shape-modulus", "--json"))
        self.assertGreater(len(rows), 60)
        for row in rows:
            self.assertEqual(set(row), {"path", "kind", "value", "default", "range", "words", "unit", "help"})
            self.assertTrue(row["help"], row["path"])
        listed = self.good("values", "shape-modulus").decode()
        self.assertEqual([row["path"] for row in rows], [line.split()[0] for line in listed.splitlines()])
        numbers = {row["path"]: row for row in rows if row["range"]}
        self.assertEqual(numbers["iterations"]["range"], [0, 10000000])
        changed = json.loads(self.good("values", "quadratic", "--set", "slice.center[1]=0.5", "--json"))
        self.assertEqual([row["value"] for row in changed if row["path"] == "slice.center[1]"], [0.5])
        self.refused(2, "values", "quadratic", "--set", "iteratons=5", says=["did you mean iterations?"])
        self.refused(2, "values", "quadratic", "--set", "slice.height=-1", says=["slice.height", "1e-300"])

    def test_every_preset_renders_the_same_on_any_number_of_threads(self):
        for preset in self.good("presets").decode().split():
            for threads in ("1", "3"):
                self.good("render", preset, "-o", self.path(threads), "--size", "40x30",
                          "--samples", "1", "--threads", threads)
            self.assertEqual(self.read("1"), self.read("3"), preset)

    def test_a_picture_carries_what_made_it(self):
        self.good("render", "julia", "-o", self.path("a.png"), "--size", "50x40",
                  "--set", "c=-0.8,0.156", "--set", "palette=fire", "--samples", "3")
        document = self.good("scene", self.path("a.png"))
        body = json.loads(document)["body"]
        self.assertEqual(body["parameters"]["c"], [-0.8, 0.156])
        self.assertEqual(body["colour"]["palette"], "fire")
        self.good("render", self.path("a.png"), "-o", self.path("b.png"))
        self.good("render", "-", "-o", self.path("c.png"), stdin=document)
        self.assertEqual(self.read("a.png"), self.read("b.png"))
        self.assertEqual(self.read("a.png"), self.read("c.png"))

    def test_a_palette_of_ones_own(self):
        palette = {"name": "two", "kind": "sequential", "space": "linear",
                   "stops": ["#000000", "#ff0000"]}
        file = self.write("two.json", json.dumps(palette))
        self.good("render", "julia", "-o", self.path("a.png"), "--size", "30x30",
                  "--set", "palette=" + file)
        os.remove(file)
        self.good("render", self.path("a.png"), "-o", self.path("b.png"))
        self.assertEqual(self.read("a.png"), self.read("b.png"))
        body = json.loads(self.good("scene", self.path("a.png")))["body"]
        self.assertEqual(body["colour"]["palette"]["name"], "two")
        self.refused(DATA, "render", "julia", "-o", self.path("c.png"), "--set",
                     "palette=" + self.write("bad.json", "{"), says="bad.json")

    def test_a_picture_carries_its_mesh(self):
        tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
        mesh = self.write("t.obj", tetrahedron)
        self.good("render", "shape-modulus", "-o", self.path("a.png"), "--size", "30x30",
                  "--set", "shape=" + mesh, "--set", "resolution=32")
        os.remove(mesh)
        self.good("render", self.path("a.png"), "-o", self.path("b.png"))
        self.assertEqual(self.read("a.png"), self.read("b.png"))

    def test_every_plate_at_both_widths_and_back(self):
        for plate in self.good("plates").decode().split():
            for width in ("89", "178"):
                self.good("plate", plate, "-o", self.path("a.png"), "--width", width,
                          "--dpi", "60", "--set", "samples=1", "--set", "iterations=20")
                self.assertIn(b"N", self.read("a.txt"))
            self.good("plate", self.path("a.png"), "-o", self.path("b.png"))
            self.assertEqual(self.read("a.png"), self.read("b.png"), plate)

    def test_set_in_plates_reaches_panels(self):
        self.good("plate", "shape-modulus-6", "-o", self.path("a.png"), "--dpi", "50",
                  "--set", "resolution=12", "--set", "padding=1", "--set", "b.alpha=3", "--set", "samples=1")
        panels = json.loads(self.good("scene", self.path("a.png")))["body"]["panels"]
        alphas = [panel["scene"]["parameters"]["alpha"] for panel in panels]
        self.assertEqual(alphas[1], 3)
        self.assertNotEqual(alphas[0], 3)
        self.assertEqual({panel["scene"]["shape"]["resolution"] for panel in panels}, {12})

    def test_fields_as_numbers(self):
        self.good("render", "mandelbrot", "-o", self.path("m.png"), "--size", "32x20",
                  "--save-field", "escape_step=" + self.path("n.npy"),
                  "--save-field", "versor=" + self.path("d.npy"))
        head, values = self.numbers("n.npy")
        self.assertIn("(20, 32)", head)
        self.assertEqual(max(values), 500)
        head, values = self.numbers("d.npy")
        self.assertIn("(20, 32, 2)", head)

    def test_eval_and_orbit(self):
        points = self.write("p.csv", "name,x,y\na,0.5,0.25\nb,-1,2\n")
        table = self.good("eval", "quadratic", "--points", points, "--field", "image_modulus",
                          "--set", "c=0,0").decode().split()
        self.assertEqual(table[0], "x,y,image_modulus")
        # |z²| = |z|², and both are exact here.
        self.assertEqual(float(table[1].split(",")[2]), 0.3125)
        self.assertEqual(float(table[2].split(",")[2]), 5)
        orbit = json.loads(self.good("orbit", "julia", "--at", "0,0", "-n", "3", "--json",
                                     "--set", "c=-1,0"))
        self.assertEqual([row["point"][0] for row in orbit["orbit"]], [0, -1, 0, -1])
        self.assertFalse(orbit["escaped"])

    def test_cycles(self):
        found = json.loads(self.good("cycles", "henon", "--period", "2", "--json"))["cycles"]
        saddle = [one for one in found if one["period"] == 1][-1]
        # The preset's second coordinate is the last x: the fixed point lies on the diagonal.
        self.assertAlmostEqual(saddle["points"][0][0], 0.631354, places=6)
        self.assertAlmostEqual(saddle["points"][0][1], 0.631354, places=6)
        self.assertEqual(saddle["kind"], "saddle")
        product = saddle["eigenvalues"][0][0] * saddle["eigenvalues"][1][0]
        self.assertAlmostEqual(product, -0.3, places=12)
        table = self.good("cycles", "logistic", "--set", "r=3.5", "--period", "4", "--csv",
                          "--window=-1,2").decode().splitlines()
        self.assertEqual(table[0], "cycle,period,kind,n,x,eigenvalue1.re,eigenvalue1.im")
        attracting = [row.split(",") for row in table if ",attracting," in row]
        self.assertEqual(len(attracting), 4)
        self.assertAlmostEqual(float(attracting[0][4]), 0.38281968, places=7)
        text = self.good("cycles", "julia", "--period", "3").decode()
        self.assertIn("3\tattracting", text)
        # A picture of parameters has the system of the parameters that the scene gives.
        same = self.good("cycles", "planar-set", "--period", "3", "--json")
        self.assertIn(b'"attracting"', same)

    def test_curves_of_planar_maps(self):
        self.good("manifolds", "henon", "--length", "3", "-o", self.path("m.csv"))
        rows = self.read("m.csv").decode().splitlines()
        self.assertEqual(rows[0], "manifold,curve,x,y")
        names = {row.split(",")[0] for row in rows[1:]}
        self.assertEqual(names, {"stable1", "unstable1", "stable2", "unstable2"})
        both = json.loads(self.good("manifolds", "henon", "--length", "3", "--json"))
        self.assertEqual(len(both["saddles"]), 2)
        curve = self.good("critical", "planar", "--set", "g.a1=0.5", "--set", "h.b1=-0.5",
                          "--window=-1,1,-1,1").decode().splitlines()[1:]
        self.assertGreater(len(curve), 50)
        for row in curve:  # a circle, by hand
            self.assertAlmostEqual(math.hypot(*map(float, row.split(",")[2:])), 0.25, places=10)
        points = json.loads(self.good("critical", "cubic", "--json"))
        self.assertEqual((len(points["curves"]), len(points["points"])), (0, 2))

    def test_explain(self):
        def answer(*arguments):
            return json.loads(self.good("explain", *arguments, "--json"))

        planar = answer("planar-set")
        self.assertEqual(planar["g"], "x² − y² + dᵍ")
        self.assertEqual(planar["h"], "2xy + dʰ")
        self.assertEqual(planar["complex"], "z² − 0.122561 + 0.744862i")
        for scene, word in (("planar-set", "only_critical_orbit"),
                            ("mandelbrot", "only_critical_orbit"),
                            ("tricorn", "only_critical_orbit"),
                            ("planar-cubic-b", "one_of_several"),
                            ("not-critical", "not_critical"),
                            ("henon-set", "no_critical_point"),
                            ("julia", "not_asked")):
            self.assertEqual(answer(scene)["catalogue"]["answer"], word, scene)
        self.assertIn("catalogue", self.good("explain", "mandelbrot").decode())

    def test_a_grid_of_a_sphere_is_its_distance(self):
        self.good("shape", "sphere(0.3)", "-o", self.path("s.f3d"), "--resolution", "33")
        content = self.read("s.f3d")
        self.assertEqual(struct.unpack("<3i", content[:12]), (33, 33, 33))
        middle = struct.unpack_from("<d", content, 60 + 8 * (16 * 33 * 33 + 16 * 33 + 16))
        self.assertEqual(middle[0], -0.3)
        points = self.write("p.csv", "x,y,z\n0.25,0,0\n0,0.4,0\n")
        table = self.good("eval", "shape-modulus", "--points", points,
                          "--set", "shape=" + self.path("s.f3d"), "--set", "alpha=2",
                          "--set", "beta=0", "--field", "image_modulus").decode().split()
        # A node of the grid is exact, and |f| = e^(alpha phi).
        self.assertAlmostEqual(float(table[1].split(",")[3]), math.exp(-0.1), places=12)
        self.assertAlmostEqual(float(table[2].split(",")[3]), math.exp(0.2), places=3)

    def test_scenes_take_the_largest_grid_that_the_help_speaks_of(self):
        self.assertIn("--resolution 161", self.good("shape", "--help").decode())
        points = self.write("p.csv", "x,y,z\n0.25,0,0\n")
        for resolution in ("161", "162"):
            grid = self.path("s" + resolution + ".f3d")
            self.good("shape", "sphere(0.3)", "-o", grid, "--resolution", resolution)
            command = ("eval", "shape-modulus", "--points", points, "--set", "shape=" + grid,
                       "--field", "image_modulus")
            if resolution == "161":
                self.good(*command)
            else:
                self.refused(INPUT_OUTPUT, *command, says="32 MiB")

    def motion(self, **changes):
        scene = {"map": "quadratic", "samples": 1, "iterations": 20}
        keys = [{"time": 0, "values": {"c.re": 0}}, {"time": 1, "values": {"c.re": -1}}]
        whole = {"versorium": 1, "scene": scene, "frames_per_second": 4, "keys": keys} | changes
        path = self.path("motion.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(whole, file)
        return path

    def test_an_animation_as_pictures_goes_on_where_it_stopped(self):
        motion, folder = self.motion(), self.path("frames")
        report = json.loads(self.good("animate", motion, "-o", folder, "--size", "24x16", "--json"))
        self.assertEqual((report["frames"], report["kept"]), (5, 0))
        names = sorted(os.listdir(folder))
        self.assertEqual(names, [f"frame-0000{k}.png" for k in range(1, 6)])
        pictures = [self.read(os.path.join(folder, name)) for name in names]
        self.assertEqual(len(set(pictures)), 5)
        self.assertEqual(pictures[2], self.good("render", os.path.join(folder, names[2]), "-o", "-"))
        os.remove(os.path.join(folder, names[1]))
        with open(os.path.join(folder, names[3]), "wb") as file:
            file.write(pictures[3][:100])  # as a copy that broke off
        report = json.loads(self.good("animate", motion, "-o", folder, "--size", "24x16", "--json"))
        self.assertEqual(report["kept"], 3)
        self.assertEqual([self.read(os.path.join(folder, name)) for name in names], pictures)
        # Another size is another picture.
        report = json.loads(self.good("animate", motion, "-o", folder, "--size", "16x16", "--json"))
        self.assertEqual(report["kept"], 0)

    def test_an_animation_as_an_archive(self):
        path = self.path("frames.zip")
        self.good("animate", self.motion(), "-o", path, "--size", "24x16", "--fps", "2")
        with zipfile.ZipFile(path) as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(
                archive.namelist(), ["animation.json"] + [f"frame-0000{k}.png" for k in (1, 2, 3)]
            )

    def test_an_animation_as_a_film(self):
        if not shutil.which("ffprobe"):
            self.skipTest("ffmpeg is not installed")
        path = self.path("film.mp4")
        self.good("animate", self.motion(), "-o", path, "--size", "33x17")
        facts = subprocess.run(
            ["ffprobe", "-v", "error", "-of", "json", "-show_streams", path],
            capture_output=True, check=True,
        )
        stream = json.loads(facts.stdout)["streams"][0]
        self.assertEqual((stream["width"], stream["height"], stream["nb_frames"]), (34, 18, "5"))
        self.assertEqual(os.listdir(self.folder).count("film.mp4.frames"), 0)

    def test_formulas_of_ones_own(self):
        # The same bits as the built-in map with the same escape radius, in every field.
        for name, typed in (("quadratic", "z^2+c"), ("quaternion-quadratic", "q^2 + c")):
            for scene, file in ((("--map", typed), "t"), ((name,), "b")):
                for field in ("smooth_escape", "distance", "squared_norm"):
                    self.good("render", *scene, "-o", self.path("a.png"), "--size", "60x40",
                              "--set", "escape_radius=100", "--save-field", f"{field}={self.path(file + field)}")
            for field in ("smooth_escape", "distance", "squared_norm"):
                self.assertEqual(self.read("t" + field), self.read("b" + field), field)
        self.good("render", "--map", "z^3 - a*z + conj(c)", "-o", self.path("a.png"), "--size",
                  "40x30", "--set", "a=0.8,0.2", "--threads", "1")
        document = json.loads(self.good("scene", self.path("a.png")))
        self.assertEqual(document["body"]["formula"], "z^3 - a*z + conj(c)")
        self.good("render", self.path("a.png"), "-o", self.path("b.png"), "--threads", "3")
        self.assertEqual(self.read("a.png"), self.read("b.png"))
        self.good("render", self.path("a.png"), "-o", self.path("b.png"), "--set",
                  "formula=z^4 + b", "--set", "b=0.1,0.2", "--size", "8x8")
        # A preset keeps its colours and takes a map.
        self.good("render", "mandelbrot", "--map", "c*sin(z)", "-o", self.path("c.png"),
                  "--size", "20x20")
        orbit = json.loads(self.good("orbit", "x' = 1 - a*x^2 + y, y' = b*x; a = 1; b = 2",
                                     "--at", "0,0", "-n", "2", "--json"))
        self.assertEqual([row["point"] for row in orbit["orbit"]], [[0, 0], [1, 0], [0, 2]])
        points = self.write("p.csv", "x,y\n0,1\n")
        table = self.good("eval", "z^2 - 1", "--points", points, "--field", "image_modulus")
        self.assertEqual(float(table.split()[1].split(b",")[2]), 2)

    def test_a_formula_gives_the_direction_of_a_shape_modulus(self):
        points = self.write("p.csv", "x,y\n0.1,0.2\n-0.3,0.05\n0.6,-0.4\n")
        numbers = ("--points", points, "--set", "shape=star(5, 0.5, 0.25)", "--set", "alpha=6",
                   "--set", "c=0.2,0.1", "--set", "shift=0.05,0")
        fields = ("--field", "log_modulus", "--field", "image_modulus", "--field", "versor")
        tables = [self.good("eval", *scene, *numbers, *fields)
                  for scene in (("shape(z^2 + c)",), ("--map", "shape-modulus-quadratic"))]
        for typed, own in zip(*(table.split() for table in tables)):
            for a, b in zip(typed.split(b","), own.split(b",")):
                self.assertTrue(a == b or abs(float(a) - float(b)) < 1e-12 * (1 + abs(float(b))),
                                tables)
        # The picture carries the formula and its shape.
        self.good("render", "shape(z/2 + c)", "-o", self.path("a.png"), "--size", "24x24",
                  "--set", "shape=disc(0.4)")
        body = json.loads(self.good("scene", self.path("a.png")))["body"]
        self.assertEqual(body["formula"], "shape(z/2 + c)")
        self.assertEqual(body["shape"]["source"], "disc(0.4)")
        self.assertIn(b"fieldAt", self.good("glsl", "shape(q^2 + c)"))

    def test_a_formula_is_explained(self):
        report = json.loads(self.good("formula", "z^3-3z+ c ; c=0.1i", "--json"))
        self.assertEqual(report["text"], "z^3 - 3*z + c; c = 0 + 0.1*i")
        self.assertEqual(report["degree"], 3)
        self.assertEqual(report["critical_points"], [[-1, 0], [1, 0]])
        self.assertIn(b"complex plane", self.good("formula", "z^2+c"))
        self.assertIn(b"formula", self.good("maps"))

    def test_random_roots(self):
        """The same seed gives the same roots, within the region and the powers asked for."""
        many = ("roots", "--count", "12", "--power", "1,4", "--half", "0.5,0.25,0,0")
        first = self.good(*many, "--seed", "3", "-o", "-")
        self.assertEqual(self.good(*many, "--seed", "3", "-o", "-"), first)
        self.assertNotEqual(self.good(*many, "--seed", "4", "-o", "-"), first)
        roots = json.loads(first)["roots"]
        self.assertEqual(len(roots), 12)
        for root in roots:
            self.assertLessEqual(abs(root["q"][0]), 0.5)
            self.assertLessEqual(abs(root["q"][1]), 0.25)
            self.assertEqual(root["q"][2:], [0, 0])
            self.assertIn(root["power"], [1, 2, 3, 4])
        real = json.loads(self.good(*many, "--powers", "real", "-o", "-"))["roots"]
        self.assertTrue(any(root["power"] != int(root["power"]) for root in real))
        # They can be used where roots are bound.
        self.write("roots.json", first)
        self.good("render", "shape-modulus", "--size", "16x16", "--samples", "1",
                  "--set", "roots=" + self.path("roots.json"), "-o", self.path("s.png"))
        # A sheet is a plate of that many candidates.
        sheet = self.path("sheet.png")
        self.good("roots", "--map", "shape-modulus-complex-rational", "--candidates", "3",
                  "--sheet", sheet)
        panels = json.loads(self.good("scene", sheet))["body"]["panels"]
        self.assertEqual(len(panels), 3)

    def test_the_mean_distance_of_a_disc(self):
        """Of a disc of radius a about the origin it is r - a on the circle of radius r."""
        disc = ("profile", "--map", "shape-modulus-quadratic", "--set", "shape=disc(0.6)",
                "--set", "alpha=8", "--to", "2", "--radii", "21")
        rows = self.good(*disc).decode().splitlines()
        self.assertEqual(rows[0], "radius,mean_phi,low,high,modulus")
        self.assertEqual(len(rows), 22)
        for row in rows[1:]:
            radius, mean, low, high, modulus = map(float, row.split(","))
            self.assertAlmostEqual(mean, radius - 0.6, places=12)
            # The mean is a sum of 4096 numbers.
            self.assertLessEqual(low, mean + 1e-12)
            self.assertGreaterEqual(high, mean - 1e-12)
            self.assertAlmostEqual(modulus, math.exp(8 * (radius - 0.6)), delta=1e-9 * modulus)
        said = json.loads(self.good(*disc, "--json"))
        # e^{8 (r - 0.6)} = r has two solutions; between them orbits fall.
        inner, outer = 0.008555, 0.860
        self.assertGreater(said["capture"], inner)
        self.assertLess(said["capture"], outer)
        self.assertGreaterEqual(said["escape"], said["capture"])

    def test_an_averaged_map_goes_on_where_it_stopped(self):
        """In two portions and in one: the same bytes."""
        scene = ("render", "--map", "shape-modulus-complex-rational", "--size", "24x24",
                 "--samples", "1", "--set", "iterations=12", "--set", "alpha=4",
                 "--set", "shape=star(5, 1.4, 0.7)", "--set", "height=3.2",
                 "--set", 'ensemble={"roots": {"count": [10, 10], "power": [1, 1]}}',
                 "--set", "field=mean_membership", "--set", "interior=none")
        kept = self.path("counts.avg")
        at = lambda count: ("--set", "ensemble.count=%d" % count)
        self.good(*scene, *at(20), "--averaged", kept, "-o", self.path("a.png"))
        self.good(*scene, *at(60), "--averaged", kept, "-o", self.path("b.png"))
        self.good(*scene, *at(60), "-o", self.path("c.png"))
        self.assertEqual(self.read("b.png"), self.read("c.png"))
        self.assertNotEqual(self.read("a.png"), self.read("b.png"))
        # Counts of another scene are not mixed in.
        self.refused(DATA, *scene, *at(60), "--set", "alpha=5", "--averaged", kept,
                     "-o", self.path("d.png"), says="another scene")
        self.write("counts.avg", self.read("counts.avg")[:-3])
        self.refused(DATA, *scene, *at(60), "--averaged", kept, "-o", self.path("d.png"),
                     says="cut or damaged")

    def test_alpha_over_space(self):
        """A number that is the same everywhere changes no byte; a second shape does."""
        scene = ("render", "--map", "shape-modulus-complex-rational", "--size", "32x32",
                 "--samples", "1", "--set", "shape=star(5, 1.4, 0.7)", "--set", "height=3.2")
        fields = lambda name: ("--save-field", "escape_step=" + self.path(name))
        picture = self.path("p.png")
        self.good(*scene, "--set", "alpha=6", *fields("a.npy"), "-o", picture)
        # Within a disc that covers everything, alpha is 6.
        self.good(*scene, "--set", "alpha=50", "--set", "modulation.alpha.shape=disc(1000)",
                  "--set", "modulation.alpha.value=6", *fields("b.npy"), "-o", picture)
        self.assertEqual(self.read("a.npy"), self.read("b.npy"))
        half = ("--set", "alpha=50", "--set", "modulation.alpha.shape=half_space(1, 0, 0, 0)",
                "--set", "modulation.alpha.value=6", "--set", "modulation.alpha.between=-0.2,0.2")
        self.good(*scene, *half, *fields("c.npy"), "-o", picture)
        self.good(*scene, "--set", "alpha=50", *fields("d.npy"), "-o", picture)
        self.assertNotEqual(self.read("c.npy"), self.read("b.npy"))
        self.assertNotEqual(self.read("c.npy"), self.read("d.npy"))
        # The picture carries it.
        self.good(*scene, *half, "-o", picture)
        said = json.loads(self.good("scene", picture))["body"]
        self.assertEqual(said["modulation"]["alpha"]["between"], [-0.2, 0.2])

    def test_standard_output(self):
        png = self.good("render", "julia", "-o", "-", "--size", "20x20")
        self.assertTrue(png.startswith(b"\x89PNG"))
        self.good("render", "-", "-o", self.path("again.png"), stdin=png)
        self.assertEqual(self.read("again.png"), png)


class BadInput(CommandLine):
    def out(self):
        return ("-o", self.path("out.png"))

    def test_names(self):
        self.refused(USAGE, "render", "nonsense", *self.out(), says=("nonsense", "mandelbrot"))
        self.refused(USAGE, "plate", "nonsense", *self.out(), says="quadratic")
        self.refused(USAGE, "glsl", "nonsense", says="maps")
        self.refused(USAGE, "glsl", "quadratic", "--pass", "colour", says="orbits or colours")
        self.refused(USAGE, "no-such-command")
        self.refused(USAGE, "render")
        self.refused(USAGE, "render", "julia", *self.out(), "--flavour", "hot", says="exact")

    def test_dynamics(self):
        self.refused(USAGE, "cycles", "mandelbulb", says=("mandelbulb", "plane"))
        self.refused(USAGE, "cycles", "julia", "--window", "1,2", says="LEFT,RIGHT,BOTTOM,TOP")
        self.refused(USAGE, "cycles", "julia", "--window", "2,1,0,1", says="--window")
        self.refused(USAGE, "cycles", "julia", "--period", "0")
        self.refused(USAGE, "cycles", "julia", "--period", "65")
        self.refused(USAGE, "cycles", "nonsense", says="mandelbrot")
        self.refused(USAGE, "manifolds", "julia", says="saddle")
        self.refused(USAGE, "manifolds", "logistic", "--set", "r=3.5", says="saddle")
        self.refused(USAGE, "critical", "logistic", says="plane")
        self.refused(INPUT_OUTPUT, "critical", "cubic", "-o", self.path("no/x.csv"))
        diagram = {"panels": [{"kind": "diagram", "scene": {"map": "logistic"},
                               "diagram": {"parameter": "x", "from": 0, "to": 1}}]}
        self.refused(USAGE, "plate", self.write("d.json", json.dumps(diagram)), *self.out(),
                     says=("panel a", "start"))
        over = {"panels": [{"scene": {"map": "quadratic", "slice": {"axes": [{"c.re": 1},
                {"c.im": 1}]}}, "overlay": {"cycles": 1}}]}
        self.refused(USAGE, "plate", self.write("o.json", json.dumps(over)), *self.out(),
                     says=("panel a", "overlay", "starting points"))
        diagram["panels"][0]["diagram"]["parameter"] = "q"
        self.refused(USAGE, "plate", self.write("d.json", json.dumps(diagram)), *self.out(),
                     says=("panel a", "\"q\""))

    def test_random_roots(self):
        self.refused(USAGE, "roots", "--count", "0", "-o", "-")
        self.refused(USAGE, "roots", "--power", "4,1", "-o", "-", says="power")
        self.refused(USAGE, "roots", "--map", "quadratic", "-o", self.path("r.json"), says="roots")
        self.refused(USAGE, "profile", "mandelbrot", says="no shape")

    def test_shapes(self):
        star = ("render", "--map", "shape-modulus-complex-rational", "--size", "8x8",
                "-o", self.path("s.png"))
        self.refused(DATA, *star, "--set", "shape=star(5, 1.4", says="character")
        for outline, said in (("0, 0, 1, 1, 2, 2", "one line"), ("0, 0, 1", "x and y"),
                              ("0, 0, 1, 0", "3 to"), ("0, 0, 1, 0, nan, 1", "numbers")):
            self.refused(DATA, *star, "--set", "shape=polygon(%s)" % outline, says=said)
        flat = self.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.refused(DATA, *star, "--set", "shape=" + flat, says="encloses nothing")
        # One that crosses itself is a shape.
        self.good(*star, "--set", "shape=polygon(-1, -1, 1, 1, 1, -1, -1, 1)")
        self.refused(USAGE, *star, "--set", "modulation.alpha.between=1,0", says="smaller")
        self.refused(USAGE, *star, "--set", "modulation.alpha.discs=[[0,0,0,0,1]]", says="radius")
        self.refused(USAGE, "render", "mandelbrot", "-o", self.path("m.png"),
                     "--set", "modulation.alpha.value=3", says="modulation")
        # Extremes, a root on the origin, a shape without the origin: a picture without NaN.
        roots = self.write("zero.json", '{"scale": 1, "roots": [{"q": [0,0,0,0], "power": 3}]}')
        for extreme in ("alpha=1e9", "alpha=-1e9", "roots=" + roots,
                        "shape=translate(3, 0, disc(0.5))", "beta=1e9"):
            self.good(*star, "--set", extreme, "--save-field",
                      "image_modulus=" + self.path("m.npy"))
            _, values = self.numbers("m.npy")
            self.assertTrue(all(value == value for value in values), extreme)

    def test_formulas(self):
        for arguments in (("render", "--map", "z^2 + * c", *self.out()),
                          ("render", "z^2 + * c", *self.out()),
                          ("glsl", "z^2 + * c"), ("formula", "z^2 + * c"),
                          ("render", "julia", "--set", "map=z^2 + * c", *self.out())):
            result = self.run_program(*arguments)
            self.assertEqual(result.returncode, USAGE)
            lines = result.stderr.decode().splitlines()
            self.assertIn("is expected, not \"*\"", lines[0])
            self.assertEqual(lines[1], "    z^2 + * c")
            self.assertEqual(lines[2], "          ^")
            self.assertEqual(os.listdir(self.folder), [])
        result = self.run_program("formula", "c + shape(z^2)")
        self.assertEqual(result.returncode, USAGE)
        lines = result.stderr.decode().splitlines()
        self.assertIn("whole formula", lines[0])
        self.assertEqual(lines[2], "        ^")
        self.refused(USAGE, "render", *self.out(), says="--map")
        self.refused(USAGE, "render", "--map", "nonsense", *self.out(), says="z^2 + c")
        scene = self.write("s.json", '{"map": "formula", "formula": "z^2 + foo(c)"}')
        self.refused(DATA, "render", scene, *self.out(), says=("s.json", "character 7", "foo"))

    def test_files(self):
        self.refused(INPUT_OUTPUT, "render", self.path("none.json"), *self.out(), says="none.json")
        self.refused(INPUT_OUTPUT, "shape", self.path("none.obj"), "-o", self.path("g.f3d"),
                     says="none.obj")
        self.write("folder-that-is-a-file", "")
        self.refused(INPUT_OUTPUT, "render", "julia", "--size", "8x8",
                     "-o", self.path("folder-that-is-a-file/x.png"), says="x.png")
        self.refused(INPUT_OUTPUT, "render", "julia", "--size", "8x8", "-o", self.path("no/x.png"))
        if os.path.exists("/dev/full"):
            self.refused(INPUT_OUTPUT, "render", "julia", "--size", "8x8", "-o", "/dev/full",
                         says="/dev/full")
            with open("/dev/full", "wb") as full:
                result = subprocess.run([PROGRAM, "maps"], stdout=full, stderr=subprocess.PIPE,
                                        check=False)
            self.assertEqual(result.returncode, INPUT_OUTPUT)

    def test_an_old_file_survives_a_failure(self):
        old = self.write("out.png", b"old")
        self.refused(USAGE, "render", "julia", "-o", old, "--size", "0x10")
        self.assertEqual(self.read("out.png"), b"old")

    def test_animations(self):
        bad = self.path("bad.json")
        for text, says in [
            ('{"keys": [], "scene": {"map": "quadratic"}}', "keys"),
            ('{"keys": [{"time": 0, "values": {"q": 1}}], "scene": {"map": "quadratic"}}', "keys[0]"),
            ('{"map": "quadratic"}', "scene"),
        ]:
            with open(bad, "w", encoding="utf-8") as file:
                file.write(text)
            self.refused(DATA, "animate", bad, "-o", self.path("frames"), says=says)
        good = {"keys": [{"time": 0, "values": {"c.re": 1}}], "scene": {"map": "quadratic"}}
        with open(bad, "w", encoding="utf-8") as file:
            json.dump(good, file)
        self.refused(INPUT_OUTPUT, "animate", bad, "-o", "/proc/no", "--size", "4x4", says="/proc/no")
        self.refused(USAGE, "animate", bad, "-o", self.path("f"), "--size", "99999x1", says="99999")
        result = subprocess.run(
            [PROGRAM, "animate", bad, "-o", self.path("a.mp4")],
            capture_output=True, timeout=60, check=False, env={"PATH": self.folder},
        )
        self.assertEqual(result.returncode, USAGE)
        self.assertIn(b"ffmpeg", result.stderr)

    def test_sizes(self):
        for size in ("0x10", "10x0", "1000000000x10", "10x1000000000", "9x", "x", "-3x4", "1e3x5"):
            self.refused(USAGE, "render", "julia", *self.out(), "--size=" + size, says="--size")
        self.refused(USAGE, "render", "julia", *self.out(), "--size", "32768x32768",
                     says="samples")
        self.refused(USAGE, "plate", "quadratic", *self.out(), "--width", "1")
        self.refused(USAGE, "plate", "quadratic", *self.out(), "--dpi", "nan")

    def test_values(self):
        for text in ("alpha=nan", "alpha=inf", "alpha=", "alpha=1,2", "alpha=x"):
            self.refused(USAGE, "render", "shape-modulus", *self.out(), "--set", text, says=text)
        for text in ("c=nan,0", "c=1,2,3", "height=0", "height=-1", "iterations=1.5",
                     "iterations=99999999", "nothing=1", "samples=0", "palette=none",
                     "escape_radius=big", "center=1,2,3"):
            self.refused(USAGE, "render", "julia", *self.out(), "--set", text,
                         says=text.split("=")[0])
        self.refused(USAGE, "render", "julia", *self.out(), "--set", "novalue", says="key=value")
        self.refused(USAGE, "plate", "quadratic", *self.out(), "--set", "alpha=2", says="alpha")
        self.refused(USAGE, "orbit", "julia", "--at", "1,2,3")
        self.refused(USAGE, "eval", "julia", "--points", "-", "--field", "none", says="log_modulus")

    def test_scenes(self):
        for content, word in (
            ("", "JSON"),
            ("{", "line 1"),
            ('{"map": "quadratic", "map": "cubic"}', "twice"),
            ('{"versorium": 99}', "newer"),
            ('{"mop": 1}', "mop"),
            ('{"map": "nonsense"}', "nonsense"),
            ('{"parameters": {"c": [0, NaN]}}', "line 1"),
            ('{"slice": {"axes": [{"w.re": 1}, {"z.im": 1}]}}', "slice.axes[0]"),
            ('{"iterations": "many"}', "iterations"),
            ("[" * 100000, "deep"),
            ('{"panels": []}', "plate"),
        ):
            path = self.write("s.json", content)
            self.refused(DATA, "render", path, *self.out(), says=("s.json", word))

    def test_pictures(self):
        self.good("render", "julia", "-o", self.path("a.png"), "--size", "20x20")
        whole = self.read("a.png")
        for length in (10, 40, len(whole) // 2, len(whole) - 3):
            torn = self.write("torn.png", whole[:length])
            self.refused(DATA, "render", torn, *self.out(), says="torn.png")
        # The same picture without its text.
        bare, at = whole[:8], 8
        while at < len(whole):
            (length,) = struct.unpack(">I", whole[at : at + 4])
            if whole[at + 4 : at + 8] not in (b"iTXt", b"tEXt", b"zTXt"):
                bare += whole[at : at + 12 + length]
            at += 12 + length
        self.refused(DATA, "scene", self.write("bare.png", bare), says="carries no scene")

    def test_meshes(self):
        grid = ("-o", self.path("g.f3d"))
        self.refused(DATA, "shape", self.write("e.obj", "v 0 0 0\nv 1 0 0\n"), *grid,
                     says="e.obj")
        self.refused(DATA, "shape", self.write("f.obj", "f 1 2 3\n"), *grid, says="f.obj")
        head = "ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\n" \
               "property float y\nproperty float z\nelement face 1\n" \
               "property list uchar int vertex_indices\nend_header\n"
        for count in (2**31 - 1, 2**31 + 1, 2**32, 2**40, 2**63, 2**64 // 3 + 1):
            self.refused(DATA, "shape", self.write("l.ply", head % count), *grid, says="l.ply")
            self.refused(DATA, "shape", self.write("l.f3d", struct.pack("<3i", 2**30, 2**30, 2**30)
                                                   + bytes(48)), *grid, says="l.f3d")
        self.refused(DATA, "shape", self.write("s.stl", b"\0" * 80 + struct.pack("<I", 2**32 - 1)),
                     *grid, says="s.stl")
        self.refused(DATA, "shape", "star(5, 0.4)", *grid, says="character")
        self.refused(USAGE, "shape", "sphere(0.3)", *grid, "--resolution", "4000")

    def evaluated(self, scene, content, *options):
        path = self.write("p.csv", content)
        lines = self.good("eval", scene, "--points", path, "--field", "membership",
                          *options).decode().split()
        return [float(line.split(",")[-1]) for line in lines[1:]]

    def test_points_are_coordinates_along_the_slice(self):
        # Of the Mandelbrot set they are c: -1 and i are members, 1 and 2i are none.
        self.assertEqual(self.evaluated("mandelbrot", "x,y\n0,0\n-1,0\n0,1\n1,0\n0,2\n"),
                         [1, 1, 1, 0, 0])
        self.assertEqual(self.evaluated("mandelbrot", "c.re,c.im\n-1,0\n1,0\n"), [1, 0])
        # Starting points by their names: under z^2 the unit disc stays.
        self.assertEqual(self.evaluated("mandelbrot", "z.im,z.re\n0,0.5\n0.9,0\n0,1.5\n",
                                        "--set", "c=0"), [1, 1, 0])
        self.assertEqual(self.evaluated("julia", "x,y\n0.5,0\n1.5,0\n", "--set", "c=0"), [1, 0])

    def test_point_tables_in_the_spellings_of_other_programs(self):
        plain = self.evaluated("mandelbrot", "x,y\n0,0\n-1,0\n0.3,0.5\n0,1\n2,2\n")
        for content in ("\ufeffx,y\n0,0\n-1,0\n0.3,0.5\n0,1\n2,2\n",
                        "x,y\r0,0\r-1,0\r0.3,0.5\r0,1\r2,2\r",
                        "x,y\r\n0,0\r\n-1,0\r\n0.3,0.5\r\n0,1\r\n2,2\r\n",
                        "X,Y\n0,0\n-1,0\n0.3,0.5\n0,1\n2,2\n",
                        "x;y\n0;0\n-1;0\n0,3;0,5\n0;1\n2;2\n",
                        "x\ty\n0\t0\n-1\t0\n0.3\t0.5\n0\t1\n2\t2\n",
                        '"x","y"\n"0","0"\n-1,0\n0.3,0.5\n0,1\n2,2\n',
                        "y,x\n0,0\n0,-1\n0.5,0.3\n1,0\n2,2\n"):
            self.assertEqual(self.evaluated("mandelbrot", content), plain, repr(content))

    def test_point_tables_that_could_mean_two_things_are_refused(self):
        for content in ("x,z\n1,2\n", "y\n1\n", "x,y,w\n1,2,3\n", "x,x\n1,2\n", "", "\n",
                        "x,c.re\n1,2\n", "x,y,z\n1,2,3\n", "x,y\n"):
            path = self.write("p.csv", content)
            self.refused(DATA, "eval", "mandelbrot", "--points", path, "--field", "membership",
                         says="p.csv")

    def test_point_tables(self):
        for content in ("", "a,b\n1,2\n", "x,y\n1\n", "x,y\n1,two\n"):
            path = self.write("p.csv", content)
            if content == "":
                continue
            self.refused(DATA, "eval", "julia", "--points", path, "--field", "membership",
                         says="p.csv, line")


class Lessons(CommandLine):
    def test_all_are_listed_in_each_language(self):
        english = self.good("lesson", "list").decode().splitlines()
        spanish = self.good("lesson", "list", "--language", "es").decode().splitlines()
        self.assertEqual(len(english), 8)
        self.assertEqual([line.split()[0] for line in english], [line.split()[0] for line in spanish])
        self.assertIn("What an orbit does", english[0])
        self.assertIn("Qué hace una órbita", spanish[0])

    def guide_example(self):
        guide = os.path.join(os.path.dirname(__file__), "..", "..", "lessons", "README.md")
        with open(guide, encoding="utf-8") as file:
            text = file.read()
        return text.split("````markdown\n")[1].split("````")[0].encode()

    def test_the_guides_example_is_a_lesson(self):
        path = self.write("my-lesson.en.md", self.guide_example())
        self.assertIn(b"no faults", self.good("lesson", "check", path))
        self.good("lesson", "render", path, "-o", self.path("out"), "--width", "89", "--dpi", "60")
        self.assertEqual(os.listdir(self.path("out")), ["my-lesson-01.en.png"])

    def test_faults_are_told_by_their_lines(self):
        example = self.guide_example()
        path = self.write("bad.en.md", example.replace(b"preset: julia", b"preset: nowhere"))
        self.refused(DATA, "lesson", "check", path, says=("line 13", "nowhere"))
        path = self.write("bad.en.md", example.replace(b"point: 0.71, 0.71", b"point: 0.5, 0.5"))
        self.refused(DATA, "lesson", "check", path, says="does not reach the goal")
        self.refused(USAGE, "lesson", "check", "no-such-lesson", says="1-orbits")


class FilesOfOthers(CommandLine):
    """Meshes, pictures, palettes and views as other programs write and name them."""

    WEDGE = ("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 1.5\nv 1 0 1.5\nv 1 1 1.5\nv 0 1 1.5\n"
             "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n")

    def test_one_mesh_by_every_name(self):
        expected = None
        for name in ("wedge.obj", "wedge (1).obj", "WEDGE.OBJ", "a wedge.Obj", "wedge.stl"):
            mesh = self.write(name, self.WEDGE)
            self.good("shape", mesh, "-o", self.path("g.f3d"), "--resolution", "16")
            expected = expected or self.read("g.f3d")
            self.assertEqual(self.read("g.f3d"), expected, name)
            self.good("render", "shape-modulus", "--set", "shape=" + mesh, "--set",
                      "resolution=16", "--size", "8x8", "-o", self.path("M.PNG"))
            self.good("render", self.path("M.PNG"), "-o", self.path("again.png"))
            self.assertEqual(self.read("M.PNG"), self.read("again.png"))

    def test_what_is_wrong_with_a_mesh_is_said(self):
        open_mesh = self.write("open.obj", self.WEDGE.replace("f 5 6 7 8\n", ""))
        turned = self.write("turned.obj", self.WEDGE.replace("f 5 6 7 8", "f 8 7 6 5"))
        for mesh, word in ((open_mesh, "open"), (turned, "turned")):
            result = self.run_program("shape", mesh, "-o", self.path("g.f3d"), "--resolution",
                                      "16", "--json")
            self.assertEqual(result.returncode, 0)
            self.assertIn("warning: ", result.stderr.decode())
            self.assertIn(word, result.stderr.decode())
            self.assertTrue(any(word in text for text in json.loads(result.stdout)["warnings"]))
            result = self.run_program("render", "shape-modulus", "--set", "shape=" + mesh, "--set",
                                      "resolution=16", "--size", "8x8", "-o", self.path("a.png"),
                                      "--json")
            self.assertIn(word, result.stderr.decode())
            self.assertTrue(json.loads(result.stdout)["warnings"])
        self.assertNotIn("warnings", json.loads(
            self.good("shape", self.write("good.obj", self.WEDGE), "-o", self.path("g.f3d"),
                      "--resolution", "16", "--json")))

    def test_palettes(self):
        maps = (("a.map", "0 0 0\n255 128 0\n255 255 255\n"),
                ("a.GPL", "GIMP Palette\nName: a\n#\n0 0 0\n255 128 0\n255 255 255\n"),
                ("a b.txt", "#000000\n#ff8000\n#ffffff\n"))
        pictures = set()
        for name, text in maps:
            self.good("render", "mandelbrot", "--size", "16x16", "-o", self.path("p.png"), "--set",
                      "palette=" + self.write(name, text))
            document = json.loads(self.good("scene", self.path("p.png")))
            stops = document["body"]["colour"]["palette"]["stops"]
            pictures.add(json.dumps([stop["colour"] for stop in stops]))
        self.assertEqual(pictures, {'["#000000", "#ff8000", "#ffffff"]'})
        self.refused(DATA, "render", "mandelbrot", "-o", self.path("x.png"), "--set",
                     "palette=" + self.write("bad.map", "0 0 0\n1 2 900\n"), says="line 2")

    def test_views(self):
        view = self.write("sea.xpf", "(initstate)\n(formula 'mandel)\n(view -0.745 0.113 0.02 0.02)\n"
                          "(maxiter 700)\n")
        result = self.run_program("render", view, "--size", "8x8", "-o", self.path("v.png"))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("XaoS", result.stderr.decode())
        body = json.loads(self.good("scene", self.path("v.png")))["body"]
        self.assertEqual(body["slice"]["center"], [-0.745, 0.113])
        self.assertEqual(body["iterations"], 700)

    def test_known_formats_are_refused_by_name(self):
        for name, content, word in (("a.gif", b"GIF89a", "GIF"), ("a.svg", b"<svg/>", "SVG"),
                                    ("a.webp", b"RIFF\0\0\0\0WEBPVP8 ", "WebP")):
            path = self.write(name, content)
            self.refused(DATA, "render", path, "-o", self.path("x.png"), says=word)
            self.refused(DATA, "shape", path, "-o", self.path("x.png"), says=(word, "PNG"))
            self.refused(DATA, "render", "shape-modulus", "-o", self.path("x.png"), "--size", "8x8", "--set",
                         "shape=" + path, says=word)
            self.refused(DATA, "render", "mandelbrot", "-o", self.path("x.png"), "--set", "layer=" + path,
                         says=word)

    def test_a_picture_becomes_a_layer(self):
        self.good("render", "julia", "--size", "8x8", "-o", self.path("photo 1.PNG"))
        self.good("render", "mandelbrot", "--size", "8x8", "-o", self.path("l.png"), "--set",
                  "layer=" + self.path("photo 1.PNG"), "--set", "layers[0].front=true", "--set",
                  "layer=#ffffff")
        document = json.loads(self.good("scene", self.path("l.png")))
        self.assertEqual(len(document["body"]["layers"]), 2)
        self.assertTrue(document["body"]["layers"][0]["front"])
        self.assertEqual([asset["name"] for asset in document["assets"].values()], ["photo 1.PNG"])
        self.good("render", self.path("l.png"), "-o", self.path("m.png"))
        self.assertEqual(self.read("l.png"), self.read("m.png"))

    def test_outlines_of_logos(self):
        def png(pixels):  # of grey and alpha, 8 by 8
            def chunk(kind, data):
                return (struct.pack(">I", len(data)) + kind + data +
                        struct.pack(">I", zlib.crc32(kind + data)))
            rows = b"".join(b"\0" + bytes(pixels[y * 16:y * 16 + 16]) for y in range(8))
            return (b"\x89PNG\r\n\x1a\n" +
                    chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 8, 8, 4, 0, 0, 0)) +
                    chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
        inside = [2 <= x < 6 and 2 <= y < 6 for y in range(8) for x in range(8)]
        logos = {
            (): [part for p in inside for part in ((0, 255) if p else (255, 255))],
            ("invert",): [part for p in inside for part in ((255, 255) if p else (0, 255))],
            ("by-alpha",): [part for p in inside for part in ((255, 255) if p else (255, 0))],
            ("by-alpha", "invert"): [part for p in inside for part in ((0, 0) if p else (0, 255))],
        }
        grids = set()
        for flags, pixels in logos.items():
            logo = self.write("logo.png", png(pixels))
            self.good("shape", logo, "-o", self.path("l.grid"), *("--" + flag for flag in flags))
            grids.add(self.read("l.grid"))
            sets = [f"--set=shape.{flag.replace('-', '_')}=true" for flag in flags]
            self.good("render", "star", "--size", "8x8", "-o", self.path("s.png"), "--set",
                      "shape=" + logo, *sets)
        self.assertEqual(len(grids), 1)
        self.refused(DATA, "shape", self.write("w.png", png(logos[("by-alpha",)])), "-o",
                     self.path("x.grid"), says=("shape.threshold", "shape.by_alpha"))


if __name__ == "__main__":
    unittest.main()
