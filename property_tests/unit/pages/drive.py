"""Writes every walkthrough's page and that of a small check, and uses them as a reader would, in headless Chromium.

    python3 drive.py --walk build/bin/rayproof-walk --check build/bin/rayproof-check

Exit status 0: all is well; 1: a page is at fault; 77: there is no Chromium, so nothing was tested."""

import argparse
import base64
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time

import devtools

VISIBLE = "[...document.querySelectorAll('.step')].map((s, i) => [s, i]).filter(([s]) => s.offsetHeight > 0).map(([, i]) => i)"
# The picture itself, drawn anew so that its pixels are still there to be read.
# Where the tips of the axes are drawn; nothing where they are not shown.
AXES = """[...document.querySelectorAll('#scene .axes line')].filter(line => line.getClientRects().length)
    .map(line => `${line.getAttribute('x2')},${line.getAttribute('y2')}`).join(' ')"""
SCENE = "(walkthrough.scene.draw(), walkthrough.scene.renderer.domElement.toDataURL())"
# Labels that reach out of the picture, or lie upon each other.
MISPLACED = """(() => {
  const frame = document.getElementById('scene').getBoundingClientRect(), bad = [];
  const boxes = [...document.querySelectorAll('.labels span')].filter(e => e.offsetParent).map(e => [e.textContent, e.getBoundingClientRect(), e.className === 'is-bright']);
  for (const [text, b] of boxes) if (b.left < frame.left - 2 || b.top < frame.top - 2 || b.right > frame.right + 2 || b.bottom > frame.bottom + 2) bad.push(`${text} is cut`);
  boxes.forEach(([text, a, isNew], i) => boxes.slice(0, i).forEach(([other, b, otherIsNew]) => {
    const x = Math.min(a.right, b.right) - Math.max(a.left, b.left), y = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
    if ((isNew || otherIsNew) && x > 3 && y > 7) bad.push(`${text} lies on ${other}`);
  }));
  return bad;
})()"""
# Where the page shows a step's points, its labels' anchors among them, and where its labels were put.
SEEN = """(() => {
  const scene = walkthrough.scene, frame = scene.labels.element.getBoundingClientRect();
  const points = scene.step.bodies.flatMap(body => body.pieces ? body.pieces.flat() : body.points);
  const labels = scene.labels.all.filter(label => label.object.visible).map(label => {
    const b = label.object.element.getBoundingClientRect();
    return [label.object.position.toArray(), [b.left + b.width / 2 - frame.left, b.top + b.height / 2 - frame.top]];
  });
  const {step, width, height} = scene;
  return {points, seen: vectorsOf(points).map(scene.seen, scene), labels, width, height, angle: scene.space.angle,
          eye: step.eye, target: step.target, up: step.up, half: step.half || 0};
})()"""

# Equations and readings that run out of their column.
CUT_OFF = """[...document.querySelectorAll('.step.shown .equation span, #live-part .wide')]
  .filter(e => e.scrollWidth > e.clientWidth + 1).map(e => e.textContent)"""


