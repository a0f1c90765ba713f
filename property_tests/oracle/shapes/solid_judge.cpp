/// \file
/// The judges for box and parallelepiped.

#include <algorithm>

#include "oracle/geometry/slabs.hpp"
#include "oracle/judge/judging.hpp"
#include "oracle/shapes/solid.hpp"

namespace rayproof::oracle {
namespace {

/// Sizes of the slabs' normals, and of the solid with its distance from the origin of coordinates.
struct SolidSizes {
  std::array<Scaled, 3> normal;
  Scaled position;
};

class SolidFigure : public Figure {
 public:
  SolidFigure(const RayQuestion& question, const Slabs& slabs, const SolidSizes& solid)
      : question_(question),
        ray_(question),
        met_(meetings(ray_, slabs)),
        chord_(chord_of(met_)),
        sizes_(question, ray_),
        solid_(solid) {}

  [[nodiscard]] std::vector<ExactNumber> hits() const override {
    std::vector<ExactNumber> all;
    if (!chord_) return all;
    if (is_in_interval(chord_->entry, question_.ray)) all.emplace_back(chord_->entry);
    if (!chord_->is_touch() && is_in_interval(chord_->exit, question_.ray)) all.emplace_back(chord_->exit);
    return all;
  }

  [[nodiscard]] Scaled residual(double t) const override {
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i) reduce(nearest, distance(i, Quotient(Ring(t), Ring(1.0))));
    return nearest;
  }

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double end : finite_ends(question_.ray))
        reduce(nearest, distance(i, Quotient(Ring(end), Ring(1.0))));
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
    const Scaled scale = abs(approximate(ray_.scale));
    const Scaled reach = sizes_.origin + solid_.position + abs(t.estimate()) * sizes_.direction;
    return ratio(gap(slab, bound, t), scale * solid_.normal[slab] * reach);
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
    const bool is_upward = sign(met.speed) > 0;
    return distance(slab, is_upward ? met.high : met.low, met.entry());
  }

  [[nodiscard]] const SlabMeetings& met() const { return met_; }
  /// |position + t·speed - bound| of a slab.
  [[nodiscard]] Scaled gap(std::size_t slab, const Ring& bound, const Quotient& t) const {
    const Ring apart = (met_[slab].position - bound) * t.denominator() + met_[slab].speed * t.numerator();
    return abs(approximate(apart)) / approximate(t.denominator());
  }

 private:
  const RayQuestion& question_;
  ObjectRay<Ring> ray_;
  SlabMeetings met_;
  std::optional<Chord> chord_;
  RaySizes sizes_;
  SolidSizes solid_;
};

/// A box in its own space: nothing is rounded but a difference and a quotient on each axis, so that distances
/// are told as |s - t| / (|s| + |t|) of the planes' own t.
class BoxFigure final : public SolidFigure {
 public:
  using SolidFigure::SolidFigure;

 protected:
  [[nodiscard]] Scaled distance(std::size_t slab, const Ring& bound, const Quotient& t) const override {
    const SlabMeeting& axis = met()[slab];
    if (axis.is_parallel()) return endless();  // inside or outside is told without rounding
    const Scaled run = abs(approximate(axis.speed) * t.estimate());
    const Scaled rise = abs(approximate(bound - axis.position));
    return ratio(gap(slab, bound, t), run + rise);
  }
};

}  // namespace

Judgement judge(const RayQuestion& question, const Box<double>& box, Precision precision,
                const RayAnswer& claimed) {
  const SolidSizes sizes{{Scaled(1), Scaled(1), Scaled(1)}, norm(box.min) + norm(box.max)};
  if (question.transform)
    return judge_hits(question, SolidFigure(question, slabs_of(box), sizes), precision, claimed);
  return judge_hits(question, BoxFigure(question, slabs_of(box), sizes), precision, claimed);
}

Judgement judge(const RayQuestion& question, const Parallelepiped<double>& solid, Precision precision,
                const RayAnswer& claimed) {
  const Scaled e0 = norm(solid.edges[0]), e1 = norm(solid.edges[1]), e2 = norm(solid.edges[2]);
  const SolidSizes sizes{{e1 * e2, e2 * e0, e0 * e1}, norm(solid.corner) + e0 + e1 + e2};
  return judge_hits(question, SolidFigure(question, slabs_of(solid), sizes), precision, claimed);
}

}  // namespace rayproof::oracle
