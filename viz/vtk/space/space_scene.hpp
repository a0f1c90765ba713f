#pragma once
/// \file
/// A step of a stage in true space, as actors of VTK.

#include <vtkRenderer.h>

#include <glm/vec3.hpp>
#include <vector>

#include "viz/picture.hpp"
#include "viz/stage/shown_items.hpp"
#include "viz/stage/stage.hpp"

namespace rayproof::viz {

/// Fills a renderer with a step's items: lines as tubes, surfaces translucent with their silhouettes, marks
/// as bodies, below them a floor with their shadows. Drawings in a plane are seen straight on, without
/// perspective and without a floor.
///
/// VTK's own numbers are floats: all coordinates are taken relative to the view, in units of its radius.
class SpaceScene {
 public:
  /// The renderer must outlive it. Its viewport must be set already, `width` by `height` pixels in size.
  SpaceScene(vtkRenderer& renderer, const Stage& stage, std::size_t step);

  /// Where an item is seen, in the pixels of a frame that the renderer's viewport fills.
  [[nodiscard]] std::vector<Point> seen(const StageItem& item, const PixelBox& frame) const;

 private:
  [[nodiscard]] glm::dvec3 placed(const glm::dvec3& p) const;
  [[nodiscard]] std::vector<glm::dvec3> placed(const StageItem& item) const;
  void set_camera(const Stage& stage, const std::vector<ShownItem>& shown);
  /// The points that the stage's own view shows, and of round things the outline as it is seen from the other
  /// camera.
  [[nodiscard]] std::vector<glm::dvec3> points_in_view(const StageCamera& chosen, const StageCamera& turned,
                                                       const std::vector<ShownItem>& shown) const;
  void add(const ShownItem& shown);
  void add_floor();
  void add_surface(const ShownItem& shown, const std::vector<glm::dvec3>& points);

  vtkRenderer& renderer_;
  StageView view_;
  bool is_flat_;
  glm::dvec3 toward_{};  ///< from the scene to the eye, a unit vector
  glm::dvec3 up_{};      ///< the axis of the world that points up
  double distance_ = 1;  ///< of the eye from the middle of what is seen
  glm::dvec3 eye_{};
};

}  // namespace rayproof::viz
