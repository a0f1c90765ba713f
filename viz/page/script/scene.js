'use strict';
/* A step in true space: cameras, lights, bodies, floor and shadows, labels; drawn when something changed. */

class StageScene {
  constructor(host) {
    Object.assign(this, {host, paint: new Paint(), built: [], t: 0});
    this.renderer = new THREE.WebGLRenderer({antialias: true, alpha: true});
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.scene = new THREE.Scene();
    this.labels = new Labels(this.scene);
    this.eyes = {space: new THREE.PerspectiveCamera(), flat: new THREE.OrthographicCamera()};
    const lamp = new THREE.DirectionalLight(0xffffff, 0.75);
    lamp.position.set(0.5, 1, 1);  // above the eye and at its right
    this.eyes.space.add(lamp, lamp.target);
    this.scene.add(this.eyes.space, new THREE.AmbientLight(0xffffff, 0.45));
    this.axes = new Axes();
    host.replaceChildren(this.renderer.domElement, this.labels.element, this.axes.element);
    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(host);
    this.dark = matchMedia('(prefers-color-scheme: dark)');
    this.recolour = () => { this.paint.refresh(); if (this.now) this.draw(); };
    this.dark.addEventListener('change', this.recolour);
  }
  /** `space` is what viz/page/space_json.cpp writes of a stage; what was shown before is gone. */
  load(space) {
    if (this.now) this.scene.remove(this.now.group);
    for (const {group} of this.built.filter(Boolean)) group.traverse(object => object.geometry && object.geometry.dispose());
    if (this.controls) this.controls.dispose();
    Object.assign(this, {space, built: [], now: null, step: space.steps[0]});
    this.controls = new SceneControls(this);
    return this;
  }
  get camera() { return this.step.flat ? this.eyes.flat : this.eyes.space; }
  resize() {
    [this.width, this.height] = [this.host.clientWidth, this.host.clientHeight];
    if (!this.width || !this.now) return;
    this.renderer.setSize(this.width, this.height, false);
    this.labels.renderer.setSize(this.width, this.height);
    this.aim();
    this.draw();
  }
  /** The cameras' own numbers: as the step says, in this frame. */
  aim() {
    const aspect = this.width / this.height, {space, flat} = this.eyes, {step} = this;
    Object.assign(space, {fov: this.space.angle, aspect, near: step.near, far: step.far});
    Object.assign(flat, {left: -step.half * aspect, right: step.half * aspect, top: step.half, bottom: -step.half, near: step.near, far: step.far});
    space.updateProjectionMatrix();
    flat.updateProjectionMatrix();
  }
  show(number) {
    if (this.now) this.scene.remove(this.now.group);
    this.step = this.space.steps[number];
    this.now = this.built[number] = this.built[number] || this.build(this.step);
    this.scene.add(this.now.group);
    this.labels.show(this.step.labels);
    this.controls.place();
    this.resize();
  }
  build(step) {
    const group = new THREE.Group(), shadows = new THREE.Group(), marks = [], surfaces = [], flat = step.flat ? {depthTest: false, transparent: true} : {};
    const add = (mesh, order) => {
      // A drawing in a plane is painted: surfaces, lines, marks, in this order.
      if (step.flat) mesh.renderOrder = order;
      group.add(mesh);
      if (step.floor) shadows.add(this.shadowOf(mesh));
      return mesh;
    };
    const lit = (role, isPlain = step.flat) => isInstanced => this.paint.material(isPlain ? 'Basic' : 'Lambert', role, flat, isInstanced);
    step.bodies.forEach((body, i) => {
      if (body.mark) marks.push(add(markMesh(body, this.space.marks, lit(body.role, ['ring', 'cross'].includes(body.mark))), 3000 + i));
      else if (body.pieces) lineMeshes(body, lit(body.role)).forEach(mesh => add(mesh, 1000 + i));
      else {
        const surface = surfaceMeshes(body, this.paint, flat);
        surface.sides.forEach(side => add(side, i));
        add(surface.rim, 1000 + i);
        surfaces.push(surface);
      }
    });
    const runner = step.runner && this.runner(step, group, lit('ray')(false));
    const floor = step.floor && this.floor(step.floor, shadows);
    if (floor) group.add(floor);
    return {group, marks, surfaces, runner, floor};
  }
  /** The slider's point: a cone below it that points to it. */
  runner(step, group, material) {
    const size = step.runner.size, cone = new THREE.Mesh(new THREE.ConeBufferGeometry(size, 2 * size, 24).translate(0, -1.3 * size, 0), material);
    cone.quaternion.setFromUnitVectors(upright, new THREE.Vector3().fromArray(step.up));
    cone.renderOrder = 4000;
    group.add(cone);
    return cone;
  }
  shadowOf(mesh) {
    const material = this.paint.material('Basic', 'shadow', {side: THREE.DoubleSide}, !!mesh.isInstancedMesh);
    const shadow = mesh.isInstancedMesh ? new THREE.InstancedMesh(mesh.geometry.clone(), material, mesh.count) : new THREE.Mesh(mesh.geometry, material);
    if (mesh.isInstancedMesh) Object.assign(shadow, {instanceMatrix: mesh.instanceMatrix, frustumCulled: false});
    shadow.position.copy(mesh.position);
    shadow.quaternion.copy(mesh.quaternion);
    shadow.scale.copy(mesh.scale);
    shadow.onBeforeRender = () => { shadow.count = mesh.count; };
    return shadow;
  }
  /** The ground, the grid on it and the shadows, laid flat. */
  floor(data, shadows) {
    const floor = new THREE.Group(), up = new THREE.Vector3().fromArray(this.step.up), axis = ['x', 'y', 'z'][data.axis];
    const ground = new THREE.Mesh(new THREE.PlaneBufferGeometry(2 * data.reach, 2 * data.reach), this.paint.material('Basic', 'ground'));
    ground.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), up);
    ground.position[axis] = data.ground;
    const ends = data.lines.flatMap((list, k) => list.flatMap(at => [-data.reach, data.reach].map(end => {
      const p = [0, 0, 0];
      [p[data.axis], p[(data.axis + 1 + k) % 3], p[(data.axis + 2 - k) % 3]] = [data.grid, at, end];
      return new THREE.Vector3(...p);
    })));
    const lines = new THREE.BufferGeometry().setFromPoints(ends);
    const grid = new THREE.LineSegments(lines, new THREE.LineBasicMaterial());
    grid.material.color = this.paint.material('Basic', 'grid').color;
    shadows.scale[axis] = 1e-4;  // a matrix of normals is to be inverted
    shadows.position[axis] = data.shadows;
    floor.add(ground, grid, shadows);
    return floor;
  }
  /** Where a point of the step is seen, in pixels of the frame. */
  seen(p) {
    const q = p.clone().project(this.camera);
    return q.z > 1 ? [NaN, NaN] : [(q.x + 1) / 2 * this.width, (1 - q.y) / 2 * this.height];
  }
  /** Moves the slider's point. */
  run(t) {
    this.t = t;
    if (this.now) this.draw();
  }
  draw() {
    if (!this.width) return;
    const {camera, now, step} = this, places = new Places(this.width, this.height);
    camera.updateMatrixWorld();
    const eye = camera.position, seen = p => this.seen(p), toward = step.flat ? new THREE.Vector3(0, 0, 1).transformDirection(camera.matrixWorld) : null;
    for (const mark of now.marks) {
      mark.quaternion.copy(camera.quaternion);
      // So far toward the eye that what it lies on does not cut it.
      if (!step.flat) mark.position.copy(eye).sub(mark.place).setLength(2 * mark.scale.x).add(mark.place);
      const [x, y] = seen(mark.position), r = mark.scale.x * 2.2 * this.pixelsPerLength(mark.position);
      places.taken.push([x - r, y - r, x + r, y + r]);
    }
    for (const body of step.bodies.filter(body => body.head)) {
      for (const p of vectorsOf(body.head)) {
        const [x, y] = seen(p), r = body.headRadius * this.pixelsPerLength(p);
        if (isFinite(x)) places.taken.push([x - r, y - r, x + r, y + r]);
      }
    }
    if (now.runner) {
      const [origin, along] = vectorsOf(step.runner.ray);
      now.runner.position.copy(origin).addScaledVector(along, this.t);
      const [x, y] = seen(now.runner.position);
      if (isFinite(x)) places.taken.push([x - 9, y - 2, x + 9, y + 18]);
    }
    for (const surface of now.surfaces) {
      const pairs = surface.rimFrom(eye, toward);
      surface.rim.lay(pairs);
      for (const [a, b] of pairs) places.avoid(seen(a), seen(b), 8);
      if (!step.flat) surface.sides.forEach((side, i) => { side.renderOrder = i - 10 * surface.centre.distanceTo(eye); });
    }
    for (const body of step.bodies.filter(body => body.pieces))
      for (const piece of body.pieces) for (const [a, b] of pairsOf(vectorsOf(piece))) places.avoid(seen(a), seen(b), body.role === 'frame' && body.how === 'scene' ? 3 : body.role === 'frame' || body.how === 'dimmed' ? 8 : 12);
    this.axes.turn(camera, !step.flat, places);
    if (now.floor) now.floor.visible = new THREE.Vector3().fromArray(step.up).dot(eye) > step.floor.ground * step.up[step.floor.axis];
    this.renderer.render(this.scene, camera);
    this.labels.place(seen, places);
    this.labels.renderer.render(this.scene, camera);
  }
  pixelsPerLength(p) {
    const {step, camera} = this, half = step.flat ? step.half : Math.tan(this.space.angle * Math.PI / 360) * camera.position.distanceTo(p);
    return this.height / 2 / half * camera.zoom;
  }
}
