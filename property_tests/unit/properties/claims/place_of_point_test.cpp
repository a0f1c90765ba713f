#include "properties/claims/place_of_point.hpp"

#include <gtest/gtest.h>

#include "case/reader.hpp"
#include "subjects/default_contract.hpp"

namespace rayproof {
namespace {

/// What is said of a guest's hit that is given by this point and no t.
double excess_of(const char* text, const glm::dvec3& point) {
  Subject guest;
  guest.topic = "sphere";
  guest.contract = default_contract("sphere");
  guest.has_own_contract = false;
  const Case one = read_case(text);
  RayAnswer given{.verdict_only = true, .point = point};
  given.hits.push_back(std::nan(""));
  const Answer answer = completed(guest, one, given);
  Trial trial(guest, one);
  trial.recall(answer, judged(one, answer));
  return excess_of_place(trial);
}

constexpr const char* from_outside =
    R"({"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";
constexpr const char* from_inside =
    R"({"ray": {"origin": [0,0,0], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})";

TEST(PlaceOfPoint, IsThatOfTheNearestHitHoweverItIsRounded) {
  EXPECT_EQ(excess_of(from_outside, {0, 0, -1}), 0);
  EXPECT_EQ(excess_of(from_outside, {0, 1e-7, -1.0000001}), 0);
  EXPECT_EQ(excess_of(from_inside, {0, 0, 1}), 0);
}

TEST(PlaceOfPoint, IsWrongAtTheFarHitAndBehindTheBeginning) {
  EXPECT_GT(excess_of(from_outside, {0, 0, 1}), 1);
  EXPECT_GT(excess_of(from_inside, {0, 0, -1}), 1);
}

TEST(PlaceOfPoint, MayBeTheOtherHitWhereRoundingDecides) {
  EXPECT_LE(
      excess_of(
          R"({"ray": {"origin": [0,0,-1], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}})",
          {0, 0, 1}),
      1)
      << "the first hit lies on the interval's beginning";
  EXPECT_LE(
      excess_of(
          R"({"ray": {"origin": [0,1,-1e-7], "direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1.00000000000001}})",
          {0, 1, -1.4e-7}),
      1)
      << "just before the interval";
}

}  // namespace
}  // namespace rayproof
