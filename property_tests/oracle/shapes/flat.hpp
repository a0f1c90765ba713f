#pragma once
/// \file
/// What the shapes bounded by planes share: the units that distances from the planes are measured in; and for
/// the flat ones, plane, triangle and polygon, the exact intersection with a ray.

#include "oracle/geometry/flat_equation.hpp"
#include "oracle/geometry/sizes.hpp"
#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {

/// The lengths that the units of a contract are made of.
template <class R>
struct PlanarSizes {
  using Size = SizeOf<R>;

  Size origin;                  ///< the ray's, and the distance of the shape's numbers from (0, 0, 0)
  Size direction;               ///< the ray's
  std::array<Size, 3> normals;  ///< the planes', in the scale of ObjectRay

  /// `position` bounds the distance of the shape's numbers from (0, 0, 0), `given` the lengths of the planes'
  /// normals as these numbers give them.
  PlanarSizes(const RayQuestion& question, const ObjectRay<R>& ray, const Size& position,
              const std::array<Size, 3>& given)
      : normals(given) {
    const RaySizes<R> of_ray(question, ray);
    origin = of_ray.origin + position;
    direction = of_ray.direction;
    if (!ray.map) return;
    const Size scale = approximate(ray.scale);
    for (Size& normal : normals) normal = scale * normal;
  }

  /// L(t) of the contracts.
  [[nodiscard]] Size reach(const Size& t) const {
    using std::abs;
    return origin + abs(t) * direction;
  }
  /// |normal|·L(t).
  [[nodiscard]] Size unit(std::size_t plane, const Size& t) const { return normals[plane] * reach(t); }
};

class PlanarIntersection : public ExactIntersection {
 public:
  using ExactIntersection::ExactIntersection;

 protected:
  /// Bounds the distance of the shape's numbers from (0, 0, 0).
  [[nodiscard]] virtual Scaled position() const = 0;
  /// Bounds the lengths of the planes' normals as the shape's numbers give them.
  [[nodiscard]] virtual std::array<Scaled, 3> normal_sizes() const = 0;

  [[nodiscard]] const PlanarSizes<Ring>& sizes() const {
    if (!sizes_) sizes_.emplace(question(), ray(), position(), normal_sizes());
    return *sizes_;
  }

 private:
  mutable std::optional<PlanarSizes<Ring>> sizes_;
};

/// Where a line meets a plane: slope·t = gap, in the scale of ObjectRay.
template <class R>
struct LineAndPlane {
  Vector<R> normal;
  R gap, slope;

  LineAndPlane(const ObjectRay<R>& ray, FlatEquation<R> plane)
      : normal(std::move(plane.normal)),
        gap(ray.scaled(plane.offset) - dot(normal, ray.origin)),
        slope(dot(normal, ray.direction)) {}

  [[nodiscard]] bool is_parallel() const { return sign(slope) == 0; }
  /// Of a line that is not parallel.
  [[nodiscard]] QuotientOf<R> t() const { return {gap, slope}; }
  /// How far p(t) is from the plane in the contract's units.
  [[nodiscard]] SizeOf<R> residual(const QuotientOf<R>& t, const PlanarSizes<R>& sizes) const {
    using std::abs;
    const R height = slope * t.numerator() - gap * t.denominator();
    const SizeOf<R> off = abs(roughly(height)) / approximate(t.denominator());
    return ratio(off, sizes.unit(0, t.estimate()));
  }
};

/// |normal·direction| / (N·|direction|): how near the ray is to being parallel.
template <class R>
[[nodiscard]] SizeOf<R> steepness_of(const LineAndPlane<R>& met, const PlanarSizes<R>& sizes) {
  using std::abs;
  return ratio(abs(approximate(met.slope)), sizes.normals[0] * sizes.direction);
}

