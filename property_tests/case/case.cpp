#include "case/case.hpp"

namespace rayproof {

std::string shape_name(const Shape& shape) {
  return std::visit([]<class S>(const S&) -> std::string { return ShapeFormat<S>::type; }, shape);
}

std::string topic_of(const Case& one) {
  if (std::holds_alternative<Quadratic<double>>(one.question)) return "quadratic";
  if (std::holds_alternative<PointAndPolygon<double>>(one.question)) return "point_in_polygon";
  return shape_name(std::get<RayQuestion>(one.question).shape);
}

}  // namespace rayproof
