#pragma once
/// \file
/// What the oracles of box and parallelepiped share: three slabs, and the interval of t in all of them.

#include "oracle/geometry/slabs.hpp"
#include "oracle/shapes/flat.hpp"

namespace rayproof::oracle {

/// How far p(t) is from one plane of a slab, the `index`th, in the contract's units.
template <class R>
[[nodiscard]] SizeOf<R> distance_to(std::size_t index, const SlabMeeting<R>& met, const R& bound,
                                    const QuotientOf<R>& t, const PlanarSizes<R>& sizes) {
  using std::abs;
  const SizeOf<R> gap = abs(roughly(met.beyond(bound, t))) / approximate(t.denominator());
  return ratio(gap, sizes.unit(index, t.estimate()));
}

/// A convex solid between three pairs of parallel planes.
class SolidIntersection : public PlanarIntersection {
 public:
  template <class Solid>
  SolidIntersection(const RayQuestion& question, const Solid& solid)
      : PlanarIntersection(question), met_(meetings(ray(), solid)) {}

  [[nodiscard]] ExactContacts hits() const override {
    ExactContacts all;
    for (auto& hit : hits_of(met_, question().ray)) all.push_back({std::move(hit.t), hit.contact});
    return all;
  }

  /// Outward from the face that holds the point; nothing on an edge or corner, where several do.
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact& hit) const override {
    const auto& t = std::get<Quotient>(hit.t);
    std::optional<ExactNormal> normal;
    int faces = 0;
    for (const SlabMeeting<Ring>& met : met_) {
      const bool is_low = sign(met.beyond(met.low, t)) == 0;
      const bool is_high = sign(met.beyond(met.high, t)) == 0;
      if (is_low || is_high) normal = {is_high ? met.normal : -met.normal};
      faces += static_cast<int>(is_low) + static_cast<int>(is_high);
    }
    return faces == 1 ? normal : std::nullopt;
  }

  [[nodiscard]] Scaled residual(const Quotient& t) const override {
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i)
      for (const Ring& bound : {met(i).low, met(i).high}) reduce(nearest, distance(i, bound, t));
    return nearest;
  }
  [[nodiscard]] Scaled off_surface(const Vector<Ring>& point, const Quotient& t) const override {
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i) {
      const Ring position = dot(met(i).normal, point);
      for (const Ring& gap : {position - met(i).low, position - met(i).high})
        reduce(nearest, ratio(abs(approximate(gap)), sizes().unit(i, t.estimate())));
    }
    return nearest;
  }

  /// The six faces.
  [[nodiscard]] SurfaceParts parts(const Quotient& t, const Scaled& /*roundoff*/) const override {
    SurfaceParts all;
    for (std::size_t i = 0; i < 3; ++i) {
      const SlabMeeting<Ring>& slab = met(i);
      const Scaled condition = sizes().normals[i] / (approximate(ray().scale) * norm(slab.normal));
      // A line in a plane is exactly in it, however its distance is measured.
      const auto apart = [&](const Ring& bound) {
        return sign(slab.beyond(bound, t)) == 0 ? Scaled{} : distance(i, bound, t);
      };
      all.push_back({{-slab.normal}, apart(slab.low), condition});
      all.push_back({{slab.normal}, apart(slab.high), condition});
    }
    return all;
  }

 protected:
  [[nodiscard]] const SlabMeeting<Ring>& met(std::size_t slab) const { return met_.at(slab); }
  /// How far p(t) is from one plane of a slab, in the contract's units.
  [[nodiscard]] virtual Scaled distance(std::size_t slab, const Ring& bound, const Quotient& t) const {
    return distance_to(slab, met(slab), bound, t, sizes());
  }

 private:
  SlabMeetings<Ring> met_;
};

}  // namespace rayproof::oracle
