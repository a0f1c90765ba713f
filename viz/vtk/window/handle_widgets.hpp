#pragma once
/// \file
/// VTK's handle widgets on what of a case can be taken hold of.

#include <vtkHandleWidget.h>
#include <vtkSmartPointer.h>
#include <vtkSphereHandleRepresentation.h>

#include <map>
#include <optional>
#include <string>

#include "viz/player/player.hpp"
#include "viz/vtk/slide_view.hpp"

namespace rayproof::viz {

/// A ball on each handle of the player's step; a drag moves it in the plane parallel to the screen, with
/// Shift along an axis of the world, and the player makes the stage again.
class HandleWidgets {
 public:
  /// Both must outlive it; the view must have an interactor.
  HandleWidgets(SlideView& view, Player& player) : view_(view), player_(player) {}

  /// Puts the balls where the player's handles are; what is held stays at the pointer. `shown` is what the
  /// player shows.
  void show(const Stage& shown);
  /// Lets the player follow what was moved since: once a frame, however many events there were.
  void follow();
  void hide();
  /// Moves the handle that has the focus, in the window's pixels.
  void nudge(double right, double up);
  /// Where a handle is seen, in the window's pixels, y up; nothing where it is not shown.
  [[nodiscard]] std::optional<Point> seen(const std::string& handle) const;

 private:
  using Ball = vtkSmartPointer<vtkHandleWidget>;
  Ball make_ball();
  void hear(vtkObject* source, unsigned long event, void* data);
  [[nodiscard]] static vtkHandleRepresentation& face_of(const Ball& ball) {
    return *ball->GetHandleRepresentation();
  }
  [[nodiscard]] glm::dvec3 in_world(const glm::dvec3& p) const;
  /// How long in the world a pixel of the window is at a place of the view.
  [[nodiscard]] double pixel_at(const glm::dvec3& p) const;

  SlideView& view_;
  Player& player_;
  StageView shown_{};
  bool is_moved_ = false;
  std::map<std::string, Ball> balls_{};
};

}  // namespace rayproof::viz
