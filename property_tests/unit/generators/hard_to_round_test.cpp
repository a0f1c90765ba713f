/// \file
/// The hard cases are as hard as they are said to be: measured in rational numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "generators/generators.hpp"
#include "generators/scene.hpp"

namespace rayproof {

inline void PrintTo(Precision precision, std::ostream* out) { *out << name_of(precision); }

namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalVector = std::array<Rational, 3>;

RationalVector rational(const glm::dvec3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }
RationalVector rational_minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
RationalVector rational_cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational rational_dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A place or, without the move, a direction of the object as the case's map puts it into the world.
RationalVector in_world(const RayQuestion& one, const glm::dvec3& v, bool is_place = true) {
  if (!one.transform) return rational(v);
  const glm::dmat4& map = *one.transform;
  RationalVector mapped;
  for (int row = 0; row < 3; ++row)
    mapped.at(static_cast<std::size_t>(row)) =
        Rational(map[0][row]) * Rational(v.x) + Rational(map[1][row]) * Rational(v.y) +
        Rational(map[2][row]) * Rational(v.z) + (is_place ? Rational(map[3][row]) : Rational(0));
  return mapped;
}
/// A ray's place or direction in the space of an object that is stretched along the axes.
RationalVector before_the_stretch(const RayQuestion& one, const glm::dvec3& v) {
  RationalVector own = rational(v);
  if (one.transform)
    for (int i = 0; i < 3; ++i) own.at(static_cast<std::size_t>(i)) /= Rational((*one.transform)[i][i]);
  return own;
}
int mapped_ones(const std::vector<RayQuestion>& cases) {
  return static_cast<int>(std::ranges::count_if(cases, [](const auto& one) { return !!one.transform; }));
}

/// The family's cases of a precision.
std::vector<RayQuestion> cases_of(const char* topic, const char* name, Precision precision) {
  std::vector<RayQuestion> cases;
  for (const Family& family : families())
    if (family.topic == topic && family.name == name)
      for (std::uint64_t seed = 0; seed < 300; ++seed)
        cases.push_back(std::get<RayQuestion>(family.generate(seed, precision).question));
  return cases;
}

/// How far t is from the nearest multiple of half a spacing, as a part of t.
double from_a_midpoint(const Rational& t, int digits) {
  const int exponent = std::ilogb(t.convert_to<double>());
  const Rational halves = t * Rational(std::exp2(digits - exponent));
  const Rational raised = halves + Rational(1, 2);
  const Rational off = halves - Rational(numerator(raised) / denominator(raised));
  return std::abs((off / halves).convert_to<double>());
}

class HardCases : public testing::TestWithParam<Precision> {};

TEST_P(HardCases, TheTOfATriangleIsBesideANumberOrTheMiddleOfTwo) {
  const int digits = draw::digits_of(GetParam());
  int nearer_than_double_the_digits = 0;
  for (const RayQuestion& one : cases_of("triangle", "hard_to_round", GetParam())) {
    const auto& shape = std::get<Triangle<double>>(one.shape);
    const RationalVector a = in_world(one, shape.a), o = rational(one.ray.origin);
    const RationalVector n =
        rational_cross(rational_minus(in_world(one, shape.b), a), rational_minus(in_world(one, shape.c), a));
    const double off = from_a_midpoint(
        rational_dot(n, rational_minus(a, o)) / rational_dot(n, rational(one.ray.direction)), digits);
    EXPECT_LE(off, std::exp2(-1.4 * digits));
    nearer_than_double_the_digits += int{off < std::exp2(-2.0 * digits)};
  }
  EXPECT_GT(nearer_than_double_the_digits, 90);
}

TEST_P(HardCases, ATrianglesEdgeIsPassedByNextToNothingOnBothSidesAndOnIt) {
  const int digits = draw::digits_of(GetParam());
  std::array<int, 3> sides{};
  for (const RayQuestion& one : cases_of("triangle", "hard_to_decide", GetParam())) {
    const auto& shape = std::get<Triangle<double>>(one.shape);
    const RationalVector corners[] = {in_world(one, shape.a), in_world(one, shape.b), in_world(one, shape.c)},
                         d = rational(one.ray.direction);
    Rational nearest(1);
    for (int i = 0; i < 3; ++i) {
      const RationalVector& p = corners[i];
      const RationalVector across = rational_cross(d, rational_minus(corners[(i + 1) % 3], p));
      const Rational by =
          rational_dot(rational_minus(p, rational(one.ray.origin)), across) / rational_dot(across, across);
      if (abs(by) < abs(nearest)) nearest = by;
    }
    EXPECT_LE(abs(nearest).convert_to<double>(), std::exp2(-1.2 * digits));
    ++sides.at(static_cast<std::size_t>(nearest.sign() + 1));
  }
  EXPECT_GT(sides[0], 50);
  EXPECT_GT(sides[1], 10);
  EXPECT_GT(sides[2], 50);
}

TEST_P(HardCases, ARayPassesASphereByNextToNothingBothInsideAndOutside) {
  const int digits = draw::digits_of(GetParam());
  std::array<int, 3> sides{};
  for (const RayQuestion& one : cases_of("sphere", "hard_to_decide", GetParam())) {
    const auto& shape = std::get<Sphere<double>>(one.shape);
    const RationalVector f = rational_minus(before_the_stretch(one, one.ray.origin), rational(shape.center)),
                         d = before_the_stretch(one, one.ray.direction);
    const Rational r(shape.radius), b = rational_dot(f, d), a = rational_dot(d, d);
    const Rational part = (b * b - a * (rational_dot(f, f) - r * r)) / (a * r * r);
    EXPECT_LE(abs(part).convert_to<double>(), std::exp2(-digits));
    ++sides.at(static_cast<std::size_t>(part.sign() + 1));
  }
  EXPECT_GT(sides[0], 50);
  EXPECT_GT(sides[2], 30);
}

TEST_P(HardCases, AParallelepipedsFaceIsRunAlongButForNextToNothing) {
  const int digits = draw::digits_of(GetParam());
  int slight = 0, along = 0;
  for (const RayQuestion& one : cases_of("parallelepiped", "hard_to_meet", GetParam())) {
    const auto& solid = std::get<Parallelepiped<double>>(one.shape);
    const RationalVector d = rational(one.ray.direction);
    double least = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalVector e = in_world(one, solid.edges[i], false),
                           f = in_world(one, solid.edges[(i + 1) % 3], false), n = rational_cross(e, f);
      const Rational by = rational_dot(n, d), size = rational_dot(n, n) * rational_dot(d, d);
      least = std::min(least, std::sqrt(Rational(by * by / size).convert_to<double>()));
    }
    EXPECT_LE(least, std::exp2(-1.2 * digits));
    along += int{least == 0};
    slight += int{least > 0 && least < std::exp2(-1.8 * digits)};
  }
  EXPECT_GT(along, 10);
  EXPECT_GT(slight, 90);
}

TEST_P(HardCases, SomeLieUnderAMap) {
  for (const char* topic : {"triangle", "polygon", "plane", "box", "parallelepiped", "sphere", "cylinder"})
    EXPECT_GT(mapped_ones(cases_of(topic, "hard_to_round", GetParam())), 10) << topic;
}

INSTANTIATE_TEST_SUITE_P(InBothPrecisions, HardCases, testing::Values(Precision::float32, Precision::float64),
                         [](const auto& given) {
                           return given.param == Precision::float32 ? "float" : "double";
                         });

TEST(HardSlabs, ABoxIsEnteredAsItIsLeftButForTheOriginsTinyCoordinates) {
  int hard = 0;
  for (const RayQuestion& one : cases_of("box", "hard_to_round", Precision::float32)) {
    const auto& box = std::get<Box<double>>(one.shape);
    if (box.max != glm::dvec3(64) && box.min != glm::dvec3(-64) && dot(one.ray.origin, one.ray.origin) < 1e-4)
      ++hard;
  }
  EXPECT_GT(hard, 30);
}

}  // namespace
}  // namespace rayproof
