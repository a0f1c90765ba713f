#pragma once
/// \file
/// VTK's button widgets over faces that the sheet shows, its slider widget for t, and the mouse beside all
/// widgets.

#include <vtkButtonWidget.h>
#include <vtkCoordinate.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkSmartPointer.h>
#include <vtkTexturedButtonRepresentation2D.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "viz/player/player.hpp"
#include "viz/vtk/window/slide_view.hpp"
#include "viz/vtk/window/stage_window.hpp"

namespace rayproof::viz {

/// VTK's trackball camera without its keys; a drawing in a plane is shifted where a scene in space is turned.
class OrbitStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static OrbitStyle* New() { VTK_STANDARD_NEW_BODY(OrbitStyle); }
  bool is_flat = false;

  void OnChar() override {}
  void Rotate() override { is_flat ? Pan() : vtkInteractorStyleTrackballCamera::Rotate(); }
  void Spin() override { is_flat ? Pan() : vtkInteractorStyleTrackballCamera::Spin(); }
};

/// A button stands for a key, so that whatever can be clicked can be typed.
struct Button {
  PixelBox box{};
  std::string text;
  std::string key;
  bool is_current = false;
  bool is_enabled = true;
};

/// Back, each step, forth, and at the right the other walkthroughs, reset, help and quit.
[[nodiscard]] std::vector<Button> buttons_of(const Player& player);
void draw_buttons(Picture& sheet, const std::vector<Button>& buttons);

/// Clear, for the face to be seen; of the box's proportions, which VTK keeps.
[[nodiscard]] inline vtkSmartPointer<vtkImageData> glass(const PixelBox& box) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(box.width), static_cast<int>(box.height), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  image->GetPointData()->GetScalars()->Fill(0);
  return image;
}

class Buttons {
 public:
  using Press = std::function<void(const std::string& key)>;
  /// The view must outlive it and have an interactor.
  Buttons(SlideView& view, Press press) : view_(view), press_(std::move(press)) {}

  /// Lets just these be clicked.
  void show(const std::vector<Button>& buttons) {
    shown_ = buttons;
    while (widgets_.size() < shown_.size()) make_one();
    for (std::size_t i = 0; i < widgets_.size(); ++i) {
      const bool is_on = i < shown_.size() && shown_[i].is_enabled;
      if (is_on) {
        const Point low = view_.to_window({shown_[i].box.left, shown_[i].box.bottom()});
        const Point high = view_.to_window({shown_[i].box.right(), shown_[i].box.top});
        const std::array<double, 6> bounds{low.x, high.x, low.y, high.y, 0, 0};
        if (placed_[i] != bounds) {
          placed_[i] = bounds;
          auto& face = *vtkTexturedButtonRepresentation2D::SafeDownCast(widgets_[i]->GetRepresentation());
          face.SetButtonTexture(0, glass(shown_[i].box));
          face.PlaceWidget(placed_[i].data());
        }
      }
      if (widgets_[i]->GetEnabled() != (is_on ? 1 : 0)) widgets_[i]->SetEnabled(is_on ? 1 : 0);
    }
  }

 private:
  void make_one() {
    vtkNew<vtkTexturedButtonRepresentation2D> face;
    face->SetNumberOfStates(1);
    face->SetPlaceFactor(1);
    vtkNew<vtkButtonWidget> widget;
    widget->SetInteractor(view_.window().GetInteractor());
    widget->SetDefaultRenderer(&view_.sheet());
    widget->SetRepresentation(face);
    widget->AddObserver(vtkCommand::StateChangedEvent, this, &Buttons::hear);
    widgets_.push_back(widget);
    placed_.emplace_back();
  }
  void hear(vtkObject* source, unsigned long /*pressed*/, void* /*nothing*/) {
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      if (widgets_[i] == source) return press_(std::string(shown_[i].key));
    }
  }

  SlideView& view_;
  Press press_;
  std::vector<vtkSmartPointer<vtkButtonWidget>> widgets_{};
  std::vector<std::array<double, 6>> placed_{};  ///< where each lies in the window
  std::vector<Button> shown_{};
};

/// Calls `move` with each t that the user chooses.
class TimeSlider {
 public:
  using Move = std::function<void(double t)>;
  /// The view must outlive it.
  TimeSlider(SlideView& view, Move move) : view_(view), move_(std::move(move)) {
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

  /// Lays it along `slider_track`, once the window has an interactor and whenever its size has changed.
  void fit() {
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
  void show(const Stage& shown, double t) {
    widget_->SetEnabled(shown.slider ? 1 : 0);
    if (!shown.slider) return;
    face_->SetMinimumValue(shown.slider->from);
    face_->SetMaximumValue(shown.slider->to);
    face_->SetValue(t);
  }
  void hide() { widget_->Off(); }

 private:
  void hear(vtkObject* /*slider*/, unsigned long /*moved*/, void* /*nothing*/) { move_(face_->GetValue()); }

  SlideView& view_;
  Move move_;
  vtkNew<vtkSliderRepresentation2D> face_;
  vtkNew<vtkSliderWidget> widget_;
};

}  // namespace rayproof::viz
