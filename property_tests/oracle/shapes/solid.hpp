#pragma once
/// \file
/// The oracle for ray and box, and for ray and parallelepiped.

#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact answer to a ray and a box, under a transform or not.
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const Box<double>& box, Precision precision);

/// The exact answer to a ray and a parallelepiped, under a transform or not.
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const Parallelepiped<double>& solid,
                               Precision precision);

/// Judges the hits somebody claims for a ray and a solid.
[[nodiscard]] Judgement judge(const RayQuestion& question, const Box<double>& box, Precision precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion& question, const Parallelepiped<double>& solid,
                              Precision precision, const RayAnswer& claimed);

}  // namespace rayproof::oracle
