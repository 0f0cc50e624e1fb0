"""The explorer in a browser: it computes what the program computes, by mouse, touch and keyboard, named, narrow, dark."""

import csv
import json
import math
import re
import shlex
import subprocess
import tempfile
import pathlib

import browser

DATA = browser.ROOT / "experiments" / "data"


def program(*arguments):
    return subprocess.run([browser.PROGRAM, *arguments], check=True, timeout=300, capture_output=True, text=True).stdout


def read_points(path):
    with open(path, encoding="utf-8") as file:
        return [[float(x) for x in row] for row in list(csv.reader(file))[1:]]


class Explorer(browser.PageTest):
    page = "report/explorer.html"

    # -- helpers -----------------------------------------------------------------------------------------------------

    def start(self, fragment=""):
        self.open(fragment=fragment)
        self.wait(lambda: self.script("return document.documentElement.dataset.ready ?? ''") != "", 60)

    def settled(self, action):
        """Does something and waits until the page has answered."""
        before = int(self.script("return document.documentElement.dataset.ready"))
        action()
        self.wait(lambda: int(self.script("return document.documentElement.dataset.ready")) > before, 30)

    def set(self, selector, value, event="input"):
        self.settled(lambda: self.script(
            "const e = document.querySelector(arguments[0]); e.focus(); e.value = arguments[1];"
            "e.dispatchEvent(new Event(arguments[2], { bubbles: true }));", selector, value, event))

    def click(self, selector):
        self.settled(lambda: self.script("document.querySelector(arguments[0]).click()", selector))

    def text(self, selector):
        return self.script("return document.querySelector(arguments[0]).textContent", selector).replace("\u2212", "-")

    def points(self):
        """The points of the curve as the page saves them."""
        return self.script("return [...xs].map((x, i) => [x, ys[i]])")

    def controls(self):
        return self.script("return state.points.map((p) => p.map(Number))")

    def commands(self):
        return self.text("#command").strip().split("\n")

    def run_commands(self):
        """The points that the commands on the page compute, and the last line of its measures."""
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            measured = None
            for line in self.commands():
                if line.startswith("printf"):
                    subprocess.run(["bash", "-c", line], cwd=folder, check=True)
                    continue
                words = [w.replace("experiments/data/", str(DATA) + "/") for w in shlex.split(line)]
                words[0] = browser.PROGRAM
                if words[1] == "analyze":
                    continue
                output = subprocess.run(words, cwd=folder, check=True, capture_output=True, text=True, timeout=120).stdout
                if words[1] == "measure":
                    measured = output.strip().split("\n")[-1].split()
            return read_points(folder / "curve.csv"), measured

    def assert_same_as_program(self):
        computed, measured = self.run_commands()
        drawn = self.points()
        self.assertEqual(len(drawn), len(computed))
        size = max(abs(x) for p in computed for x in p)
        for a, b in zip(drawn, computed):
            self.assertLess(math.dist(a, b), 1e-12 * size)
        if measured is not None:
            reply = self.script("return reply")
            self.assertEqual(int(measured[1]), reply["points"])
            self.assertAlmostEqual(float(measured[2]), reply["length"], delta=1e-9 * reply["length"])
            if reply["area"] is not None:
                self.assertAlmostEqual(float(measured[3]), reply["area"], delta=1e-9 * size * size)
            self.assertAlmostEqual(float(measured[4]), reply["largestJerk"], delta=1e-6 * reply["largestJerk"] + 1e-12)

    # -- numbers -----------------------------------------------------------------------------------------------------

    def test_starts_and_draws_what_the_program_computes(self):
        self.start()
        self.assertEqual(self.script("return document.getElementById('failure').hidden"), True)
        self.assertIn("C2, and not C3", self.text("#continuity"))
        self.assert_same_as_program()
        self.assertEqual(self.console_errors(), [])
        self.assertEqual(self.network_requests(), [])

    def test_presets_have_the_curves_smoothness_and_areas_of_the_library(self):
        self.start()
        names = self.script("return data.presets.map((p) => p.name)")
        self.assertGreaterEqual(len(names), 30)
        analysed = {}
        for name in names:
            with self.subTest(name):
                self.set("#preset", name, "change")
                self.assertEqual(self.script("return document.getElementById('preset').value"), name)
                self.assert_same_as_program()
                scheme = shlex.split(self.commands()[-1])[-1]
                last = scheme.split("+")[-1]
                if last not in analysed:
                    analysed[last] = json.loads(program("analyze", last, "--json"))["regularity"]
                known = analysed[last]
                shown = self.script("return smoothness")
                self.assertEqual(f"C{shown['proved']}" if shown["proved"] >= 0 else None, known["continuity"])
                self.assertLessEqual(float(shown["exponent"]["lower"]), float(known["hoelder"]["upper"]) + 1e-9)
                self.assertGreaterEqual(float(shown["exponent"]["upper"]), float(known["hoelder"]["lower"]) - 1e-9)
        self.assertEqual(self.console_errors(), [])

    def test_sliders_and_fields_agree(self):
        self.start()
        before = self.points()
        self.set("#step-0-0-slider", "1.27")
        self.assertEqual(self.script("return document.getElementById('step-0-0').value"), "1.27")
        self.assertNotEqual(self.points(), before)
        self.assertIn("C3, and not C4", self.text("#continuity"))
        self.assertIn("3-log2(73/100) = 3.4540316", self.text("#exponent"))
        self.set("#step-0-0", "3/8")
        decimal = self.points()
        self.assertIn("popping.fixed", self.text("#claims"))
        self.set("#step-0-0", "0.375")
        self.assertEqual(self.points(), decimal)
        self.assertAlmostEqual(float(self.script("return document.getElementById('step-0-0-slider').value")), 0.375)
        self.script("const e = document.getElementById('step-0-0'); e.focus(); e.value = '3/';"
                    "e.dispatchEvent(new Event('input', { bubbles: true }))")
        self.assertEqual(self.find("#step-0-0").get_attribute("aria-invalid"), "true")
        self.assertIn("3/8", self.text("#step-0-0-wrong"))
        self.assertEqual(self.points(), decimal)
        self.set("#step-0-0", "4")
        self.assertIn("C1, and not C2", self.text("#continuity"))
        self.set("#step-0-0", "3.999999999999")
        self.assertIn("C2, and not C3", self.text("#continuity"))

    def test_two_parameters_are_proved_or_undecided(self):
        self.start("steps=2,3")
        self.assertIn("C2", self.text("#continuity"))
        self.start("steps=1/3,1/2")
        self.assertIn("proved", self.text("#exponent"))
        self.start("steps=-20,30")
        self.assertIn("undecided", self.text("#continuity"))
        self.start("steps=12")
        self.assertIn("no limit curve", self.text("#continuity"))

    def test_retrofitted_and_open_curves_are_those_of_the_program(self):
        self.start("steps=3/2&levels=4&points=0,0;4,1;8,0;7,4;2.5,6&retrofit")
        self.assertIn("--retrofit direct", self.text("#command"))
        self.assert_same_as_program()
        self.click("#open")
        self.assertIn("--open reflected", self.text("#command"))
        self.assert_same_as_program()
        self.start("steps=2&levels=4&points=0,0;4,0;4,4;0,4&retrofit")
        self.assertIn("The address of this page names no curve", self.text("#failure"))

    # -- hands -------------------------------------------------------------------------------------------------------

    def test_dragging_moves_a_point_and_can_be_undone(self):
        from selenium.webdriver.common.action_chains import ActionChains

        self.start()
        before = self.controls()
        curve = self.points()
        handle = self.find(".handle:nth-child(3)")
        self.settled(lambda: ActionChains(self.driver).drag_and_drop_by_offset(handle, 30, -20).perform())
        after = self.controls()
        self.assertGreater(after[2][0], before[2][0])
        self.assertGreater(after[2][1], before[2][1])
        self.assertEqual(after[:2] + after[3:], before[:2] + before[3:])
        self.assertNotEqual(self.points(), curve)
        self.assertIn("printf", self.text("#command"))
        self.assert_same_as_program()
        self.click("#undo")
        self.assertEqual(self.controls(), before)
        self.click("#redo")
        self.assertEqual(self.controls(), after)
        self.click("#reset")
        self.assertEqual(self.controls(), before)

    def test_a_finger_drags(self):
        self.size(360, 740)
        self.start()
        before = self.controls()
        box = self.script("const r = document.querySelector('.handle:nth-child(2) .dot').getBoundingClientRect();"
                          "return [r.x + r.width / 2, r.y + r.height / 2]")

        def touch(kind, *points):
            self.command("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y} for x, y in points])

        def drag():
            touch("touchStart", box)
            touch("touchMove", [box[0] + 8, box[1] + 12])
            touch("touchMove", [box[0] + 16, box[1] + 25])
            touch("touchEnd")

        self.settled(drag)
        self.assertGreater(self.controls()[1][0], before[1][0])
        self.assertLess(self.controls()[1][1], before[1][1])

    def test_keyboard_alone(self):
        self.start()
        before = self.controls()
        self.script("document.querySelector('.handle:nth-child(2)').focus()")
        self.settled(lambda: self.keys("ARROW_RIGHT"))
        self.assertGreater(self.controls()[1][0], before[1][0])
        step = self.controls()[1][0] - before[1][0]
        self.settled(lambda: self.script(
            "document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', shiftKey: true, bubbles: true }))"))
        self.assertAlmostEqual(self.controls()[1][1] - before[1][1], 10 * step, delta=1e-9)
        self.settled(lambda: self.keys("INSERT"))
        self.assertEqual(len(self.controls()), len(before) + 1)
        self.assertIn("Point 3 of 9", self.script("return document.activeElement.getAttribute('aria-label')"))
        self.settled(lambda: self.keys("DELETE"))
        self.assertEqual(len(self.controls()), len(before))
        self.script("document.getElementById('levels').focus()")
        self.settled(lambda: self.keys("ARROW_LEFT"))
        self.assertIn("--levels 5", self.text("#command"))

    def test_points_come_and_go_by_double_click_but_three_stay(self):
        from selenium.webdriver.common.action_chains import ActionChains

        self.start("steps=1/2&points=0,0;6,0;3,5")
        handle = self.find(".handle:nth-child(1)")
        other = self.find(".handle:nth-child(2)")
        middle = (other.rect["x"] - handle.rect["x"]) / 2
        self.settled(lambda: ActionChains(self.driver).move_to_element_with_offset(handle, int(middle), 0).double_click().perform())
        self.assertEqual(len(self.controls()), 4)
        self.assertAlmostEqual(self.controls()[1][0], 3, delta=0.2)
        self.settled(lambda: ActionChains(self.driver).double_click(self.find(".handle:nth-child(2)")).perform())
        self.assertEqual(len(self.controls()), 3)
        ActionChains(self.driver).double_click(self.find(".handle:nth-child(1)")).perform()
        self.assertEqual(len(self.controls()), 3)
        self.assertIn("at least 3 points", self.text("#summary"))

    def test_steps_are_added_split_and_left_out(self):
        self.start()
        self.click("#more-steps")
        self.assertEqual([e.text for e in self.find_all("#steps legend")], ["First step", "Then for ever"])
        self.set("#step-0-0", "2/3")
        self.set("#step-1-0", "1")
        self.assertIn("edge.j1.interpolates", self.text("#claims"))
        self.click("#step-0-linked")
        self.set("#step-0-1", "3/4")
        self.assertIn("jspline:a=2/3,b=3/4+jspline:s=1", self.text("#command"))
        self.assert_same_as_program()
        self.click("#step-0-drop")
        self.assertEqual([e.text for e in self.find_all("#steps legend")], ["Every step"])

    def test_the_address_holds_the_curve(self):
        self.start()
        self.set("#preset", "{J(-7/4, 59/52), *J(3/2)}", "change")
        self.set("#levels", "3")
        self.click("#show-jerk")
        address = self.script("return location.hash")
        points = self.points()
        self.start(address.lstrip("#"))
        self.assertEqual(self.points(), points)
        self.assertIn("C4", self.text("#continuity"))
        self.assertTrue(self.script("return document.getElementById('jerk-comb').getAttribute('d').length") > 100)
        for wrong in ("steps=abc", "steps=1&points=0,0", "steps=1&levels=-3", "steps=<img src=x>&points=1,1;2,2;3,4"):
            self.start(wrong)
            self.assertTrue(len(self.points()) > 0, wrong)
        self.assertEqual(self.console_errors(), [])

    # -- eyes and ears -------------------------------------------------------------------------------------------------

    def test_every_control_has_a_name_and_the_summary_speaks(self):
        self.start()
        self.assertEqual(self.nameless(), [])
        self.assertEqual(self.skipped_headings(), [])
        names = [n["name"] for n in self.accessibility() if n["role"] == "slider"]
        for name in ("s, step 1, slider", "Levels", "Size of the combs"):
            self.assertIn(name, names)
        self.assertEqual(self.script("return document.getElementById('summary').getAttribute('role')"), "status")
        self.assertTrue(re.search(r"C2.*exponent 3.log2\(3/2\).*area", self.text("#summary")))

    def test_narrow_wide_light_and_dark(self):
        for scheme in ("light", "dark"):
            for width in (320, 390, 800, 1600):
                self.size(width, 800)
                self.scheme(scheme)
                self.start("steps=-7/4,59/52;3/2&points=0,0;4,1;8,0;7,4;9,7;5,5;1,8&show=curvature,jerk,edges")
                self.assertEqual(self.sticking_out(), [], width)
                self.assertEqual(self.low_contrast(), [], (scheme, width))
        self.screenshots("explorer")

    def test_links_lead_somewhere(self):
        self.start()
        self.set("#preset", "{J(0.836), *J(-0.531)}", "change")
        self.assertEqual(self.broken_links(), [])

    def test_saved_files(self):
        self.start("steps=1/2&levels=2&points=0,0;6,0;3,5.5")
        self.assertEqual(self.script("return csv(state.points)"), "x,y\n0,0\n6,0\n3,5.5\n")
        self.assertEqual(len(self.script("return curveCsv()").strip().split("\n")), 13)
        picture = self.script("return pictureSvg()")
        problem = self.script("return new DOMParser().parseFromString(arguments[0], 'image/svg+xml')"
                              ".querySelector('parsererror')?.textContent ?? ''", picture)
        self.assertEqual(problem, "")


if __name__ == "__main__":
    browser.main()
