#include "case/case.hpp"

namespace rayproof {

std::string shape_name(const Shape& shape) {
  return std::visit([]<class S>(const S&) -> std::string { return ShapeFormat<S>::type; }, shape);
}

std::string topic_of(const Case& one) {
  if (const auto* asked = std::get_if<RayQuestion>(&one.question)) return shape_name(asked->shape);
  return std::holds_alternative<Quadratic<double>>(one.question) ? "quadratic" : "point_in_polygon";
}

}  // namespace rayproof
