#pragma once
/// \file
/// What the shapes bounded by planes share: the units that distances from the planes are measured in; and for
/// the flat ones, plane, triangle and polygon, the exact intersection with a ray.

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

/// The plane normal·q = offset in the object's space.
struct FlatEquation {
  Vector<Ring> normal;
  Ring offset;
};

/// The plane through a point.
[[nodiscard]] inline FlatEquation plane_through(const glm::dvec3& point, const Vector<Ring>& normal) {
  return {normal, dot(normal, Vector<Ring>::from(point))};
}

/// One hit at most, where the ray's line meets the plane within the shape: slope·t = gap, in the scale of
/// ObjectRay. A shape without area has a normal of 0.
class FlatIntersection : public PlanarIntersection {
 public:
  FlatIntersection(const RayQuestion& question, FlatEquation plane)
      : PlanarIntersection(question),
        normal_(std::move(plane.normal)),
        gap_(ray().scaled(plane.offset) - dot(normal_, ray().origin)),
        slope_(dot(normal_, ray().direction)) {}

  [[nodiscard]] ExactContacts hits() const override {
    ExactContacts all;
    if (is_parallel()) return all;
    Quotient at = t();
    const bool is_asked = is_in_interval(at, question().ray.t_min, question().ray.t_max);
    const Contact contact = is_asked ? contact_at(at) : Contact::none;
    if (contact != Contact::none) all.push_back({std::move(at), contact});
    return all;
  }
  [[nodiscard]] Contact miss() const override {
    if (!is_parallel()) return Contact::none;
    if (is_degenerate()) return Contact::degenerate;
    return sign(gap_) == 0 ? Contact::in_surface : Contact::parallel;
  }
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact&) const override {
    return ExactNormal{normal_};
  }

  [[nodiscard]] Scaled residual(const Quotient& t) const override {
    const Ring height = slope_ * t.numerator() - gap_ * t.denominator();
    const Scaled off = abs(roughly(height)) / approximate(t.denominator());
    return ratio(off, sizes().unit(0, t.estimate()));
  }
  [[nodiscard]] Scaled off_surface(const Vector<Ring>& point, const Quotient& t) const override {
    const Ring height = dot(normal_, point - ray().origin) - gap_;
    return ratio(abs(approximate(height)), sizes().unit(0, t.estimate()));
  }
  [[nodiscard]] SurfaceParts parts(const Quotient&, const Scaled&) const override {
    if (is_degenerate()) return {};
    SurfaceParts plane;
    plane.push_back({{normal_}, {}, size_of_products() / norm(normal_)});
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

  [[nodiscard]] const Vector<Ring>& plane_normal() const { return normal_; }
  /// What the products are as large as that the normal is the sum of.
  [[nodiscard]] virtual Scaled size_of_products() const {
    return sizes().normals[0] / approximate(ray().scale);
  }
  [[nodiscard]] bool is_degenerate() const {
    return sign(normal_.x) == 0 && sign(normal_.y) == 0 && sign(normal_.z) == 0;
  }
  [[nodiscard]] bool is_parallel() const { return sign(slope_) == 0; }
  /// normal·point - offset of a point seen from the ray's origin, in the scale of ObjectRay.
  [[nodiscard]] Ring height_of(const Vector<Ring>& point) const { return dot(normal_, point) - gap_; }
  /// normal·p(t) - offset.
  [[nodiscard]] Ring height_at(double t) const { return slope_ * Ring(t) - gap_; }
  /// Of a line that is not parallel.
  [[nodiscard]] Quotient t() const { return {gap_, slope_}; }
  /// |normal·direction| / (N·|direction|): how near the ray is to being parallel.
  [[nodiscard]] Scaled steepness() const {
    return ratio(abs(approximate(slope_)), sizes().normals[0] * sizes().direction);
  }

 private:
  Vector<Ring> normal_;
  Ring gap_, slope_;
};

}  // namespace rayproof::oracle
