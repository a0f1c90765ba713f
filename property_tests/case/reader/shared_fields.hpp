#pragma once
/// \file
/// Fields that cases and scenes have in common, with the same refusals.

#include "case/reader/field.hpp"

namespace rayproof {

/// The field `precision`, float64 where it is left out.
[[nodiscard]] Precision read_precision(ObjectReader& reader);

/// An affine and regular object-to-world matrix, written by rows.
[[nodiscard]] glm::dmat4 read_transform(const Field& field, Precision precision);

}  // namespace rayproof
