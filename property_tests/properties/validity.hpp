#pragma once
#include "case/case.hpp"

namespace rayproof {

/// Whether the case format accepts the case: finite numbers, a direction, an interval, a shape and a regular
/// transform.
[[nodiscard]] bool is_valid(const Case& one);

}  // namespace rayproof
