#pragma once
/// \file
/// The oracle for ray and triangle.

#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact answer to a ray and a triangle, under a transform or not.
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const Triangle<double>& triangle,
                               Precision precision);

/// Judges the hits somebody claims for a ray and a triangle.
[[nodiscard]] Judgement judge(const RayQuestion& question, const Triangle<double>& triangle,
                              Precision precision, const RayAnswer& claimed);

}  // namespace rayproof::oracle
