"""The page of a check, used as a reader would."""

import time

import devtools


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
