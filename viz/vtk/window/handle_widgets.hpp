#pragma once
/// \file
/// VTK's handle widgets on what of a case can be taken hold of.

#include <vtkHandleWidget.h>
#include <vtkInteractorObserver.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>
#include <vtkSphereHandleRepresentation.h>

#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "viz/player/player.hpp"
#include "viz/vtk/window/slide_view.hpp"

namespace rayproof::viz {

inline constexpr double ball_size = 12;  ///< the diameter, in the slide's pixels

/// The place of the view that is seen `right` and `up` of another, as far from the eye.
[[nodiscard]] inline glm::dvec3 beside(vtkRenderer& renderer, const glm::dvec3& p, double right, double up) {
  double seen[3];
  double place[4];
  vtkInteractorObserver::ComputeWorldToDisplay(&renderer, p.x, p.y, p.z, seen);
  vtkInteractorObserver::ComputeDisplayToWorld(&renderer, seen[0] + right, seen[1] + up, seen[2], place);
  return {place[0], place[1], place[2]};
}

/// A ball on each handle of the player's step; a drag moves it in the plane parallel to the screen, with
/// Shift along an axis of the world, and the player makes the stage again.
class HandleWidgets {
 public:
  /// Both must outlive it; the view must have an interactor.
  HandleWidgets(SlideView& view, Player& player) : view_(view), player_(player) {}

  /// Puts the balls where the player's handles are; what is held stays at the pointer. `shown` is what the
  /// player shows.
  void show(const Stage& shown) {
    shown_ = shown.steps[player_.step()].view;
    std::set<std::string> names;
    for (const Handle& handle : player_.handles()) {
      names.insert(handle.name);
      Ball& ball = balls_[handle.name];
      if (!ball) ball = make_ball();
      if (ball->GetEnabled() == 0) ball->On();
      auto& face = *vtkSphereHandleRepresentation::SafeDownCast(ball->GetRepresentation());
      const bool is_focused = handle.name == player_.focused_handle();
      set_colour(*face.GetProperty(), colour_of(is_focused ? Role::claimed : Role::frame));
      face.SetHandleSize(ball_size * view_.scale());
      if (is_focused && player_.is_held()) continue;
      glm::dvec3 at = in_view(shown_, handle.at);
      face.SetWorldPosition(&at.x);
    }
    for (auto& [name, ball] : balls_) {
      const bool is_held = player_.is_held() && name == player_.focused_handle();
      if (!names.contains(name) && !is_held && ball->GetEnabled() != 0) ball->Off();
    }
  }
  /// Lets the player follow what was moved since: once a frame, however many events there were.
  void follow() {
    if (!is_moved_) return;
    is_moved_ = false;
    const auto held = balls_.find(player_.focused_handle());
    if (held == balls_.end()) return;
    glm::dvec3 p;
    face_of(held->second).GetWorldPosition(&p.x);
    player_.drag_to(in_world(p), pixel_at(p));
  }
  void hide() {
    for (auto& [name, ball] : balls_) ball->Off();
  }
  /// Moves the handle that has the focus, in the window's pixels.
  void nudge(double right, double up) {
    const std::string name = player_.focused_handle();
    const auto found = balls_.find(name);
    if (found == balls_.end()) return;
    glm::dvec3 p;
    face_of(found->second).GetWorldPosition(&p.x);
    const double resolution = pixel_at(p);
    player_.grasp(name);
    player_.drag_to(in_world(beside(view_.front(), p, right, up)), resolution);
    player_.release();
  }
  /// Where a handle is seen, in the window's pixels, y up; nothing where it is not shown.
  [[nodiscard]] std::optional<Point> seen(const std::string& handle) const {
    const auto found = balls_.find(handle);
    if (found == balls_.end() || found->second->GetEnabled() == 0) return std::nullopt;
    double at[3];
    face_of(found->second).GetDisplayPosition(at);
    return Point{at[0], at[1]};
  }

 private:
  using Ball = vtkSmartPointer<vtkHandleWidget>;
  Ball make_ball() {
    vtkNew<vtkSphereHandleRepresentation> face;
    face->GetSelectedProperty()->SetAmbient(0.3);
    set_colour(*face->GetSelectedProperty(), colour_of(Role::claimed));
    auto ball = Ball::New();
    ball->SetInteractor(view_.window().GetInteractor());
    ball->SetDefaultRenderer(&view_.front());
    ball->SetRepresentation(face);
    ball->AllowHandleResizeOff();
    for (const unsigned long event :
         {vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent})
      ball->AddObserver(event, this, &HandleWidgets::hear);
    return ball;
  }
  void hear(vtkObject* source, unsigned long event, void* /*nothing*/) {
    if (event == vtkCommand::InteractionEvent) is_moved_ = true;
    if (event == vtkCommand::EndInteractionEvent) {
      follow();
      player_.release();
    }
    if (event != vtkCommand::StartInteractionEvent) return;
    for (const auto& [name, ball] : balls_)
      if (ball == source) player_.grasp(name);
  }
  [[nodiscard]] static vtkHandleRepresentation& face_of(const Ball& ball) {
    return *ball->GetHandleRepresentation();
  }
  [[nodiscard]] glm::dvec3 in_world(const glm::dvec3& p) const { return shown_.centre + shown_.radius * p; }
  /// How long in the world a pixel of the window is at a place of the view.
  [[nodiscard]] double pixel_at(const glm::dvec3& p) const {
    return shown_.radius * glm::length(beside(view_.front(), p, 1, 0) - p);
  }

  SlideView& view_;
  Player& player_;
  StageView shown_{};
  bool is_moved_ = false;
  std::map<std::string, Ball> balls_{};
};

}  // namespace rayproof::viz
