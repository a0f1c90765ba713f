#pragma once
/// \file
/// Which way the axes of a scene point.

#include <vtkNew.h>
#include <vtkRenderer.h>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {

/// The place of the axes in a scene's frame: no label may stand there.
[[nodiscard]] inline PixelBox triad_place(const PixelBox& frame) {
  const double size = 0.25 * frame.height;
  return {frame.left, frame.bottom() - size, size, size};
}

/// VTK's own arrows x, y and z, seen as a renderer's camera sees its scene.
class Triad {
 public:
  Triad();
  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  /// As they are seen in `space`, or not at all.
  void show(vtkRenderer& space, bool is_shown);

 private:
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace rayproof::viz
