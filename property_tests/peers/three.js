#!/usr/bin/env node
// three.js (Debian's libjs-three, release 111) under node: Ray.intersectSphere, intersectBox, intersectTriangle,
// intersectPlane, in double. Its documentation: a Ray's direction "must be normalized for the methods to
// operate properly". A Ray has no end and begins at its origin; it gives the point of the nearest hit, or null;
// t is read off the point, where that says it well.
"use strict";

const THREE = require(process.env.RAYPROOF_THREE || "/usr/share/javascript/three/three.js");

const vector = ([x, y, z]) => new THREE.Vector3(x, y, z);

// By the case format's type: the shape's fields, as three.js holds them, met by a ray.
const meet = {
  sphere: (ray, { center, radius }) => ray.intersectSphere(new THREE.Sphere(vector(center), radius), new THREE.Vector3()),
  box: (ray, { min, max }) => ray.intersectBox(new THREE.Box3(vector(min), vector(max)), new THREE.Vector3()),
  triangle: (ray, { a, b, c }) => ray.intersectTriangle(vector(a), vector(b), vector(c), false, new THREE.Vector3()),
  plane: (ray, fields) => ray.intersectPlane(planeOf(fields), new THREE.Vector3()),
};

function planeOf({ normal, d, point }) {
  const plane = new THREE.Plane();
  if (point) return plane.setFromNormalAndCoplanarPoint(vector(normal).normalize(), vector(point));
  return plane.setComponents(...normal, d).normalize();
}

/** The case's numbers, rounded to its precision. */
function numbers(value, round) {
  if (Array.isArray(value)) return value.map((one) => numbers(one, round));
  if (typeof value === "object") return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, numbers(one, round)]));
  return round(value === "inf" ? Infinity : value === "-inf" ? -Infinity : Number(value));
}

/** A number as JSON, which has no infinity and no NaN. */
const written = (x) => (Number.isFinite(x) ? x : Number.isNaN(x) ? "nan" : x > 0 ? "inf" : "-inf");

/** Whether a point rounded where `point` lies still says t as well as the case is judged by. */
function saysT(type, origin, point) {
  return (type !== "sphere" && type !== "box") || origin.length() <= 8 * point.distanceTo(origin);
}

function answer({ id, precision, ray: rayFields, shape, transform }) {
  const [given, fields] = numbers([rayFields || {}, shape || {}], precision === "float32" ? Math.fround : (x) => x);
  const type = shape?.type, mayHaveFartherHit = type === "sphere" || type === "box";
  if (!meet[type] || transform || fields.u || given.t_min < 0 || (given.t_min > 0 && mayHaveFartherHit)) return { id, unsupported: true };
  const length = Math.hypot(...given.direction);
  if (!(length > 1e-300 && length < 1e300)) return { id, unsupported: true }; // no unit vector to be had
  const origin = vector(given.origin), direction = vector(given.direction.map((d) => d / length));
  const point = meet[type](new THREE.Ray(origin, direction), fields);
  if (!point) return { id, verdict: "miss", hits: [] };
  const t = point.clone().sub(origin).dot(direction) / length;
  if ((t < given.t_min && given.t_min > 0) || t > given.t_max) return { id, verdict: "miss", hits: [] };
  const said = { id, verdict: "hit", point: point.toArray().map(written) };
  if (saysT(type, origin, point)) said.hits = [{ t: written(t) }];
  return said;
}

let rest = "";
process.stdin.setEncoding("utf8").on("data", (text) => {
  const lines = (rest + text).split("\n");
  rest = lines.pop();
  process.stdout.write(lines.filter(Boolean).map((line) => JSON.stringify(answer(JSON.parse(line))) + "\n").join(""));
});
