#pragma once
/// \file
/// The oracle for ray and sphere.

#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact answer to a ray and a sphere, under a transform or not.
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const Sphere<double>& sphere,
                               Precision precision);

/// Judges the hits somebody claims for a ray and a sphere.
[[nodiscard]] Judgement judge(const RayQuestion& question, const Sphere<double>& sphere, Precision precision,
                              const RayAnswer& claimed);

}  // namespace rayproof::oracle
