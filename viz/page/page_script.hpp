#pragma once
/// \file
/// The page's script, second part: drawing a step, the slider, and the ways to move about.

namespace rayproof::viz {

inline constexpr const char* page_controls = R"js(
const steps = data.steps, sections = [...document.querySelectorAll('.step')], slider = document.getElementById('slider');
let t = data.slider ? number(data.slider.start) : 0;
const write = (elements, words) => elements.forEach((element, i) => element.textContent = words[i]);
const path = points => points.map((p, i) => (i ? 'L' : 'M') + p[0].toFixed(1) + ' ' + p[1].toFixed(1)).join('');
const dashes = {dashed: ' stroke-dasharray="7 5"', dotted: ' stroke-dasharray="1.5 5" stroke-linecap="round"'};
function markAt(role, shape, [x, y]) {
  const at = `${x.toFixed(1)} ${y.toFixed(1)}`, line = d => `<path class="l ${role}" stroke-width="2.6" d="${d}"/>`;
  if (shape === 'exact') return `<circle class="l ${role}" stroke-width="2.6" cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="6"/>`;
  if (shape === 'claimed') return line(`M${at}m-6-6l12 12m0-12l-12 12`);
  if (shape === 'nearest') return `<path class="f ${role}" d="M${at}m-6 0l6 6l6-6l-6-6Z"/>`;
  return `<circle class="f ${role}" cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="4.5"/>`;
}
function draw() {
  const step = steps[place], apart = step.magnification !== undefined, centre = step.view.centre.map(number);
  const scale = zoom * Math.min(W / aspect - 56, H - 56) / 2 / number(step.view.radius);
  const seen = p => { const q = plus(p.map(number), centre, -1); return [W/2 + scale * dot(q, eye.right), H/2 - scale * dot(q, eye.up)]; };
  const all = apart ? [] : data.scene.map(item => [item, 'scene']);
  let begun = place;
  while (begun > 0 && !steps[begun].anew) --begun;
  if (!apart) for (let i = begun; i < place; ++i) if (steps[i].magnification === undefined) all.push(...steps[i].items.map(item => [item, 'dimmed']));
  all.push(...step.items.map(item => [item, 'bright']));
  const places = new Places(), fills = [], strokes = [], marks = [], labels = [];
  for (const [item, how] of all) {
    const role = how === 'dimmed' ? 'muted' : item.role, points = item.points.map(seen);
    const inside = p => p[0] >= 0 && p[0] <= W && p[1] >= 0 && p[1] <= H;
    let outline = points, anchors = [points[points.length - 1]];
    if (item.form === 'point') {
      if (!['surface', 'text'].includes(item.role) && inside(points[0])) { marks.push(markAt(role, item.role, points[0])); places.take(points[0], 7); }
    } else {
      if (item.form === 'ellipsoid') outline = ellipse(points);
      if (item.form === 'hull') { outline = hullOf(points); outline.push(outline[0]); }
      if (['ellipsoid', 'hull', 'polygon'].includes(item.form) && how !== 'dimmed') fills.push(`<path class="a ${role}" fill-rule="evenodd" d="${path(outline)}Z"/>`);
      if (item.form !== 'polygon') {
        const width = how === 'bright' ? (item.role === 'frame' ? 1 : 2.8) : how === 'dimmed' ? 1.2 : item.role === 'frame' ? 1 : item.role === 'ray' ? 2 : 1.8;
        const parts = [];
        for (let i = 0; i + 1 < outline.length; ++i) {
          const part = inFrame(outline[i], outline[i+1]);
          if (!part) continue;
          parts.push(part);
          places.avoid(...part, how === 'dimmed' ? 8 : 12);
        }
        const joined = parts.map((p, i) => (i && parts[i-1][1][0] === p[0][0] && parts[i-1][1][1] === p[0][1] ? '' : 'M' + p[0][0].toFixed(1) + ' ' + p[0][1].toFixed(1)) + 'L' + p[1][0].toFixed(1) + ' ' + p[1][1].toFixed(1)).join('');
        const hidden = item.pattern === 'dashed' && how === 'scene' && moved();  // what was hidden is so no more
        strokes.push(`<path class="l ${role}" stroke-width="${hidden ? 1.2 : width}"${hidden ? '' : dashes[item.pattern] || ''} d="${joined}"/>`);
        if (parts.length) {
          const [from, to] = parts[parts.length - 1];
          anchors = item.role === 'ray' || parts.length > 1 ? [to] : [0.5, 0.35, 0.65, 0.2, 0.8].map(part => [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]);
        } else anchors = [];
        const length = Math.hypot(points[1][0] - points[0][0], points[1][1] - points[0][1]);
        if (item.form === 'arrow' && length > 2 && inside(points[1])) {
          const size = Math.min(11, length / 2), a = [(points[1][0]-points[0][0]) / length * size, (points[1][1]-points[0][1]) / length * size];
          const barb = side => [points[1][0] - a[0] - side * a[1] / 2, points[1][1] - a[1] + side * a[0] / 2];
          strokes.push(`<path class="l ${role}" stroke-width="${width}" d="${path([barb(1), points[1], barb(-1)])}"/>`);
        }
      } else anchors = [points.reduce((sum, p) => [sum[0] + p[0] / points.length, sum[1] + p[1] / points.length], [0, 0])];
    }
    anchors = anchors.filter(inside);
    if (item.label && anchors.length) labels.push([item.label, anchors, role, how, item.form === 'point' && item.role === 'text']);
  }
  if (data.slider && !apart) {
    const s = data.slider, at = seen(plus(s.origin.map(number), s.direction.map(number), t));
    if (at[0] >= 0 && at[0] <= W && at[1] >= 0 && at[1] <= H) { marks.push(`<path id="runner" class="f ray" d="M${at[0].toFixed(1)} ${at[1].toFixed(1)}m0 4l-6 11h12Z"/>`); places.take([at[0], at[1] + 10], 7); }
  }
  const k = Math.min(1.6, Math.max(1, 500 / (figure.clientWidth || W)));  // as large on a phone as on a desk
  const words = [], texts = labels.reverse().sort((a, b) => b[4] - a[4]).map(([label, anchors, role, how, isText]) => {
    const bright = how === 'bright', size = Math.round(k * (bright ? 17 : 14)), spot = isText ? places.putAt(label, anchors[0], size) : places.put(label, anchors, size, bright);
    if (spot) words.push(label);
    return spot ? `<text class="f h ${role}" text-anchor="middle" font-size="${size}"${bright ? ' font-weight="bold"' : ''} x="${spot[0].toFixed(1)}" y="${spot[1].toFixed(1)}"></text>` : '';
  });
  figure.innerHTML = fills.join('') + strokes.join('') + marks.join('') + texts.join('');
  write(figure.querySelectorAll('text'), words);
  figure.setAttribute('aria-label', `${step.title}. ${step.caption}`);
  document.getElementById('magnified').textContent = apart && step.magnification !== 1 ? step.scale : data.camera.flat ? '' : 'Drag, or focus the picture and use the arrow keys, to look from another side';
}
function show(to) {
  place = Math.min(Math.max(to, 0), steps.length - 1);
  sections.forEach((section, i) => section.classList.toggle('shown', i === place));
  [...document.querySelectorAll('#steps button')].forEach((button, i) => button.setAttribute('aria-current', i === place ? 'step' : 'false'));
  document.getElementById('back').disabled = place === 0;
  document.getElementById('next').disabled = place === steps.length - 1;
  document.getElementById('place').textContent = `Step ${place + 1} of ${steps.length}: ${steps[place].title}`;
  draw();
}
function run(to) {
  const s = data.slider, single = data.precision === 'float32', round = single ? Math.fround : x => x;
  t = round(to);
  const along = (round, i) => round(round(number(s.origin[i])) + round(t * number(s.direction[i])));
  const horner = (round, list) => list.reduceRight((sum, c) => round(round(sum * t) + round(number(c))), 0);
  const show = x => String(single && Math.fround(x) === x ? shortest(x) : x);
  const rows = s.shows_point ? [['p(t)', '(' + [0, 1, 2].map(i => show(along(round, i))).join(', ') + ')', single ? '(' + [0, 1, 2].map(i => Number(along(x => x, i).toPrecision(12))).join(', ') + ')' : '']] : [];
  for (const r of s.readouts) rows.push([r.label, show(horner(round, r.coefficients)), single ? String(Number(horner(x => x, r.coefficients).toPrecision(12))) : '']);
  document.getElementById('t').textContent = `${s.symbol} = ${show(t)}`;
  const live = document.getElementById('live');
  live.innerHTML = rows.map(([, value, fine]) => `<tr><th scope="row"></th><td class="claimed" data-of="${data.precision}">${value}</td><td class="exact" data-of="in double">${fine}</td></tr>`).join('');
  write(live.querySelectorAll('th'), rows.map(row => row[0]));
  slider.setAttribute('aria-valuetext', `${s.symbol} = ${show(t)}`);
  draw();
}
/** The shortest decimal that reads back as the same float. */
function shortest(x) { for (let digits = 1; digits < 10; ++digits) { const text = x.toPrecision(digits); if (Math.fround(text) === x) return Number(text); } return x; }
const fraction = () => { const s = data.slider; return (t - number(s.from)) / (number(s.to) - number(s.from)); };
[...document.querySelectorAll('#steps button')].forEach((button, i) => button.onclick = () => show(i));
document.getElementById('back').onclick = () => show(place - 1);
document.getElementById('next').onclick = () => show(place + 1);
document.getElementById('reset').onclick = () => { eye = first(); zoom = 1; if (slider) { run(number(data.slider.start)); slider.value = 1000 * fraction(); } draw(); };
let held = null;
figure.addEventListener('pointerdown', event => { held = [event.clientX, event.clientY]; figure.setPointerCapture(event.pointerId); });
figure.addEventListener('pointermove', event => {
  if (!held) return;
  turn((event.clientX - held[0]) * 0.01, (held[1] - event.clientY) * 0.01);
  held = [event.clientX, event.clientY];
});
for (const end of ['pointerup', 'pointercancel']) figure.addEventListener(end, () => held = null);
document.addEventListener('keydown', event => {
  if (event.altKey || event.ctrlKey || event.metaKey) return;
  const orbit = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]}[event.key];
  if (event.target === figure && orbit && !data.camera.flat) { turn(...orbit); event.preventDefault(); return; }
  if (event.target === figure && (event.key === '+' || event.key === '-')) { zoom = Math.min(8, Math.max(0.25, zoom * (event.key === '+' ? 1.25 : 0.8))); draw(); return; }
  if (event.target === slider) return;
  const to = {ArrowLeft: place - 1, ArrowRight: place + 1, PageUp: place - 1, PageDown: place + 1, Home: 0, End: steps.length - 1}[event.key];
  if (to !== undefined) { show(to); event.preventDefault(); }
  else if (/^[1-9]$/.test(event.key) && Number(event.key) <= steps.length) show(Number(event.key) - 1);
});
document.documentElement.classList.add('live');
show(Math.max(0, location.hash.startsWith('#') ? Number(location.hash.slice(1)) - 1 || 0 : 0));
if (slider) { slider.value = 1000 * fraction(); slider.oninput = () => { const s = data.slider; run(number(s.from) + slider.value / 1000 * (number(s.to) - number(s.from))); }; run(t); }
)js";

}  // namespace rayproof::viz
