'use strict';
/* Labels beside what they name, so that none covers another, a mark or, where there is room, a line. */

const labelOffsets = [13, 22, 34, 48].flatMap(away => Array.from({length: 16}, (_, i) => ({away, angle: Math.PI * (0.25 + i / 8), cost: 1.5 * (away + Math.max(0, away - 34)) + i * 0.4})));
const sharedArea = (a, b) => Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
const boxAround = (x, y, w, h) => [x - w / 2, y - h / 2, x + w / 2, y + h / 2];

/** What of the picture is taken: boxes of labels and marks, and places on lines that cost. */
class Places {
  constructor(width, height) { this.frame = [2, 2, width - 2, height - 2]; this.taken = []; this.avoided = []; }
  isIn([x, y]) { return x >= 0 && y >= 0 && x <= this.frame[2] + 2 && y <= this.frame[3] + 2; }
  avoid([ax, ay], [bx, by], cost) {
    const n = Math.min(150, Math.max(1, Math.round(Math.hypot(bx - ax, by - ay) / 6)));
    for (let i = 0; i <= n; ++i) this.avoided.push([ax + (bx - ax) * i / n, ay + (by - ay) * i / n, cost]);
  }
  cost(box, most) {
    let cost = 20 * ((box[2] - box[0]) * (box[3] - box[1]) - sharedArea(box, this.frame));
    for (const other of this.taken) cost += 10 * sharedArea(box, other);
    if (cost >= most) return cost;
    for (const [x, y, extra] of this.avoided) if (x >= box[0] && x <= box[2] && y >= box[1] && y <= box[3]) cost += extra;
    return cost;
  }
  isFree(box) { return this.cost(box, Infinity) <= 20 * ((box[2] - box[0]) * (box[3] - box[1]) - sharedArea(box, this.frame)); }
  /** The best place for a label of this size at one of the anchors, the first of which is the best. */
  best(anchors, w, h, before) {
    let best = null, least = Infinity;
    anchors.forEach((at, k) => labelOffsets.forEach((offset, i) => {
      const x = at[0] + (offset.away + w / 2) * Math.cos(offset.angle), y = at[1] - (offset.away + h / 2) * Math.sin(offset.angle);
      const box = boxAround(x, y, w, h), penalty = offset.cost + k * 5 - (before === i ? 12 : 0), cost = penalty + this.cost(box, least - penalty);
      if (cost < least) { least = cost; best = {box, x, y, anchor: k, offset: i}; }
    }));
    return best && {...best, cost: least};
  }
}

/** Which way the axes of a scene point, in the first corner that nothing of it crosses, else the lower left one; no label stands there. */
class Axes {
  constructor() {
    this.at = 0;
    this.element = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    this.element.setAttribute('class', 'axes');
    this.element.setAttribute('viewBox', '-1.6 -1.6 3.2 3.2');
    this.element.setAttribute('aria-hidden', 'true');
    this.element.innerHTML = ['x', 'y', 'z'].map(name => `<g class="${name}"><line/><text>${name}</text></g>`).join('');
  }
  turn(camera, isShown, places) {
    this.element.style.display = isShown ? '' : 'none';
    if (!isShown) return;
    const back = camera.quaternion.clone().conjugate();
    [...this.element.children].forEach((part, i) => {
      const tip = new THREE.Vector3().setComponent(i, 1).applyQuaternion(back), [line, text] = part.children;
      Object.entries({x2: tip.x, y2: -tip.y}).forEach(([name, value]) => line.setAttribute(name, value.toFixed(3)));
      Object.entries({x: 1.35 * tip.x, y: -1.35 * tip.y}).forEach(([name, value]) => text.setAttribute(name, value.toFixed(3)));
    });
    const [, , right, bottom] = places.frame.map(x => x + 2), size = 0.22 * bottom, low = bottom - size;
    const corners = [[0, low], [right - size, low], [0, 0], [right - size, 0]].map(([x, y]) => [x, y, x + size, y + size]);
    this.at = [this.at, 0, 1, 2, 3].find(i => places.isFree(corners[i])) || 0;
    const corner = corners[this.at];
    Object.assign(this.element.style, {left: `${corner[0]}px`, top: `${corner[1]}px`, width: `${size}px`, height: `${size}px`});
    places.taken.push(corner);
  }
}

/** The labels of a step: HTML with formulas, at places of the scene, moved aside in pixels. */
class Labels {
  constructor(scene) {
    this.renderer = new THREE.CSS2DRenderer();
    this.group = new THREE.Group();
    scene.add(this.group);
    this.element = this.renderer.domElement;
    this.element.className = 'labels';
    this.element.setAttribute('aria-hidden', 'true');
  }
  show(labels) {
    this.group.remove(...this.group.children);
    this.all = labels.map(data => {
      const outer = document.createElement('div'), inner = document.createElement('span');
      inner.innerHTML = data.html;
      inner.className = `is-${data.how}`;
      inner.style.color = `var(--role-${data.role})`;
      outer.append(inner);
      this.element.append(outer);
      const object = new THREE.CSS2DObject(outer);
      this.group.add(object);
      return {data, object, inner, points: vectorsOf(data.points), before: -1};
    });
  }
  /** Where a label may stand, best first: its point, or along what is seen of its line, from the middle. */
  anchorsOf(label, seen, places) {
    if (label.points.length === 1) return label.points.filter(p => places.isIn(seen(p)));
    const [from, to] = label.points, along = Array.from({length: 33}, (_, i) => from.clone().lerp(to, i / 32)).filter(p => places.isIn(seen(p)));
    if (!along.length) return [];
    const shares = label.data.atEnd ? [1] : [0.5, 0.35, 0.65, 0.2, 0.8];
    return shares.map(share => along[Math.round(share * (along.length - 1))]);
  }
  place(seen, places) {
    const written = [];
    for (const label of [...this.all].sort((a, b) => b.data.isText - a.data.isText)) {
      const anchors = this.anchorsOf(label, seen, places), {object, inner, data} = label, spots = anchors.map(seen);
      // The same may stand there already, of a newer step.
      object.visible = anchors.length > 0 && !written.some(([html, [x, y]]) => html === data.html && Math.hypot(x - spots[0][0], y - spots[0][1]) < 12);
      if (!object.visible) continue;
      object.element.style.display = '';
      const w = (label.width = label.width || inner.offsetWidth) + 2, h = (label.height = label.height || inner.offsetHeight);
      let best = places.best(spots, w, h, label.before);
      if (data.isText) {  // it stands at its point where it covers nothing there
        const x = Math.max(Math.min(spots[0][0], places.frame[2] - w / 2), places.frame[0] + w / 2), y = spots[0][1], box = boxAround(x, y, w, h);
        if (places.cost(box, best.cost) < best.cost) best = {x, y, box, anchor: 0};
      }
      object.visible = data.isText || data.how === 'bright' || best.cost < 150;
      if (!object.visible) continue;
      places.taken.push(best.box);
      written.push([data.html, spots[0]]);
      label.before = best.offset;
      object.position.copy(anchors[best.anchor]);
      inner.style.transform = `translate(${(best.x - spots[best.anchor][0]).toFixed(1)}px, ${(best.y - spots[best.anchor][1]).toFixed(1)}px)`;
    }
  }
}
