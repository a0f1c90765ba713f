#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {

namespace {

constexpr const char* far_apart =
    R"({"precision": "float32", "query": "quadratic", "a": 1, "b": -1234.5, "c": 0.7})";
constexpr const char* tiny_product = "4ac is tiny beside b², so nothing cancels yet: √D is nearly |b|.";

}  // namespace

std::vector<Lesson> quadratic_lessons() {
  return {
      {"quadratic-two", "quadratics", "The quadratic: D > 0, two roots",
       "D / 4|a| is how deep the parabola dips below the axis (or rises above it, for a < 0).",
       R"({"precision": "float32", "query": "quadratic", "a": 0.7, "b": -2.3, "c": 1.1})",
       "quadratic/textbook"},
      {"quadratic-double", "quadratics", "The quadratic: D = 0, a double root",
       "The parabola touches the axis: with c one ulp larger it would miss it, one ulp smaller it has two "
       "roots.",
       R"({"precision": "float32", "query": "quadratic", "a": 1, "b": -3, "c": 2.25})", "quadratic/textbook"},
      {"quadratic-none", "quadratics", "The quadratic: D < 0, no real root",
       "The parabola stays on one side; the root of a negative number is NaN.",
       R"({"precision": "float32", "query": "quadratic", "a": 0.9, "b": -1.3, "c": 1.2})",
       "quadratic/textbook"},
      {"quadratic-cancellation",
       "quadratics",
       "The quadratic: where −b and √D cancel",
       "b² is so much larger than 4ac that √D is nearly b, and their difference is what the rounding left.",
       far_apart,
       "quadratic/textbook",
       nullptr,
       {{"Form the discriminant", tiny_product}}},
      {"quadratic-citardauq",
       "quadratics",
       "The quadratic upside down: citardauq",
       "2c over the same sum keeps the small root, and its other branch cancels instead.",
       far_apart,
       "quadratic/citardauq",
       nullptr,
       {{"Form the discriminant", tiny_product}}},
      {"quadratic-linear",
       "quadratics",
       "The quadratic with a = 0: only citardauq is left",
       "The textbook divides by 2a = 0; 2c over the sum still gives the root −c/b of the line.",
       R"({"precision": "float32", "query": "quadratic", "a": 0, "b": -1.5, "c": 0.6})",
       "quadratic/citardauq",
       nullptr,
       {{"Form the discriminant",
         "With a = 0 it is b² and says nothing of the number of roots: a line has one."},
        {"Apply the formula upside down",
         "−b and √D are equal here: their difference is 0, and 2c / 0 is no root."}}},
      {"quadratic-viete",
       "quadratics",
       "The quadratic without cancellation: one branch, then Viète",
       "One root from the branch where −b and √D add up, the other from x₀·x₁ = c/a: both keep their digits.",
       far_apart,
       "quadratic/citardauq_viete",
       nullptr,
       {{"Form the discriminant", tiny_product}}},
  };
}

}  // namespace rayproof::viz
