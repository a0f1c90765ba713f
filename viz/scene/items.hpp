#pragma once
/// \file
/// Items in few words, how a topic's named values look, and the view that just holds what there is to see.

#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "viz/scene/stage.hpp"
#include "viz/trace/walkthrough.hpp"

namespace rayproof::viz {

using Items = std::vector<StageItem>;

template <class T>
void append(std::vector<T>& list, const std::vector<T>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

[[nodiscard]] inline StageItem point(Role role, const glm::dvec3& at, std::string label = {}) {
  return {role, Form::point, {at}, std::move(label)};
}
[[nodiscard]] inline StageItem segment(Role role, const glm::dvec3& from, const glm::dvec3& to,
                                       std::string label = {}, Pattern pattern = Pattern::solid) {
  return {role, Form::segment, {from, to}, std::move(label), pattern};
}
[[nodiscard]] inline StageItem arrow(Role role, const glm::dvec3& from, const glm::dvec3& to,
                                     std::string label = {}) {
  return {role, Form::arrow, {from, to}, std::move(label)};
}
[[nodiscard]] inline StageItem polygon(Role role, std::vector<glm::dvec3> corners, std::string label = {}) {
  return {role, Form::polygon, std::move(corners), std::move(label)};
}
/// The same with a line around it.
[[nodiscard]] inline Items outlined(Role role, std::vector<glm::dvec3> corners, std::string label = {}) {
  StageItem ring{role, Form::polyline, corners};
  ring.points.push_back(corners.front());
  return {polygon(role, std::move(corners), std::move(label)), std::move(ring)};
}
/// What of an endless surface the view shows.
[[nodiscard]] inline StageItem open_polygon(Role role, std::vector<glm::dvec3> corners) {
  StageItem item = polygon(role, std::move(corners));
  item.is_open = true;
  return item;
}
/// An ellipse level to x and y, as a line.
[[nodiscard]] StageItem level_ring(Role role, double rx, double ry, double z, std::string label = {});
[[nodiscard]] inline StageItem ball(const glm::dvec3& centre, double r) {
  const glm::dvec3 x(r, 0, 0), y(0, r, 0), z(0, 0, r);
  return {Role::surface, Form::ellipsoid, {centre, centre + x, centre + y, centre + z}};
}
/// A body seen in profile, so near that its surface is level: all that lies below 0.
[[nodiscard]] inline Items ground_of(const StageCamera& camera) {
  constexpr double beyond = 8;
  const glm::dvec3 end = beyond * camera.right, down = beyond * camera.up;
  return {open_polygon(Role::surface, {-end, end, end - down, -end - down}),
          segment(Role::surface, -end, end)};
}
[[nodiscard]] inline StageItem polyline(Role role, std::vector<glm::dvec3> points, std::string label = {},
                                        Pattern pattern = Pattern::solid) {
  return {role, Form::polyline, std::move(points), std::move(label), pattern};
}

/// The inputs and every named value up to and with a step, each as the exact arithmetic has it, rounded to
/// double; of a name that was given twice the later one. What is drawn lies where it belongs; only answers
/// are drawn where the rounded arithmetic put them. To ask for a name that the run does not have is an error
/// of the picture: std::logic_error.
class NumbersByName {
 public:
  explicit NumbersByName(const Walkthrough& walk, std::size_t last_step) {
    for (const WalkValue& value : walk.inputs) take(value);
    for (std::size_t i = 0; i <= last_step && i < walk.steps.size(); ++i) {
      for (const WalkValue& value : walk.steps[i].values) take(value);
    }
  }

  [[nodiscard]] bool has(const std::string& name) const { return exact_.contains(name); }
  [[nodiscard]] double operator[](const std::string& name) const { return find(exact_, name); }
  [[nodiscard]] double rounded(const std::string& name) const { return find(rounded_, name); }
  /// The vector name.x, name.y, name.z; z is 0 of one that the kernel has in a plane.
  [[nodiscard]] glm::dvec3 vector(const std::string& name) const {
    const auto in_space = [&](const std::string& component) {
      return has(component) ? (*this)[component] : 0.0;
    };
    return {(*this)[name + ".x"], (*this)[name + ".y"], in_space(name + ".z")};
  }
  [[nodiscard]] bool has_vector(const std::string& name) const { return has(name + ".x"); }

  /// The same of a name that was given twice as it was at first: the case's own.
  [[nodiscard]] glm::dvec3 input(const std::string& name) const {
    return {find(first_, name + ".x"), find(first_, name + ".y"), find(first_, name + ".z")};
  }

  /// The ray as the kernel sees it: in the shape's own space where the case has a transform.
  [[nodiscard]] glm::dvec3 origin() const { return input(has_vector("o′") ? "o′" : "o"); }
  // A plane has a d of its own; beside it the direction bears an arrow. A kernel may name a d of its own
  // later.
  [[nodiscard]] glm::dvec3 direction() const { return input("d"); }
  [[nodiscard]] glm::dvec3 at(double t) const { return origin() + t * direction(); }

 private:
  [[nodiscard]] static double find(const std::map<std::string, double>& numbers, const std::string& name) {
    const auto found = numbers.find(name);
    if (found == numbers.end()) throw std::logic_error("no kernel of this run names " + name);
    return found->second;
  }
  void take(const WalkValue& value) {
    first_.try_emplace(value.name, value.exact_value);
    exact_[value.name] = value.exact_value;
    rounded_[value.name] = value.value;
  }
  std::map<std::string, double> exact_{}, rounded_{};
  std::map<std::string, double> first_{};  ///< of a name that was given twice the earlier one
};

/// How a named value looks: the items it becomes, given all numbers known by then, in the space in which the
/// kernel works. A name is as the kernel has it, a vector's without ".x"; or it is a step's title, for what a
/// step shows whatever it names.
struct Binding {
  std::string name;
  std::function<Items(const NumbersByName& n)> draw;
  bool begins_anew = false;  ///< the items of the steps before would hide what this one shows
};

/// How far an item reaches: its points, and of an ellipsoid the points of its outline that lie farthest to
/// each side as the camera sees it.
[[nodiscard]] std::vector<glm::dvec3> extent_of(const StageItem& item, const StageCamera& camera);
[[nodiscard]] std::vector<glm::dvec3> extent_of(const std::vector<StageItem>& items,
                                                const StageCamera& camera);

/// The smallest view that holds the points as the camera sees them; those that are not finite are left out.
[[nodiscard]] StageView view_of(const std::vector<glm::dvec3>& points, const StageCamera& camera);

/// The radius that a view of this centre needs to hold the items.
[[nodiscard]] double radius_for(const StageView& view, const std::vector<StageItem>& items,
                                const StageCamera& camera);

/// What a picture can hang on: the names of the run's values, a vector's without ".x", and the titles of its
/// steps.
[[nodiscard]] std::set<std::string> recorded_names(const Walkthrough& walk);

/// The point of an ellipsoid that lies farthest in a direction.
[[nodiscard]] glm::dvec3 farthest_of(const StageItem& ellipsoid, const glm::dvec3& direction);

}  // namespace rayproof::viz
