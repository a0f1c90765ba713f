/// \file
/// Spheres, cylinders and quadratics, computed independently: CGAL's numbers of the form a + b·√c over
/// rational ones, put into the shape's own inequalities point by point.

#include <CGAL/Sqrt_extension.h>

#include "unit/oracle/independent/meeting.hpp"

namespace rayproof::oracle::test {
namespace {

/// a + b·√c with exact comparison.
using Surd = CGAL::Sqrt_extension<Rational, Rational>;

/// The real roots of ax² + 2bx + c with a > 0, ascending, each once.
std::vector<Surd> roots(const Rational& a, const Rational& b, const Rational& c) {
  const Rational discriminant = (b * b - a * c) / (a * a);
  if (discriminant < 0) return {};
  if (discriminant == 0) return {Surd(Rational(-b / a))};
  const Surd lower(Rational(-b / a), Rational(-1), discriminant);
  return {lower, Surd(Rational(-b / a), Rational(1), discriminant)};
}

/// What the oracle must say of a round shape: the hits with their contact, and whether they bear a normal.
struct RoundHit {
  Surd t;
  Contact contact;
};

void expect_agrees(const Case& one, const RationalRay& ray, const std::vector<RoundHit>& line, Contact miss) {
  std::vector<RoundHit> hits;
  for (const RoundHit& hit : line)
    if (is_within(hit.t, std::get<RayQuestion>(one.question).ray)) hits.push_back(hit);
  const RayAnswer found = ray_answer(one);
  EXPECT_EQ(found.contact, hits.empty() ? miss : hits[0].contact);
  ASSERT_EQ(found.hits.count, hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i)
    EXPECT_TRUE(is_nearest(found.hits.t[i], hits[i].t, one.precision)) << found.hits.t[i];
  ASSERT_EQ(found.point.has_value(), !hits.empty());
  for (int axis = 0; axis < 3 && found.point; ++axis) {
    const Surd exact = Surd(ray.world_origin[axis]) + hits[0].t * Surd(ray.world_direction[axis]);
    EXPECT_TRUE(is_nearest((*found.point)[axis], exact, one.precision)) << (*found.point)[axis];
  }
}

TEST(IndependentComputation, NumbersWithRootsAgreeWithSpheres) {
  for_each_case("sphere", independent_cases, [](Case one) {
    const RayQuestion& asked = question_of(one);
    const auto& sphere = std::get<Sphere<double>>(asked.shape);
    const RationalRay ray(asked);
    const Vector3 from_center = ray.origin - point_of(sphere.center);
    const Rational radius(sphere.radius);
    const auto line = roots(ray.direction.squared_length(), ray.direction * from_center,
                            from_center.squared_length() - radius * radius);
    std::vector<RoundHit> hits;
    for (const Surd& t : line) hits.push_back({t, line.size() == 1 ? Contact::tangent : Contact::crossing});
    expect_agrees(one, ray, hits, Contact::none);
  });
}

/// The ray where the cylinder is upright and round, of radius 1 and height 1 (or none).
struct UnitRay {
  Rational ox, oy, oz, dx, dy, dz, height;

  UnitRay(const RationalRay& ray, const Cylinder<double>& tube)
      : ox(ray.origin.x() / Rational(tube.rx)),
        oy(ray.origin.y() / Rational(tube.ry)),
        oz(ray.origin.z()),
        dx(ray.direction.x() / Rational(tube.rx)),
        dy(ray.direction.y() / Rational(tube.ry)),
        dz(ray.direction.z()),
        height(tube.height) {}

  [[nodiscard]] bool is_upright() const { return dx == 0 && dy == 0; }
  [[nodiscard]] Rational power(const Rational& t) const {
    const Rational x = ox + t * dx, y = oy + t * dy;
    return x * x + y * y - 1;
  }
};

std::vector<RoundHit> side_hits(const UnitRay& ray) {
  if (ray.is_upright()) return {};
  const auto line = roots(ray.dx * ray.dx + ray.dy * ray.dy, ray.ox * ray.dx + ray.oy * ray.dy, ray.power(0));
  std::vector<RoundHit> hits;
  for (const Surd& t : line) {
    const Surd z = Surd(ray.oz) + t * Surd(ray.dz);
    if (z < Rational(0) || z > ray.height) continue;
    const bool on_rim = z == Rational(0) || z == ray.height;
    hits.push_back({t, on_rim ? Contact::rim : line.size() == 1 ? Contact::tangent : Contact::crossing});
  }
  return hits;
}

/// Every hit of the line: with the side, and with what of its two ends is not on the side already.
std::vector<RoundHit> hits_of(const UnitRay& ray, bool has_caps) {
  std::vector<RoundHit> hits = side_hits(ray);
  if (ray.dz == 0) return hits;
  for (const Rational& z : {Rational(0), ray.height}) {
    const Rational t = (z - ray.oz) / ray.dz;
    const Rational power = ray.power(t);
    const bool on_rim = power == 0 && (has_caps || ray.height == 0);
    if (!on_rim && !(has_caps && power < 0)) continue;
    const bool is_new =
        std::none_of(hits.begin(), hits.end(), [&](const RoundHit& hit) { return hit.t == t; });
    if (is_new) hits.push_back({Surd(t), on_rim ? Contact::rim : Contact::crossing});
  }
  // In the order of the line. No two that are compared have different roots: the caps' t have none.
  // one.
  std::sort(hits.begin(), hits.end(), [](const RoundHit& a, const RoundHit& b) { return a.t < b.t; });
  return hits;
}

TEST(IndependentComputation, NumbersWithRootsAgreeWithCylinders) {
  for_each_case("cylinder", independent_cases, [](Case one) {
    const RayQuestion& asked = question_of(one);
    const auto& tube = std::get<Cylinder<double>>(asked.shape);
    const RationalRay ray(asked);
    const UnitRay unit(ray, tube);
    const bool in_side = !tube.capped && tube.height > 0 && unit.is_upright() && unit.power(0) == 0;
    expect_agrees(one, ray, hits_of(unit, tube.capped), in_side ? Contact::in_surface : Contact::none);
  });
}

TEST(IndependentComputation, NumbersWithRootsAgreeWithQuadratics) {
  for_each_case("quadratic", independent_cases, [](const Case& one) {
    const auto& q = std::get<Quadratic<double>>(one.question);
    if (q.a == 0) return;  // no square, no root: see quadratic_test.cpp
    const Rational sign(q.a < 0 ? -1 : 1);
    const auto expected = roots(sign * Rational(q.a), sign * Rational(q.b) / 2, sign * Rational(q.c));
    const auto found = std::get<QuadraticAnswer<double>>(answer(one));
    constexpr std::array kinds{RootKind::none, RootKind::twice, RootKind::two};
    EXPECT_EQ(found.kind, kinds[expected.size()]);
    ASSERT_EQ(found.count, expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_TRUE(is_nearest(found.roots[i], expected[i], one.precision)) << found.roots[i];
  });
}

}  // namespace
}  // namespace rayproof::oracle::test
