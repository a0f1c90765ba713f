#pragma once
/// \file
/// A case as a function is asked it: every number in a row, in the order in which parameters name them.

#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <rayproof/transform.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace rayproof::answering {

/// Appends the fields of a shape: a letter for each to the pattern, its numbers to the row.
///
/// The letters: `n` a number, `b` a bool, `v` three numbers, `p` two, `a` three vectors, `V` a list of
/// vectors of three, `P` of two.
struct FieldRow {
  std::string pattern{};
  std::vector<double> row{};
  const std::vector<glm::dvec3>* points = nullptr;
  const std::vector<Vec2<double>>* points_of_plane = nullptr;

  void clear() {
    pattern.clear();
    row.clear();
  }
  void add(double x) { append('n', {x}); }
  void add(bool x) { append('b', {x ? 1.0 : 0.0}); }
  void add(const glm::dvec3& v) { append('v', {v.x, v.y, v.z}); }
  void add(const Vec2<double>& v) { append('p', {v.x, v.y}); }
  void add(const std::array<glm::dvec3, 3>& vectors) {
    for (const glm::dvec3& v : vectors) row.insert(row.end(), {v.x, v.y, v.z});
    pattern += 'a';
  }
  void add(const std::vector<glm::dvec3>& list) {
    points = &list;
    pattern += 'V';
  }
  void add(const std::vector<Vec2<double>>& list) {
    points_of_plane = &list;
    pattern += 'P';
  }
  template <class S>
  void add_fields(const S& shape) {
    ShapeFormat<S>::fields(shape, [this](const char* /*name*/, const auto& field) { this->add(field); });
  }

 private:
  void append(char letter, std::initializer_list<double> numbers) {
    pattern += letter;
    row.insert(row.end(), numbers);
  }
};

/// The question in the function's own terms: the ray in the object's space, unless the function takes the
/// transform itself; its direction of length 1 where the function needs that.
struct Problem {
  Ray<double> ray{};  ///< as the function is given it
  double length = 1;  ///< of the direction before it was made a unit vector
  const Question* question = nullptr;
  const RayQuestion* asked = nullptr;                 ///< null for a question without a ray
  std::optional<ObjectSpace<double>> object_space{};  ///< where the case has a transform
  FieldRow fields{};                                  ///< of the shape, or of the question without a ray

  /// Takes a ray question apart; false where the ray cannot be given in the function's terms.
  [[nodiscard]] bool set(const RayQuestion& ray_question, bool needs_unit_direction, bool takes_transform) {
    asked = &ray_question;
    ray = ray_question.ray;
    length = 1;
    object_space.reset();
    if (ray_question.transform && !takes_transform) {
      object_space = rayproof::object_space<double>(*ray_question.transform);
      ray = to_object(*object_space, ray);
    }
    if (needs_unit_direction) {
      length = std::hypot(ray.direction.x, ray.direction.y, ray.direction.z);
      ray.direction = ray.direction / length;
      ray.t_min *= length;
      ray.t_max *= length;
    }
    // Beyond, the length is no number that t could be scaled back by.
    if (!(length > 0x1p-1000 && length < 0x1p1000)) return false;
    return std::isfinite(dot(ray.direction, glm::dvec3(1))) && ray.direction != glm::dvec3(0);
  }
};

}  // namespace rayproof::answering
