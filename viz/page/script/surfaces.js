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

/** A filled ring of points in a plane; what is filled of one that crosses itself comes in strips of four corners. */
function polygonOf(ring, strips) {
  const pairs = pairsOf([...ring, ring[0]]), rest = {rimFrom: () => pairs, most: pairs.length, centre: ring[0]};
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

/** The convex hull of points: round sides look round, edges stay sharp. */
function hullOf(points) {
  const hull = new THREE.ConvexHull().setFromPoints(points), apex = apexOver(points);
  if (apex) hull.setFromPoints([...points, apex]);
  const faces = hull.faces.filter(face => !cornersOf(face).includes(apex));
  const corners = faces.flatMap(cornersOf), edges = [];
  const smooth = faces.flatMap(face => cornersOf(face).map(p => faces.reduce(
    (sum, other) => cornersOf(other).includes(p) && other.normal.dot(face.normal) > sharp ? sum.addScaledVector(other.normal, other.area) : sum,
    new THREE.Vector3()).normalize()));
  for (const face of faces) {
    let edge = face.edge;
    do {
      const across = edge.twin.face, isBorder = !faces.includes(across);
      if (isBorder || faces.indexOf(face) < faces.indexOf(across))
        edges.push({ends: [edge.tail().point, edge.head().point], faces: [face, across], isSharp: isBorder || face.normal.dot(across.normal) < sharp});
      edge = edge.next;
    } while (edge !== face.edge);
  }
  const rimFrom = (eye, toward) => {
    const faces = face => toward ? face.normal.dot(toward) : face.normal.dot(eye) - face.constant;
    return edges.filter(edge => edge.isSharp || (faces(edge.faces[0]) > 0) !== (faces(edge.faces[1]) > 0)).map(edge => edge.ends);
  };
  return {geometry: trianglesOf(corners, smooth), rimFrom, most: edges.length, centre: points[0]};
}

function cornersOf(face) {
  return [face.edge, face.edge.next, face.edge.prev].map(edge => edge.head().point);
}

/** A point off the plane in which all points lie; null where they lie in none. */
function apexOver(points) {
  const [a] = points, from = p => p.clone().sub(a);
  const b = points.reduce((far, p) => p.distanceTo(a) > far.distanceTo(a) ? p : far);
  const normal = points.reduce((most, p) => { const n = from(b).cross(from(p)); return n.lengthSq() > most.lengthSq() ? n : most; }, new THREE.Vector3()).normalize();
  return points.every(p => Math.abs(from(p).dot(normal)) < 1e-5) ? normal.add(a) : null;
}

/** Back sides first, then front sides; the line around it is opaque. */
function surfaceMeshes(body, paint, flat) {
  const made = {ellipsoid: ellipsoidOf, polygon: polygonOf, hull: hullOf}[body.form](vectorsOf(body.points), body.strips);
  const film = {transparent: true, opacity: body.opacity, depthWrite: false, ...flat}, isRound = body.form === 'ellipsoid';
  const mesh = side => new THREE.Mesh(made.geometry, flat.depthTest === false ? paint.material('Basic', body.role, {...film, side})
    : paint.material(isRound ? 'Phong' : 'Lambert', body.role, {...film, side, ...(isRound ? {specular: 0} : {})}));
  const sides = body.form === 'polygon' || flat.depthTest === false && body.form === 'hull' ? [mesh(THREE.DoubleSide)] : [mesh(THREE.BackSide), mesh(THREE.FrontSide)];
  const rim = new Tubes([], body.radius, paint.material(flat.depthTest === false ? 'Basic' : 'Lambert', body.role, flat, true), made.most);
  return {...made, sides, rim};
}
