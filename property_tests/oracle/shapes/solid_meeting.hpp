#pragma once
/// \file
/// What the quick judges of box and parallelepiped share.

#include "oracle/shapes/estimated.hpp"
#include "oracle/shapes/solid.hpp"

namespace rayproof::oracle {

/// The ray's line and three slabs over estimates, but for what only the shape knows (estimated.hpp).
class SolidMeeting {
 public:
  template <class Solid>
  SolidMeeting(const RayQuestion& question, const Solid& solid)
      : question_(question), ray_(question), met_(meetings(ray_, solid)) {}

  [[nodiscard]] const ObjectRay<Estimate>& ray() const { return ray_; }
  [[nodiscard]] auto hits() const { return hits_of(met_, question_.ray); }
  [[nodiscard]] long double residual(double t) const {
    return nearest([&](std::size_t slab, const SlabMeeting<Estimate>& met, const Estimate& bound) {
      return distance_to(slab, met, bound, QuotientOf<Estimate>(t), *sizes_);
    });
  }

 protected:
  [[nodiscard]] const SlabMeeting<Estimate>& met(std::size_t slab) const { return met_.at(slab); }
  /// The least of the distances from the six planes.
  template <class Distance>
  [[nodiscard]] long double nearest(const Distance& distance) const {
    long double least = HUGE_VALL;
    for (std::size_t i = 0; i < 3; ++i)
      for (const Estimate& bound : {met(i).low, met(i).high}) reduce(least, distance(i, met(i), bound));
    return least;
  }
  void measure_by(long double position, const std::array<long double, 3>& normals) {
    sizes_.emplace(question_, ray_, position, normals);
  }

 private:
  const RayQuestion& question_;
  ObjectRay<Estimate> ray_;
  SlabMeetings<Estimate> met_;
  std::optional<PlanarSizes<Estimate>> sizes_;
};

}  // namespace rayproof::oracle
