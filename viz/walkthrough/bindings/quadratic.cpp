#include <cmath>
#include <limits>

#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {
namespace {

Quadratic<double> equation_of(const NumbersByName& n) { return {n["a"], n["b"], n["c"]}; }

/// The frame that the scene is drawn in, from the same numbers.
ParabolaFrame frame_of(const NumbersByName& n) {
  const auto [a, b, c] = equation_of(n);
  std::vector<double> roots;
  const double D = b * b - 4 * a * c;
  if (a == 0) {
    roots = {-c / b};
  } else if (D >= 0) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(D), b));
    roots = {q / a};
    if (q != 0) roots.push_back(c / q);
  }
  return parabola_frame(equation_of(n), roots);
}

/// What is measured along the axis is drawn so far below it that its label finds room between.
constexpr glm::dvec3 under_the_axis{0, -0.2, 0};

/// −D/4a: how far the vertex lies from the axis.
Items discriminant(const NumbersByName& n) {
  const auto [a, b, c] = equation_of(n);
  const double x = -b / (2 * a);
  const ParabolaFrame frame = frame_of(n);
  return {segment(Role::nearest, frame.at(x, 0), frame.at(x, c - b * b / (4 * a)), "−D/(4a)")};
}

Items half_distance(const NumbersByName& n) {
  const auto [a, b, c] = equation_of(n);
  const ParabolaFrame frame = frame_of(n);
  const double x = -b / (2 * a);
  const double s = std::sqrt(b * b - 4 * a * c) / (2 * a);
  if (!(std::abs(s) > 0)) return {};
  return {
      segment(Role::edge, frame.at(x, 0) + under_the_axis, frame.at(x + s, 0) + under_the_axis, "√D/(2a)"),
      segment(Role::edge, frame.at(x, 0) + under_the_axis, frame.at(x - s, 0) + under_the_axis),
      point(Role::edge, frame.at(x, 0) + under_the_axis)};
}

Binding root(const char* name) {
  return {name, [=](const NumbersByName& n) {
            return Items{point(Role::claimed, frame_of(n).at(n.rounded(name), 0), name)};
          }};
}

Items vertex(const NumbersByName& n) {
  const auto [a, b, c] = equation_of(n);
  const ParabolaFrame frame = frame_of(n);
  const double x = -b / (2 * a);
  const double far_root = n["q"] / a;
  return {segment(Role::edge, frame.at(x, 0) + under_the_axis, frame.at(far_root, 0) + under_the_axis,
                  "to the far root")};
}

}  // namespace

std::vector<Binding> quadratic_bindings() {
  return {{"D", discriminant}, {"√D", half_distance}, {"q", vertex}, root("x₀"),
          root("x₁"),          root("q/a"),           root("c/q")};
}

}  // namespace rayproof::viz
