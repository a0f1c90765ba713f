"""Writes every walkthrough's page and uses it as a reader would, in headless Chromium.

    python3 drive.py --walk build/bin/rayproof-walk

Exit status 0: all is well; 1: a page is at fault; 77: there is no Chromium, so nothing was tested."""

import argparse
import pathlib
import struct
import subprocess
import sys
import tempfile

import devtools

VISIBLE = "[...document.querySelectorAll('.step')].map((s, i) => [s, i]).filter(([s]) => s.offsetHeight > 0).map(([, i]) => i)"
SCENE = "document.getElementById('scene').innerHTML"
# Labels that reach out of the picture, or lie upon each other.
MISPLACED = """(() => {
  const boxes = [...document.querySelectorAll('#scene text')].map(t => [t.textContent, t.getBBox(), t.hasAttribute('font-weight')]), bad = [];
  for (const [text, b] of boxes) if (b.x < -1 || b.y < -1 || b.x + b.width > 641 || b.y + b.height > 431) bad.push(`${text} is cut`);
  boxes.forEach(([text, a, isNew], i) => boxes.slice(0, i).forEach(([other, b, otherIsNew]) => {
    const x = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x), y = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
    if ((isNew || otherIsNew) && x > 3 && y > 5) bad.push(`${text} lies on ${other}`);
  }));
  return bad;
})()"""

# Equations and readings that run out of their column.
CUT_OFF = """[...document.querySelectorAll('.step.shown .equation span, #live-part .wide')]
  .filter(e => e.scrollWidth > e.clientWidth + 1).map(e => e.textContent)"""


def float32(x):
    return struct.unpack("f", struct.pack("f", x))[0]


