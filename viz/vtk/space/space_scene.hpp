#pragma once
/// \file
/// A step of a stage in true space, as actors of VTK.

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "viz/picture/picture.hpp"
#include "viz/scene/space.hpp"
#include "viz/scene/stage.hpp"
#include "viz/vtk/space/geometry.hpp"

class vtkRenderWindow;

namespace rayproof::viz {

/// Lets a window sort translucent surfaces; to be called before it renders.
void prepare_for_space(vtkRenderWindow& window);

/// Whether surfaces behind one another are sorted pixel by pixel, and edges smoothed: slower by half.
void set_fine(vtkRenderer& renderer, bool is_fine);

/// What stays of where VTK's camera is: nothing, so that the step's own view just fits; the side from which
/// it looks; all of it.
enum class Look { anew, from_same_side, from_same_place };

/// Fills a renderer with a step's items: lines as tubes, surfaces translucent with their silhouettes, marks
/// as bodies, below them a floor with their shadows. Drawings in a plane are seen straight on, without
/// perspective and without a floor.
///
/// VTK's own numbers are floats: all coordinates are taken relative to the view, in units of its radius.
class SpaceScene {
 public:
  /// The renderer must outlive it; its viewport must be set already. Round things are made of this many
  /// sides (viz/vtk/space/geometry.hpp).
  SpaceScene(vtkRenderer& renderer, const Stage& stage, std::size_t step, Look look = Look::anew,
             int sides = fine_sides);

  /// Where an item is seen, in the pixels of a frame that the renderer's viewport fills; of a round surface
  /// the outline.
  [[nodiscard]] std::vector<Point> seen(const StageItem& item, const PixelBox& frame) const;
  [[nodiscard]] bool is_flat() const { return space_.camera.is_flat; }

 private:
  [[nodiscard]] bool is_fine() const { return sides_ == fine_sides; }
  void place_camera(Look look);
  /// A geometry in one colour; lines, marks, polygons and bodies with an inside differ by their kind.
  struct SpacePart {
    enum class Kind { line, mark, polygon, closed } kind;
    Role role;
    Geometry geometry;
    double opacity = 1;
    double specular = 0;
    glm::dvec3 shift{0, 0, 0};  ///< of what is seen, not of its shadow
  };
  /// As one those that look alike.
  [[nodiscard]] static std::vector<SpacePart> merged(const std::vector<SpacePart>& parts);
  void add_mark(const SpaceBody& body);
  void add_surface(const SpaceBody& body);
  void add_actor(const SpacePart& part);
  void add_floor();
  /// Draws the surfaces over all else, without VTK's pass for translucent ones, which takes a third of the
  /// time.
  void blend_films();

  vtkRenderer& renderer_;
  Space space_;
  int sides_;
  std::vector<SpacePart> parts_{};
  std::vector<vtkSmartPointer<vtkActor>> films_{};   ///< the surfaces
  std::vector<vtkSmartPointer<vtkActor>> closed_{};  ///< those of them that have an inside
};

}  // namespace rayproof::viz
