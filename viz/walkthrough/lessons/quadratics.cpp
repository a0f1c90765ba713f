#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

std::vector<Lesson> quadratic_lessons() {
  return {
      {"quadratic-two", "quadratics", "The quadratic: D > 0, two roots",
       "The discriminant is how deep the parabola dips.",
       R"({"precision": "float32", "query": "quadratic", "a": 0.7, "b": -2.3, "c": 1.1})",
       "quadratic/textbook"},
      {"quadratic-double", "quadratics", "The quadratic: D = 0, a double root",
       "The parabola touches the axis, and the last digit decides whether it is said to.",
       R"({"precision": "float32", "query": "quadratic", "a": 1, "b": -3, "c": 2.25})", "quadratic/textbook"},
      {"quadratic-none", "quadratics", "The quadratic: D < 0, no real root",
       "The parabola stays on one side; the root of a negative number is NaN.",
       R"({"precision": "float32", "query": "quadratic", "a": 0.9, "b": -1.3, "c": 1.2})",
       "quadratic/textbook"},
      {"quadratic-cancellation", "quadratics", "The quadratic: where −b and √D cancel",
       "b² is so much larger than 4ac that √D is nearly b, and their difference is what the rounding left.",
       R"({"precision": "float32", "query": "quadratic", "a": 1, "b": -1234.5, "c": 0.7})",
       "quadratic/textbook"},
      {"quadratic-citardauq", "quadratics", "The quadratic upside down: citardauq",
       "2c over the same sum keeps the small root, and its other branch cancels instead.",
       R"({"precision": "float32", "query": "quadratic", "a": 1, "b": -1234.5, "c": 0.7})",
       "quadratic/citardauq"},
      {"quadratic-viete", "quadratics", "The quadratic without cancellation: one branch, then Viète",
       "One root from the branch where −b and √D add up, the other from x₀·x₁ = c/a: both keep their digits.",
       R"({"precision": "float32", "query": "quadratic", "a": 1, "b": -1234.5, "c": 0.7})",
       "quadratic/citardauq_viete"},
  };
}

}  // namespace rayproof::viz
