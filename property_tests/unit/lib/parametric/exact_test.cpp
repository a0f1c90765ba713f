/// \file
/// Hits of patches against exact numbers: the residual in the oracle's ring, by the sum of Bernstein
/// polynomials, and for the bilinear patch its quadratic in u, solved in numbers a + b·√c.

#include <CGAL/Sqrt_extension.h>
#include <gtest/gtest.h>

#include <rayproof/parametric/bilinear_quadratic.hpp>
#include <rayproof/parametric/hits.hpp>

#include "generators/draw.hpp"
#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/exact.hpp"
#include "unit/oracle/independent/rational.hpp"

namespace rayproof::parametric {
namespace {

using Ring = oracle::Exact;
using oracle::test::Rational;
using Surd = CGAL::Sqrt_extension<Rational, Rational>;
using Exact = oracle::Vector<Ring>;

Ring power(const Ring& x, std::size_t n) { return n == 0 ? Ring(1.0) : x * power(x, n - 1); }

template <class T, std::size_t Degree>
Exact exact_point(const BezierPatch<T, Degree>& patch, double u, double v) {
  constexpr std::array<std::array<double, 4>, 4> binomial{{{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}}};
  const auto bernstein = [&](std::size_t i, const Ring& x) {
    return Ring(binomial[Degree][i]) * power(x, i) * power(Ring(1.0) - x, Degree - i);
  };
  Exact sum{Ring(0.0), Ring(0.0), Ring(0.0)};
  for (std::size_t i = 0; i <= Degree; ++i)
    for (std::size_t j = 0; j <= Degree; ++j)
      sum = sum + bernstein(i, Ring(u)) * bernstein(j, Ring(v)) * Exact::from(glm::dvec3(patch.points[i][j]));
  return sum;
}

/// The exact squared distance of a hit's two points, r(u, v) and p(t).
template <class T, std::size_t Degree>
Ring squared_distance(const Ray<T>& ray, const BezierPatch<T, Degree>& patch, const PatchHit<T>& hit) {
  const Exact p = Exact::from(glm::dvec3(ray.origin)) + Ring(hit.t) * Exact::from(glm::dvec3(ray.direction));
  const Exact off = exact_point(patch, hit.u, hit.v) - p;
  return dot(off, off);
}

/// A patch of numbers from one draw.
template <class Patch, class Draw>
Patch patch_of(Draw&& draw) {
  Patch patch{};
  for (auto& row : patch.points)
    for (auto& point : row) point = draw::vector(draw);
  return patch;
}

template <class T>
class ExactPatchHits : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ExactPatchHits, Precisions);

TYPED_TEST(ExactPatchHits, KeepTheirResidual) {
  using T = TypeParam;
  std::size_t certain = 0;
  double worst = 0;
  const auto put = [&](const auto& ray, const auto& patch) {
    for (const PatchHit<T>& hit : hits(ray, patch)) {
      const Ring squared = squared_distance(ray, patch, hit);
      const Ring bound = Ring(hits_contract.residual.promised) * Ring(hit.residual);
      EXPECT_LE(squared, bound * bound);
      if (hit.residual > 0) worst = std::max(worst, std::sqrt(squared.to_double()) / double{hit.residual});
      certain += hit.is_certain ? 1 : 0;
    }
  };
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(combine(seed, 41));
    const auto number = [&] { return draw::symmetric<T>(random); };
    const double scale = std::exp2(random.uniform(-10, 10));
    const Ray<T> ray{draw::vector(number) * T(scale), draw::vector(number), -infinity<T>};
    put(ray, patch_of<BilinearPatch<T>>([&] { return T(scale) * number(); }));
    put(ray, patch_of<BicubicPatch<T>>([&] { return T(scale) * number(); }));
  }
  std::printf("%.4f of the residual at most\n", worst);
  EXPECT_LE(worst, hits_contract.residual.measured);
  EXPECT_GT(certain, 50U);
}

/// The point aimed at is in one of the answers.
TYPED_TEST(ExactPatchHits, FindThePointThatTheRayWasAimedAt) {
  using T = TypeParam;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(combine(seed, 42));
    const auto whole = [&] { return T(random.between(-16, 16)); };
    const auto patch = patch_of<BicubicPatch<T>>(whole);
    const T u = T(random.between(0, 16)) / 16,
            v = T(random.between(0, 16)) / 16;  // r(u, v) is exact in double
    const Exact aim = exact_point(patch, u, v);
    const glm::vec<3, T> d = draw::vector(whole);
    const glm::dvec3 origin =
        glm::dvec3(aim.x.to_double(), aim.y.to_double(), aim.z.to_double()) - glm::dvec3(d) * 2.0;
    const Ray<T> ray{glm::vec<3, T>(origin), d};
    if (d == glm::vec<3, T>(0) || glm::dvec3(ray.origin) != origin) continue;  // not exact in float
    const auto found = hits(ray, patch);
    const bool is_missed = std::none_of(found.begin(), found.end(), [&](const PatchHit<T>& hit) {
      return hit.t_range.contains(T(2)) && hit.u_range.contains(u) && hit.v_range.contains(v);
    });
    EXPECT_LE(is_missed ? 1 : 0, hits_contract.missed.promised) << "seed " << seed;
  }
}

/// The exact hits of a bilinear patch and the double ones among them, in whole numbers.
struct ExactPatchHit {
  Surd t, u, v;
};
struct ExactHits {
  std::vector<ExactPatchHit> all;
  bool is_double = false;
  bool is_regular = true;  ///< no ruling in the ray's direction, no volume that is 0 everywhere
};

