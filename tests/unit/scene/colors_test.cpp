#include "scene/colors.hpp"

#include <gtest/gtest.h>

namespace lamina::scene {
namespace {

using number::Rational;

TEST(ColorTest, KnowsTheNamesOfCss) {
  EXPECT_EQ(color_of_name("red"), (Color{1, 0, 0, 1}));
  EXPECT_EQ(color_of_name("AliceBlue"), (Color{Rational(240) / 255, Rational(248) / 255, 1, 1}));
  EXPECT_EQ(color_of_name("yellowgreen"),
            (Color{Rational(154) / 255, Rational(205) / 255, Rational(50) / 255, 1}));
}

TEST(ColorTest, ReadsHexadecimalDigits) {
  EXPECT_EQ(color_of_name("#f00"), (Color{1, 0, 0, 1}));
  EXPECT_EQ(color_of_name("#F000"), (Color{1, 0, 0, 0}));
  EXPECT_EQ(color_of_name("#336699"),
            (Color{Rational(1) / 5, Rational(2) / 5, Rational(3) / 5, 1}));
  EXPECT_EQ(color_of_name("#33669900"),
            (Color{Rational(1) / 5, Rational(2) / 5, Rational(3) / 5, 0}));
}

TEST(ColorTest, RefusesOtherNames) {
  for (const char* name :
       {"", "#", "#ff", "#fffff", "#ggg", "#1234567", "#123456789", "reddish", "zzz", "a"}) {
    EXPECT_FALSE(color_of_name(name)) << name;
  }
}

TEST(ColorTest, EqualColoursHaveEqualTexts) {
  EXPECT_EQ(canonical_text(*color_of_name("red")), "[1, 0, 0, 1]");
  EXPECT_EQ(canonical_text({Rational(1) / 2, Rational(1) / 3, 0, 1}), "[0.5, 1/3, 0, 1]");
}

}  // namespace
}  // namespace lamina::scene
