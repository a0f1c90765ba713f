/// \file
/// The judge of points, normals and coordinates judged: right ones have no error to speak of, and an error
/// that is planted is found in its size.

#include "oracle/numbers/ulp.hpp"
#include "unit/oracle/every_case.hpp"

namespace rayproof::oracle::test {
namespace {

constexpr double epsilon = 0x1p-53;

/// The details of the exact answer after `plant` has changed it.
template <class Plant>
Details planted(const Case& one, Plant&& plant) {
  RayAnswer claimed = ray_answer(one);
  plant(claimed);
  return judge_details(one, claimed);
}

/// The unit sphere, met at (-0.6, 0, 0.8), t = 1.6.
Case slanting() { return sphere_case({-0.6, 0, 2.4}, {0, 0, -1}, {0, 0, 0}, 1); }

/// A triangle, met at α = 0.2, β = 0.5, γ = 0.3.
Case triangle_case() {
  return {.question =
              RayQuestion{.ray = down(0.5, 0.3), .shape = Triangle<double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
}

/// The box from 0 to 3, met from above.
Case box_case(double x, double y) {
  return {.question =
              RayQuestion{.ray = {{x, y, 5}, {0, 0, -1}}, .shape = Box<double>{{0, 0, 0}, {3, 3, 3}}}};
}

bool is_in_reach(const Case& one) {
  const Judgement judgement = judge(one, answer(one));
  const int reach = one.precision == Precision::float32 ? 28 : 240;
  return judgement.smallest >= -reach && judgement.largest <= reach;
}

using DetailsOf = EveryShape;

TEST_P(DetailsOf, ExactAnswersAreWithinTheirRounding) {
  const auto at_most = [](const std::optional<double>& error, double bound) {
    return !error || *error <= bound;
  };
  for_each_case(GetParam(), 50, [&](const Case& one) {
    if (!is_in_reach(one)) return;
    const Details details = judge_details(one, answer(one));
    EXPECT_TRUE(at_most(details.point, 2)) << *details.point;
    EXPECT_TRUE(at_most(details.surface, 2)) << *details.surface;
    EXPECT_TRUE(at_most(details.forward, 1)) << *details.forward;
    EXPECT_TRUE(at_most(details.normal, 2)) << *details.normal;
    EXPECT_TRUE(at_most(details.coordinates, 1)) << *details.coordinates;
  });
}
INSTANTIATE_TEST_SUITE_P(Of, DetailsOf, testing::ValuesIn(ray_topics()), topic_name);

TEST(Details, OfAMissAndOfWhatIsNoRayAreNone) {
  const Case beside = sphere_case({2, 0, 2}, {0, 0, -1}, {0, 0, 0}, 1);
  const Details of_miss = judge_details(beside, answer(beside));
  EXPECT_FALSE(of_miss.point || of_miss.surface || of_miss.normal || of_miss.coordinates || of_miss.contact);
  const Case equation{.question = Quadratic<double>{1, 3, 2}};
  EXPECT_FALSE(judge_details(equation, answer(equation)).point);
}

TEST(Details, FindAPointOffTheRayOffTheSurfaceAndOfAnotherHit) {
  const double length = std::hypot(0.6, 2.4) + 1.6;  // |o| + |t||d|
  const Details aside = planted(slanting(), [](RayAnswer& a) { a.point->y += 1e-4; });
  EXPECT_NEAR(*aside.point * epsilon * length, 1e-4, 1e-12);
  EXPECT_NEAR(*aside.forward * epsilon * length, 1e-4, 1e-12);
  EXPECT_NEAR(*aside.surface * epsilon * (length + 1), 0.5e-8, 1e-12);  // y²/2, along the surface
  const Details above = planted(slanting(), [](RayAnswer& a) { a.point->z += 1e-4; });
  EXPECT_NEAR(*above.surface * epsilon * (length + 1), 0.8e-4, 1e-8);
  const Details later = planted(slanting(), [](RayAnswer& a) { a.point->z = -a.point->z; });
  EXPECT_LT(*later.surface, 4);
  EXPECT_NEAR(*later.point * epsilon * length, 1.6, 1e-8);
}

TEST(Details, FindAFlippedAMissingAndALongNormal) {
  const double condition = 1 + std::hypot(0.6, 2.4) + 1.6;
  const Details flipped = planted(slanting(), [](RayAnswer& a) { a.normal = -*a.normal; });
  EXPECT_NEAR(*flipped.normal * epsilon * condition, 1, 1e-7);
  const Details missing = planted(slanting(), [](RayAnswer& a) { a.normal.reset(); });
  EXPECT_EQ(*missing.normal, *flipped.normal);
  const Details longer = planted(slanting(), [](RayAnswer& a) { a.normal = 1.001 * *a.normal; });
  EXPECT_NEAR(*longer.normal * epsilon, 0.001, 1e-6);
  const Details none = planted(slanting(), [](RayAnswer& a) { a.normal = glm::dvec3(std::nan("")); });
  EXPECT_EQ(*none.normal, *flipped.normal);
}

TEST(Details, FindANormalThatIsStillThatOfTheObjectsSpace) {
  Case one = slanting();  // of an ellipsoid twice as high as it is wide, met at (-0.6, 0, 1.6)
  question_of(one).transform = stretch(1, 1, 2);
  const Details unmapped = planted(one, [](RayAnswer& a) { a.normal = glm::dvec3(-0.6, 0, 0.8); });
  const double turned = std::atan2(0.8, 0.6) - std::atan2(0.4, 0.6);
  const double length = 0x1p-53 * *unmapped.normal;
  EXPECT_GT(length, turned / 200);  // the condition is that of the map, of the sphere and of its size
  EXPECT_LT(length, turned / 2);
  const Details mapped = judge_details(one, answer(one));
  EXPECT_LT(*mapped.normal, 1);
}

TEST(Details, OfABoxTakeTheNormalOfEitherFaceAtAnEdgeAndOfOneFaceElsewhere) {
  const auto sideways = [](RayAnswer& a) { a.normal = glm::dvec3(1, 0, 0); };
  const auto without = [](RayAnswer& a) { a.normal.reset(); };
  const Case at_edge = box_case(3, 1), inside = box_case(2, 1);
  EXPECT_EQ(*planted(at_edge, sideways).normal, 0);
  EXPECT_EQ(*planted(at_edge, without).normal, 0);
  EXPECT_GT(*planted(at_edge, [](RayAnswer& a) { a.normal = glm::dvec3(-1, 0, 0); }).normal, 0x1p50);
  EXPECT_GT(*planted(inside, sideways).normal, 0x1p50);
  EXPECT_GT(*planted(inside, without).normal, 0x1p50);
}

TEST(Details, FindSwappedCoordinates) {
  const Details right = judge_details(triangle_case(), answer(triangle_case()));
  EXPECT_LE(*right.coordinates, 1);
  EXPECT_GE(right.condition, 1);
  const Details swapped =
      planted(triangle_case(), [](RayAnswer& a) { std::swap(a.barycentric->y, a.barycentric->z); });
  EXPECT_NEAR(*swapped.coordinates * epsilon, 0.2, 1e-12);
  const Details missing = planted(triangle_case(), [](RayAnswer& a) { a.barycentric.reset(); });
  EXPECT_EQ(*missing.coordinates, HUGE_VAL);
}

TEST(Details, CountTheErrorOfALargeParameterInUnitsOfEpsilonAndInPartsOfItself) {
  const Case one{.question = RayQuestion{.ray = down(9000.25, 0.5),
                                         .shape = ParametricPlane{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const auto claim = [](double u, double v) {
    return [u, v](RayAnswer& a) { a.parameters = glm::dvec2(u, v); };
  };
  EXPECT_EQ(*planted(one, claim(9000.25, 0.5)).rounded_coordinates, 0);
  const Details far = planted(one, claim(9000.25 + 9000.25 * epsilon * 4, 0.5));
  EXPECT_NEAR(*far.rounded_coordinates, 4, 1);
  EXPECT_NEAR(*far.coordinates, 36001, 9001);
  const Details near = planted(one, claim(9000.25, 0.5 + 4 * epsilon));
  EXPECT_EQ(*near.rounded_coordinates, 4);
  EXPECT_EQ(*near.coordinates, 4);
  EXPECT_EQ(*planted(one, claim(9000.25, HUGE_VAL)).rounded_coordinates, HUGE_VAL);
}

TEST(Details, KnowWhetherCoordinatesAreRoundedOnce) {
  const Case plane{.question = RayQuestion{.ray = down(9000.25, 0.5),
                                           .shape = ParametricPlane{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}}}};
  const auto claim = [](double u, double v) {
    return [u, v](RayAnswer& a) { a.parameters = glm::dvec2(u, v); };
  };
  const double third = 9000.25 / 3;
  EXPECT_TRUE(planted(plane, claim(third, 0.5)).coordinates_are_rounded);
  EXPECT_FALSE(planted(plane, claim(std::nextafter(third, 0), 0.5)).coordinates_are_rounded);
  EXPECT_FALSE(planted(plane, claim(third, std::nextafter(0.5, 1))).coordinates_are_rounded);
  EXPECT_TRUE(judge_details(triangle_case(), answer(triangle_case())).coordinates_are_rounded);
  const auto off = [](RayAnswer& a) { a.barycentric->z = std::nextafter(a.barycentric->z, 2); };
  const auto first_off = [](RayAnswer& a) { a.barycentric->x = std::nextafter(a.barycentric->x, 2); };
  EXPECT_FALSE(planted(triangle_case(), off).coordinates_are_rounded);
  EXPECT_TRUE(planted(triangle_case(), first_off).coordinates_are_rounded) << "it is 1 less the others";
}

TEST(Details, OfATriangleSeenFromTheSideAreLessCertain) {
  Case grazing = triangle_case();
  question_of(grazing).ray = {{-1, 0.3, 0.001}, {1, 0, -0.001}};
  const double from_above = judge_details(triangle_case(), answer(triangle_case())).condition;
  const double from_aside = judge_details(grazing, answer(grazing)).condition;
  EXPECT_GT(from_aside, 100 * from_above);
}

TEST(Details, SayHowTheExactHitTouches) {
  const Case touching = sphere_case({1, 0, 2}, {0, 0, -1}, {0, 0, 0}, 1);
  EXPECT_EQ(judge_details(touching, answer(touching)).contact, Contact::tangent);
  EXPECT_EQ(judge_details(slanting(), RayAnswer{}).contact, Contact::crossing);
}

}  // namespace
}  // namespace rayproof::oracle::test
