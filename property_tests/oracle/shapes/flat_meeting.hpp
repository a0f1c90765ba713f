#pragma once
/// \file
/// What the quick judges of the flat shapes, plane, triangle and polygon, share.

#include "oracle/shapes/flat.hpp"

namespace rayproof::oracle {

/// The ray's line and a flat shape over estimates, but for what only the shape knows (estimated.hpp).
class FlatMeeting {
 public:
  FlatMeeting(const RayQuestion& question, FlatEquation<Estimate> plane)
      : question_(question), ray_(question), met_(ray_, std::move(plane)) {}

  [[nodiscard]] const ObjectRay<Estimate>& ray() const { return ray_; }
  [[nodiscard]] long double residual(double t) const { return met_.residual(t, *sizes_); }

 protected:
  [[nodiscard]] const LineAndPlane<Estimate>& met() const { return met_; }
  [[nodiscard]] const PlanarSizes<Estimate>& sizes() const { return *sizes_; }
  template <class ContactAt>
  [[nodiscard]] auto hits_where(const ContactAt& contact_at) const {
    return hits_of(met_, question_.ray, contact_at);
  }
  void measure_by(long double position, long double normal_size) {
    sizes_.emplace(question_, ray_, position, std::array{normal_size, 0.0L, 0.0L});
  }

 private:
  const RayQuestion& question_;
  ObjectRay<Estimate> ray_;
  LineAndPlane<Estimate> met_;
  std::optional<PlanarSizes<Estimate>> sizes_;
};

}  // namespace rayproof::oracle
