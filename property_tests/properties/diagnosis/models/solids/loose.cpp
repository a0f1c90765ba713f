#include "properties/diagnosis/models/solids/loose.hpp"

#include <glm/common.hpp>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/models/cylinders/ends.hpp"

namespace rayproof::diagnosis {

std::vector<Case> widened(const Case& one, double by) {
  Case in_doubles = one;  // so little may be lost in float
  in_doubles.precision = Precision::float64;
  return with_question(in_doubles, [by](RayQuestion& asked) {
    if (auto* box = std::get_if<Box<double>>(&asked.shape)) {
      box->min -= by;
      box->max += by;
    } else if (auto* solid = std::get_if<Parallelepiped<double>>(&asked.shape)) {
      for (glm::dvec3& edge : solid->edges) {
        solid->corner -= by * edge;
        edge *= 1 + 2 * by;
      }
    } else if (auto* cylinder = std::get_if<Cylinder<double>>(&asked.shape)) {
      if (cylinder->capped) return false;
      cylinder->height += 2 * by;
      lift(asked, -by);
    } else {
      return false;
    }
    return true;
  });
}

Answers narrowed(const Case& one, const Answer& exact, double by) {
  const std::vector<Case> left = widened(one, -by);
  if (!left.empty()) return exact_of(left);
  const auto* cylinder = shape_in<Cylinder<double>>(one);
  const bool is_thin = shape_in<Box<double>>(one) != nullptr || (cylinder != nullptr && !cylinder->capped);
  return is_thin && finds_something(exact) ? Answers{RayAnswer{}} : Answers{};
}

Answers thickened(const Case& one, double least) {
  Case in_doubles = one;
  in_doubles.precision = Precision::float64;
  Answers answers;
  for (const bool is_about_middle : {false, true}) {
    const auto made = with_shape<Box<double>>(in_doubles, [&](RayQuestion& /*asked*/, Box<double>& box) {
      const glm::dvec3 more = glm::max(least - (box.max - box.min), 0.0);
      box.min -= is_about_middle ? more / 2.0 : glm::dvec3(0);
      box.max += is_about_middle ? more / 2.0 : more;
      return more != glm::dvec3(0);
    });
    for (Answer& answer : exact_of(made)) answers.push_back(std::move(answer));
  }
  return answers;
}

}  // namespace rayproof::diagnosis
