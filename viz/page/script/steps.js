'use strict';
/* A walkthrough's page: one step at a time, the slider along the ray with its numbers, and the ways to move about. */

/** Without three.js, or in a browser without WebGL, the step's still picture takes the scene's place. */
const hasWebGL = () => {
  const canvas = document.createElement('canvas');
  return typeof THREE !== 'undefined' && !!(canvas.getContext('webgl2') || canvas.getContext('webgl'));
};

const byId = id => document.getElementById(id), dataOf = id => JSON.parse(byId(id).textContent);
const asNumber = x => typeof x === 'number' ? x : x === 'inf' ? Infinity : x === '-inf' ? -Infinity : NaN;
/** The shortest decimal that reads back as the same float. */
function shortest(x) {
  for (let digits = 1; digits < 10; ++digits) {
    const text = x.toPrecision(digits);
    if (Math.fround(text) === x) return Number(text);
  }
  return x;
}

class Walkthrough {
  constructor() {
    this.data = dataOf('stage');
    this.sections = [...document.querySelectorAll('.step')];
    this.buttons = [...document.querySelectorAll('#steps button')];
    this.slider = byId('slider');
    this.t = this.data.slider ? asNumber(this.data.slider.start) : 0;
    this.place = 0;
    document.documentElement.classList.add('live');
    if (hasWebGL()) this.scene = new StageScene(byId('scene')).load(dataOf('space'));
    this.listen();
    this.show(location.hash ? Number(location.hash.slice(1)) - 1 || 0 : Number(byId('walk').dataset.first));
    if (this.slider) {
      this.slider.value = 1000 * this.fraction();
      this.run(this.t);
    }
  }
  listen() {
    this.buttons.forEach((button, i) => { button.onclick = () => this.show(i); });
    byId('back').onclick = () => this.show(this.place - 1);
    byId('next').onclick = () => this.show(this.place + 1);
    byId('reset').onclick = () => this.reset();
    if (this.slider) this.slider.oninput = () => {
      const {from, to} = this.data.slider;
      this.run(asNumber(from) + this.slider.value / 1000 * (asNumber(to) - asNumber(from)));
    };
    document.addEventListener('keydown', event => this.press(event));
    this.swipe(byId('texts'));
  }
  /** A finger across the text leads a step on or back. */
  swipe(texts) {
    let start = null;
    texts.addEventListener('touchstart', event => { start = event.touches.length === 1 ? event.touches[0] : null; }, {passive: true});
    texts.addEventListener('touchend', event => {
      if (!start) return;
      const {clientX, clientY} = event.changedTouches[0], across = clientX - start.clientX, down = clientY - start.clientY;
      if (Math.abs(across) > 60 && Math.abs(across) > 2 * Math.abs(down)) this.show(this.place + (across < 0 ? 1 : -1));
      start = null;
    });
  }
  fraction() {
    const {from, to} = this.data.slider;
    return (this.t - asNumber(from)) / (asNumber(to) - asNumber(from));
  }
  show(to) {
    const {data, sections} = this;
    this.place = Math.min(Math.max(to, 0), sections.length - 1);
    const step = data.steps[this.place], isApart = step.magnification !== undefined;
    sections.forEach((section, i) => section.classList.toggle('shown', i === this.place));
    this.buttons.forEach((button, i) => button.setAttribute('aria-current', i === this.place ? 'step' : 'false'));
    byId('back').disabled = this.place === 0;
    byId('next').disabled = this.place === sections.length - 1;
    byId('place').textContent = `Step ${this.place + 1} of ${sections.length}: ${step.title}`;
    byId('scene').setAttribute('aria-label', `${step.title}. ${step.caption}`);
    if (this.scene) this.scene.show(this.place);
    else byId('scene').replaceChildren(sections[this.place].querySelector('figure').firstElementChild.cloneNode(true));
    byId('magnified').textContent = isApart && step.magnification !== 1 ? step.scale : !this.scene || data.camera.flat || isApart ? ''
      : 'Drag, or focus the picture and use the arrow keys, to look from another side';
  }
  /** Moves the slider's point; the numbers at it in the walkthrough's own precision, step by step, and in double. */
  run(to) {
    const s = this.data.slider, isFloat = this.data.precision === 'float32', round = isFloat ? Math.fround : x => x, t = this.t = round(to);
    const along = (round, i) => round(round(asNumber(s.origin[i])) + round(t * asNumber(s.direction[i])));
    const horner = (round, list) => list.reduceRight((sum, c) => round(round(sum * t) + round(asNumber(c))), 0);
    const show = x => String(isFloat && Math.fround(x) === x ? shortest(x) : x), exact = x => x;
    const point = list => `(${list.join(', ')})`, axes = [0, 1, 2];
    const rows = s.shows_point ? [['p(t)', point(axes.map(i => show(along(round, i)))), isFloat ? point(axes.map(i => Number(along(exact, i).toPrecision(12)))) : '']] : [];
    for (const r of s.readouts) rows.push([r.label, show(horner(round, r.coefficients)), isFloat ? String(Number(horner(exact, r.coefficients).toPrecision(12))) : '']);
    byId('live').replaceChildren(...rows.map(([name, value, fine]) => {
      const row = document.createElement('tr');
      row.innerHTML = `<th scope="row"></th><td class="claimed" data-of="${this.data.precision}">${value}</td><td class="exact" data-of="in double">${fine}</td>`;
      row.firstChild.textContent = name;
      return row;
    }));
    byId('t').textContent = `${s.symbol} = ${show(t)}`;
    this.slider.setAttribute('aria-valuetext', `${s.symbol} = ${show(t)}`);
    if (this.scene) this.scene.run(t);
  }
  reset() {
    if (this.scene) this.scene.controls.reset();
    if (!this.slider) return;
    this.run(asNumber(this.data.slider.start));
    this.slider.value = 1000 * this.fraction();
  }
  press(event) {
    if (event.altKey || event.ctrlKey || event.metaKey || event.target === this.slider) return;
    const last = this.sections.length - 1;
    const to = {ArrowLeft: this.place - 1, ArrowRight: this.place + 1, PageUp: this.place - 1, PageDown: this.place + 1, Home: 0, End: last}[event.key];
    if (to !== undefined) {
      this.show(to);
      event.preventDefault();
    } else if (/^[1-9]$/.test(event.key) && Number(event.key) <= last + 1) this.show(Number(event.key) - 1);
  }
}

const walkthrough = byId('stage') ? new Walkthrough() : null;
