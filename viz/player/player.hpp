#pragma once
/// \file
/// The interactive walkthrough as data and events: what a window shows, and what keys and handles do to it.
///
///     Player player({{stage, [&](const Case& one) { return stage_of(report_on(one)); }}});
///     player.press_key("Right");                 // the next step
///     player.grasp("tip");                       // a handle of handles()
///     player.drag_to({1.2, 0.5, 0.1}, 0.01);     // in the world; runs the method and the exact answer again
///     player.release();
///     const Stage stage = player.shown();        // with p(t) in the step's items

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viz/flat/stage_picture.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

class Rounding {
 public:
  /// `resolution` is how far apart two places are that can just be distinguished.
  Rounding(double resolution, Precision precision) : resolution_(resolution), precision_(precision) {}

  /// The shortest decimal that distinguishes `next` at this resolution, then a number of the precision; `old`
  /// where it did not move.
  [[nodiscard]] double operator()(double old, double next) const;
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& old, const glm::dvec3& next) const;
  /// The same for lengths of which each appears as `factor` of them.
  [[nodiscard]] Rounding magnified(double factor) const { return {resolution_ / factor, precision_}; }

 private:
  double resolution_;
  Precision precision_;
};

/// A point to take hold of: of the ray its origin or the tip of its arrow, of a shape what defines it, of a
/// transform its translation or the tip of one of its axes.
struct Handle {
  std::string name;  ///< "origin", "tip", "center", "vertices 2"; each once in a case
  glm::dvec3 at{};
  /// Writes the place to which it was moved into a case: of the case from which the handle was made.
  std::function<void(Case& next, const glm::dvec3& to, const Rounding& round)> move{};
};

/// The handles in the view of a step, those of the ray first. None where the step shows something else than
/// the case: a scene of its own, or another ray.
[[nodiscard]] std::vector<Handle> handles_of(const Stage& stage, std::size_t step);

/// The handles of the shape and of its transform, wherever they are; `size` is about the view's radius,
/// `aside` the direction in which a radius lies.
[[nodiscard]] std::vector<Handle> shape_handles(const Case& one, double size, const glm::dvec3& aside);

/// The case with the handle moved to `to`. Coordinates that the move changes become the shortest decimals
/// that distinguish points at a distance of `resolution`, then numbers of the case's precision; the others
/// keep their bits. Throws a Refusal where the format refuses the case: a zero direction, say.
[[nodiscard]] Case moved(const Case& one, const Handle& handle, const glm::dvec3& to, double resolution);

/// A stage, and how to make it again of another case.
struct Play {
  Stage stage;
  /// May throw: then the case is refused, and the player says why.
  std::function<Stage(const Case&)> again;
};

/// What a key asks of the window: to end, to write, to move what has the focus, or to look anew.
enum class Request { none, quit, print_case, save_picture, move_focused, nearer, farther, look_anew };

/// What the arrow keys move; Tab goes on to the next, and through all handles.
enum class Focus { steps, slider, view, handle };

class Player {
 public:
  /// At least one play, each with at least one step.
  explicit Player(std::vector<Play> plays);

  /// A key by its X name: "Right", "Home", "h", "comma", "3". Keys that mean nothing do nothing.
  Request press_key(const std::string& key, bool is_shifted = false);
  void go_to(std::size_t step);
  /// Puts the slider there, or as near as its range and the precision allow.
  void set_t(double t);
  /// Takes hold of a handle by its name; its stage's view rests until it is let go.
  void grasp(const std::string& handle);
  /// Moves what is held, from where the case had it when it was grasped, to a place in the world of which
  /// points at a distance of `resolution` can just be distinguished. Makes the stage again; keeps the old one
  /// and complains where the case is refused.
  void drag_to(const glm::dvec3& to, double resolution);
  void release() { held_.reset(); }

  /// The stage as it stands: of the case as it was dragged.
  [[nodiscard]] const Stage& stage() const { return stage_; }
  /// The same to be looked at: p(t) is among the items of the step on show, and while a handle is held the
  /// view rests.
  [[nodiscard]] Stage shown() const;
  [[nodiscard]] std::size_t step() const { return step_; }
  [[nodiscard]] double t() const { return t_; }
  [[nodiscard]] std::size_t play() const { return play_; }
  [[nodiscard]] std::size_t play_count() const { return plays_.size(); }
  [[nodiscard]] Focus focus() const { return focus_; }
  /// Of the handle that has the focus or is held; else empty.
  [[nodiscard]] const std::string& focused_handle() const { return focused_; }
  [[nodiscard]] bool is_held() const { return held_.has_value(); }
  [[nodiscard]] bool is_help_shown() const { return is_help_shown_; }
  /// Why the last drag came to nothing; empty where it did not.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  [[nodiscard]] std::vector<Handle> handles() const { return handles_of(stage_, step_); }

 private:
  struct Grasp {
    Handle handle;
    Case one;
    StageView view;
  };

  void show_play(std::size_t play) {
    play_ = play;
    step_ = 0;
    reset();
  }
  void reset();
  Request press_arrow(const std::string& key);
  void move_focus(bool is_backward);
  void put_focus(Focus focus, const std::string& handle = {}) {
    focus_ = focus;
    focused_ = handle;
  }
  /// By so much of its range.
  void move_slider(double part) {
    if (stage_.slider) set_t(t_ + part * (stage_.slider->to - stage_.slider->from));
  }
  void take(const Case& one);

  std::vector<Play> plays_;
  std::size_t play_ = 0;
  Stage stage_{};
  std::size_t step_ = 0;
  double t_ = 0;
  bool follows_hit_ = true;  ///< nobody has moved the slider: it stays at the first hit
  Focus focus_ = Focus::steps;
  std::string focused_{};
  bool is_help_shown_ = false;
  std::string complaint_{};
  std::optional<Grasp> held_{};
};

/// In a slide's place.
[[nodiscard]] Picture help_picture(const Stage& stage);

}  // namespace rayproof::viz
