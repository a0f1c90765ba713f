#pragma once
/// \file
/// How bad a finding is.

#include "properties/finding.hpp"
#include "properties/finding_kind.hpp"

namespace rayproof {

/// The kind of a finding, by its shrunk case and what was answered to that, and by its cause where that is
/// known.
[[nodiscard]] FindingKind kind_of(const Finding& finding);

/// Whether a model names what is wrong on a boundary.
[[nodiscard]] bool is_named_boundary(const Finding& finding);
/// Whether it shows of a fault of small sizes only what it does on boundaries, where a number is 0.
[[nodiscard]] bool is_zero_alone(const Finding& finding);

/// Whether its cause says no more than a part of what the other's says.
[[nodiscard]] bool is_part_of(const Finding& finding, const Finding& other);

/// Whether the case has very large or very small numbers.
[[nodiscard]] bool is_extreme(const Finding& finding);

/// Whether the cause says no more than that a small change avoids what is wrong.
[[nodiscard]] bool is_avoided(const Finding& finding);

}  // namespace rayproof
