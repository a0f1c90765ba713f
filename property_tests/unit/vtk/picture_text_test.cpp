/// \file
/// Text as VTK paints it.

#include <gtest/gtest.h>

#include <algorithm>

#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"

namespace rayproof::viz {
namespace {

Picture picture_of(const Text& text) {
  Picture picture;
  picture.width = 200;
  picture.height = 60;
  picture.elements = {text};
  return picture;
}

Text bold(const std::string& letters, Role role) {
  return {role, {20, 40}, letters, Anchor::start, 23, true};
}

/// Of each pixel, whether it is not quite white.
std::vector<bool> ink_of(const Raster& raster) {
  std::vector<bool> ink;
  for (const Rgb& pixel : raster.pixels) ink.push_back(pixel[0] < 250 || pixel[1] < 250 || pixel[2] < 250);
  return ink;
}

long ink_in_rows(const Raster& raster, int from, int to) {
  const std::vector<bool> ink = ink_of(raster);
  return std::count(ink.begin() + from * raster.width, ink.begin() + to * raster.width, true);
}

TEST(PictureText, KeepsItsFontHoweverManyFontsWereDrawnBefore) {
  const OffscreenDisplay display;
  Picture first = picture_of(bold("n", Role::edge));
  first.elements.emplace_back(Text{Role::text, {20, 40}, "n"});
  (void)PictureCanvas().draw(first);
  Picture many = picture_of({});
  for (int i = 0; i < 60; ++i)
    many.elements.emplace_back(Text{Role::muted, {20, 40}, "m", Anchor::start, 8.0 + i});
  (void)PictureCanvas().draw(many);
  const Raster late = PictureCanvas().draw(picture_of(bold("nm", Role::edge)));
  const Raster fresh = PictureCanvas().draw(picture_of(bold("nm", Role::claimed)));
  EXPECT_EQ(ink_of(late), ink_of(fresh));
}

TEST(PictureText, DrawsHatsAboveLettersThatStayAsTheyAre) {
  const OffscreenDisplay display;
  PictureCanvas canvas;
  const Raster plain = canvas.draw(picture_of(bold("n·d = 1", Role::text)));
  const Raster accented = canvas.draw(picture_of(bold("n·d\u0302 = 1", Role::text)));
  constexpr int top_of_d = png_scale * 22;
  EXPECT_EQ(ink_in_rows(plain, 0, top_of_d), 0);
  EXPECT_GT(ink_in_rows(accented, 0, top_of_d), 20);
  EXPECT_EQ(ink_in_rows(accented, top_of_d, plain.height), ink_in_rows(plain, top_of_d, plain.height));
}

}  // namespace
}  // namespace rayproof::viz
