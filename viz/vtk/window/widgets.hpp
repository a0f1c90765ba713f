#pragma once
/// \file
/// A slide in a window of VTK's: the step in true space, over it a sheet with title, numbers and caption, and
/// VTK's widgets: buttons over faces that the sheet shows, handles on what of a case can be taken hold of, a
/// slider for t; and the mouse beside all of them.

#include <vtkButtonWidget.h>
#include <vtkHandleWidget.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkSmartPointer.h>
#include <vtkSphereHandleRepresentation.h>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viz/picture/picture.hpp"
#include "viz/player/player.hpp"
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

class Buttons {
 public:
  using Press = std::function<void(const std::string& key)>;
  /// The view must outlive it and have an interactor.
  Buttons(SlideView& view, Press press) : view_(view), press_(std::move(press)) {}

  /// Lets just these be clicked.
  void show(const std::vector<Button>& buttons);

 private:
  void make_one();
  void hear(vtkObject* source, unsigned long event, void* data);

  SlideView& view_;
  Press press_;
  std::vector<vtkSmartPointer<vtkButtonWidget>> widgets_{};
  std::vector<std::array<double, 6>> placed_{};  ///< where each lies in the window
  std::vector<Button> shown_{};
};

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
