#pragma once
/// \file
/// The page's script, first part: how a stage's items are seen. The same as scene_picture.cpp draws, from any
/// side.

namespace rayproof::viz {

inline constexpr const char* page_scene = R"js(
const data = JSON.parse(document.getElementById('stage').textContent);
const figure = document.getElementById('scene'), W = 640, H = 430;
const number = x => typeof x === 'number' ? x : x === 'inf' ? Infinity : x === '-inf' ? -Infinity : NaN;
const dot = (a, b) => a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
const plus = (a, b, s = 1) => [a[0] + s*b[0], a[1] + s*b[1], a[2] + s*b[2]];
const cross = (a, b) => [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]];
const unit = v => { const n = Math.hypot(...v) || 1; return v.map(x => x / n); };
const first = () => ({right: data.camera.right.map(number), up: data.camera.up.map(number), toward: data.camera.toward.map(number)});
let eye = first(), zoom = 1, place = 0;
const moved = () => dot(eye.toward, first().toward) < 0.9999 || dot(eye.up, first().up) < 0.9999;
/** The scene turned before the eye: what is nearest moves by this many radians to the right and upward. */
function turn(rightward, upward) {
  if (data.camera.flat) return;
  const mix = (a, b, angle) => plus(a.map(x => x * Math.cos(angle)), b, Math.sin(angle));
  const {right, up, toward} = eye;
  eye.right = mix(right, toward, rightward);
  eye.toward = unit(mix(mix(toward, right, -rightward), up, -upward));
  eye.right = unit(plus(eye.right, eye.toward, -dot(eye.right, eye.toward)));
  eye.up = cross(eye.toward, eye.right);
  draw();
}
const hullOf = points => {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]), half = list => {
    const chain = [];
    for (const p of list) {
      while (chain.length > 1) {
        const a = chain[chain.length - 2], b = chain[chain.length - 1];
        if ((b[0]-a[0])*(p[1]-a[1]) > (b[1]-a[1])*(p[0]-a[0])) break;
        chain.pop();
      }
      chain.push(p);
    }
    chain.pop();
    return chain;
  };
  return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
};
function ellipse([centre, ...tips]) {
  let xx = 0, xy = 0, yy = 0;
  for (const p of tips) { const x = p[0]-centre[0], y = p[1]-centre[1]; xx += x*x; xy += x*y; yy += y*y; }
  return Array.from({length: 73}, (_, i) => {
    const a = i * Math.PI / 36, c = Math.cos(a), s = Math.sin(a), n = Math.sqrt(Math.max(xx*c*c + 2*xy*c*s + yy*s*s, 1e-300));
    return [centre[0] + (xx*c + xy*s) / n, centre[1] + (xy*c + yy*s) / n];
  });
}
/** The part of a segment inside the frame, or null: Liang and Barsky. */
function inFrame(a, b) {
  let from = 0, to = 1;
  const d = [b[0]-a[0], b[1]-a[1]];
  for (const [p, q] of [[-d[0], a[0]+2], [d[0], W+2-a[0]], [-d[1], a[1]+2], [d[1], H+2-a[1]]]) {
    if (p === 0) { if (q < 0) return null; continue; }
    if (p < 0) from = Math.max(from, q / p); else to = Math.min(to, q / p);
  }
  return from <= to ? [[a[0]+from*d[0], a[1]+from*d[1]], [a[0]+to*d[0], a[1]+to*d[1]]] : null;
}
const textWidth = (text, size) => [...text].reduce((sum, c) => sum + (/[ ,.'|iIjl:;!()ftr\u2080-\u209f]/.test(c) ? 0.4 : /[\u20d0-\u20ff\u0300-\u036f]/.test(c) ? 0 : /[mwMW=+\u2212%]/.test(c) ? 0.88 : 0.64), 0) * size;
class Places {
  taken = []; avoided = [];
  take(p, r) { this.taken.push([p[0]-r, p[1]-r, p[0]+r, p[1]+r]); }
  avoid(a, b, cost) {
    const n = Math.min(200, Math.max(1, Math.round(Math.hypot(b[0]-a[0], b[1]-a[1]) / 6)));
    for (let i = 0; i <= n; ++i) this.avoided.push([a[0] + (b[0]-a[0])*i/n, a[1] + (b[1]-a[1])*i/n, cost]);
  }
  cost(box, most) {
    const shared = (a, b) => Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
    let cost = 20 * ((box[2]-box[0]) * (box[3]-box[1]) - shared(box, [4, 4, W-4, H-4]));
    for (const other of this.taken) cost += 10 * shared(box, other);
    if (cost >= most) return cost;
    for (const [x, y, extra] of this.avoided) if (x >= box[0] && x <= box[2] && y >= box[1] && y <= box[3]) cost += extra;
    return cost;
  }
  putAt(text, at, size) {
    const w = textWidth(text, size) * 1.1 + 4, h = size * 1.15;
    const x = Math.max(Math.min(at[0], W - w/2), w/2);
    this.taken.push([x - w/2, at[1] - h/2, x + w/2, at[1] + h/2]);
    return [x, at[1] + h/2 - size * 0.27];
  }
  put(text, anchors, size, must) {
    const w = textWidth(text, size) * 1.1 + 4, h = size * 1.15;
    let best = null, least = Infinity;
    anchors.forEach((at, k) => { for (const away of [13, 22, 34, 48]) for (let i = 0; i < 16; ++i) {
      const angle = Math.PI * (0.25 + i / 8), x = at[0] + (away + w/2) * Math.cos(angle), y = at[1] - (away + h/4) * Math.sin(angle);
      const box = [x - w/2, y - h/2, x + w/2, y + h/2], penalty = away * 1.5 + i * 0.4 + k * 5, cost = penalty + this.cost(box, least - penalty);
      if (cost < least) { least = cost; best = box; }
    } });
    if (!must && least > 150) return null;
    this.taken.push(best);
    return [(best[0] + best[2]) / 2, best[3] - size * 0.27];
  }
}
)js";

}  // namespace rayproof::viz