def float32(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def plus(a, b, factor=1):
    return [x + factor * y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def pinhole(camera, point):
    """The pixel in which the point is seen; None where it is not before the eye. VTK is held to the same formula in
    property_tests/unit/vtk/space_test.cpp."""
    toward = unit(plus(camera["eye"], camera["target"], -1))
    right = unit(cross(camera["up"], toward))
    off = plus(point, camera["eye"], -1)
    depth = -dot(off, toward)
    half = camera["half"] or depth * math.tan(math.radians(camera["angle"] / 2))
    scale = camera["height"] / 2 / half if half > 0 else 0
    if depth <= 0:
        return None
    return [camera["width"] / 2 + scale * dot(off, right), camera["height"] / 2 - scale * dot(off, cross(toward, right))]


class Test:
    def __init__(self, page, name):
        self.page, self.name, self.failures = page, name, []

    def expect(self, holds, what):
        if not holds:
            self.failures.append(f"{self.name}: {what}")

    def steps(self):
        page = self.page
        count = page.run("walkthrough.data.steps.length")
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
            page.run(f"walkthrough.show({step})")
            self.expect(page.run("walkthrough.scene.renderer.info.render.triangles") > 0, f"step {step + 1} shows nothing")
            for fault in page.run(MISPLACED):
                self.expect(False, f"step {step + 1}: {fault}")
            self.places(step)

    def places(self, step):
        """Every point and label is where the step's camera has it, to a tenth of a pixel and to half of one."""
        seen = self.page.run(SEEN)
        points = [seen["points"][i:i + 3] for i in range(0, len(seen["points"]), 3)]
        off = [math.dist(at, expected) for at, expected in zip(seen["seen"], map(lambda p: pinhole(seen, p), points))
               if expected and None not in at and max(map(abs, expected)) < 5000]
        self.expect(len(off) > 0 and max(off) < 0.1, f"step {step + 1}: points are {max(off, default=9)} pixels away")
        for anchor, at in seen["labels"]:
            self.expect(math.dist(at, pinhole(seen, anchor)) < 0.5, f"step {step + 1}: a label at {at} belongs to {pinhole(seen, anchor)}")

    def orbit(self):
        page = self.page
        # A step in space, if the walkthrough has one.
        page.run("walkthrough.show(Math.max(0, walkthrough.scene.space.steps.findIndex((s, i) => i > 0 && !s.flat)))")
        page.run("document.getElementById('scene').scrollIntoView({block: 'center'})")
        is_flat = page.run("!!walkthrough.scene.step.flat")
        nearest = ("(() => { const {scene} = walkthrough, {step} = scene, t = new THREE.Vector3().fromArray(step.target);"
                   " return scene.seen(t.lerp(new THREE.Vector3().fromArray(step.eye), 0.2)); })()")
        page.run("document.getElementById('reset').click()")
        before, (x0, y0), axes = page.run(SCENE), page.run(nearest), page.run(AXES)
        x, y = page.middle_of("#scene")
        page.mouse("mousePressed", x, y)
        page.mouse("mouseMoved", x + 60, y + 25)
        page.mouse("mouseReleased", x + 60, y + 25)
        self.expect((page.run(SCENE) == before) == is_flat, "dragging ought to turn what is not flat, and nothing else")
        self.expect(is_flat or len(set(axes.split())) == 3, "each axis is to be seen in a direction of its own")
        self.expect((page.run(AXES) == axes) == is_flat, "the axes ought to turn with the scene")
        x1, y1 = page.run(nearest)
        self.expect(is_flat or (x1 > x0 + 5 and y1 > y0 + 5), "what is nearest to the eye ought to follow the pointer, right and down")
        for fault in page.run(MISPLACED):
            self.expect(False, f"turned: {fault}")
        page.run("document.getElementById('reset').click()")
        self.expect(page.run(SCENE) == before, "Reset view ought to bring the first view back")
        page.run("document.getElementById('scene').focus()")
        page.press("ArrowUp")
        self.expect(is_flat or page.run(nearest)[1] < y0 - 2, "the key ↑ ought to move what is nearest upward")
        page.press("+")
        self.expect(page.run("walkthrough.scene.camera.zoom") > 1, "the key + ought to lead nearer")
        page.run("document.getElementById('reset').click(); document.activeElement.blur()")
        self.expect(page.run(SCENE) == before, "Reset view ought to undo keys as well")

    def swipe(self):
        page = self.page
        page.run("walkthrough.show(0)")
        x, y = page.middle_of(".step.shown h2")
        page.send("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        page.send("Input.dispatchTouchEvent", type="touchMove", touchPoints=[{"x": x - 120, "y": y + 5}])
        page.send("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        # The page's listeners are passive, so that Chromium says "done" before they have heard of the finger.
        deadline = time.monotonic() + 20
        while page.run(VISIBLE) != [1] and time.monotonic() < deadline:
            time.sleep(0.1)
        self.expect(page.run(VISIBLE) == [1], "a finger from right to left ought to lead a step on")

    def slider(self):
        page = self.page
        if not page.run("!!walkthrough.data.slider"):
            return
        # Of the steps in the world, the one that looks from nearest: from far off no step of the slider would show.
        page.run("walkthrough.show(walkthrough.data.steps.map((s, i) => [s.magnification === undefined ? asNumber(s.view.radius) : Infinity, i])"
                 ".sort((a, b) => a[0] - b[0])[0][1]); document.getElementById('slider').focus()")
        before, scene = page.run("walkthrough.t"), page.run(SCENE)
        page.press("ArrowRight")
        page.press("ArrowRight")
        self.expect(page.run("walkthrough.t") > before, "an arrow key ought to move the slider")
        self.expect(page.run(SCENE) != scene, "the slider ought to move the point")
        if not page.run("walkthrough.data.slider.shows_point && walkthrough.data.precision === 'float32'"):
            return
        t, o, d = page.run("[walkthrough.t, walkthrough.data.slider.origin, walkthrough.data.slider.direction]")
        expected = [float32(float32(a) + float32(t * float32(b))) for a, b in zip(o, d)]
        shown = page.run("document.querySelector('#live td').textContent").strip("()").split(", ")
        self.expect([float32(float(x)) for x in shown] == expected, f"p(t) is {expected}, shown as {shown}")
        page.run("document.activeElement.blur()")

    def numbers(self):
        """The tables show the decimals of the data, and those read back as the very numbers."""
        rows = self.page.run("walkthrough.data.steps.map(s => s.values.flatMap(v => v.components.map(c => [c.value, c.shown])))")
        tables = self.page.run("walkthrough.sections.map(s => [...s.querySelectorAll('tbody tr')].map(r => r.cells[1].textContent))")
        single = self.page.run("walkthrough.data.precision === 'float32'")
        for number, (row, cells) in enumerate(zip(rows, tables)):
            self.expect([shown for _, shown in row] == cells, f"the table of step {number + 1} is not the data's")
            for value, shown in row:
                if not isinstance(value, str):
                    self.expect((float32(float(shown)) if single else float(shown)) == value, f"{shown} is not {value}")

    def media(self):
        page = self.page
        page.send("Emulation.setEmulatedMedia", media="print")
        count = page.run("walkthrough.data.steps.length")
        self.expect(page.run(VISIBLE) == list(range(count)), "all steps are to be printed")
        self.expect(page.run("[...document.querySelectorAll('.step figure')].every(f => f.firstElementChild.getBoundingClientRect().height > 50)"),
                    "each printed step is to have its picture")
        paper = base64.b64decode(page.send("Page.printToPDF")["data"])
        self.expect(paper.startswith(b"%PDF") and paper.count(b"/Type /Page\n") + paper.count(b"/Type /Page ") >= 1, "the page ought to print")
        page.send("Emulation.setEmulatedMedia", media="")
        light = page.run(SCENE)
        page.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
        self.expect(any(page.run(SCENE) != light for _ in range(50)), "in the dark the picture is to be light on dark")
        page.send("Emulation.setEmulatedMedia", features=[])
        page.send("Emulation.setDeviceMetricsOverride", width=900, height=740, deviceScaleFactor=1, mobile=False)
        self.fits(900)
        page.send("Emulation.clearDeviceMetricsOverride")

    def fits(self, width):
        """Nothing runs out of the page, its column or the picture."""
        page = self.page
        wide = page.run("document.documentElement.scrollWidth")
        self.expect(wide <= width, f"in {width} pixels the page is {wide} wide")
        for step in range(page.run("walkthrough.data.steps.length")):
            page.run(f"walkthrough.show({step})")
            for fault in page.run(CUT_OFF) + page.run(MISPLACED):
                self.expect(False, f"step {step + 1}, {width} pixels wide: {fault}")

    def phone(self):
        self.page.send("Emulation.setDeviceMetricsOverride", width=360, height=740, deviceScaleFactor=1, mobile=True)
        self.fits(360)
        self.page.send("Emulation.clearDeviceMetricsOverride")

    def all(self, number, every):
        """The numbers of every page. Drawing in software takes seconds, so that steps, slider and a phone's width are tried in
        one page of `every`, and what is the same script's work in all of them in a third of those."""
        self.numbers()
        if number % every == 0:
            parts = [self.steps, self.slider, self.phone]
            if number % (3 * every) == 0:
                parts += [self.swipe, self.orbit, self.media]
            for part in parts:
                part()
        return self.ended()

    def without_webgl(self):
        """Every step's still picture stands where the scene would be."""
        self.numbers()
        for step in range(self.page.run("walkthrough.data.steps.length")):
            self.page.run(f"walkthrough.show({step})")
            self.expect(self.page.run("document.querySelector('#scene > :is(img, svg)')?.getBoundingClientRect().height > 100"),
                        f"step {step + 1} ought to show its still picture")
        return self.ended()

    def ended(self):
        return self.failures + [f"{self.name}: {fault}" for fault in self.page.faults()]


def drive_cases(path, browser):
    """A page of many cases: thumbnails come as they are scrolled to, one scene is open at a time."""
    failures = []
    page = devtools.Page(browser, path.as_uri())

    def expect(holds, what):
        if not holds:
            failures.append(f"{path.parent.name}: {what}")

    count = page.run("document.querySelectorAll('.case').length")
    expect(count > 3, f"{count} findings have a picture")
    drawn = "[...document.querySelectorAll('.case')].filter(c => c.classList.contains('drawn')).length"
    page.run("document.querySelector('.case').scrollIntoView()")
    deadline = time.monotonic() + 60
    while page.run(drawn) == 0 and time.monotonic() < deadline:
        time.sleep(0.1)
    expect(0 < page.run(drawn) < count, f"{page.run(drawn)} of {count} thumbnails are drawn before anybody saw them")
    page.click(".case .thumbnail")
    expect(page.run("document.querySelectorAll('.case.open canvas').length") == 1, "a click on a thumbnail ought to open its scene")
    for number in (1, 2):
        page.run(f"document.querySelectorAll('.case')[{number}].querySelector('.looking button:last-child').click()")
        expect(page.run("document.querySelectorAll('canvas').length") == 1, "one scene is to be open at a time")
        expect(page.run("cases.scene.renderer.info.render.triangles") > 0, f"finding {number + 1} shows nothing")
    page.press("Escape")
    expect(page.run("document.querySelectorAll('.case.open').length") == 0, "Escape ought to close it")
    page.send("Emulation.setEmulatedMedia", media="print")
    expect(page.run("[...document.querySelectorAll('.case > svg')].every(s => s.getBoundingClientRect().height > 50)"), "each is to be printed")
    failures += [f"{path.parent.name}: {fault}" for fault in page.faults()]
    page.close()
    return failures


def drive(folder, browser, plain, every):
    """Every page is opened in `browser`, and in `plain`, which has no WebGL."""
    failures = []
    pages = sorted(path for path in folder.glob("*.html") if path.name != "index.html")
    for number, path in enumerate(pages):
        if path.stat().st_size + (folder / "walkthrough.js").stat().st_size > 1_500_000:
            failures.append(f"{path.name}: {path.stat().st_size} bytes are more than 1.5 MB with the script")
        page = devtools.Page(browser, path.as_uri())
        failures += Test(page, path.name).all(number, every)
        page.close()
        page = devtools.Page(plain, path.as_uri())
        failures += Test(page, f"{path.name} without WebGL").without_webgl()
        page.close()
    gallery = devtools.Page(browser, (folder / "index.html").as_uri())
    links = gallery.run("[...document.querySelectorAll('.gallery a')].map(a => a.getAttribute('href'))")
    if sorted(links) != [path.name for path in pages]:
        failures.append("index.html does not link every page once")
    failures += [f"index.html: {fault}" for fault in gallery.faults()]
    print(f"{len(pages)} pages driven, {len(failures)} faults")
    return failures


def write(options, folder):
    """Writes the pages. Their still pictures by VTK take a second each, so that they are flat unless every page is used."""
    environment = dict(os.environ)
    if options.every > 1:
        environment["PATH"] = "/nowhere"  # where there is no Xvfb
    subprocess.run([pathlib.Path(options.walk).resolve(), options.topic, "--html", folder], check=True, env=environment)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--walk", required=True, help="the program rayproof-walk")
    parser.add_argument("--check", required=True, help="the program rayproof-check")
    parser.add_argument("--topic", default="all")
    parser.add_argument("--every", type=int, default=8, help="drawn and used is one page of this many; 1: and stills by VTK")
    options = parser.parse_args()
    program = devtools.find_browser()
    if program is None:
        print("skipped: Chromium was not found (Debian package chromium)")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        write(options, folder)
        browser, plain = devtools.Browser(program), devtools.Browser(program, ["--disable-3d-apis"])
        try:
            failures = drive(pathlib.Path(folder), browser, plain, options.every)
            for shape in ("sphere", "triangle", "polygon"):
                check = pathlib.Path(folder) / f"check-{shape}"
                subprocess.run([options.check, "--cases", "300", "--shape", shape, "--out", check], check=True, stdout=subprocess.DEVNULL)
                failures += drive_cases(check / "index.html", browser)
        finally:
            browser.close()
            plain.close()
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
