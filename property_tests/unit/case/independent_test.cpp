#include "case/independent.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rayproof {
namespace {

glm::dmat4 from_columns(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
  return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(0, 0, 0, 1)};
}

TEST(regular, is_a_transform_of_any_size) {
  EXPECT_TRUE(is_regular(glm::dmat4(1)));
  for (const double size : {0x1p-1074, 0x1p-1000, 1.0, 0x1p1000, 0x1.fffffffffffffp1023}) {
    EXPECT_TRUE(is_regular(from_columns({size, 0, 0}, {0, -size, 0}, {0, 0, size}))) << size;
    EXPECT_TRUE(is_regular(from_columns({0x1p-1074, 0, 0}, {0, size, 0}, {0, 0, 0x1p1023}))) << size;
  }
}

TEST(regular, is_not_a_transform_that_flattens_space) {
  EXPECT_FALSE(is_regular(from_columns({0, 0, 0}, {0, 1, 0}, {0, 0, 1})));
  EXPECT_FALSE(is_regular(from_columns({1, 2, 3}, {4, 5, 6}, {7, 8, 9})));
  EXPECT_FALSE(is_regular(from_columns({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0, 0, 1})));
  EXPECT_FALSE(is_regular(from_columns({0x1p-1074, 0x1p1000, 0}, {0x1p-1073, 0x1p1001, 0}, {0, 1, 1})));
}

TEST(regular, is_decided_by_the_last_bit) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(is_regular(from_columns({1, 1, 0}, {1, next, 0}, {0, 0, 1})));
  EXPECT_TRUE(is_regular(from_columns({1, 2, 3}, {4, 5, 6}, {7, 8, std::nextafter(9.0, 10.0)})));
  // The determinant is -2^-2000 here, and 0 in doubles.
  EXPECT_TRUE(is_regular(from_columns({0, 0x1p-1000, 0}, {0x1p-1000, 0x1p1000, 0}, {0x1p1000, 0, 1})));
}

TEST(independent, are_two_vectors_that_differ_in_direction_by_the_last_bit) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(are_independent({1, 1, 0}, {1, next, 0}));
  EXPECT_TRUE(are_independent({0x1p1000, 0, 0}, {0, 0x1p-1074, 0}));
  EXPECT_FALSE(are_independent({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}));
  EXPECT_FALSE(are_independent({0x1p1000, 0, -0x1p1000}, {-0x1p-1074, 0, 0x1p-1074}));
  EXPECT_FALSE(are_independent({0, 0, 0}, {1, 2, 3}));
}

}  // namespace
}  // namespace rayproof
