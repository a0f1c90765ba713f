#pragma once
/// \file
/// The oracle for ray and plane, in its three forms.

#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact answer to a ray and a plane, under a transform or not.
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const ImplicitPlane& plane, Precision precision);
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const PointNormalPlane& plane,
                               Precision precision);
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const ParametricPlane& plane,
                               Precision precision);

/// Judges the hits somebody claims for a ray and a plane.
[[nodiscard]] Judgement judge(const RayQuestion& question, const ImplicitPlane& plane, Precision precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion& question, const PointNormalPlane& plane, Precision precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion& question, const ParametricPlane& plane, Precision precision,
                              const RayAnswer& claimed);

}  // namespace rayproof::oracle
