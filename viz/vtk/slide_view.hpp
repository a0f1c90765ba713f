#pragma once
/// \file
/// A slide in a window of VTK's: the step in true space, and over it a sheet with title, numbers and caption.

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include <array>

#include "viz/picture/picture.hpp"
#include "viz/scene/stage.hpp"
#include "viz/vtk/space/space_scene.hpp"

class vtkContextActor;

namespace rayproof::viz {

class PictureItem;

/// The slide is as large as the window allows, in its middle, its proportions kept.
class SlideView {
 public:
  /// `scene` is the scene's frame in a slide of slide_width by slide_height.
  explicit SlideView(const PixelBox& scene);
  ~SlideView();
  SlideView(const SlideView&) = delete;
  SlideView& operator=(const SlideView&) = delete;

  /// Puts the layers where the window's size has them.
  void fit();
  /// Fills the layers: the step, and the sheet with the step's labels put into it. Nothing is rendered yet.
  SpaceScene show(const Stage& stage, std::size_t step, const Picture& sheet, Look look);
  /// Fills the sheet alone; the space is empty.
  void show(const Picture& sheet);
  /// Whether surfaces behind one another are sorted pixel by pixel, edges smoothed, round things made of
  /// many sides, lit pixel by pixel, each a body of its own, and labels have halos: twice the work. From the
  /// next `show` on.
  void set_fine(bool is_fine);

  [[nodiscard]] vtkRenderWindow& window() { return *window_; }
  [[nodiscard]] vtkRenderer& space() { return *space_; }
  /// Before the space, with its camera: for what can be taken hold of.
  [[nodiscard]] vtkRenderer& front() { return *front_; }
  [[nodiscard]] vtkRenderer& sheet() { return *sheet_; }
  /// Pixels of the window for each of the slide's.
  [[nodiscard]] double scale() const;
  /// From the slide's pixels to the window's, whose y points up, as VTK's events have them.
  [[nodiscard]] Point to_window(const Point& p) const;

 private:
  PixelBox scene_;
  Picture picture_{};
  bool is_fine_ = true;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> backdrop_, space_, front_, sheet_;
  /// Each paints a part of the picture: VTK keeps 50 texts for each, and the next frame needs them again.
  std::array<vtkNew<PictureItem>, 4> items_;
};

}  // namespace rayproof::viz
