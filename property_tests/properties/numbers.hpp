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
  if (auto* q = std::get_if<Quadratic<double>>(&one.question)) {
    append("a", q->a);
    append("b", q->b);
    append("c", q->c);
  } else if (auto* place = std::get_if<PointAndPolygon<double>>(&one.question)) {
    append("point", place->point);
    append("vertices", place->vertices);
  } else {
    auto& [ray, shape, transform] = std::get<RayQuestion>(one.question);
    append("ray.origin", ray.origin);
    append("ray.direction", ray.direction);
    append("ray.t_min", ray.t_min);
    all.push_back({"ray.t_max", &ray.t_max, infinity<double>});
    std::visit([&]<class S>(S& of_shape) { ShapeFormat<S>::fields(of_shape, append); }, shape);
    for (int column = 0; transform && column < 4; ++column)
      for (int row = 0; row < 3; ++row)
        all.push_back({"transform", &(*transform)[column][row], column == row ? 1.0 : 0.0});
  }
  return all;
}

}  // namespace rayproof
