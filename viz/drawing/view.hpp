#pragma once
/// \file
/// A window on a plane scene: from world lengths of any size to pixels, with everything clipped to its frame.

#include <string>
#include <vector>

#include "viz/picture/picture.hpp"
#include "viz/trace/shadow.hpp"

namespace rayproof::viz {

/// Two things nearer to each other than this, in pixels, can't be distinguished.
inline constexpr double visible_gap = 24;

/// A point of the scene. Shadow numbers, since a picture may look at 1e-30 of a length of 1e30.
struct WorldPoint {
  Shadow x, y;
};

/// A frame in the picture, the world point at its middle, and pixels per unit along x and y (which differ
/// where a sliver is stretched to be seen). World y points up.
struct View {
  PixelBox frame{};
  WorldPoint centre{};
  Shadow scale_x = 1;
  Shadow scale_y = 1;

  /// In pixels; far outside the frame, only the direction from its middle is right.
  [[nodiscard]] Point to_pixels(const WorldPoint& p) const;
  [[nodiscard]] bool shows(const WorldPoint& p) const;
  [[nodiscard]] Shadow half_width() const { return frame.width / 2 / scale_x; }
  [[nodiscard]] Shadow half_height() const { return frame.height / 2 / scale_y; }
  /// Looks at `centre` with half the frame's width and height being at least the given lengths, unstretched.
  [[nodiscard]] static View around(const PixelBox& frame, const WorldPoint& centre, const Shadow& half_width,
                                   const Shadow& half_height);
};

/// Adds what lies inside the view's frame.
void draw_curve(Picture& picture, const View& view, PixelLine line, const std::vector<WorldPoint>& points);
void draw_area(Picture& picture, const View& view, Role role, const std::vector<WorldPoint>& points);
void draw_mark(Picture& picture, const View& view, Role role, MarkShape shape, const WorldPoint& at);
/// The frame with its caption above it.
void draw_frame(Picture& picture, const PixelBox& frame, const std::string& caption);
/// A bar of 1, 2 or 5 times a power of ten in the frame's lower corner, and one across where the view is
/// stretched.
void draw_scale_bars(Picture& picture, const View& view);

/// The outline of the circle, dense where the view looks.
[[nodiscard]] std::vector<WorldPoint> circle_outline(const View& view, const WorldPoint& centre,
                                                     const Shadow& radius);

}  // namespace rayproof::viz
