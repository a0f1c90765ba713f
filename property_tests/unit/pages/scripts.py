"""What the tests ask a page in its own language."""

# The numbers of the steps that are shown.
VISIBLE = "[...document.querySelectorAll('.step')].map((s, i) => [s, i]).filter(([s]) => s.offsetHeight > 0).map(([, i]) => i)"
# Where the tips of the axes are drawn; nothing where they are not shown.
AXES = """[...document.querySelectorAll('#scene .axes line')].filter(line => line.getClientRects().length)
    .map(line => `${line.getAttribute('x2')},${line.getAttribute('y2')}`).join(' ')"""
# The picture itself, drawn anew so that its pixels are still there to be read.
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
