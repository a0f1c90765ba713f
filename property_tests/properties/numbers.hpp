#pragma once
/// \file
/// Every number of a case, by name: what the shrinker makes simpler and the NaN property spoils.

#include <string_view>
#include <variant>
#include <vector>

#include "case/case.hpp"
#include "case/each_number.hpp"

namespace rayproof {

/// One number of a case and the value that says nothing, as which it could be left out (0 but for t_max and a
/// matrix's diagonal).
struct CaseNumber {
  std::string_view field;
  double* value = nullptr;
  double plain = 0;
};

namespace detail {

void append(std::vector<CaseNumber>& all, std::string_view field, auto& value) {
  each_number(value, [&](double& x) { all.push_back({field, &x}); });
}

/// The numbers of a shape, or of a question without a ray.
template <class S>
void append_question(std::vector<CaseNumber>& all, S& shape) {
  ShapeFormat<S>::fields(shape, [&](const char* name, auto& value) { append(all, name, value); });
}

inline void append_question(std::vector<CaseNumber>& all, RayQuestion& asked) {
  append(all, "ray.origin", asked.ray.origin);
  append(all, "ray.direction", asked.ray.direction);
  append(all, "ray.t_min", asked.ray.t_min);
  all.push_back({"ray.t_max", &asked.ray.t_max, infinity<double>});
  std::visit([&](auto& shape) { append_question(all, shape); }, asked.shape);
  if (!asked.transform) return;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      all.push_back({"transform", &(*asked.transform)[column][row], column == row ? 1.0 : 0.0});
}

}  // namespace detail

/// Every number of `one` in the order of the format; the pointers hold as long as `one` does. The last row of
/// a transform, which is always 0 0 0 1, is left out.
[[nodiscard]] inline std::vector<CaseNumber> numbers_of(Case& one) {
  std::vector<CaseNumber> all;
  all.reserve(21);
  std::visit([&](auto& asked) { detail::append_question(all, asked); }, one.question);
  return all;
}

}  // namespace rayproof
