'use strict';
/* Looking from another side: by drag and touch (three.js' OrbitControls), by keys, and nearer or farther. What a reader
   turned stays turned in the next step, whose own camera it is then counted from. */

class SceneControls {
  constructor(scene) {
    this.scene = scene;
    this.turned = [0, 0];
    const first = scene.space.steps.find(step => !step.flat), {space} = scene.eyes;
    if (first) space.up.fromArray(first.up);
    this.orbit = new THREE.OrbitControls(space, scene.host);
    Object.assign(this.orbit, {enableKeys: false, enablePan: false, enableZoom: false, rotateSpeed: 0.7});
    this.toY = new THREE.Quaternion().setFromUnitVectors(space.up, upright);
    this.orbit.addEventListener('change', () => {
      if (this.isPlacing) return;
      const now = this.angles(space.position), own = this.angles(new THREE.Vector3().fromArray(scene.step.eye));
      this.turned = [now.theta - own.theta, now.phi - own.phi];
      scene.draw();
    });
    this.onKey = event => this.press(event);
    scene.host.addEventListener('keydown', this.onKey);
  }
  dispose() {
    this.orbit.dispose();
    this.scene.host.removeEventListener('keydown', this.onKey);
  }
  get isMoved() { return Math.hypot(...this.turned) > 1e-6; }
  angles(position) {
    const target = new THREE.Vector3().fromArray(this.scene.step.target);
    return new THREE.Spherical().setFromVector3(position.clone().sub(target).applyQuaternion(this.toY));
  }
  /** Puts the cameras where the step has them, turned as the reader did. */
  place() {
    const {step, eyes} = this.scene, target = new THREE.Vector3().fromArray(step.target);
    this.orbit.enabled = !step.flat;
    this.scene.host.classList.toggle('flat', !!step.flat);
    const camera = this.scene.camera;
    camera.up.fromArray(step.up);
    camera.position.fromArray(step.eye);
    if (!step.flat && this.isMoved) {
      const to = this.angles(camera.position);
      to.theta += this.turned[0];
      to.phi += this.turned[1];
      camera.position.setFromSpherical(to.makeSafe()).applyQuaternion(this.toY.clone().conjugate()).add(target);
    }
    camera.lookAt(target);
    this.isPlacing = true;
    this.orbit.target.copy(target);
    if (!step.flat) this.orbit.update();
    this.isPlacing = false;
  }
  /** What is nearest to the eye moves by this many radians to the right and upward. */
  turn(rightward, upward) {
    if (this.scene.step.flat) return;
    this.turned = [this.turned[0] - rightward, this.turned[1] + upward];
    this.place();
    const now = this.angles(this.scene.camera.position), own = this.angles(new THREE.Vector3().fromArray(this.scene.step.eye));
    this.turned[1] = now.phi - own.phi;  // no farther than the pole
    this.scene.draw();
  }
  zoom(factor) {
    for (const camera of Object.values(this.scene.eyes)) camera.zoom = Math.min(8, Math.max(0.25, camera.zoom * factor));
    this.scene.aim();
    this.scene.draw();
  }
  reset() {
    this.turned = [0, 0];
    for (const camera of Object.values(this.scene.eyes)) camera.zoom = 1;
    this.place();
    this.scene.aim();
    this.scene.draw();
  }
  press(event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const turn = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]}[event.key];
    const zoom = {'+': 1.25, '-': 0.8}[event.key];
    if (!zoom && (!turn || this.scene.step.flat)) return;
    if (zoom) this.zoom(zoom); else this.turn(...turn);
    event.preventDefault();
    event.stopPropagation();
  }
}
