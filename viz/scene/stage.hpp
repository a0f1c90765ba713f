#pragma once
/// \file
/// A staged walkthrough: a method's run on one case, step by step, with something to look at in each step.
///
/// All of it is data: titles, captions, formulas, numbers, and items placed in the world. The PNG storyboard,
/// the page and the window are sinks of it and compute nothing of their own but how it is seen. The steps
/// are the kernel's own, titles and words (rayproof/method/narration.hpp), and the numbers are the run's own,
/// bit for bit: what a value holds is what the same kernel computes in plain `float` or `double`.
///
///     const CaseReport report = report_of(one, "sphere/centred");  // viz/programs/report_of.hpp
///     const Stage stage = stage_of(report);                        // viz/walkthrough/lesson.hpp
///     for (const StageStep& step : stage.steps) …                  // what to show, and from where

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "viz/picture/picture.hpp"
#include "viz/trace/walkthrough.hpp"

namespace rayproof::viz {

/// What an item's points are.
enum class Form {
  point,     ///< one, with the mark of its role (mark_of)
  segment,   ///< two
  arrow,     ///< two, the head at the second
  polyline,  ///< two or more
  polygon,   ///< three or more, filled by the even-odd rule
  solid,     ///< four or more, the corners of a convex solid with its `faces`
  ellipsoid  ///< its centre and the tips of three conjugate semi-axes; the outline as it is seen is an
             ///< ellipse
};

/// Their names in JSON, in that order.
inline constexpr std::array<const char*, 7> form_names{"point",   "segment", "arrow",    "polyline",
                                                       "polygon", "solid",   "ellipsoid"};

/// Something in the world to look at. The role gives colour and mark, in every sink the same.
struct StageItem {
  Role role = Role::text;
  Form form = Form::point;
  std::vector<glm::dvec3> points{};
  std::string label{};  ///< "t₀"; empty for none
  Pattern pattern = Pattern::solid;
  std::vector<std::vector<std::size_t>> faces{};  ///< of a solid, the corners around each in either direction
  bool is_open = false;             ///< a polygon that goes on beyond the view: without a line around it
  bool stands_for_earlier = false;  ///< a point in place of those of its role that earlier steps have there
};

/// The mark of a point of the role: no two roles that can meet in a picture share one.
[[nodiscard]] constexpr MarkShape mark_of(Role role) {
  return role == Role::exact     ? MarkShape::ring
         : role == Role::claimed ? MarkShape::cross
         : role == Role::nearest ? MarkShape::diamond
                                 : MarkShape::dot;
}

/// Points of the surface bear a label beside them and no mark; points of mere text are where the text stands.
[[nodiscard]] constexpr bool has_mark(Role role) { return role != Role::surface && role != Role::text; }

/// A number or vector that the kernel names.
struct StageValue {
  std::string name;   ///< "f"
  Formula formula{};  ///< o − C; null for an input
  Formula put_in{};   ///< (0, 0, -5) − (0, 0, 0): the formula with the rounded numbers in it
  std::vector<WalkValue> components{};  ///< one of a number, two or three of a vector
};

/// How much wider than high the part of the world is that a view shows.
inline constexpr double view_aspect = 1.6;

/// Which part of the world is shown: what lies, as it is seen, no more than `radius` above or below the
/// centre and view_aspect times that to its sides. Sinks leave a margin for marks and labels.
struct StageView {
  glm::dvec3 centre{};
  double radius = 1;
};

/// One step. Its items are the new ones; those of the steps before are to be shown dimmed, unless
/// `is_apart`, and back to the last step that `begins_anew`.
struct StageStep {
  std::string title{};  ///< the kernel's own
  std::string words{};  ///< what the step means, the kernel's own sentence; may be empty
  std::string caption{};  ///< the same and the numbers put in: "… D = b·b − 4·a·c = 3·3 − 4·1·2 = 1"
  std::string digits{};  ///< what the step did to the digits, in one sentence; may be empty
  std::vector<StageValue> values{};
  std::vector<StageItem> items{};
  StageView view{};
  /// The step has a scene of its own: neither the stage's scene nor the items before belong to it. Its
  /// lengths are the world's times `magnification`, from a point of the world's own.
  bool is_apart = false;
  double magnification = 1;
  /// A scene of its own that is another space of three dimensions, not a drawing: to be seen as the world is.
  bool is_other_space = false;
  /// From this step on, the items of the steps before are shown no more.
  bool begins_anew = false;
};

/// How much larger than the stage's first step a step shows the world.
[[nodiscard]] inline double enlargement(const StageStep& first, const StageStep& step) {
  return step.magnification / first.magnification * first.view.radius / step.view.radius;
}

/// A number that lives on the slider: a polynomial in t, or in x where the slider moves along an x axis.
struct StageReadout {
  std::string label;                   ///< "|p − C|² − r²"
  std::vector<double> coefficients{};  ///< of t⁰, t¹, …
};

/// The range of the slider: the point origin + t·direction for t in [from, to], both finite.
struct StageSlider {
  std::string symbol = "t";
  glm::dvec3 origin{};
  glm::dvec3 direction{1, 0, 0};
  double from = 0;
  double to = 1;
  double start = 0;         ///< where it stands at first: at the first hit, if there is one
  bool shows_point = true;  ///< whether the point's coordinates mean something to the reader
  std::vector<StageReadout> readouts{};
};

/// From where it is looked at first: unit vectors at right angles to each other. Without perspective.
struct StageCamera {
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 up{0, 1, 0};
  glm::dvec3 toward{0, 0, 1};  ///< from the scene to the eye
  bool is_flat = false;        ///< the scene is a drawing in the plane of right and up: nothing to orbit
};

struct Stage {
  std::string name;      ///< of the lesson, "far-sphere"; of any other case the method with a dash
  std::string title;     ///< "A sphere, from the ray point nearest its centre"
  std::string sentence;  ///< what there is to learn
  std::string method;    ///< "sphere/centred"; what ran, where it is not a method of the registry
  std::string source;    ///< author, title, year
  std::string conclusion;
  Case one{};  ///< to compute all of it again
  Precision precision = Precision::float32;
  int digits = 24;
  std::vector<StageItem> scene{};  ///< what all steps have in common: the shape and the ray
  std::vector<StageStep> steps{};
  std::size_t decisive_step = 0;  ///< where the answer was spoilt, else where it is seen to be wrong
  std::optional<StageSlider> slider{};
  StageCamera camera{};
};

}  // namespace rayproof::viz
