#pragma once
/// \file
/// How a shape is written in the case format: its name, its fields, and what is refused.

#include <stdexcept>
#include <string>

namespace rayproof {

/// Input that is refused: the field at fault, and one sentence that names it.
class Refusal : public std::runtime_error {
 public:
  Refusal(std::string field, const std::string& sentence)
      : std::runtime_error(sentence), field_(std::move(field)) {}
  [[nodiscard]] const std::string& field() const { return field_; }

 private:
  std::string field_;
};

/// Specialised for each shape, and for each question without a ray, with
///  - `type`, the name in the case format;
///  - `fields(shape, visit)`, which calls `visit("center", shape.center)` for each field in the order of the
///  format;
///  - `validate(shape)`, which throws a Refusal for a shape that the format refuses; numbers are finite by
///  then;
///  - `in_words(shape, show)`, "a sphere of radius 1", with numbers as `show(number)` writes them, where
///  there is more to say of it than its type; and, where its distance says something of a case,
///  `middle(shape)`, a point to measure it to.
/// Reading, writing, rounding, shrinking and the NaN property all go through `fields`.
template <class Shape>
struct ShapeFormat;

}  // namespace rayproof
