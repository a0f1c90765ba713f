#include "viz/vtk/window/widgets.hpp"

#include <vtkCoordinate.h>
#include <vtkInteractorObserver.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "viz/vtk/space/geometry.hpp"
#include "viz/vtk/window/stage_window.hpp"

namespace rayproof::viz {
namespace {

constexpr double ball_size = 12;  ///< the diameter, in the slide's pixels

/// The place of the view that is seen `right` and `up` of another, as far from the eye.
glm::dvec3 beside(vtkRenderer& renderer, const glm::dvec3& p, double right, double up) {
  double seen[3];
  double place[4];
  vtkInteractorObserver::ComputeWorldToDisplay(&renderer, p.x, p.y, p.z, seen);
  vtkInteractorObserver::ComputeDisplayToWorld(&renderer, seen[0] + right, seen[1] + up, seen[2], place);
  return {place[0], place[1], place[2]};
}

}  // namespace

HandleWidgets::Ball HandleWidgets::make_ball() {
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

glm::dvec3 HandleWidgets::in_world(const glm::dvec3& p) const { return shown_.centre + shown_.radius * p; }

double HandleWidgets::pixel_at(const glm::dvec3& p) const {
  return shown_.radius * glm::length(beside(view_.front(), p, 1, 0) - p);
}

void HandleWidgets::hear(vtkObject* source, unsigned long event, void* /*nothing*/) {
  if (event == vtkCommand::InteractionEvent) is_moved_ = true;
  if (event == vtkCommand::EndInteractionEvent) {
    follow();
    player_.release();
  }
  if (event != vtkCommand::StartInteractionEvent) return;
  for (const auto& [name, ball] : balls_)
    if (ball == source) player_.grasp(name);
}

void HandleWidgets::follow() {
  if (!is_moved_) return;
  is_moved_ = false;
  const auto held = balls_.find(player_.focused_handle());
  if (held == balls_.end()) return;
  glm::dvec3 p;
  face_of(held->second).GetWorldPosition(&p.x);
  player_.drag_to(in_world(p), pixel_at(p));
}

void HandleWidgets::nudge(double right, double up) {
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

void HandleWidgets::show(const Stage& shown) {
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

void HandleWidgets::hide() {
  for (auto& [name, ball] : balls_) ball->Off();
}

std::optional<Point> HandleWidgets::seen(const std::string& handle) const {
  const auto found = balls_.find(handle);
  if (found == balls_.end() || found->second->GetEnabled() == 0) return std::nullopt;
  double at[3];
  face_of(found->second).GetDisplayPosition(at);
  return Point{at[0], at[1]};
}

TimeSlider::TimeSlider(SlideView& view, Move move) : view_(view), move_(std::move(move)) {
  face_->ShowSliderLabelOff();
  face_->SetSliderLength(0.008);
  face_->SetSliderWidth(0.03);
  face_->SetTubeWidth(0.005);
  face_->SetEndCapLength(0);
  for (vtkProperty2D* const part : {face_->GetSliderProperty(), face_->GetSelectedProperty(),
                                    face_->GetTubeProperty(), face_->GetCapProperty()})
    part->SetColor(0.72, 0.745, 0.776);
  face_->GetSliderProperty()->SetColor(0.086, 0.094, 0.11);
  face_->GetSelectedProperty()->SetColor(0.72, 0.29, 0);
  widget_->SetDefaultRenderer(&view_.sheet());
  widget_->SetRepresentation(face_);
  widget_->SetAnimationModeToJump();
  widget_->AddObserver(vtkCommand::InteractionEvent, this, &TimeSlider::hear);
}

void TimeSlider::hear(vtkObject* /*slider*/, unsigned long /*moved*/, void* /*nothing*/) {
  move_(face_->GetValue());
}

void TimeSlider::fit() {
  widget_->SetInteractor(view_.window().GetInteractor());
  const int* const size = view_.window().GetSize();
  const auto put = [&](vtkCoordinate& end, double x) {
    const Point p = view_.to_window({x, slider_track.centre().y});
    end.SetCoordinateSystemToNormalizedDisplay();
    end.SetValue(p.x / size[0], p.y / size[1]);
  };
  put(*face_->GetPoint1Coordinate(), slider_track.left);
  put(*face_->GetPoint2Coordinate(), slider_track.right());
}

void TimeSlider::show(const Stage& shown, double t) {
  widget_->SetEnabled(shown.slider ? 1 : 0);
  if (!shown.slider) return;
  face_->SetMinimumValue(shown.slider->from);
  face_->SetMaximumValue(shown.slider->to);
  face_->SetValue(t);
}

}  // namespace rayproof::viz
