'use strict';
/* The bodies of a step as objects of three.js. Everything is placed and measured already (viz/scene/space.hpp);
   coordinates and lengths are of the step's view. */

const upright = new THREE.Vector3(0, 1, 0);
const vectorsOf = flat => Array.from({length: flat.length / 3}, (_, i) => new THREE.Vector3().fromArray(flat, 3 * i));
const pairsOf = points => points.slice(1).map((p, i) => [points[i], p]);

/** Materials by role, in the page's own colours; light and dark are switched for all at once. */
class Paint {
  made = new Map();
  static colourOf(role) { return getComputedStyle(document.documentElement).getPropertyValue(`--role-${role}`).trim(); }
  /** Of its kind, "Basic", "Lambert" or "Phong"; what is drawn many times at once needs one of its own. */
  material(kind, role, more = {}, isInstanced = false) {
    const key = JSON.stringify([kind, role, more, isInstanced]);
    if (!this.made.has(key)) {
      const one = new THREE[`Mesh${kind}Material`]({color: Paint.colourOf(role), ...more});
      if (kind === 'Phong') one.onBeforeCompile = withRim;
      this.made.set(key, [one, role]);
    }
    return this.made.get(key)[0];
  }
  refresh() { for (const [one, role] of this.made.values()) one.color.set(Paint.colourOf(role)); }
}

/** A translucent surface covers more where it turns away from the eye, as a film does. */
function withRim(shader) {
  const rim = 'gl_FragColor.a += (1.0 - gl_FragColor.a) * 0.55 * pow(1.0 - abs(dot(normal, normalize(vViewPosition))), 3.0);';
  shader.fragmentShader = shader.fragmentShader.replace('#include <dithering_fragment>', rim);
}

/** Cylinders around pairs of points, which may change. */
class Tubes extends THREE.InstancedMesh {
  static shape = new THREE.CylinderBufferGeometry(1, 1, 1, 12);
  constructor(pairs, radius, material, most = pairs.length) {
    super(Tubes.shape.clone(), material, most);  // r111 knows instances apart by their geometry alone
    this.radius = radius;
    this.frustumCulled = false;
    this.lay(pairs);
  }
  lay(pairs) {
    const matrix = new THREE.Matrix4(), turn = new THREE.Quaternion(), along = new THREE.Vector3(), size = new THREE.Vector3();
    this.count = Math.min(pairs.length, this.instanceMatrix.count);
    for (let i = 0; i < this.count; ++i) {
      const [a, b] = pairs[i], length = along.subVectors(b, a).length();
      turn.setFromUnitVectors(upright, along.divideScalar(length || 1));
      matrix.compose(a.clone().lerp(b, 0.5), turn, size.set(this.radius, length || 1e-9, this.radius));
      this.setMatrixAt(i, matrix);
    }
    this.instanceMatrix.needsUpdate = true;
  }
}

/** Balls at points: what joins the cylinders of a bent line. */
class Joints extends THREE.InstancedMesh {
  static shape = new THREE.SphereBufferGeometry(1, 10, 6);
  constructor(points, radius, material) {
    super(Joints.shape.clone(), material, points.length);
    this.frustumCulled = false;
    points.forEach((p, i) => this.setMatrixAt(i, new THREE.Matrix4().makeScale(radius, radius, radius).setPosition(p)));
  }
}

/** `material` gives the one for what is drawn many times at once, or for what is not. */
function lineMeshes(body, material) {
  const pieces = body.pieces.map(vectorsOf), meshes = [new Tubes(pieces.flatMap(pairsOf), body.radius, material(true))];
  const bends = pieces.flatMap(piece => piece.slice(1, -1));
  if (bends.length) meshes.push(new Joints(bends, body.radius, material(true)));
  if (body.head) {
    const [base, tip] = vectorsOf(body.head), along = tip.clone().sub(base);
    const cone = new THREE.Mesh(new THREE.ConeBufferGeometry(body.headRadius, along.length(), 24), material(false));
    cone.position.copy(base).lerp(tip, 0.5);
    cone.quaternion.setFromUnitVectors(upright, along.normalize());
    meshes.push(cone);
  }
  return meshes;
}

/** A mark's mesh; z is the direction to the eye. */
function markMesh(body, sizes, material) {
  const shapes = {
    ring: () => new THREE.TorusBufferGeometry(sizes.ring, sizes.wire, 12, 40),
    diamond: () => new THREE.OctahedronBufferGeometry(sizes.diamond),
    dot: () => new THREE.SphereBufferGeometry(sizes.dot, 24, 16),
    cross: () => null,
  };
  const corner = (x, y) => new THREE.Vector3(x * sizes.cross, y * sizes.cross, 0);
  const mesh = body.mark === 'cross'
    ? new Tubes([[corner(-1, -1), corner(1, 1)], [corner(-1, 1), corner(1, -1)]], sizes.wire, material(true))
    : new THREE.Mesh(shapes[body.mark](), material(false));
  mesh.position.fromArray(body.points);
  mesh.place = mesh.position.clone();
  mesh.scale.setScalar(body.radius);
  return mesh;
}
