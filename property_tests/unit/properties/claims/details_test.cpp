#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "case/reader.hpp"
#include "generators/random.hpp"
#include "unit/properties/broken_subjects.hpp"

namespace rayproof {
namespace {

/// An ellipsoid, met beside its pole.
const char* const on_ellipsoid =
    R"({"precision": "float32", "ray": {"origin": [0.25,0,-5], "direction": [0,0,1]}, "transform": [[1,0,0,0],[0,1,0,0],[0,0,2,0],[0,0,0,1]], "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
/// Touched at (0, 1, 0).
const char* const touching =
    R"({"precision": "float32", "ray": {"origin": [0,1,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
const char* const in_triangle =
    R"({"precision": "float32", "ray": {"origin": [0.5,0.25,2], "direction": [0,0,-1]}, "shape": {"type": "triangle", "a": [0,0,0], "b": [1,0,0], "c": [0,1,0]}})";

/// How a property rules on the exact answer after `change` has spoilt its details.
template <class Change>
Ruling rule(const char* property, const char* text, Change) {
  const Case one = read_case(text);
  const Subject subject = broken::subject(topic_of(one), [](const Case& asked) -> Answer {
    auto answer = std::get<RayAnswer>(broken::exactly(asked));
    Change{}(answer);
    return answer;
  });
  Trial trial(subject, one);
  return find_property(property)->rule(trial);
}

constexpr auto unchanged = [](RayAnswer&) {};

TEST(DetailsProperties, HoldForTheOracleUnderATransformAndAreNotAskedOfWhatAShapeLacks) {
  for (const char* name : {"point", "point-on-surface", "normal", "touch"})
    EXPECT_EQ(rule(name, on_ellipsoid, unchanged), Ruling::held) << name;
  EXPECT_EQ(rule("coordinates", on_ellipsoid, unchanged), Ruling::outside);
  EXPECT_EQ(rule("coordinates", in_triangle, unchanged), Ruling::held);
}

TEST(DetailsProperties, WhoRoundsTOnceRoundsTheCoordinatesOnceToo) {
  const Case one = read_case(in_triangle);
  Subject subject = broken::subject("triangle", [](const Case& asked) -> Answer {
    auto answer = std::get<RayAnswer>(broken::exactly(asked));
    answer.barycentric->y = std::nextafter(static_cast<float>(answer.barycentric->y), 2.0F);
    return answer;
  });
  const auto ruling = [&] {
    return find_property("coordinates")->rule(*std::make_unique<Trial>(subject, one));
  };
  subject.contract.holds = Claims{Claim::coordinates};
  EXPECT_EQ(ruling(), Ruling::held);
  subject.contract.holds = Claims{Claim::coordinates, Claim::rounded};
  EXPECT_EQ(ruling(), Ruling::broken);
}

TEST(DetailsProperties, APointOfTheObjectsSpaceIsOffRayAndSurface) {
  const auto unmapped = [](RayAnswer& answer) { answer.point->z /= 2; };
  EXPECT_EQ(rule("point", on_ellipsoid, unmapped), Ruling::broken);
  EXPECT_EQ(rule("point-on-surface", on_ellipsoid, unmapped), Ruling::broken);
}

TEST(DetailsProperties, APointOfTheSecondHitIsOnTheSurfaceButNotAtT) {
  const auto second = [](RayAnswer& answer) { answer.point->z = -answer.point->z; };
  EXPECT_EQ(rule("point", on_ellipsoid, second), Ruling::broken);
  EXPECT_EQ(rule("point-on-surface", on_ellipsoid, second), Ruling::held);
}

TEST(DetailsProperties, ANormalOnTheWrongSideLeftOutOrTooLongIsNoticed) {
  EXPECT_EQ(rule("normal", on_ellipsoid, [](RayAnswer& answer) { answer.normal = -*answer.normal; }),
            Ruling::broken);
  EXPECT_EQ(rule("normal", on_ellipsoid, [](RayAnswer& answer) { answer.normal.reset(); }), Ruling::broken);
  EXPECT_EQ(rule("normal", on_ellipsoid, [](RayAnswer& answer) { *answer.normal *= 1.00001; }),
            Ruling::broken);
}

/// A triangle walked round many times, the ray through its middle.
Case walked_round(int times, std::uint64_t seed) {
  Random random(seed);
  const auto vertex = [&] {
    return glm::dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  };
  const std::array corners{vertex(), vertex(), vertex()};
  Polygon<double> polygon;
  for (int k = 0; k < times; ++k)
    polygon.vertices.insert(polygon.vertices.end(), corners.begin(), corners.end());
  const glm::dvec3 origin = vertex(), middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const RayQuestion asked{.ray = {.origin = origin, .direction = middle - origin}, .shape = polygon};
  return {.precision = Precision::float64, .question = asked};
}

// By hand: the bound did not grow with the number of vertices where the normal does, too.
TEST(DetailsProperties, TheNormalOfAPolygonThatWindsManyTimesKeepsItsBound) {
  int held = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Case one = walked_round(301, seed);
    Trial trial(*find_subject("polygon/winding"), one);
    const Ruling ruling = find_property("normal")->rule(trial);
    EXPECT_NE(ruling, Ruling::broken) << seed;
    held += ruling == Ruling::held ? 1 : 0;
  }
  EXPECT_GE(held, 90) << "some may pass beside a sliver";
}

TEST(DetailsProperties, ANormalThatTheMapTookAlongInPlaceOfItsInverseIsNoticed) {
  const auto taken_along = [](RayAnswer& answer) {
    glm::dvec3 own = *answer.normal * glm::dvec3(1, 1, 2);  // the object's, but for its length
    own *= glm::dvec3(1, 1, 2);
    answer.normal = own / std::sqrt(own.x * own.x + own.y * own.y + own.z * own.z);
  };
  EXPECT_EQ(rule("normal", on_ellipsoid, taken_along), Ruling::broken);
}

TEST(DetailsProperties, CoordinatesOfAnotherVertexAreNoticed) {
  const auto turned = [](RayAnswer& answer) { std::swap(answer.barycentric->x, answer.barycentric->y); };
  EXPECT_EQ(rule("coordinates", in_triangle, turned), Ruling::broken);
}

TEST(DetailsProperties, ATouchMayGoUnsaidButNotBeInvented) {
  const auto crossing = [](RayAnswer& answer) { answer.contact = Contact::crossing; };
  const auto edge = [](RayAnswer& answer) { answer.contact = Contact::edge; };
  EXPECT_EQ(rule("touch", touching, unchanged), Ruling::held);
  EXPECT_EQ(rule("touch", touching, crossing), Ruling::broken);  // two hits of the line where there is one
  EXPECT_EQ(rule("touch", in_triangle, edge), Ruling::broken);
  EXPECT_EQ(rule("touch", on_ellipsoid, [](RayAnswer& answer) { answer.contact = Contact::tangent; }),
            Ruling::broken);
}

TEST(DetailsProperties, WhichOfItsPlacesAGuestRoundsAHitToIsJudgedWhereNothingIsRounded) {
  const auto rule_of_guest = [](const char* text) {
    Subject guest = broken::subject("triangle", [](const Case& asked) -> Answer {
      auto answer = std::get<RayAnswer>(broken::exactly(asked));
      answer.contact = answer.contact == Contact::edge ? Contact::vertex : Contact::edge;
      return answer;
    });
    guest.has_own_contract = false;
    const Case one = read_case(text);
    Trial trial(guest, one);
    return find_property("touch")->rule(trial);
  };
  // The vertex b, at 1/0.1 lengths of the direction, which no float holds.
  EXPECT_EQ(rule_of_guest(R"({"precision": "float64", "ray": {"origin": [0, 0, 1], "direction": [1, 0, -0.1]},
    "shape": {"type": "triangle", "a": [0, 0, 0], "b": [10, 0, 0], "c": [0, 1, 0]}})"),
            Ruling::held);
  EXPECT_EQ(rule_of_guest(R"({"precision": "float64", "ray": {"origin": [2, 0, 1], "direction": [0, 0, -1]},
    "shape": {"type": "triangle", "a": [0, 0, 0], "b": [4, 0, 0], "c": [0, 4, 0]}})"),
            Ruling::broken);
  // Far inside, at 1/0.1 lengths, no rounding makes an edge; beside an edge it may.
  EXPECT_EQ(
      rule_of_guest(R"({"precision": "float64", "ray": {"origin": [0.1, 0.1, 1], "direction": [0.3, 0, -0.1]},
    "shape": {"type": "triangle", "a": [0, 0, 0], "b": [10, 0, 0], "c": [0, 1, 0]}})"),
      Ruling::broken);
  EXPECT_EQ(rule_of_guest(
                R"({"precision": "float64", "ray": {"origin": [0.1, 1e-16, 1], "direction": [0.3, 0, -0.1]},
    "shape": {"type": "triangle", "a": [0, 0, 0], "b": [10, 0, 0], "c": [0, 1, 0]}})"),
            Ruling::held);
}

}  // namespace
}  // namespace rayproof
