#include "oracle/oracle.hpp"

#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

/// The judge of every shape that has none of its own.
template <class Shape>
Judgement judge(const RayQuestion& question, const Shape& shape, Precision precision,
                const RayAnswer& claimed) {
  return judge(*intersection_of(question, shape), precision, claimed);
}

}  // namespace

Answer answer(const Case& one) {
  if (const auto* equation = std::get_if<Quadratic<double>>(&one.question))
    return answer(*equation, one.precision);
  if (const auto* asked = std::get_if<PointAndPolygon<double>>(&one.question)) return answer(*asked);
  const auto& question = std::get<RayQuestion>(one.question);
  return std::visit(
      [&](const auto& shape) { return answer(*intersection_of(question, shape), one.precision); },
      question.shape);
}

Judgement judge(const Case& one, const Answer& claimed) {
  if (const auto* equation = std::get_if<Quadratic<double>>(&one.question))
    return judge(*equation, one.precision, std::get<QuadraticAnswer<double>>(claimed));
  if (const auto* asked = std::get_if<PointAndPolygon<double>>(&one.question))
    return judge(*asked, one.precision, std::get<Position>(claimed));
  const auto& question = std::get<RayQuestion>(one.question);
  return std::visit(
      [&](const auto& shape) { return judge(question, shape, one.precision, std::get<RayAnswer>(claimed)); },
      question.shape);
}

}  // namespace rayproof::oracle
