#pragma once
/// \file
/// What all steps of a stage have in common: the scene, and from where it is seen; and what only from very
/// near is to be seen: a stretch of a line on which single numbers can be distinguished, and a solid that a
/// ray just misses, or just meets.

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "viz/explain/case_report.hpp"
#include "viz/scene/items.hpp"
#include "viz/shapes/figure.hpp"

namespace rayproof::viz {

/// Another space than the world, in which a run computes from a step on until another space begins.
struct StepSpace {
  std::string first_step;  ///< how the title of its first step begins
  std::string words{};     ///< "Drawn in the sheared space, looking back along the ray toward o."
  /// What is there, as the kernel has it; none for the world.
  std::function<Items(const NumbersByName& n)> scene{};
  std::function<glm::dvec3(const glm::dvec3&)> place{};  ///< from the kernel's space to where it is drawn
  std::vector<Binding> bindings{};                       ///< its own; none for those of the setting
  bool is_flat = false;                                  ///< a drawing in a plane
  double magnification = 1;                              ///< its lengths over the world's
};

/// What the verdict hangs on, drawn so large that its length is 1: of the ray and the shape's outline where
/// they are nearest, seen along the outline.
struct CloseUp {
  double gap = 0;       ///< the length; 0 where there is nothing to magnify
  std::string words{};  ///< "The ray passes 4.4e-8 from the outline."
  Items items{};        ///< in the plane of the camera, around 0
};

struct Setting {
  Items scene{};
  StageCamera camera{};
  std::optional<StageSlider> slider{};
  StageView near{};  ///< the shape
  StageView wide{};  ///< the shape and the ray's start
  /// How far off the ray's start is, where the ray comes into the near view.
  std::optional<StageItem> far_start{};
  /// Whether the shape would be a speck in the wide view.
  [[nodiscard]] bool starts_far() const { return far_start && wide.radius > 12 * near.radius; }
  /// From the space in which the kernel works to the world; the identity where there is no transform.
  std::function<glm::dvec3(const glm::dvec3&)> to_world{};
  std::vector<Binding> bindings{};  ///< how the named values look: the topic's, or a lesson's own
  std::vector<StepSpace> spaces{};
  bool has_inside = false;            ///< the shape is a solid
  std::optional<CloseUp> close_up{};  ///< none of what has no outline
};

[[nodiscard]] Setting setting_of(const CaseReport& report);

/// Both answers' hits or roots on the slider's line: "t₀ exact", "t₀ as computed".
[[nodiscard]] Items hits_of(const StageSlider& slider, const CaseReport& report);

/// The title of a stage's last step.
inline constexpr const char* comparison_title = "Float result against exact result";

/// The step of that title: what the exact answer says beside the method's, magnified where
/// they are too near to be distinguished.
[[nodiscard]] StageStep difference_step(const CaseReport& report, const Setting& setting);

[[nodiscard]] Setting flat_setting(const CaseReport& report);

/// The height of an equation's drawing, whose x goes from -1 to 1.
inline constexpr double plot_height = 1.2;

/// How an equation's numbers are put into its drawing: x from `left` to `right` becomes -1 to 1, and y from
/// its least to its greatest value, `height` more, takes up the drawing's height.
struct ParabolaFrame {
  double left = -1, right = 1, height = 1;
  [[nodiscard]] glm::dvec3 at(double x, double y) const {
    return {(2 * x - left - right) / (right - left), plot_height * y / height, 0};
  }
};
[[nodiscard]] ParabolaFrame parabola_frame(const Quadratic<double>& equation,
                                           const std::vector<double>& roots);
[[nodiscard]] std::function<glm::dvec3(const glm::dvec3&)> flat_on(const StageCamera& camera);

/// The point's projection along the largest axis of `n`, as the kernels have it.
[[nodiscard]] glm::dvec3 dropped(const glm::dvec3& n, const glm::dvec3& p);

/// The space that step `index` of the run computes in; null for the world.
[[nodiscard]] const StepSpace* space_of(const Setting& setting, const Walkthrough& walk, std::size_t index);
[[nodiscard]] Setting in_space(Setting setting, const StepSpace& space);
[[nodiscard]] std::vector<StepSpace> triangle_spaces(const Walkthrough& walk, const StageCamera& camera);

/// Lets a step show its space: the scene there, what earlier steps showed there in grey, and its own items.
/// `earlier` then has those, too.
void show_in_space(StageStep& step, const StepSpace& space, const NumbersByName& n, const StageCamera& camera,
                   Items& earlier);

/// A triangle in a plane, and the names of its corners.
[[nodiscard]] Items triangle_items(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// What is shown of it, in gaps from the outline: surfaces run out of the view.
inline constexpr StageView close_up_view{{0, 0, 0}, 2.3};

/// The ray and what lies below it in profile: a face, a solid's edge, or a round side that looks level; with
/// both answers' hits that are near.
[[nodiscard]] std::optional<CloseUp> close_up_of(const RayScene& scene, const CaseReport& report,
                                                 const StageCamera& camera);

/// A point and the sides of a polygon that are nearest to it.
[[nodiscard]] CloseUp close_up_of(const std::vector<glm::dvec3>& ring, const glm::dvec3& p);

/// Where the exact interval of t inside a solid begins and ends, and where the computed one does; an interval
/// that ends before it begins is empty.
struct Gap {
  double entry, exit;
  double computed_entry, computed_exit;
  const char* computed_exit_name;  ///< an exit that is moved on has a name of its own
};

/// As the kernels call the ends, and an exit that is moved on.
inline constexpr std::array<const char*, 3> gap_names{"t_entry", "t_exit", "t_padded"};

/// The gap of a run that names both ends, where it is narrow.
[[nodiscard]] std::optional<Gap> gap_of(const CaseReport& report);

/// Both intervals beside the ray, magnified.
void show_gap(StageStep& step, const Gap& gap, Precision precision, const Setting& setting);

/// The step that moves the exit on, where the planes of entry and exit meet in an edge that the ray nearly
/// touches: that edge seen end-on, with the box as it is and as it counts.
[[nodiscard]] std::optional<StepSpace> padded_space(const CaseReport& report, const StageCamera& camera);

/// "Exactly, t_entry = 1 and t_exit = 0.999999886; …"
[[nodiscard]] std::string in_words(const Gap& gap, Precision precision);

/// Where a number lies on the magnified line: the centre's is 0, and `unit` more is one length along.
struct Magnifier {
  double centre = 0;
  double unit = 1;
  glm::dvec3 along{1, 0, 0};
  [[nodiscard]] glm::dvec3 at(double t) const { return (t - centre) / unit * along; }
};

/// A dot for each number of the precision around one of them: between them there is nothing for an answer.
[[nodiscard]] Items dots_of(const Magnifier& magnifier, double around, Precision precision);

/// "Each dot is a float32 value."
[[nodiscard]] std::string dots_in_words(Precision precision);

/// What magnified steps show: numbers up to this many lengths from the centre.
inline constexpr double magnified_reach = 3.2;

}  // namespace rayproof::viz
