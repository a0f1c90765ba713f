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

/// Every number of `one` in the order of the format; the pointers hold as long as `one` does. The last row of
/// a transform, which is always 0 0 0 1, is left out.
[[nodiscard]] inline std::vector<CaseNumber> numbers_of(Case& one) {
  std::vector<CaseNumber> all;
  all.reserve(21);
  const auto append = [&](std::string_view field, auto& value) {
    each_number(value, [&](double& x) { all.push_back({field, &x}); });
  };
  const auto append_fields = [&]<class S>(S& shape) { ShapeFormat<S>::fields(shape, append); };
  const auto append_question = [&]<class Query>(Query& asked) {
    if constexpr (std::is_same_v<Query, RayQuestion>) {
      append("ray.origin", asked.ray.origin);
      append("ray.direction", asked.ray.direction);
      append("ray.t_min", asked.ray.t_min);
      all.push_back({"ray.t_max", &asked.ray.t_max, infinity<double>});
      std::visit(append_fields, asked.shape);
      for (int column = 0; asked.transform && column < 4; ++column)
        for (int row = 0; row < 3; ++row)
          all.push_back({"transform", &(*asked.transform)[column][row], column == row ? 1.0 : 0.0});
    } else {
      append_fields(asked);
    }
  };
  std::visit(append_question, one.question);
  return all;
}

/// Calls `act(x)` for every number of the case, in the order of the format.
void each_number_of(const Case& one, auto&& act) {
  const auto visit_field = [&](const char* /*name*/, const auto& field) { each_number(field, act); };
  const auto visit_shape = [&]<class S>(const S& shape) { ShapeFormat<S>::fields(shape, visit_field); };
  const auto* asked = std::get_if<RayQuestion>(&one.question);
  if (const auto* equation = std::get_if<Quadratic<double>>(&one.question)) return visit_shape(*equation);
  if (asked == nullptr) return visit_shape(std::get<PointAndPolygon<double>>(one.question));
  each_number(asked->ray.origin, act);
  each_number(asked->ray.direction, act);
  act(asked->ray.t_min);
  act(asked->ray.t_max);
  std::visit(visit_shape, asked->shape);
  if (asked->transform) each_number(*asked->transform, act);
}

}  // namespace rayproof
