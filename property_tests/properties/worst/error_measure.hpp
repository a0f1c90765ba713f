#pragma once
/// \file
/// The errors that a search for the worst case makes larger, in the units of the contracts.

#include <array>

#include "properties/engine/tally.hpp"

namespace rayproof::worst {

/// One kind of error; each has the name of the property that holds it to the promise.
struct ErrorMeasure {
  const char* name;
  double Worst::*value;
  const Bound& (*bound)(const Contract&);
  bool is_of_details;  ///< measured by the judge of point, normal and coordinates, which costs as much again
};

inline constexpr std::array<ErrorMeasure, 6> error_measures{{
    {"verdict", &Worst::verdict, [](const Contract& c) -> const Bound& { return c.verdict; }, false},
    {"residual", &Worst::residual, [](const Contract& c) -> const Bound& { return c.residual; }, false},
    {"ulp", &Worst::ulp, [](const Contract& c) -> const Bound& { return c.ulp; }, false},
    {"point", &Worst::point, [](const Contract& c) -> const Bound& { return c.hit.point; }, true},
    {"normal", &Worst::normal, [](const Contract& c) -> const Bound& { return c.hit.normal; }, true},
    {"coordinates", &Worst::coordinates, [](const Contract& c) -> const Bound& { return c.hit.coordinates; },
     true},
}};

/// The errors of one case, in the order of `error_measures`, and once more for cases under a transform, for
/// which another promise holds (promise.hpp). 0 where there is none, or the case is outside of the domain.
inline constexpr std::size_t error_kinds = 2 * error_measures.size();
using ErrorList = std::array<double, error_kinds>;

[[nodiscard]] constexpr const ErrorMeasure& measure_of(std::size_t kind) {
  return error_measures.at(kind % error_measures.size());
}
[[nodiscard]] constexpr bool is_of_transformed(std::size_t kind) { return kind >= error_measures.size(); }

/// The errors of the subject's answer to the case, as every run of the property tests measures them; those of
/// point, normal and coordinates where they are asked for.
[[nodiscard]] ErrorList errors_of(const Subject& subject, const Case& one, bool with_details);

/// Whether the answer exceeds what the subject promises of this error, and does not declare that it may.
[[nodiscard]] bool exceeds_promise(const Subject& subject, const Case& one, std::size_t kind);

}  // namespace rayproof::worst
