#pragma once
/// \file
/// Which subject is put which cases, and in which order.

#include <functional>

#include "properties/engine/hunt.hpp"
#include "properties/engine/plan.hpp"

namespace rayproof {

/// Which subject the plan gives which cases.
[[nodiscard]] std::vector<Unit> units_of(const Plan& plan);

/// The units, those of a family together: what is judged of one subject's answer need not be of another's.
[[nodiscard]] std::vector<std::reference_wrapper<Unit>> by_families(std::vector<Unit>& units);

}  // namespace rayproof
