#include <gtest/gtest.h>

#include <rayproof/method/narration.hpp>
#include <type_traits>

namespace rayproof {
namespace {

template <class T>
concept TakesATitleAlone = requires {
  step<T>("Find the nearest point");
};
template <class T>
concept TakesAnEmptyMeaning = requires {
  step<T>("Find the nearest point", "");
};
template <class T>
concept TakesAMeaning = requires {
  step<T>("Find the nearest point", "It is the middle of the chord.");
};

TEST(Narration, AStepThatDoesNotSayWhatItMeansDoesNotCompile) {
  EXPECT_TRUE(TakesAMeaning<float>);
  EXPECT_FALSE(TakesATitleAlone<float>);
  EXPECT_FALSE(TakesAnEmptyMeaning<float>);
  EXPECT_FALSE((std::is_constructible_v<Step, const char*>));
  EXPECT_FALSE((std::is_constructible_v<Step, const char*, const char(&)[1]>));
}

}  // namespace
}  // namespace rayproof
