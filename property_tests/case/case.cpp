#include "case/case.hpp"

#include "case/shape_name.hpp"

namespace rayproof {

std::string topic_of(const Case& one) {
  if (std::holds_alternative<Quadratic<double>>(one.question)) return "quadratic";
  if (std::holds_alternative<PointAndPolygon<double>>(one.question)) return "point_in_polygon";
  return shape_name(std::get<RayQuestion>(one.question).shape);
}

}  // namespace rayproof
