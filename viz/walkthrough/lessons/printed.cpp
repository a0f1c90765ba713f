#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

/// Each formula that a source prints wrongly, on a case that shows it. Those of the camera and of polygons
/// have their place among the lessons on them.
std::vector<Lesson> printed_lessons() {
  return {
      {.name = "printed-2ac",
       .group = "printed",
       .title = "As printed: the quadratic formula over 2ac",
       .sentence = "The denominator is 2a: with 2ac both roots are off by the factor c.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [-2.5, -0.6, 0.4], "direction": [1.3, 0.5, 0.1]},
           "shape": {"type": "sphere", "center": [0.2, 0.1, 0.3], "radius": 1.4}})",
       .method = "sphere/printed_2ac",
       .beside = "sphere/textbook"},
      {.name = "printed-half-b",
       .group = "printed",
       .title = "As printed: half b, with |d| = 1 taken for granted",
       .sentence =
           "t = −b ± √(b² − c) is right for a direction of length 1 alone; else a = |d|² must divide.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [-3.7, -0.9, 0.4], "direction": [1.3, 0.5, 0.1]},
           "shape": {"type": "sphere", "center": [0.2, 0.1, 0.3], "radius": 1.4}})",
       .method = "sphere/printed_half_b",
       .beside = "sphere/half_b"},
      {.name = "printed-unit-direction",
       .group = "printed",
       .title = "As printed: the direction made a unit vector",
       .sentence = "From then on t is a length, and no longer the t of the ray that was given.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [-3.7, -0.9, 0.4], "direction": [1.3, 0.5, 0.1]},
           "shape": {"type": "sphere", "center": [0.2, 0.1, 0.3], "radius": 1.4}})",
       .method = "sphere/printed_unit_direction",
       .beside = "sphere/centred"},
      {.name = "printed-plane",
       .group = "printed",
       .title = "As printed: a plane's numerator without its coefficients",
       .sentence =
           "x₀ + y₀ + z₀ + D is not the plane's equation at the ray's origin: A, B and C are missing.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [-1.2, -2.1, 2.7], "direction": [0.4, 0.7, -0.6]},
           "shape": {"type": "plane", "normal": [0.3, 0.2, 1.1], "d": -0.7}})",
       .method = "plane/printed_implicit",
       .beside = "plane/implicit"},
      {.name = "printed-parallelogram",
       .group = "printed",
       .title = "As printed: α and β in [0, 1], a whole parallelogram",
       .sentence = "Without α + β ≤ 1 the other half of the parallelogram is hit, too.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [1.6, -1.1, 2.4], "direction": [-0.2, 0.9, -0.8]},
           "shape": {"type": "triangle", "a": [-1.1, -0.4, 0.3], "b": [1.6, -0.2, 0.1], "c": [0.2, 1.3, 0.6]}})",
       .method = "triangle/printed_parallelogram",
       .beside = "triangle/cramer"},
      {.name = "printed-lambda2",
       .group = "printed",
       .title = "As printed: a wrong sign in the second barycentric coordinate",
       .sentence = "One sign is enough: a point inside the triangle is called outside.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [0.7, -1.9, 2.4], "direction": [-0.2, 0.9, -0.8]},
           "shape": {"type": "triangle", "a": [-1.1, -0.4, 0.3], "b": [1.6, -0.2, 0.1], "c": [0.2, 1.3, 0.6]}})",
       .method = "triangle/printed_lambda2",
       .notes = {{"Find the barycentric coordinates, the second as printed",
                  "Printed is λ₂ = (−(a.y − c.y)·(q.x − c.x) − (a.x − c.x)·(q.y − c.y)) / D; β has the right "
                  "signs."}},
       .beside = "triangle/plane_projection"},
      {.name = "printed-xy",
       .group = "printed",
       .title = "As printed: barycentric coordinates in x and y alone",
       .sentence = "An upright triangle has no area in x and y: D = 0, and every share is NaN or infinite.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [0.3, -2.5, 0.9], "direction": [0.1, 1, -0.1]},
           "shape": {"type": "triangle", "a": [-1, 0.5, 0], "b": [1.5, 0.5, 0.25], "c": [0.5, 0.5, 1.5]}})",
       .method = "triangle/printed_xy",
       .beside = "triangle/plane_projection"},
      {.name = "slabs-parallel",
       .group = "boxes",
       .title = "A ray in a face of the box: 0·∞",
       .sentence = "d.y = 0 makes 1/d.y infinite, and the face's own distance is 0: their product is NaN.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [-2.4, -0.5, 0.3], "direction": [0.9, 0, 0.1]},
           "shape": {"type": "box", "min": [-0.75, -0.5, 0.1], "max": [1.25, 1, 1.2]}})",
       .method = "box/printed_slabs",
       .beside = "box/slabs"},
      {.name = "printed-cylinder",
       .group = "printed",
       .title = "As printed: a ray that ends at t = 1, and no caps",
       .sentence =
           "t in [0, 1] is a segment's: the ray goes on, and meets the cylinder beyond its direction's tip.",
       .case_text =
           R"({"precision": "float32", "ray": {"origin": [-3.4, -0.9, 0.6], "direction": [1.4, 0.4, 0.2]},
           "shape": {"type": "cylinder", "rx": 1.6, "ry": 0.9, "height": 2.2, "capped": false}})",
       .method = "cylinder/printed",
       .beside = "cylinder/textbook"},
      {.name = "printed-b-4ac",
       .group = "printed",
       .title = "As printed: the careful branch where b ≫ 4ac",
       .sentence = "Cancellation depends on b² and 4ac: of this b, which is not much larger than 4ac, √D "
                   "still is nearly |b|.",
       .case_text = R"({"precision": "float32", "query": "quadratic", "a": 1, "b": 90, "c": 1})",
       .method = "quadratic/printed_b_4ac",
       .beside = "quadratic/citardauq_viete"},
  };
}

}  // namespace rayproof::viz
