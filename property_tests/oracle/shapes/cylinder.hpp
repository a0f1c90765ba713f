#pragma once
/// \file
/// The oracle for ray and elliptic cylinder.

#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact answer to a ray and an elliptic cylinder, under a transform or not.
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const Cylinder<double>& cylinder,
                               Precision precision);

/// Judges the hits somebody claims for a ray and an elliptic cylinder.
[[nodiscard]] Judgement judge(const RayQuestion& question, const Cylinder<double>& cylinder,
                              Precision precision, const RayAnswer& claimed);

}  // namespace rayproof::oracle