using Three = std::array<Surd, 3>;
Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Surd dot(const Three& a, const Three& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Three exact(const glm::dvec3& v) { return {Surd(Rational(v.x)), Surd(Rational(v.y)), Surd(Rational(v.z))}; }
Three along(const Three& a, const Surd& s, const Three& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

/// The roots of ax² + bx + c, a or b not 0, in one field.
std::vector<Surd> roots_of(const Rational& a, const Rational& b, const Rational& c) {
  if (a == 0) return {Surd(Rational(-c / b))};
  const Rational middle = -b / (2 * a), square = middle * middle - c / a;
  if (square < 0) return {};
  if (square == 0) return {Surd(middle)};
  return {Surd(middle, Rational(-1), square), Surd(middle, Rational(1), square)};
}

template <class T>
ExactHits exact_hits(const Ray<T>& ray, const BilinearPatch<T>& patch) {
  const auto& p = patch.points;
  const glm::dvec3 o(ray.origin);
  const Three d = exact(ray.direction), a = exact(glm::dvec3(p[0][0]) - o);
  const Three a_u = exact(glm::dvec3(p[1][0]) - glm::dvec3(p[0][0]));
  const Three e = exact(glm::dvec3(p[0][1]) - glm::dvec3(p[0][0]));
  const Three far = exact(glm::dvec3(p[1][1]) - glm::dvec3(p[1][0]));
  const Three e_u = along(far, Surd(Rational(-1)), e);
  const auto volume = [&](const Three& x, const Three& y) { return dot(cross(x, d), y).a0(); };
  const Rational quadratic = volume(a_u, e_u), linear = volume(a, e_u) + volume(a_u, e),
                 constant = volume(a, e);
  ExactHits found;
  if (quadratic == 0 && linear == 0) {
    found.is_regular = constant != 0;
    return found;
  }
  const auto us = roots_of(quadratic, linear, constant);
  found.is_double = us.size() == 1 && quadratic != 0;
  for (const Surd& u : us) {
    const Three at = along(a, u, a_u), ruling = along(e, u, e_u), n = cross(d, ruling);
    const Surd nn = dot(n, n);
    if (nn == Surd(Rational(0))) {
      found.is_regular = false;
      return found;
    }
    const ExactPatchHit hit{dot(cross(at, ruling), n) / nn, u, dot(cross(at, d), n) / nn};
    const auto in_unit = [](const Surd& x) { return x >= Rational(0) && x <= Rational(1); };
    if (in_unit(hit.u) && in_unit(hit.v) && hit.t >= Rational(0)) found.all.push_back(hit);
  }
  return found;
}

template <class T>
bool holds(const Interval<T>& range, const Surd& x) {
  return (std::isinf(range.lo) || x >= Rational(range.lo)) &&
         (std::isinf(range.hi) || x <= Rational(range.hi));
}

TYPED_TEST(ExactPatchHits, OfABilinearPatchAreThoseOfItsExactQuadratic) {
  using T = TypeParam;
  std::size_t known = 0, certain = 0, undecided = 0, closed = 0;
  for (std::uint64_t seed = 0; seed < 800; ++seed) {
    SCOPED_TRACE(seed);
    Random random(combine(seed, 43));
    const auto whole = [&] { return T(random.between(-5, 5)); };
    const auto patch = patch_of<BilinearPatch<T>>(whole);
    Ray<T> ray{draw::vector(whole), draw::vector(whole)};
    if (!random.one_in(4)) {  // towards the middle of the patch, and a little beside it
      const auto& p = patch.points;
      ray.direction += p[0][0] + p[0][1] + p[1][0] + p[1][1] - T(4) * ray.origin;
    }
    if (ray.direction == vec3<T>(0)) ray.direction.z = 1;
    const ExactHits exact = exact_hits(ray, patch);
    if (!exact.is_regular) continue;
    const PatchHits<T> found = hits(ray, patch);
    const auto holds_hit = [](const PatchHit<T>& hit, const ExactPatchHit& one) {
      return holds(hit.t_range, one.t) && holds(hit.u_range, one.u) && holds(hit.v_range, one.v);
    };
    const auto missed = std::count_if(exact.all.begin(), exact.all.end(), [&](const ExactPatchHit& one) {
      return std::none_of(found.begin(), found.end(), [&](const auto& hit) { return holds_hit(hit, one); });
    });
    EXPECT_LE(static_cast<double>(missed), hits_contract.missed.promised);
    for (const PatchHit<T>& hit : found) {
      const auto inside = std::count_if(exact.all.begin(), exact.all.end(),
                                        [&](const ExactPatchHit& one) { return holds_hit(hit, one); });
      const bool is_wrong = hit.is_certain && (inside != 1 || exact.is_double);
      EXPECT_LE(is_wrong ? 1 : 0, hits_contract.wrong.promised);
      certain += hit.is_certain ? 1 : 0;
      undecided += hit.is_certain ? 0 : 1;
    }
    known += exact.all.size();
    for (const auto& hit : BilinearQuadratic::roots(ray, patch)) closed += hit.t == hit.t ? 1 : 0;
  }
  std::printf("known %zu, certain %zu, undecided answers %zu, closed form in plain numbers %zu\n", known,
              certain, undecided, closed);
  EXPECT_GT(certain, 100U);
}

}  // namespace
}  // namespace rayproof::parametric
