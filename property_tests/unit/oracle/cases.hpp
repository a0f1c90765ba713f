#pragma once
/// \file
/// Short ways to write the cases of the oracle's tests.

#include <gtest/gtest.h>

#include <vector>

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

/// The answer to a ray and any shape.
inline RayAnswer met(const Ray<double>& ray, const Shape& shape, Precision precision = Precision::float64) {
  return ray_answer({.precision = precision, .question = RayQuestion{ray, shape}});
}

/// The answer to a ray and the image of a shape.
inline RayAnswer met_under(const glm::dmat4& transform, const Ray<double>& ray, const Shape& shape) {
  return ray_answer({.question = RayQuestion{ray, shape, transform}});
}

/// A stretch along the axes, which may mirror.
inline glm::dmat4 stretch(double x, double y, double z) {
  glm::dmat4 map(1);
  map[0][0] = x;
  map[1][1] = y;
  map[2][2] = z;
  return map;
}

/// The ray straight down on (x, y).
inline Ray<double> down(double x, double y) { return {{x, y, 2}, {0, 0, -1}}; }

/// Whether the answer's hits are just these.
inline bool hits_at(const RayAnswer& found, const std::vector<double>& expected) {
  const auto view = found.hits.view();
  return std::vector<double>(view.begin(), view.end()) == expected;
}

inline void expect_hits(const RayAnswer& found, Contact contact, const std::vector<double>& expected) {
  EXPECT_TRUE(hits_at(found, expected)) << testing::PrintToString(found.hits.view());
  EXPECT_EQ(found.contact, contact);
  EXPECT_TRUE(found.point.has_value());
}

inline void expect_miss(const RayAnswer& found, Contact contact) {
  EXPECT_EQ(found.hits.count, 0U);
  EXPECT_EQ(found.contact, contact);
  EXPECT_FALSE(found.point.has_value());
  EXPECT_FALSE(found.normal.has_value());
  EXPECT_FALSE(found.barycentric.has_value());
}

inline QuadraticAnswer<double> roots_of(double a, double b, double c,
                                        Precision precision = Precision::float64) {
  return std::get<QuadraticAnswer<double>>(
      answer({.precision = precision, .question = Quadratic<double>{a, b, c}}));
}

}  // namespace rayproof::oracle::test
