#pragma once
/// \file
/// A run's numbers by the names that the kernel gave them.

#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <string>

#include "viz/trace/walkthrough.hpp"

namespace rayproof::viz {

/// The inputs and every named value up to and with a step, each as the exact arithmetic has it, rounded to
/// double; of a name that was given twice the later one. What is drawn lies where it belongs; only answers
/// are drawn where the rounded arithmetic put them. To ask for a name that the run does not have is an error
/// of the picture: std::logic_error.
class NumbersByName {
 public:
  explicit NumbersByName(const Walkthrough& walk, std::size_t last_step);

  [[nodiscard]] bool has(const std::string& name) const { return exact_.contains(name); }
  [[nodiscard]] double operator[](const std::string& name) const;
  /// The same as it was rounded.
  [[nodiscard]] double rounded(const std::string& name) const;
  /// The vector name.x, name.y, name.z; z is 0 of one that the kernel has in a plane.
  [[nodiscard]] glm::dvec3 vector(const std::string& name) const;
  [[nodiscard]] bool has_vector(const std::string& name) const { return has(name + ".x"); }

  /// The same of a name that was given twice as it was at first: the case's own.
  [[nodiscard]] glm::dvec3 input(const std::string& name) const { return first_vector(name); }

  /// The ray as the kernel sees it: in the shape's own space where the case has a transform.
  [[nodiscard]] glm::dvec3 origin() const;
  [[nodiscard]] glm::dvec3 direction() const;
  [[nodiscard]] glm::dvec3 at(double t) const { return origin() + t * direction(); }

 private:
  void take(const WalkValue& value);
  [[nodiscard]] glm::dvec3 first_vector(const std::string& name) const;
  std::map<std::string, double> exact_{}, rounded_{};
  std::map<std::string, double> first_{};  ///< of a name that was given twice the earlier one
};

/// What a picture can hang on: the names of the run's values, a vector's without ".x", and the titles of its
/// steps.
[[nodiscard]] std::set<std::string> recorded_names(const Walkthrough& walk);

}  // namespace rayproof::viz
