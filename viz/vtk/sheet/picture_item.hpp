#pragma once
/// \file
/// A picture as an item of a VTK scene.

#include <vtkContextItem.h>

#include "viz/picture/picture.hpp"

namespace rayproof::viz {

/// Paints `picture`, which must outlive it, in its light colours with VTK's two-dimensional painter. Its
/// lower left corner lies at (left, bottom) of the scene, `scale` pixels stand for each of the picture's.
class PictureItem : public vtkContextItem {
 public:
  static PictureItem* New();

  const Picture* picture = nullptr;
  double scale = 1;
  double left = 0;
  double bottom = 0;
  /// Of as many parts of the picture's elements, the one to paint.
  std::size_t part = 0;
  std::size_t parts = 1;

  bool Paint(vtkContext2D* context) override;
};

}  // namespace rayproof::viz
