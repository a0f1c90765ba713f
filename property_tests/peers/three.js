#!/usr/bin/env node
// three.js (Debian's libjs-three, release 111) under node: Ray.intersectSphere, intersectBox, intersectTriangle,
// intersectPlane, in double. Its documentation: a Ray's direction "must be normalized for the methods to
// operate properly". A Ray has no end and begins at its origin; it gives the point of the nearest hit, or null;
// t is read off the point, where that says it well. `mesh`: Raycaster.intersectObject on a Mesh of one triangle, both
// sides, which stands in the world by its matrix; near and far are distances. `mesh interval`: the same without a matrix,
// intervals of no length too.
"use strict";

const THREE = require(process.env.RAYPROOF_THREE || "/usr/share/javascript/three/three.js");

const vector = ([x, y, z]) => new THREE.Vector3(x, y, z);

/** A vector as a program has it. */
const text = (v) => `new THREE.Vector3(${v.map((x) => (Object.is(x, -0) ? "-0" : String(x))).join(", ")})`;

const scaled = (v, s) => v.map((x) => x * s);
const lengthOf = (v) => Math.hypot(...v);
/** The plane's normal as a unit vector, and its constant. */
function hesse({ normal, d, point }) {
  const n = scaled(normal, 1 / lengthOf(normal));
  return { normal: n, d: point ? -(n[0] * point[0] + n[1] * point[1] + n[2] * point[2]) : d / lengthOf(normal) };
}

// By the case format's type: the fields as three.js takes them, the call, and the same as a program has it.
const meet = {
  sphere: {
    call: (ray, { center, radius }) => ray.intersectSphere(new THREE.Sphere(vector(center), radius), new THREE.Vector3()),
    source: ({ center, radius }) => `ray.intersectSphere(new THREE.Sphere(${text(center)}, ${radius}), new THREE.Vector3())`,
  },
  box: {
    call: (ray, { min, max }) => ray.intersectBox(new THREE.Box3(vector(min), vector(max)), new THREE.Vector3()),
    source: ({ min, max }) => `ray.intersectBox(new THREE.Box3(${text(min)}, ${text(max)}), new THREE.Vector3())`,
  },
  triangle: {
    call: (ray, { a, b, c }) => ray.intersectTriangle(vector(a), vector(b), vector(c), false, new THREE.Vector3()),
    source: ({ a, b, c }) => `ray.intersectTriangle(${text(a)}, ${text(b)}, ${text(c)}, false, new THREE.Vector3())`,
  },
  plane: {
    prepare: hesse,
    call: (ray, { normal, d }) => ray.intersectPlane(new THREE.Plane(vector(normal), d), new THREE.Vector3()),
    source: ({ normal, d }) => `ray.intersectPlane(new THREE.Plane(${text(normal)}, ${d}), new THREE.Vector3())`,
  },
};

const IDENTITY = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
const bothSides = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide });
const isReproducing = process.argv.includes("--reproduce");
const show = (object) => process.stdout.write(JSON.stringify(object) + "\n");

/** Asks three.js, and shows a program that asks the same, and what it prints, where that is wanted. */
function asked(type, origin, direction, fields) {
  if (isReproducing) {
    const source = `const THREE = require("three/build/three.js");
const ray = new THREE.Ray(${text(origin)}, ${text(direction)});
const point = ${meet[type].source(fields)};
console.log(point ? "hit = 1, point = " + point.toArray() : "hit = 0");
`;
    const named = type === "box" ? { low: fields.min, high: fields.max } : fields;
    show({ function: `Ray.${source.match(/ray\.(\w+)/)[1]}`, source, inputs: { origin, direction, ...named } });
  }
  const point = meet[type].call(new THREE.Ray(vector(origin), vector(direction)), fields);
  if (isReproducing) {
    const said = point ? { hit: 1, x: point.x, y: point.y, z: point.z } : { hit: 0 };
    show({ printed: point ? "hit = 1, point = " + point.toArray() : "hit = 0", said });
  }
  return point;
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
  const unit = given.direction.map((d) => d / length), prepared = meet[type].prepare ? meet[type].prepare(fields) : fields;
  const origin = vector(given.origin), direction = vector(unit), point = asked(type, given.origin, unit, prepared);
  if (!point) return { id, verdict: "miss", hits: [] };
  const t = point.clone().sub(origin).dot(direction) / length;
  if ((t < given.t_min && given.t_min > 0) || t > given.t_max) return { id, verdict: "miss", hits: [] };
  const said = { id, verdict: "hit", point: point.toArray().map(written) };
  if (saysT(type, origin, point)) said.hits = [{ t: written(t) }];
  return said;
}

