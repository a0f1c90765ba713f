#include <gtest/gtest.h>

#include "viz/picture/picture.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

TEST(Sentences, EndAtAFullStopAndASpace) {
  const std::vector<std::string> two{"t = 1.5 is a number.", "D is another."};
  EXPECT_EQ(sentences_of("t = 1.5 is a number. D is another."), two);
  EXPECT_EQ(sentences_of("no end"), std::vector<std::string>{"no end"});
  EXPECT_TRUE(sentences_of("").empty());
}

TEST(Sentences, SpeakOfWholeNamesAlone) {
  EXPECT_TRUE(mentions("D is a volume.", "D"));
  EXPECT_TRUE(mentions("it is D.", "D"));
  EXPECT_FALSE(mentions("D_t is a volume.", "D"));
  EXPECT_TRUE(mentions("√D is half the chord.", "√D"));
  EXPECT_TRUE(mentions("n·(p - o) is a distance.", "n·(p - o)"));
  EXPECT_FALSE(mentions("half a chord", "a"));
}

TEST(Sentences, AreTypesetWithMinusSigns) {
  EXPECT_EQ(typeset("n·(p - o) = -3.5"), "n·(p − o) = −3.5");
  EXPECT_EQ(typeset("-b/a and 4·-c, |-∞| at (-1, -2)"), "−b/a and 4·−c, |−∞| at (−1, −2)");
  for (const char* const word : {"half-open", "1e-4 along n", "--html", "a- b", "-"})
    EXPECT_EQ(typeset(word), word);
}

TEST(Sentences, CountLettersAndNotBytes) {
  EXPECT_EQ(letters_of("√D = ∞"), 6U);
  EXPECT_EQ(letters_of("d\u20d7"), 2U);
}

}  // namespace
}  // namespace rayproof::viz
