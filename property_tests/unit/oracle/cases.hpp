#pragma once
/// \file
/// Short ways to write the cases of the oracle's tests.

#include "oracle/oracle.hpp"

namespace rayproof::oracle::test {

/// A ray and a sphere at double precision.
inline Case sphere_case(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& center,
                        double radius) {
  RayQuestion question{.ray = {origin, direction}, .shape = Sphere<double>{center, radius}};
  return {.question = question};
}

inline RayQuestion& question_of(Case& one) { return std::get<RayQuestion>(one.question); }

inline RayAnswer ray_answer(const Case& one) { return std::get<RayAnswer>(answer(one)); }

inline QuadraticAnswer<double> roots_of(double a, double b, double c,
                                        Precision precision = Precision::float64) {
  return std::get<QuadraticAnswer<double>>(
      answer({.precision = precision, .question = Quadratic<double>{a, b, c}}));
}

}  // namespace rayproof::oracle::test
