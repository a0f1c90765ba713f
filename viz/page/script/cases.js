'use strict';
/* Pictures of many cases on one page: a thumbnail as it comes into view, and one scene at a time to look around in. */

class Cases {
  constructor(figures) {
    this.waiting = new Set();
    this.host = document.createElement('div');
    this.scene = new StageScene(this.host);
    this.watch = new IntersectionObserver(entries => {
      for (const {target, isIntersecting} of entries) this.waiting[isIntersecting ? 'add' : 'delete'](target);
      this.drawNext();
    }, {rootMargin: '200px'});
    for (const figure of figures) {
      this.dress(figure);
      this.watch.observe(figure);
    }
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.anew(figures));
    document.addEventListener('keydown', event => { if (event.key === 'Escape' && this.open) this.close(); });
  }
  /** The place of a thumbnail, and a button for each view of the case. */
  dress(figure) {
    const {title, text} = {title: figure.querySelector('title'), text: figure.querySelector('desc')};
    figure.thumbnail = document.createElement('div');
    figure.thumbnail.className = 'thumbnail';
    figure.thumbnail.title = 'Look around';
    figure.thumbnail.onclick = () => this.show(figure, 0);
    figure.words = [title, text].map(element => element ? element.textContent : '').join('. ');
    figure.bar = document.createElement('div');
    figure.bar.className = 'looking screen';
    for (const [number, name] of this.dataOf(figure).steps.map(step => step.title).entries()) {
      const button = document.createElement('button');
      Object.assign(button, {type: 'button', textContent: name, onclick: () => this.open === figure && this.number === number ? this.close() : this.show(figure, number)});
      button.setAttribute('aria-pressed', 'false');
      figure.bar.append(button);
    }
    figure.append(figure.thumbnail, figure.bar);
  }
  dataOf(figure) { return JSON.parse(figure.querySelector('script').textContent); }
  /** One thumbnail at a time, so that the page stays quick; none while a scene is open. */
  drawNext() {
    if (this.open || this.timer || !this.waiting.size) return;
    this.timer = setTimeout(() => {
      this.timer = 0;
      const [figure] = this.waiting;
      if (figure && !this.open) {
        this.waiting.delete(figure);
        this.draw(figure);
      }
      this.drawNext();
    });
  }
  draw(figure) {
    const width = figure.clientWidth;
    this.host.className = 'scene aside';
    Object.assign(this.host.style, {width: `${width}px`, height: `${width / 1.6}px`});
    document.body.append(this.host);
    this.scene.load(this.dataOf(figure)).show(0);
    const picture = new Image();
    picture.src = this.scene.renderer.domElement.toDataURL();
    picture.alt = figure.words;
    figure.thumbnail.replaceChildren(picture, this.scene.labels.element.cloneNode(true));
    figure.classList.add('drawn');
    this.watch.unobserve(figure);
    this.host.remove();
  }
  show(figure, number) {
    if (this.open !== figure) {
      if (this.open) this.close();
      this.open = figure;
      this.host.className = 'scene';
      Object.assign(this.host.style, {width: '', height: ''});
      this.host.tabIndex = 0;
      this.host.setAttribute('role', 'img');
      this.host.setAttribute('aria-label', figure.words);
      figure.insertBefore(this.host, figure.thumbnail);
      figure.classList.add('drawn', 'open');
      this.scene.load(this.dataOf(figure));
    }
    this.number = number;
    this.scene.show(number);
    [...figure.bar.children].forEach((button, i) => button.setAttribute('aria-pressed', String(i === number)));
    this.host.focus({preventScroll: true});
  }
  close() {
    const figure = this.open;
    this.open = null;
    this.host.remove();
    figure.classList.remove('open');
    for (const button of figure.bar.children) button.setAttribute('aria-pressed', 'false');
    if (!figure.thumbnail.children.length) this.waiting.add(figure);
    this.drawNext();
  }
  /** In other colours. */
  anew(figures) {
    for (const figure of figures) {
      figure.thumbnail.replaceChildren();
      if (figure !== this.open) figure.classList.remove('drawn');
      this.watch.observe(figure);
    }
  }
}

const cases = hasWebGL() && document.querySelector('.case') ? new Cases(document.querySelectorAll('.case')) : null;
