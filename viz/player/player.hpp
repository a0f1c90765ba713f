#pragma once
/// \file
/// The interactive walkthrough as data and events: what a window shows, and what keys and the mouse do to it.
///
///     Player player({{stage, [&](const Case& one) { return stage_of(report_on(one)); }}});
///     player.press_key("Right");              // the next step
///     player.press({300, 239});               // the left button, in the picture's pixels
///     player.drag_to({320, 239});
///     player.release();
///     const Picture picture = player.picture();

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viz/player/player_layout.hpp"
#include "viz/player/ray_handles.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// A stage, and how to make it again of another case.
struct Play {
  Stage stage;
  /// May throw: then the case is refused, and the player says why.
  std::function<Stage(const Case&)> again;
};

/// What a key or a button asks of the window.
enum class Request { none, quit, print_case, save_picture };

/// What the arrow keys move; Tab goes on to the next.
enum class Focus { steps, slider, view, origin, tip };

/// One walkthrough of several on show.
class Player {
 public:
  /// At least one play, each with at least one step.
  explicit Player(std::vector<Play> plays);

  /// A key by its X name: "Right", "Home", "h", "comma", "3". Keys that mean nothing do nothing.
  Request press_key(const std::string& key, bool is_shifted = false);
  /// The left button goes down, at a place in the picture's pixels.
  Request press(const Point& at);
  void drag_to(const Point& at);
  void release();
  /// The wheel over the scene: nearer where positive.
  void turn_wheel(int notches);
  /// Puts the slider there, or as near as its range and the precision allow.
  void set_t(double t);

  /// What to show, of player_width by player_height.
  [[nodiscard]] Picture picture() const;

  /// The stage as it stands: of the case as it was dragged.
  [[nodiscard]] const Stage& stage() const { return stage_; }
  [[nodiscard]] std::size_t step() const { return step_; }
  [[nodiscard]] double t() const { return t_; }
  [[nodiscard]] const StageCamera& camera() const { return camera_; }
  [[nodiscard]] Focus focus() const { return focus_; }
  [[nodiscard]] bool is_help_shown() const { return is_help_shown_; }
  /// Why the last drag came to nothing; empty where it did not.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  /// The world's point to the picture, as the step on show is seen.
  [[nodiscard]] ScreenProjection projection() const;
  [[nodiscard]] std::vector<Handle> handles() const;
  [[nodiscard]] std::vector<Button> buttons() const;

 private:
  enum class Drag { none, slider, orbit, handle };

  void show_play(std::size_t play);
  void reset();
  void go_to(std::size_t step);
  bool press_arrow(const std::string& key);
  void move_focus(bool is_backward);
  void zoom_by(double factor);
  /// By so much of its range.
  void move_slider(double part);
  [[nodiscard]] bool can_focus(Focus focus) const;
  [[nodiscard]] std::optional<Handle> handle_of(Grip grip) const;
  /// Moves the case's handle by this many pixels, in the plane through it that is parallel to the screen.
  void move_handle(const Case& one, const Handle& handle, double right, double down);
  /// Makes the stage again; keeps the old one and complains where the case is refused.
  void take(const Case& one);
  [[nodiscard]] StageView view() const;

  void draw_runner(Picture& picture) const;
  void draw_handles(Picture& picture) const;
  void draw_controls(Picture& picture) const;

  std::vector<Play> plays_;
  std::size_t play_ = 0;
  Stage stage_{};
  std::size_t step_ = 0;
  double t_ = 0;
  bool follows_hit_ = true;  ///< nobody has moved the slider: it stays at the first hit
  StageCamera camera_{};
  double zoom_ = 1;
  Focus focus_ = Focus::steps;
  bool is_help_shown_ = false;
  std::string complaint_{};

  Drag drag_ = Drag::none;
  Point held_at_{};
  Handle held_{};
  Case held_case_{};
  std::optional<StageView> held_view_{};  ///< the view rests while a handle is dragged
};

}  // namespace rayproof::viz
