#pragma once
/// \file
/// What the oracle knows exactly: an overload for each shape and each other question, and none of them knows
/// the next. A new shape is a line here.

#include <memory>

#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {

using ExactPointer = std::unique_ptr<ExactIntersection>;

/// The exact intersection of a ray and a shape, under a transform or not, for as long as both live.
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const ImplicitPlane&);
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const PointNormalPlane&);
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const ParametricPlane&);
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const Triangle<double>&);
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const Polygon<double>&);
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const Box<double>&);
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const Parallelepiped<double>&);
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const Cylinder<double>&);
[[nodiscard]] ExactPointer intersection_of(const RayQuestion&, const Sphere<double>&);

/// Judges of their own, for speed.
[[nodiscard]] Judgement judge(const RayQuestion&, const ImplicitPlane&, Precision, const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion&, const PointNormalPlane&, Precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion&, const ParametricPlane&, Precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion&, const Triangle<double>&, Precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion&, const Polygon<double>&, Precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion&, const Box<double>&, Precision, const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion&, const Parallelepiped<double>&, Precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion&, const Cylinder<double>&, Precision,
                              const RayAnswer& claimed);
[[nodiscard]] Judgement judge(const RayQuestion&, const Sphere<double>&, Precision, const RayAnswer& claimed);

/// The exact kind and the correctly rounded roots of ax² + bx + c = 0.
[[nodiscard]] QuadraticAnswer<double> answer(const Quadratic<double>& equation, Precision precision);
[[nodiscard]] Judgement judge(const Quadratic<double>& equation, Precision precision,
                              const QuadraticAnswer<double>& claimed);

/// The exact place of a point, the same in every precision.
[[nodiscard]] Position answer(const PointAndPolygon<double>& question, Precision);
[[nodiscard]] Judgement judge(const PointAndPolygon<double>& question, Precision precision, Position claimed);

}  // namespace rayproof::oracle
