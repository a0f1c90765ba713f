#pragma once
/// \file
/// What the shapes bounded by planes share: the units that distances from the planes are measured in.

#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {

/// The lengths that the units of a contract are made of.
struct PlanarSizes {
  Scaled origin;                  ///< the ray's, and the distance of the shape's numbers from (0, 0, 0)
  Scaled direction;               ///< the ray's
  std::array<Scaled, 3> normals;  ///< the planes', in the scale of ObjectRay

  /// L(t) of the contracts.
  [[nodiscard]] Scaled reach(const Scaled& t) const { return origin + abs(t) * direction; }
  /// |normal|·L(t).
  [[nodiscard]] Scaled unit(std::size_t plane, const Scaled& t) const { return normals[plane] * reach(t); }
};

class PlanarIntersection : public ExactIntersection {
 public:
  using ExactIntersection::ExactIntersection;

 protected:
  /// Bounds the distance of the shape's numbers from (0, 0, 0).
  [[nodiscard]] virtual Scaled position() const = 0;
  /// Bounds the lengths of the planes' normals as the shape's numbers give them.
  [[nodiscard]] virtual std::array<Scaled, 3> normal_sizes() const = 0;

  [[nodiscard]] const PlanarSizes& sizes() const {
    if (!sizes_) {
      const RaySizes of_ray(question(), ray());
      sizes_ = {of_ray.origin + position(), of_ray.direction, normal_sizes()};
      for (Scaled& normal : sizes_->normals) normal = approximate(ray().scale) * normal;
    }
    return *sizes_;
  }

 private:
  mutable std::optional<PlanarSizes> sizes_;
};

}  // namespace rayproof::oracle
