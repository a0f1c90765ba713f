/// \file
/// The oracle for ray and disk.

#include "oracle/shapes/flat.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

class DiskIntersection final : public FlatIntersection {
 public:
  DiskIntersection(const RayQuestion& question, const Disk<double>& disk)
      : FlatIntersection(question, plane_through(disk.center, Vector<Ring>::from(disk.normal))),
        disk_(disk) {}

  [[nodiscard]] Scaled margin(bool may_merge) const override {
    Scaled nearest = FlatIntersection::margin(may_merge);
    reduce(nearest, steepness());
    if (!is_parallel()) reduce(nearest, from_rim());
    return nearest;
  }

 protected:
  [[nodiscard]] Contact contact_at(const Quotient& t) const override {
    const int side = sign(beyond(t));
    return side > 0 ? Contact::none : side == 0 ? Contact::rim : Contact::crossing;
  }
  [[nodiscard]] Scaled position() const override { return norm(disk_.center) + Scaled(disk_.radius); }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override { return {norm(disk_.normal)}; }

 private:
  /// What the lengths below are multiplied with: t's denominator, in the scale of ObjectRay.
  [[nodiscard]] Ring weight(const Quotient& t) const { return t.denominator() * ray().scale; }
  /// The point at t as seen from the centre.
  [[nodiscard]] Vector<Ring> from_center(const Quotient& t) const {
    return t.denominator() * (ray().origin - ray().scale * Vector<Ring>::from(disk_.center)) +
           t.numerator() * ray().direction;
  }
  /// |point - center|² - radius²: its sign says whether the point at t is outside, on the rim or inside.
  [[nodiscard]] Ring beyond(const Quotient& t) const {
    const Vector<Ring> q = from_center(t);
    const Ring radius = Ring(disk_.radius) * weight(t);
    return dot(q, q) - radius * radius;
  }

  /// ||point - center| - radius|·s / L(t), with s = steepness.
  [[nodiscard]] Scaled from_rim() const {
    const Quotient at = t();
    const Scaled whole = abs(approximate(weight(at)));
    const Scaled sum = norm(from_center(at)) + Scaled(disk_.radius) * whole;
    const Scaled distance = ratio(ratio(abs(approximate(beyond(at))), sum), whole);
    return ratio(distance * steepness(), sizes().reach(at.estimate()));
  }

  const Disk<double>& disk_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Disk<double>& disk) {
  return std::make_unique<DiskIntersection>(question, disk);
}

}  // namespace rayproof::oracle
