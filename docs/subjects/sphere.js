// A program on trial: ./rayproof check --subject-command "node docs/subjects/sphere.js" --shape sphere
"use strict";

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Every t at which the ray meets the sphere, ascending. Put your own code here. */
function sphere(ray, shape) {
  const l = ray.origin.map((o, i) => o - shape.center[i]);
  const a = dot(ray.direction, ray.direction), b = dot(l, ray.direction);
  const D = b * b - a * (dot(l, l) - shape.radius * shape.radius);
  if (D < 0) return [];
  const root = Math.sqrt(D);
  return D === 0 ? [-b / a] : [(-b - root) / a, (-b + root) / a];
}

const shapes = { sphere }; // more shapes: their names in docs/case-format.md, and a function for each

/** The case's numbers, rounded to its precision; an infinity is a string. */
function numbers(value, round) {
  if (Array.isArray(value)) return value.map((one) => numbers(one, round));
  if (typeof value === "object") return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, numbers(one, round)]));
  return round(value === "inf" ? Infinity : value === "-inf" ? -Infinity : Number(value));
}

function answer(line) {
  const { id, precision, ray: givenRay, shape: givenShape, transform } = JSON.parse(line);
  const meet = shapes[givenShape?.type];
  if (!meet || transform) return { id, unsupported: true };
  const [ray, shape] = numbers([givenRay, givenShape], precision === "float32" ? Math.fround : (x) => x);
  const hits = meet(ray, shape).filter((t) => ray.t_min <= t && t <= ray.t_max).map((t) => ({ t }));
  return { id, verdict: hits.length ? "hit" : "miss", hits };
}

let rest = "";
process.stdin.setEncoding("utf8").on("data", (text) => {
  const lines = (rest + text).split("\n");
  rest = lines.pop();
  process.stdout.write(lines.filter(Boolean).map((line) => JSON.stringify(answer(line)) + "\n").join(""));
});
