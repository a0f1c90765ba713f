#pragma once
/// \file
/// VTK's slider widget for t.

#include <vtkNew.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>

#include <functional>

#include "viz/player/player.hpp"
#include "viz/vtk/slide_view.hpp"

namespace rayproof::viz {

/// Calls `move` with each t that the user chooses.
class TimeSlider {
 public:
  using Move = std::function<void(double t)>;
  /// The view must outlive it.
  TimeSlider(SlideView& view, Move move);

  /// Lays it along `slider_track`, once the window has an interactor and whenever its size has changed.
  void fit();
  /// Shows the player's t, if the step has one to choose.
  void show(const Stage& shown, double t);
  void hide() { widget_->Off(); }

 private:
  void hear(vtkObject* source, unsigned long event, void* data);

  SlideView& view_;
  Move move_;
  vtkNew<vtkSliderRepresentation2D> face_;
  vtkNew<vtkSliderWidget> widget_;
};

}  // namespace rayproof::viz
