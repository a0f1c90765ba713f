/// \file
/// Whether the colours of labels differ enough from what is behind them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "viz/picture/picture.hpp"
#include "viz/picture/raster.hpp"
#include "viz/scene/shown_items.hpp"

namespace rayproof::viz {
namespace {

double luminance(const Rgb& colour) {
  const auto linear = [](std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
}

double contrast(const Rgb& a, const Rgb& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// Labels bear a halo of the background's colour, whatever is behind them.
TEST(LabelColours, EveryRoleThatALabelMayHaveContrastsWithItsHalo) {
  const RoleColour& background = colour_of(Role::background);
  for (const Role role : {Role::text, Role::muted, Role::surface, Role::ray, Role::exact, Role::claimed,
                          Role::nearest, Role::normal, Role::edge}) {
    EXPECT_GE(contrast(rgb_of(colour_of(role).light), rgb_of(background.light)), 4.5) << colour_of(role).name;
    EXPECT_GE(contrast(rgb_of(colour_of(role).dark), rgb_of(background.dark)), 4.5) << colour_of(role).name;
  }
}

/// What is seen where a surface of this opacity stands before a background.
Rgb tinted(const char* surface, double opacity, const char* background) {
  Rgb mixed;
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = static_cast<std::uint8_t>(
        std::lround(opacity * rgb_of(surface)[i] + (1 - opacity) * rgb_of(background)[i]));
  return mixed;
}

/// Without the halo, too: labels are large letters (24 pixels of a slide), for which WCAG 2.1 asks 3:1.
TEST(LabelColours, EveryRoleThatALabelMayHaveContrastsWithASurfaceBehindIt) {
  const RoleColour& surface = colour_of(Role::surface);
  const double two_sides = 1 - (1 - 0.2) * (1 - 0.2);
  for (const double opacity : {0.2, 0.36, two_sides}) {
    for (const RoleColour& behind :
         {colour_of(Role::background), floor_colours.ground, floor_colours.shadow}) {
      const Rgb light = tinted(surface.light, opacity, behind.light);
      const Rgb dark = tinted(surface.dark, opacity, behind.dark);
      for (const Role role : {Role::text, Role::muted, Role::ray, Role::exact, Role::claimed, Role::nearest,
                              Role::normal, Role::edge}) {
        EXPECT_GE(contrast(rgb_of(colour_of(role).light), light), 3) << colour_of(role).name << opacity;
        EXPECT_GE(contrast(rgb_of(colour_of(role).dark), dark), 3) << colour_of(role).name << opacity;
      }
    }
  }
}

TEST(LabelColours, NoLabelHasTheColourOfASurface) {
  const StageItem item{Role::surface, Form::point, {{0, 0, 0}}, "C"};
  EXPECT_EQ(label_role({&item, Emphasis::scene}), Role::edge);
  EXPECT_EQ(label_role({&item, Emphasis::dimmed}), Role::muted);
}

}  // namespace
}  // namespace rayproof::viz
