#include "viz/vtk/window/time_slider.hpp"

#include <vtkCoordinate.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>

#include "viz/vtk/window/stage_window.hpp"

namespace rayproof::viz {

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
