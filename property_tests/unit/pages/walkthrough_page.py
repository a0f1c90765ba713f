"""A walkthrough's page, used as a reader would."""

import base64
import math
import struct
import time

from pinhole import pinhole
from scripts import AXES, CUT_OFF, MISPLACED, SCENE, SEEN, VISIBLE


def float32(x):
    return struct.unpack("f", struct.pack("f", x))[0]


class WalkthroughTest:
    """Of one open page; what is at fault is kept in `failures`."""

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
