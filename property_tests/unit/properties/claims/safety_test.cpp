#include <gtest/gtest.h>

#include "case/reader.hpp"
#include "subjects/default_contract.hpp"

#include "properties/property.hpp"
#include "properties/trial.hpp"

namespace rayproof {
namespace {

/// What is said of a hit at t by the rule that hits lie inside the interval.
Ruling ruling_of(const char* text, double t, bool is_own = false) {
  Subject subject;
  subject.topic = "plane";
  subject.contract = default_contract("plane");
  subject.has_own_contract = is_own;
  const Case one = read_case(text);
  RayAnswer given;
  given.hits.push_back(t);
  Trial trial(subject, one);
  trial.recall(given, judged(one, given));
  return find_property("ascending")->rule(trial);
}

/// The plane lies at t = t_min, 33.83979 as a float.
constexpr const char* float_from_there =
    R"({"precision": "float32", "ray": {"origin": [0,0,0], "direction": [0,0,1], "t_min": 33.83979}, "shape": {"type": "plane", "point": [0,0,33.83979], "normal": [0,0,1]}})";
constexpr const char* double_until_99 =
    R"({"ray": {"origin": [0,0,0], "direction": [0,0,1], "t_max": 99}, "shape": {"type": "plane", "point": [0,0,99], "normal": [0,0,1]}})";

TEST(HitsInsideTheInterval, MayBeFloatsWrittenWithNineDigits) {
  constexpr double nine_digits = 33.8397903;
  ASSERT_LT(nine_digits, double{33.83979F}) << "as a double it lies before the beginning";
  EXPECT_EQ(ruling_of(float_from_there, nine_digits), Ruling::held);
  EXPECT_EQ(ruling_of(float_from_there, 33.8397), Ruling::broken) << "too few digits";
}

TEST(HitsInsideTheInterval, MayLieBeyondItByAGuestsRoundingAlone) {
  EXPECT_EQ(ruling_of(double_until_99, 99), Ruling::held);
  EXPECT_EQ(ruling_of(double_until_99, std::nextafter(99.0, 100.0)), Ruling::held);
  EXPECT_EQ(ruling_of(double_until_99, 99.0000001), Ruling::broken) << "that of a float";
  EXPECT_EQ(ruling_of(double_until_99, -1e-300), Ruling::broken) << "0 is not rounded";
  EXPECT_EQ(ruling_of(double_until_99, std::nan("")), Ruling::broken);
}

TEST(HitsInsideTheInterval, AreNeverBeyondItByAMethodOfOurs) {
  EXPECT_EQ(ruling_of(double_until_99, 99, true), Ruling::held);
  EXPECT_EQ(ruling_of(double_until_99, std::nextafter(99.0, 100.0), true), Ruling::broken);
}

/// What is said of a guest that calls the triangle [0, 0, 0], [1, 1, 0], [2, 2, z] one without area.
Ruling ruling_of_no_area(double z) {
  Subject guest;
  guest.topic = "triangle";
  guest.contract = default_contract("triangle");
  guest.has_own_contract = false;
  const Case one{.question = RayQuestion{.ray = {{0, 0, 1}, {1, 0, 0}, 0, infinity<double>},
                                         .shape = Triangle<double>{{0, 0, 0}, {1, 1, 0}, {2, 2, z}}}};
  RayAnswer given;
  given.contact = Contact::degenerate;
  given.says_contact = true;
  Trial trial(guest, one);
  trial.recall(given, judged(one, given));
  return find_property("contact")->rule(trial);
}

TEST(ReasonsOfMisses, AreNoAreaWhereThatIsRoundedTo0) {
  EXPECT_EQ(ruling_of_no_area(0), Ruling::held);
  EXPECT_EQ(ruling_of_no_area(0x1p-51), Ruling::outside);
  EXPECT_EQ(ruling_of_no_area(0.25), Ruling::broken);
}

}  // namespace
}  // namespace rayproof