/// The hit of a line where it is in the ray's interval and contact_at(t) touches the shape.
template <class R, class ContactAt>
[[nodiscard]] auto hits_of(const LineAndPlane<R>& met, const Ray<double>& ray, const ContactAt& contact_at) {
  boost::container::static_vector<HitAt<QuotientOf<R>>, 1> hits;
  if (met.is_parallel()) return hits;
  QuotientOf<R> at = met.t();
  const Contact contact = is_in_interval(at, ray.t_min, ray.t_max) ? contact_at(at) : Contact::none;
  if (contact != Contact::none) hits.push_back({std::move(at), contact});
  return hits;
}

/// One hit at most, where the ray's line meets the plane within the shape: slope·t = gap, in the scale of
/// ObjectRay. A shape without area has a normal of 0.
class FlatIntersection : public PlanarIntersection {
 public:
  FlatIntersection(const RayQuestion& question, FlatEquation<Ring> plane)
      : PlanarIntersection(question), met_(ray(), std::move(plane)) {}

  [[nodiscard]] ExactContacts hits() const override {
    ExactContacts all;
    for (auto& hit : hits_of(met_, question().ray, [&](const Quotient& t) { return contact_at(t); }))
      all.push_back({std::move(hit.t), hit.contact});
    return all;
  }
  [[nodiscard]] Contact miss() const override {
    if (!is_parallel()) return Contact::none;
    if (is_degenerate()) return Contact::degenerate;
    return sign(met_.gap) == 0 ? Contact::in_surface : Contact::parallel;
  }
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact&) const override {
    return ExactNormal{met_.normal};
  }

  [[nodiscard]] Scaled residual(const Quotient& t) const override { return met_.residual(t, sizes()); }
  [[nodiscard]] Scaled off_surface(const Vector<Ring>& point, const Quotient& t) const override {
    const Ring height = dot(met_.normal, point - ray().origin) - met_.gap;
    return ratio(abs(approximate(height)), sizes().unit(0, t.estimate()));
  }
  [[nodiscard]] SurfaceParts parts(const Quotient&, const Scaled&) const override {
    if (is_degenerate()) return {};
    SurfaceParts plane;
    plane.push_back({{met_.normal}, {}, size_of_products() / norm(met_.normal)});
    return plane;
  }
  /// Of the ends of the interval; and of an open end, how near the ray is to being parallel.
  [[nodiscard]] Scaled margin(bool) const override {
    const std::vector<double> ends = finite_ends(question().ray);
    Scaled nearest = ends.size() < 2 ? steepness() : endless();
    for (const double end : ends) reduce(nearest, residual(end));
    return nearest;
  }

 protected:
  /// How the line, not parallel, touches the shape where it meets the plane at t; none where it passes by.
  [[nodiscard]] virtual Contact contact_at(const Quotient&) const { return Contact::crossing; }

  [[nodiscard]] const LineAndPlane<Ring>& met() const { return met_; }
  [[nodiscard]] const Vector<Ring>& plane_normal() const { return met_.normal; }
  /// What the products are as large as that the normal is the sum of.
  [[nodiscard]] virtual Scaled size_of_products() const {
    return sizes().normals[0] / approximate(ray().scale);
  }
  [[nodiscard]] bool is_degenerate() const {
    const Vector<Ring>& n = met_.normal;
    return sign(n.x) == 0 && sign(n.y) == 0 && sign(n.z) == 0;
  }
  [[nodiscard]] bool is_parallel() const { return met_.is_parallel(); }
  /// normal·point - offset of a point seen from the ray's origin, in the scale of ObjectRay.
  [[nodiscard]] Ring height_of(const Vector<Ring>& point) const { return dot(met_.normal, point) - met_.gap; }
  /// normal·p(t) - offset.
  [[nodiscard]] Ring height_at(double t) const { return met_.slope * Ring(t) - met_.gap; }
  /// Of a line that is not parallel.
  [[nodiscard]] Quotient t() const { return met_.t(); }
  [[nodiscard]] Scaled steepness() const { return steepness_of(met_, sizes()); }

 private:
  LineAndPlane<Ring> met_;
};

}  // namespace rayproof::oracle
