#include "case/case.hpp"

#include <type_traits>

namespace rayproof {

std::string topic_of(const Case& one) {
  if (std::holds_alternative<Quadratic<double>>(one.question)) return "quadratic";
  if (std::holds_alternative<PointAndPolygon<double>>(one.question)) return "point_in_polygon";
  const auto& question = std::get<RayQuestion>(one.question);
  return std::visit(
      [](const auto& shape) -> std::string { return ShapeFormat<std::decay_t<decltype(shape)>>::type; },
      question.shape);
}

}  // namespace rayproof
