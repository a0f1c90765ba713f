#pragma once
/// \file
/// The oracle for ray and polygon, and for point in polygon.

#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact answer to a ray and a polygon, under a transform or not.
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const Polygon<double>& polygon,
                               Precision precision);

/// The exact place of a point.
[[nodiscard]] Position answer(const PointAndPolygon<double>& question);

/// Judges the hits somebody claims for a ray and a polygon.
[[nodiscard]] Judgement judge(const RayQuestion& question, const Polygon<double>& polygon,
                              Precision precision, const RayAnswer& claimed);

/// Judges the place somebody claims for a point.
[[nodiscard]] Judgement judge(const PointAndPolygon<double>& question, Precision precision, Position claimed);

}  // namespace rayproof::oracle
