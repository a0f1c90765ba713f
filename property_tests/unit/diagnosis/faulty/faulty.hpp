#pragma once
/// \file
/// Faulty code as answers to cases.

#include "properties/claims/answers.hpp"
#include "subjects/default_contract.hpp"
#include "unit/diagnosis/faulty/flat.hpp"
#include "unit/diagnosis/faulty/solids.hpp"

namespace rayproof::faulty {

template <class T>
[[nodiscard]] QuadraticAnswer<double> answer_equation(const Quadratic<double>& given, Fault fault) {
  const auto [a, b, c] = convert<T>(given);
  if (a == 0 && fault != Fault::no_linear) {
    if (b == 0) return {c == 0 ? RootKind::everything : RootKind::constant, 0, {}};
    return {RootKind::linear, 1, {static_cast<double>(-c / b)}};
  }
  T D = b * b - 4 * a * c;
  if (fault == Fault::abs_discriminant) D = std::abs(D);
  if (!(D >= 0)) return {RootKind::none, 0, {}};
  if (D == 0) {
    auto x = static_cast<double>(-b / (2 * a));
    if (fault == Fault::division_by_2) x *= static_cast<double>(a);
    if (fault == Fault::denominator_a) x *= 2;
    if (fault == Fault::double_missed) return {RootKind::none, 0, {}};
    if (fault == Fault::double_twice) return {RootKind::two, 2, {x, x}};
    return {RootKind::twice, 1, {x}};
  }
  const T s = std::sqrt(D), q = T(-0.5) * (b + std::copysign(s, b));
  T x = q / a, y = c / q;
  if (fault == Fault::cancelling || fault == Fault::abs_discriminant)
    x = (-b - s) / (2 * a), y = (-b + s) / (2 * a);
  if (fault == Fault::division_by_2) x *= a, y *= a;
  if (fault == Fault::denominator_a) x *= 2, y *= 2;
  const bool is_turned = fault == Fault::descending || (fault == Fault::wrong_order && a < 0);
  const auto low = static_cast<double>(std::min(x, y)), high = static_cast<double>(std::max(x, y));
  if (is_turned) return {RootKind::two, 2, {high, low}};
  return {RootKind::two, 2, {low, high}};
}

template <class T>
[[nodiscard]] Position answer_place(const PointAndPolygon<double>& given, Fault fault) {
  const PointAndPolygon<T> place = convert<T>(given);
  return is_inside(place.point, place.vertices, fault) ? Position::inside : Position::outside;
}

template <class T>
[[nodiscard]] RayAnswer answer_ray(const RayQuestion& asked, Fault fault) {
  return std::visit(
      [&]<class S>(const S& shape) {
        return answered<T>(asked, fault, [&](const Ray<T>& ray, Fault planted) {
          if constexpr (
              !requires { shape.normal; } && !requires { shape.u; })
            return find(ray, convert<T>(shape), planted);
          else
            return find<T>(ray, shape, planted);
        });
      },
      asked.shape);
}

/// Code with the fault.
template <Fault fault>
[[nodiscard]] Answer answer(const Case& one) {
  const Precision precision = fault == Fault::computes_in_float ? Precision::float32 : one.precision;
  return in_precision(precision, [&]<class T>(T) -> Answer {
    if (const auto* q = std::get_if<Quadratic<double>>(&one.question)) return answer_equation<T>(*q, fault);
    if (const auto* place = std::get_if<PointAndPolygon<double>>(&one.question))
      return answer_place<T>(*place, fault);
    return answer_ray<T>(std::get<RayQuestion>(one.question), fault);
  });
}

/// Two faults in one: it culls back faces, and forgets an edge.
[[nodiscard]] inline Answer two_faults(const Case& one) {
  const bool is_hit = !numbers_in(answer<Fault::nothing>(one)).empty();
  const Answer culled = answer<Fault::culls_back>(one);
  return is_hit && numbers_in(culled).empty() ? culled : answer<Fault::no_beta_test>(one);
}

/// The code on trial by the claims that every subject is held to, as a guest is.
[[nodiscard]] inline Subject subject_of(const char* topic, Answer (*code)(const Case&)) {
  Subject subject;
  subject.topic = topic;
  subject.name = "on_trial";
  subject.answer_by(code);
  subject.contract = default_contract(topic);
  subject.has_own_contract = false;
  return subject;
}

}  // namespace rayproof::faulty
