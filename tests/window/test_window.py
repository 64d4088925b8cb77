# SPDX-License-Identifier: MIT
"""The studio's window on a virtual display, with a hand on mouse and keys: test_window.py PROGRAM"""
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = None
PATIENCE = 60  # seconds: for machines that are busy with other tests


def program(*arguments, display=None, **options):
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    environment["XDG_CONFIG_HOME"] = options.pop("settings")
    if display:
        environment["DISPLAY"] = display
        environment["LIBGL_ALWAYS_SOFTWARE"] = "1"
    return subprocess.Popen([PROGRAM, *arguments], env=environment, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, **options)


class Window(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        read, write = os.pipe()
        cls.server = subprocess.Popen(
            # Without a reset: between one window and the next there may be a moment without any.
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp",
             "-noreset"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        # The whole line: the server ends when it cannot write all of it.
        with os.fdopen(read) as line:
            cls.display = ":" + line.readline().strip()

    @classmethod
    def tearDownClass(cls):
        cls.server.terminate()
        cls.server.wait()

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def start(self, *arguments, display=True):
        run = program(*arguments, display=self.display if display else None,
                      settings=os.path.join(self.folder, "settings"), cwd=self.folder)
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        return run

    def finish(self, run):
        out, err = run.communicate(timeout=PATIENCE)
        return run.returncode, out.decode(), err.decode()

    def shoot(self, *arguments):
        path = os.path.join(self.folder, "window.png")
        code, _, err = self.finish(self.start("studio", *arguments, "--screenshot", path))
        self.assertEqual(code, 0, err)
        return self.colours(path)

    def colours(self, path, area="1280x800+0+0"):
        """How many colours there are in a part of a picture."""
        out = subprocess.run(["convert", path, "-crop", area, "+repage", "-format", "%k", "info:"],
                             check=True, capture_output=True).stdout
        return int(out)

    def hand(self, *words):
        environment = dict(os.environ, DISPLAY=self.display)
        subprocess.run(["xdotool", *map(str, words)], check=True, env=environment, timeout=PATIENCE,
                       stdout=subprocess.DEVNULL)

    def press(self, modifier, key):
        """As slowly as a hand does: a slow machine sees fewer frames than key strokes."""
        for words in (("keydown", modifier), ("keydown", key), ("keyup", key), ("keyup", modifier)):
            self.hand(*words)
            time.sleep(0.15)

    def screen(self, name):
        path = os.path.join(self.folder, name)
        subprocess.run(["import", "-display", self.display, "-window", "root", path], check=True)
        return path

    def differing(self, one, other, area):
        """The share of pixels that differ in a part of the screen."""
        out = subprocess.run(["compare", "-metric", "AE", "-fuzz", "4%", "-extract", area, one,
                              other, "null:"], capture_output=True).stderr
        width, height = map(int, area.split("+")[0].split("x"))
        return float(out.split()[0]) / (width * height)

    def wait_for(self, what, condition):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if condition():
                return
            time.sleep(0.2)
        self.fail(f"it never came to this: {what}")

    def steady(self, name):
        """The screen once it does not change any more."""
        last = self.screen("last.png")
        for _ in range(PATIENCE):
            time.sleep(0.7)
            now = self.screen(name)
            if self.differing(last, now, "1280x800+0+0") == 0:
                return now
            shutil.copy(now, last)
        self.fail("the screen never came to rest")

    def test_without_a_display_it_names_what_works(self):
        for arguments in ((), ("studio", "julia")):
            code, _, err = self.finish(self.start(*arguments, display=False))
            self.assertEqual(code, 2)
            self.assertIn("versorium render", err)

    def test_it_starts_and_draws_every_kind_of_scene(self):
        for preset in ("mandelbrot", "henon", "logistic", "newton", "quaternion-julia"):
            self.assertGreater(self.shoot(preset), 300, preset)

    def test_a_picture_opens_and_what_is_none_is_refused(self):
        picture = os.path.join(self.folder, "julia.png")
        run = self.start("render", "julia", "-o", picture, "--size", "64x64", display=False)
        self.assertEqual(self.finish(run)[0], 0)
        self.assertGreater(self.shoot(picture), 300)
        code, _, err = self.finish(self.start("studio", "no-such-scene"))
        self.assertNotEqual(code, 0)
        self.assertIn("no-such-scene", err)

    def draw_by(self, who):
        """Whom the studio's settings let draw live pictures. The file ends as editors end it."""
        folder = os.path.join(self.folder, "settings", "versorium")
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, "renderer"), "w") as setting:
            setting.write(who + "\n")

    def test_the_graphics_processor_draws_what_the_processor_draws(self):
        # The last one has pixels too close together for 32 bits: the CPU takes it over.
        deep = os.path.join(self.folder, "deep.json")
        with open(deep, "w") as scene:
            scene.write('{"document": 1, "kind": "scene", "body": {"versorium": 1, "map": "quadratic",'
                        ' "iterations": 300, "samples": 1,'
                        ' "slice": {"axes": [{"z.re": 1}, {"z.im": 1}], "center": [0.35, 0.2],'
                        ' "height": 1e-9}}}')
        for scene in ("julia", "quaternion-julia", deep):
            pictures = []
            for who in ("graphics", "processor"):
                self.draw_by(who)
                pictures.append(os.path.join(self.folder, who + ".png"))
                code, _, err = self.finish(self.start("studio", scene, "--screenshot", pictures[-1]))
                self.assertEqual(code, 0, err)
            for area in ("460x590+8+8", "460x590+476+8"):
                self.assertLess(self.differing(*pictures, area), 0.02, (scene, area))
            # The status line says who drew.
            status = self.differing(*pictures, "400x24+530+762")
            self.assertEqual(status == 0, scene == deep, scene)

    def test_hand_on_mouse_and_keys(self):
        left, right = "440x580+10+10", "440x580+480+10"
        run = self.start("studio", "mandelbrot")
        self.hand("search", "--sync", "--name", "^Versorium$", "windowfocus", "--sync")
        self.hand("mousemove", 235, 580)
        first = self.steady("first.png")
        # The middle of the parameter plane is c = -0.65, which lies on view 1: the preset's ring
        # stands at c = 0. Ctrl and a click put it elsewhere, and the other view follows.
        self.hand("keydown", "ctrl", "mousemove", 100, 260, "click", 1, "keyup", "ctrl")
        self.hand("mousemove", 235, 580)
        moved = self.steady("moved.png")
        self.assertGreater(self.differing(first, moved, right), 0.05)
        # The wheel goes in where the pointer is.
        self.hand("mousemove", 300, 300, "click", 4, "click", 4, "click", 4)
        self.hand("mousemove", 235, 580)
        zoomed = self.steady("zoomed.png")
        self.assertGreater(self.differing(moved, zoomed, left), 0.05)
        # Undo brings both back: each deed is a step of its own.
        self.press("ctrl", "z")
        again = self.steady("again.png")
        self.assertLess(self.differing(moved, again, left), 0.02)
        self.press("ctrl", "z")
        again = self.steady("again.png")
        self.assertLess(self.differing(first, again, right), 0.02)
        # The scene is saved beside, and opens again.
        self.press("ctrl", "s")
        scene = os.path.join(self.folder, "quadratic.json")
        self.wait_for("a saved scene", lambda: os.path.exists(scene))
        self.assertIsNone(run.poll())
        run.kill()
        self.assertGreater(self.shoot(scene), 300)


    def studio(self, *arguments):
        run = self.start("studio", *arguments)
        self.hand("search", "--sync", "--name", "^Versorium$", "windowfocus", "--sync")
        self.hand("mousemove", 235, 700)
        return run

    def tap(self, *keys):
        """Down and up at once: a key that is held repeats itself."""
        for key in keys:
            self.hand("key", key)
            time.sleep(0.4)

    def saved(self):
        """The scene as Ctrl S saves it now."""
        before = set(os.listdir(self.folder))
        self.press("ctrl", "s")
        fresh = lambda: [name for name in set(os.listdir(self.folder)) - before
                         if name.endswith(".json")]
        self.wait_for("a saved scene", fresh)
        with open(os.path.join(self.folder, fresh()[0])) as file:
            return json.load(file)["body"]

    def test_keys_that_go_down_and_up_between_two_frames(self):
        self.studio("mandelbrot")
        self.steady("first.png")
        for _ in range(6):
            self.tap("Right")
            time.sleep(0.9)  # one deed ends before the next begins
            # Within 12 ms: the modifier goes up before the letter does.
            self.hand("key", "ctrl+z")
            time.sleep(0.5)
            self.assertEqual(self.saved()["slice"]["center"], [-0.65, 0])

    def test_exports_are_what_the_command_line_makes(self):
        self.studio("mandelbrot")
        self.steady("first.png")
        self.press("ctrl", "e")
        self.steady("dialog.png")
        self.tap("Return")
        picture = os.path.join(self.folder, "quadratic.png")
        self.wait_for("an exported picture", lambda: os.path.exists(picture))
        time.sleep(1)
        self.press("ctrl", "e")
        self.steady("dialog.png")
        self.hand("mousemove", 573, 354, "click", 1)  # "plate"
        time.sleep(0.5)
        self.tap("Return")
        plate = os.path.join(self.folder, "quadratic-plate.png")
        self.wait_for("an exported plate", lambda: os.path.exists(plate))
        for command, path in (("render", picture), ("plate", plate)):
            again = os.path.join(self.folder, "again.png")
            code, _, err = self.finish(self.start(command, path, "-o", again, display=False))
            self.assertEqual(code, 0, err)
            with open(path, "rb") as one, open(again, "rb") as other:
                self.assertEqual(one.read(), other.read(), command)

    def test_the_gallery_opens_presets_and_keeps_recent_scenes(self):
        run = self.studio("mandelbrot")
        self.press("ctrl", "g")
        self.steady("gallery.png")
        presets = subprocess.run([PROGRAM, "presets"], capture_output=True, check=True)
        steps = presets.stdout.decode().split().index("julia")
        self.tap(*["Right"] * steps, "Return")
        time.sleep(1)
        self.assertEqual(self.saved()["slice"]["axes"][0], {"z.re": 1})
        run.kill()
        run.wait()
        time.sleep(1)  # until its window is gone: the next one is found by the same name
        with open(os.path.join(self.folder, "settings", "versorium", "recent")) as file:
            links = file.read().split()
        self.assertGreaterEqual(len(links), 1)
        self.assertTrue(all(link.startswith("v1:") for link in links))
        self.studio("mandelbrot")
        self.press("ctrl", "g")
        self.steady("gallery.png")
        self.tap("End", "Return")
        time.sleep(1)
        self.assertEqual(self.saved()["slice"]["axes"][0], {"z.re": 1})

    def find(self, words):
        """What Ctrl K finds is opened by Enter."""
        self.press("ctrl", "k")
        time.sleep(0.8)
        self.hand("type", "--delay", "60", words)
        time.sleep(0.8)
        self.tap("Return")
        time.sleep(1)

    def test_a_formula_is_typed_and_a_motion_of_it_recorded(self):
        self.studio("mandelbrot")
        self.steady("first.png")
        self.find("z^3 - a*z + c")
        self.assertEqual(self.saved()["formula"], "z^3 - a*z + c")
        self.tap("1", "r")
        self.hand("mousemove", 235, 300)
        for _ in range(4):
            self.hand("click", 4)
            time.sleep(0.3)
        self.tap("r")
        time.sleep(0.5)
        self.find("save the motion as a file")
        motion = os.path.join(self.folder, "formula-motion.json")
        self.wait_for("a saved motion", lambda: os.path.exists(motion))
        frames = os.path.join(self.folder, "frames")
        code, out, err = self.finish(self.start("animate", motion, "-o", frames, "--size", "32x24",
                                                "--fps", "2", "--json", display=False))
        self.assertEqual(code, 0, err)
        report = json.loads(out)
        self.assertGreaterEqual(report["frames"], 3)
        pictures = set()
        for name in os.listdir(frames):
            with open(os.path.join(frames, name), "rb") as file:
                pictures.add(file.read())
        self.assertGreater(len(pictures), 2)

    def test_an_analysis_has_four_places_that_are_dragged(self):
        self.studio("planar-set")
        self.tap("n")
        before = self.steady("analysis.png")
        # The first one stands where the numbers were.
        self.hand("mousemove", 250, 250, "keydown", "ctrl", "click", 1, "keyup", "ctrl")
        time.sleep(0.5)
        moved = self.steady("moved.png")
        self.assertGreater(self.differing(before, moved, "226x290+476+10"), 0.02)
        for area in ("226x290+710+10", "226x290+476+312", "226x290+710+312"):
            self.assertLess(self.differing(before, moved, area), 0.02, area)

    def stroke(self, points):
        self.hand("mousemove", *points[0], "mousedown", 1)
        for x, y in points[1:]:
            self.hand("mousemove", x, y)
            time.sleep(0.03)
        self.hand("mouseup", 1)
        time.sleep(0.5)

    def test_a_star_is_drawn_becomes_its_julia_set_and_is_painted_on(self):
        self.studio()
        self.tap("d")
        corners = [(700 + r * math.sin(k * math.pi / 5), 300 - r * math.cos(k * math.pi / 5))
                   for k, r in ((k, 90 if k % 2 else 200) for k in range(11))]
        points = [(round(a[0] + (b[0] - a[0]) * part / 6), round(a[1] + (b[1] - a[1]) * part / 6))
                  for a, b in zip(corners, corners[1:]) for part in range(6)]
        self.stroke(points)
        scene = self.saved()
        self.assertEqual(scene["map"], "shape-modulus-complex-rational")
        outline = json.loads("[" + scene["shape"]["source"].removeprefix("polygon(")[:-1] + "]")
        # Ten corners, and what the hand's steps leave beside them.
        self.assertGreaterEqual(len(outline) // 2, 10)
        self.assertLess(len(outline) // 2, 30)
        before = self.steady("star.png")
        self.find("paint")
        self.stroke([(700, 120), (700, 140), (705, 160), (700, 180)])
        discs = self.saved()["modulation"]["alpha"]["discs"]
        self.assertGreater(len(discs), 1)
        self.tap("Escape")
        self.hand("mousemove", 235, 700)
        painted = self.steady("painted.png")
        self.assertGreater(self.differing(before, painted, "440x580+480+10"), 0.002)

    def test_a_mesh_opens_from_the_list_of_files(self):
        with open(os.path.join(self.folder, "tetra.obj"), "w") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        self.studio("mandelbrot")
        self.press("ctrl", "o")
        time.sleep(1)
        # ".." and the settings stand above it.
        self.tap("Down", "Down", "Return")
        time.sleep(1.5)
        scene = self.saved()
        self.assertEqual(scene["map"], "shape-modulus")
        self.assertTrue(scene["shape"]["source"].startswith("asset:"))

    def test_roots_follow_the_hand_and_a_sheet_is_picked_from(self):
        start = os.path.join(self.folder, "start.json")
        with open(start, "w") as file:
            json.dump({"document": 1, "kind": "scene", "body": {
                "versorium": 1, "map": "shape-modulus-complex-rational",
                "shape": {"source": "star(5, 0.5, 0.25)"},
                "lists": {"roots": {"roots": [{"q": [0, 0, 0, 0], "power": 1},
                                              {"q": [0.3, 0.2, 0, 0], "power": 1}]}},
                "slice": {"axes": [{"z.re": 1}, {"z.im": 1}], "center": [0, 0],
                          "height": 1.2}}}, file)
        self.studio(start)
        # The right view is 461 pixels wide, and its shorter side shows 1.2.
        pixel = 1.2 / 461
        across, down = 705 + round(0.3 / pixel), 305 - round(0.2 / pixel)
        self.hand("mousemove", across, down)
        time.sleep(1)
        for words in (("mousedown", 1), ("mousemove", across, down + 30),
                      ("mousemove", across, down + 60), ("mouseup", 1), ("click", 4)):
            self.hand(*words)
            time.sleep(0.4)
        self.hand("mousemove", 235, 700)
        time.sleep(0.5)
        root = self.saved()["lists"]["roots"]["roots"][1]
        self.assertAlmostEqual(root["q"][0], 0.3, delta=4 * pixel)
        self.assertAlmostEqual(root["q"][1], 0.2 - 60 * pixel, delta=4 * pixel)
        self.assertEqual(root["power"], 2)
        # The third candidate of the sheet.
        self.tap("s")
        time.sleep(3)
        self.tap("Right", "Right", "Return")
        time.sleep(1)
        self.assertEqual(len(self.saved()["lists"]["roots"]["roots"]), 10)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    missing = [tool for tool in ("Xvfb", "xdotool", "import", "convert") if not shutil.which(tool)]
    if missing:
        print("SKIPPED: these are missing: " + ", ".join(missing))
        sys.exit(77)
    unittest.main()
