'use strict';
/* Surfaces: their bodies and the line around them, where they turn away from the eye. */

/** Positions and normals of triangles, three points each. */
function trianglesOf(points, normals) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(points.flatMap(p => p.toArray()), 3));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute(normals.flatMap(n => n.toArray()), 3));
  return geometry;
}

/** A ball in its own matrix; around it the circle in which the cone from the eye touches it: of the unit ball seen
    from e the circle in the plane q·e = 1. */
function ellipsoidOf([centre, ...tips]) {
  const matrix = new THREE.Matrix4().makeBasis(...tips.map(tip => tip.clone().sub(centre))).setPosition(centre);
  const inverse = new THREE.Matrix4().getInverse(matrix), turn = new THREE.Quaternion();
  const rimFrom = (eye, toward) => {
    const e = eye.clone().applyMatrix4(inverse), distance = e.length();
    const isFlat = toward !== null, axis = isFlat ? toward.clone().transformDirection(inverse) : e.divideScalar(distance);
    if (!isFlat && distance <= 1) return [];
    const height = isFlat ? 0 : 1 / distance, radius = Math.sqrt(1 - height * height);
    turn.setFromUnitVectors(new THREE.Vector3(0, 0, 1), axis);
    return pairsOf(Array.from({length: 97}, (_, i) => {
      const angle = i / 48 * Math.PI;
      return new THREE.Vector3(radius * Math.cos(angle), radius * Math.sin(angle), height).applyQuaternion(turn).applyMatrix4(matrix);
    }));
  };
  return {geometry: new THREE.SphereBufferGeometry(1, 64, 48).applyMatrix(matrix), rimFrom, most: 96, centre};
}

/** A filled ring of points in a plane, an open one without a line around it; what is filled of one that crosses itself
    comes in strips of four corners. */
function polygonOf(ring, strips, isOpen) {
  const pairs = isOpen ? [] : pairsOf([...ring, ring[0]]), rest = {rimFrom: () => pairs, most: pairs.length, centre: ring[0]};
  if (strips) {
    const corners = strips.flatMap(strip => { const [a, b, c, d] = vectorsOf(strip); return [a, b, c, a, c, d]; });
    const across = corners[1].clone().sub(corners[0]).cross(corners[2].clone().sub(corners[0])).normalize();
    return {geometry: trianglesOf(corners, corners.map(() => across)), ...rest};
  }
  const normal = normalOf(ring), turn = new THREE.Quaternion().setFromUnitVectors(normal, new THREE.Vector3(0, 0, 1));
  const flat = ring.map(p => p.clone().applyQuaternion(turn)), height = flat[0].z;
  const geometry = new THREE.ShapeBufferGeometry(new THREE.Shape(flat.map(p => new THREE.Vector2(p.x, p.y))));
  geometry.translate(0, 0, height).applyMatrix(new THREE.Matrix4().makeRotationFromQuaternion(turn.conjugate()));
  return {geometry, ...rest};
}

/** Newell's normal of a ring. */
function normalOf(ring) {
  const sum = new THREE.Vector3();
  ring.forEach((p, i) => sum.add(p.clone().cross(ring[(i + 1) % ring.length])));
  return sum.lengthSq() > 1e-20 ? sum.normalize() : new THREE.Vector3(0, 0, 1);
}

/** How far apart two faces are that still look like one round side. */
const sharp = Math.cos(Math.PI / 6);

/** A convex solid of its corners and faces: round sides look round, edges stay sharp. */
function solidOf(points, rings) {
  const centre = points.reduce((sum, p) => sum.add(p), new THREE.Vector3()).divideScalar(points.length), edges = new Map();
  const faces = rings.map(ring => {
    const corners = ring.map(i => points[i]), normal = normalOf(corners);
    if (normal.dot(corners[0].clone().sub(centre)) < 0) { normal.negate(); corners.reverse(); }
    const face = {corners, normal, constant: normal.dot(corners[0])};
    ring.forEach((from, k) => {
      const ends = [from, ring[(k + 1) % ring.length]].sort((a, b) => a - b);
      edges.set(String(ends), {ends: ends.map(i => points[i]), faces: [...(edges.get(String(ends)) || {faces: []}).faces, face]});
    });
    return face;
  });
  const normalAt = (p, own) => faces.reduce((sum, {corners, normal}) => corners.includes(p) && normal.dot(own) > sharp ? sum.add(normal) : sum,
    new THREE.Vector3()).normalize();
  const triangles = faces.flatMap(({corners, normal}) => corners.slice(2).flatMap((p, i) => [corners[0], corners[i + 1], p].map(q => [q, normalAt(q, normal)])));
  const rimFrom = (eye, toward) => {
    const isFront = face => (toward ? face.normal.dot(toward) : face.normal.dot(eye) - face.constant) > 0;
    return [...edges.values()].filter(({faces: [a, b]}) => !b || a.normal.dot(b.normal) < sharp || isFront(a) !== isFront(b)).map(edge => edge.ends);
  };
  return {geometry: trianglesOf(...[0, 1].map(k => triangles.map(pair => pair[k]))), rimFrom, most: edges.size, centre};
}

/** Back sides first, then front sides; the line around it is opaque. */
function surfaceMeshes(body, paint, flat) {
  const made = {ellipsoid: ellipsoidOf, polygon: polygonOf, solid: solidOf}[body.form](vectorsOf(body.points), body.faces ?? body.strips, body.radius === 0);
  const film = {transparent: true, opacity: body.opacity, depthWrite: false, ...flat}, isRound = body.form === 'ellipsoid';
  const mesh = side => new THREE.Mesh(made.geometry, flat.depthTest === false ? paint.material('Basic', body.role, {...film, side})
    : paint.material(isRound ? 'Phong' : 'Lambert', body.role, {...film, side, ...(isRound ? {specular: 0} : {})}));
  const sides = body.form === 'polygon' ? [mesh(THREE.DoubleSide)] : [mesh(THREE.BackSide), mesh(THREE.FrontSide)];
  const rim = new Tubes([], body.radius, paint.material(flat.depthTest === false ? 'Basic' : 'Lambert', body.role, flat, true), made.most);
  return {...made, sides, rim};
}
