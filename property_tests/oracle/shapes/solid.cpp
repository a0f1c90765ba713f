/// \file
/// The oracle for ray and box, and for ray and parallelepiped.

#include <algorithm>

#include "oracle/geometry/slabs.hpp"
#include "oracle/shapes/planar.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

Quotient exactly(double t) { return {Ring(t), Ring(1.0)}; }

class SolidIntersection : public PlanarIntersection {
 public:
  SolidIntersection(const RayQuestion& question, const Slabs& slabs)
      : PlanarIntersection(question),
        slabs_(slabs),
        met_{SlabMeeting(ray(), slabs[0]), SlabMeeting(ray(), slabs[1]), SlabMeeting(ray(), slabs[2])},
        chord_(chord_of(met_)) {}

  [[nodiscard]] std::vector<ExactContact> hits() const override {
    std::vector<ExactContact> all;
    if (!chord_) return all;
    const bool is_touch = chord_->is_touch();
    const Contact contact = is_touch ? Contact::tangent : Contact::crossing;
    add(all, chord_->entry, contact);
    if (!is_touch) add(all, chord_->exit, contact);
    return all;
  }

  /// Outward from the face that holds the point; nothing on an edge or corner, where several do.
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact& hit) const override {
    const auto& t = std::get<Quotient>(hit.t);
    std::optional<ExactNormal> normal;
    int faces = 0;
    for (std::size_t i = 0; i < slabs_.size(); ++i) {
      const bool is_low = sign(met_[i].beyond(met_[i].low, t)) == 0;
      const bool is_high = sign(met_[i].beyond(met_[i].high, t)) == 0;
      if (is_low || is_high) normal = {is_high ? slabs_[i].normal : -slabs_[i].normal};
      faces += static_cast<int>(is_low) + static_cast<int>(is_high);
    }
    return faces == 1 ? normal : std::nullopt;
  }

  [[nodiscard]] Scaled residual(double t) const override {
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i) reduce(nearest, distance(i, exactly(t)));
    return nearest;
  }

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double end : finite_ends(question().ray)) reduce(nearest, distance(i, exactly(end)));
      for (std::size_t j = 0; j < 3; ++j) {
        if (i == j || met_[j].is_parallel()) continue;
        reduce(nearest, distance(i, met_[j].entry()));
        reduce(nearest, distance(i, met_[j].exit()));
      }
      reduce(nearest, thickness(i));
    }
    return nearest;
  }

 protected:
  /// How far p(t) is from one plane of a slab, in the contract's units.
  [[nodiscard]] virtual Scaled distance(std::size_t slab, const Ring& bound, const Quotient& t) const {
    return ratio(gap(slab, bound, t), sizes().unit(slab, t.estimate()));
  }
  /// The same from the nearer plane.
  [[nodiscard]] Scaled distance(std::size_t slab, const Quotient& t) const {
    return std::min(distance(slab, met_[slab].low, t), distance(slab, met_[slab].high, t));
  }
  /// How far the two planes of a slab are apart where the line meets them: two hits may round to one.
  [[nodiscard]] Scaled thickness(std::size_t slab) const {
    const SlabMeeting& met = met_[slab];
    // A slab of no thickness is met at one t by any method: its two planes are the same number.
    if (met.is_parallel() || sign(met.high - met.low) == 0) return endless();
    return distance(slab, sign(met.speed) > 0 ? met.high : met.low, met.entry());
  }

  [[nodiscard]] const SlabMeetings& met() const { return met_; }
  /// |position + t·speed - bound| of a slab.
  [[nodiscard]] Scaled gap(std::size_t slab, const Ring& bound, const Quotient& t) const {
    return abs(approximate(met_[slab].beyond(bound, t))) / approximate(t.denominator());
  }

 private:
  Slabs slabs_;
  SlabMeetings met_;
  std::optional<Chord> chord_;
};

class BoxIntersection final : public SolidIntersection {
 public:
  BoxIntersection(const RayQuestion& question, const Box<double>& box)
      : SolidIntersection(question, slabs_of(box)), box_(box) {}

 protected:
  [[nodiscard]] Scaled position() const override { return norm(box_.min) + norm(box_.max); }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    return {Scaled(1), Scaled(1), Scaled(1)};
  }
  /// A box in its own space: nothing is rounded but a difference and a quotient on each axis, so that
  /// distances are measured as |s - t| / (|s| + |t|) of the planes' own t.
  [[nodiscard]] Scaled distance(std::size_t slab, const Ring& bound, const Quotient& t) const override {
    if (question().transform) return SolidIntersection::distance(slab, bound, t);
    const SlabMeeting& axis = met()[slab];
    if (axis.is_parallel()) return endless();  // inside or outside is decided without rounding
    const Scaled run = abs(approximate(axis.speed) * t.estimate());
    const Scaled rise = abs(approximate(bound - axis.position));
    return ratio(gap(slab, bound, t), run + rise);
  }

 private:
  const Box<double>& box_;
};

class ParallelepipedIntersection final : public SolidIntersection {
 public:
  ParallelepipedIntersection(const RayQuestion& question, const Parallelepiped<double>& solid)
      : SolidIntersection(question, slabs_of(solid)), solid_(solid) {}

 protected:
  [[nodiscard]] Scaled position() const override {
    const auto& edges = solid_.edges;
    return norm(solid_.corner) + norm(edges[0]) + norm(edges[1]) + norm(edges[2]);
  }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    const Scaled e0 = norm(solid_.edges[0]), e1 = norm(solid_.edges[1]), e2 = norm(solid_.edges[2]);
    return {e1 * e2, e2 * e0, e0 * e1};
  }

 private:
  const Parallelepiped<double>& solid_;
};

}  // namespace

std::unique_ptr<MeasuredIntersection> intersection_of(const RayQuestion& question, const Box<double>& box) {
  return std::make_unique<BoxIntersection>(question, box);
}

std::unique_ptr<MeasuredIntersection> intersection_of(const RayQuestion& question,
                                                      const Parallelepiped<double>& solid) {
  return std::make_unique<ParallelepipedIntersection>(question, solid);
}

}  // namespace rayproof::oracle
