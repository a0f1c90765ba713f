/// \file
/// The registration of the oracle's layer: each question goes to the overload that knows it. A shape is a
/// line of includes here.

#include "oracle/oracle.hpp"

#include "oracle/shapes/cylinder.hpp"
#include "oracle/shapes/plane.hpp"
#include "oracle/shapes/polygon.hpp"
#include "oracle/shapes/quadratic.hpp"
#include "oracle/shapes/solid.hpp"
#include "oracle/shapes/sphere.hpp"
#include "oracle/shapes/triangle.hpp"

namespace rayproof::oracle {

Answer answer(const Case& one) {
  if (const auto* equation = std::get_if<Quadratic<double>>(&one.question))
    return answer(*equation, one.precision);
  if (const auto* asked = std::get_if<PointAndPolygon<double>>(&one.question)) return answer(*asked);
  const auto& question = std::get<RayQuestion>(one.question);
  return std::visit([&](const auto& shape) { return answer(question, shape, one.precision); },
                    question.shape);
}

Judgement judge(const Case& one, const Answer& claimed) {
  if (const auto* equation = std::get_if<Quadratic<double>>(&one.question)) {
    return judge(*equation, one.precision, std::get<QuadraticAnswer<double>>(claimed));
  }
  if (const auto* asked = std::get_if<PointAndPolygon<double>>(&one.question))
    return judge(*asked, one.precision, std::get<Position>(claimed));
  const auto& question = std::get<RayQuestion>(one.question);
  return std::visit(
      [&](const auto& shape) { return judge(question, shape, one.precision, std::get<RayAnswer>(claimed)); },
      question.shape);
}

}  // namespace rayproof::oracle