class Test:
    def __init__(self, page, name):
        self.page, self.name, self.failures = page, name, []

    def expect(self, holds, what):
        if not holds:
            self.failures.append(f"{self.name}: {what}")

    def steps(self):
        page = self.page
        count = page.run("data.steps.length")
        self.expect(page.run(VISIBLE) == [0], "the first step alone is to be seen at first")
        for key, step in (("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1), ("End", count - 1), ("ArrowRight", count - 1),
                          ("Home", 0), ("3", 2)):
            page.press(key)
            self.expect(page.run(VISIBLE) == [step], f"key {key} ought to lead to step {step + 1}")
        page.click("#steps button:nth-child(2)")
        self.expect(page.run(VISIBLE) == [1], "button 2 ought to lead to step 2")
        page.click("#next")
        self.expect(page.run(VISIBLE) == [2], "the button → ought to lead on")
        self.expect("Step 3 of" in page.run("document.getElementById('place').textContent"), "the step is to be announced")
        for step in range(count):
            page.run(f"show({step})")
            self.expect(page.run("document.querySelectorAll('#scene path').length") > 0, f"step {step + 1} shows nothing")
            for fault in page.run(MISPLACED):
                self.expect(False, f"step {step + 1}: {fault}")

    def orbit(self):
        page = self.page
        page.run("show(1); document.getElementById('scene').scrollIntoView({block: 'center'})")
        before = page.run(SCENE)
        x, y = page.middle_of("#scene")
        page.mouse("mousePressed", x, y)
        page.mouse("mouseMoved", x + 60, y + 25)
        page.mouse("mouseReleased", x + 60, y + 25)
        is_flat = page.run("data.camera.flat")
        self.expect((page.run(SCENE) == before) == is_flat, "dragging ought to turn what is not flat, and nothing else")
        right, up = page.run("[dot(first().toward, eye.right), dot(first().toward, eye.up)]")
        self.expect(is_flat or (right > 0.1 and up < -0.1), "what is nearest to the eye ought to follow the pointer, right and down")
        page.run("document.getElementById('reset').click()")
        self.expect(page.run(SCENE) == before, "Reset view ought to bring the first view back")
        page.run("document.getElementById('scene').focus()")
        page.press("ArrowUp")
        self.expect(is_flat or page.run("dot(first().toward, eye.up)") > 0.05, "the key ↑ ought to move what is nearest upward")
        self.expect((page.run(SCENE) == before) == is_flat, "arrow keys ought to turn the picture in focus")
        page.run("document.getElementById('reset').click(); document.activeElement.blur()")

    def slider(self):
        page = self.page
        if not page.run("!!data.slider"):
            return
        # Of the steps in the world, the one that looks from nearest: from far off no step of the slider would show.
        page.run("show(steps.map((s, i) => [s.magnification === undefined ? number(s.view.radius) : Infinity, i])"
                 ".sort((a, b) => a[0] - b[0])[0][1]); document.getElementById('slider').focus()")
        before, scene = page.run("t"), page.run(SCENE)
        page.press("ArrowRight")
        page.press("ArrowRight")
        self.expect(page.run("t") > before, "an arrow key ought to move the slider")
        self.expect(page.run(SCENE) != scene, "the slider ought to move the point")
        if not page.run("data.slider.shows_point && data.precision === 'float32'"):
            return
        t, o, d = page.run("[t, data.slider.origin, data.slider.direction]")
        expected = [float32(float32(a) + float32(t * float32(b))) for a, b in zip(o, d)]
        shown = page.run("document.querySelector('#live td').textContent").strip("()").split(", ")
        self.expect([float32(float(x)) for x in shown] == expected, f"p(t) is {expected}, shown as {shown}")
        page.run("document.activeElement.blur()")

    def numbers(self):
        """The tables show the decimals of the data, and those read back as the very numbers."""
        rows = self.page.run("data.steps.map(s => s.values.flatMap(v => v.components.map(c => [c.value, c.shown])))")
        tables = self.page.run("sections.map(s => [...s.querySelectorAll('tbody tr')].map(r => r.cells[1].textContent))")
        single = self.page.run("data.precision === 'float32'")
        for number, (row, cells) in enumerate(zip(rows, tables)):
            self.expect([shown for _, shown in row] == cells, f"the table of step {number + 1} is not the data's")
            for value, shown in row:
                if not isinstance(value, str):
                    self.expect((float32(float(shown)) if single else float(shown)) == value, f"{shown} is not {value}")

    def media(self):
        page = self.page
        page.send("Emulation.setEmulatedMedia", media="print")
        count = page.run("data.steps.length")
        self.expect(page.run(VISIBLE) == list(range(count)), "all steps are to be printed")
        self.expect(page.run("[...document.querySelectorAll('.step figure svg')].every(s => s.getBoundingClientRect().height > 50)"),
                    "each printed step is to have its picture")
        page.send("Emulation.setEmulatedMedia", media="")
        for width in (360, 900, 1250):
            page.send("Emulation.setDeviceMetricsOverride", width=width, height=740, deviceScaleFactor=2, mobile=width < 500)
            wide = page.run("document.documentElement.scrollWidth")
            self.expect(wide <= width, f"in {width} pixels the page is {wide} wide")
            for step in range(count):
                page.run(f"show({step})")
                for fault in page.run(CUT_OFF) + page.run(MISPLACED):
                    self.expect(False, f"step {step + 1}, {width} pixels wide: {fault}")
        page.send("Emulation.clearDeviceMetricsOverride")

    def all(self):
        for part in (self.steps, self.orbit, self.slider, self.numbers, self.media):
            part()
        for fault in self.page.faults():
            self.expect(False, fault)
        return self.failures


def drive(folder, browser):
    failures = []
    pages = sorted(path for path in folder.glob("*.html") if path.name != "index.html")
    for path in pages:
        if path.stat().st_size > 300_000:
            failures.append(f"{path.name}: {path.stat().st_size} bytes are more than 300 kB")
        page = devtools.Page(browser, path.as_uri())
        failures += Test(page, path.name).all()
        page.close()
    gallery = devtools.Page(browser, (folder / "index.html").as_uri())
    links = gallery.run("[...document.querySelectorAll('.gallery a')].map(a => a.getAttribute('href'))")
    if sorted(links) != [path.name for path in pages]:
        failures.append("index.html does not link every page once")
    failures += [f"index.html: {fault}" for fault in gallery.faults()]
    print(f"{len(pages)} pages driven, {len(failures)} faults")
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--walk", required=True, help="the program rayproof-walk")
    parser.add_argument("--topic", default="all")
    options = parser.parse_args()
    program = devtools.find_browser()
    if program is None:
        print("skipped: Chromium was not found (Debian package chromium)")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([options.walk, options.topic, "--html", folder], check=True)
        browser = devtools.Browser(program)
        try:
            failures = drive(pathlib.Path(folder), browser)
        finally:
            browser.close()
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