/** Its far = 0 means no end; that is asked where there is no matrix, so that it is not mixed with what a matrix does. */
const isLeftOut = ({ t_min, t_max }, transform) => (process.argv.includes("interval") ? transform : !(t_max > t_min));

/** A Mesh of one triangle in the world, by a Raycaster. */
function answerByMesh({ id, precision, ray: rayFields, shape, transform }) {
  const [given, fields, rows] = numbers([rayFields || {}, shape || {}, transform || IDENTITY], precision === "float32" ? Math.fround : (x) => x);
  const length = given.direction ? lengthOf(given.direction) : 0;
  if (shape?.type !== "triangle" || given.t_min < 0 || isLeftOut(given, transform) || !(length > 1e-300 && length < 1e300)) return { id, unsupported: true };
  const direction = scaled(given.direction, 1 / length), near = given.t_min * length, far = given.t_max * length;
  const corners = [...fields.a, ...fields.b, ...fields.c], matrix = rows.flat();
  if (isReproducing) {
    const source = `const THREE = require("three/build/three.js");
const geometry = new THREE.BufferGeometry();
geometry.setAttribute("position", new THREE.BufferAttribute(new Float64Array([${corners.join(", ")}]), 3));
const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
mesh.matrixWorld.set(${matrix.join(", ")});
const raycaster = new THREE.Raycaster(${text(given.origin)}, ${text(direction)}, ${near}, ${far});
const [hit] = raycaster.intersectObject(mesh);
console.log(hit ? "hit = 1, distance = " + hit.distance : "hit = 0");
`;
    const ends = { t_min: near, t_max: far === Infinity ? "inf" : far };
    show({ function: "Raycaster.intersectObject", source, inputs: { ...fields, matrix, origin: given.origin, direction, ...ends } });
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float64Array(corners), 3));
  const mesh = new THREE.Mesh(geometry, bothSides);
  mesh.matrixWorld.set(...matrix);
  const [hit] = new THREE.Raycaster(vector(given.origin), vector(direction), near, far).intersectObject(mesh);
  if (isReproducing) show({ printed: hit ? "hit = 1, distance = " + hit.distance : "hit = 0", said: hit ? { hit: 1, distance: hit.distance } : { hit: 0 } });
  if (!hit) return { id, verdict: "miss", hits: [] };
  // A distance within near and far is a t within t_min and t_max: what the division rounds is not the library's.
  const isWithin = near <= hit.distance && hit.distance <= far, t = hit.distance / length;
  const said = isWithin ? Math.min(Math.max(t, given.t_min), given.t_max) : t;
  return { id, verdict: "hit", hits: [{ t: written(said) }], point: hit.point.toArray().map(written) };
}

if (process.argv.includes("--about")) {
  show({
    library: "three.js",
    version: `r${THREE.REVISION}`,
    build: "NODE_PATH=/usr/share/javascript node reproduction.js",
    tracker: "https://github.com/mrdoob/three.js/issues",
  });
  process.exit(0);
}

const answerBy = process.argv.includes("mesh") ? answerByMesh : answer;
let rest = "";
process.stdin.setEncoding("utf8").on("data", (text) => {
  const lines = (rest + text).split("\n");
  rest = lines.pop();
  process.stdout.write(lines.filter(Boolean).map((line) => JSON.stringify(answerBy(JSON.parse(line))) + "\n").join(""));
});
