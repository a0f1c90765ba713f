/// \file
/// The oracle for ray and box.

#include <algorithm>

#include "oracle/shapes/solid_meeting.hpp"

namespace rayproof::oracle {
namespace {

template <class Size>
Size position_of(const Box<double>& box) {
  return Size(length_of(box.min)) + Size(length_of(box.max));
}
template <class Size>
std::array<Size, 3> normal_sizes_of(const Box<double>&) {
  return {Size(1), Size(1), Size(1)};
}

/// In the box's own space nothing is rounded but a difference and a quotient on each axis, so that distances
/// there are measured as |s - t| / (|s| + |t|) of the planes' own t.
template <class R>
SizeOf<R> distance_along(const SlabMeeting<R>& met, const R& bound, const QuotientOf<R>& t) {
  using std::abs;
  if (met.is_parallel()) return endless_of<R>();  // inside or outside is decided without rounding
  const SizeOf<R> gap = abs(roughly(met.beyond(bound, t))) / approximate(t.denominator());
  const SizeOf<R> run = abs(approximate(met.speed) * t.estimate());
  return ratio(gap, run + abs(approximate(bound - met.position)));
}

/// The same over estimates.
class BoxMeeting final : public SolidMeeting {
 public:
  BoxMeeting(const RayQuestion& question, const Box<double>& box) : SolidMeeting(question, box), box_(box) {}

  void measure() { measure_by(position_of<long double>(box_), normal_sizes_of<long double>(box_)); }
  [[nodiscard]] double far() const { return 1; }
  [[nodiscard]] long double residual(double t) const {
    if (ray().map) return SolidMeeting::residual(t);
    return nearest([&](std::size_t, const auto& met, const Estimate& bound) {
      return distance_along(met, bound, QuotientOf<Estimate>(t));
    });
  }

 private:
  const Box<double>& box_;
};

class BoxIntersection final : public SolidIntersection {
 public:
  BoxIntersection(const RayQuestion& question, const Box<double>& box)
      : SolidIntersection(question, box), box_(box) {}

  /// The line is in the solid where it has come into every slab and left none: the condition that is broken
  /// most, or the one that holds most narrowly. An end of the ray counts where the line meets the solid.
  [[nodiscard]] Scaled margin(bool may_merge) const override {
    Scaled narrowest = endless();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (i != j || may_merge)
          reduce(narrowest, met(i).is_parallel() ? depth(i, Quotient(0.0)) : lead(i, j));
    Scaled nearest = abs(narrowest), beyond;
    for (const double end : finite_ends(question().ray)) {
      const Quotient at(end);
      Scaled inside = endless();
      for (std::size_t i = 0; i < 3; ++i) {
        const SlabMeeting<Ring>& met = this->met(i);
        reduce(inside, depth(i, at));
        const int side = sign(met.beyond(met.high, at)) > 0 ? 1 : std::min(sign(met.beyond(met.low, at)), 0);
        if (stays_beyond(side * sign(met.speed), end)) beyond = std::max(beyond, abs(depth(i, at)));
      }
      if (narrowest.sign() >= 0) reduce(nearest, abs(inside));
    }
    return std::max(nearest, beyond);
  }

  /// The six faces; of a slab of no thickness the one that the ray enters by, which faces it. How a transform
  /// rounds may turn a ray that nearly runs along it.
  [[nodiscard]] SurfaceParts parts(const Quotient& t, const Scaled& roundoff) const override {
    const SurfaceParts faces = SolidIntersection::parts(t, roundoff);
    if (question().transform) return faces;
    SurfaceParts met_by_ray;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_flat = sign(met(i).high - met(i).low) == 0;
      const int way = sign(met(i).speed);
      if (!is_flat || way >= 0) met_by_ray.push_back(faces[2 * i]);
      if (!is_flat || way <= 0) met_by_ray.push_back(faces[2 * i + 1]);
    }
    return met_by_ray;
  }

 protected:
  [[nodiscard]] Scaled position() const override { return position_of<Scaled>(box_); }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override { return normal_sizes_of<Scaled>(box_); }

  [[nodiscard]] Scaled distance(std::size_t slab, const Ring& bound, const Quotient& t) const override {
    if (question().transform) return SolidIntersection::distance(slab, bound, t);
    return distance_along(met(slab), bound, t);
  }

 private:
  /// How far inside a slab p(t) is; negative outside.
  [[nodiscard]] Scaled depth(std::size_t slab, const Quotient& t) const {
    const auto beyond = [&](const Ring& bound, int side) {
      const Scaled gap = distance(slab, bound, t);
      return side * sign(met(slab).beyond(bound, t)) < 0 ? -gap : gap;
    };
    return std::min(beyond(met(slab).low, 1), beyond(met(slab).high, -1));
  }
  /// How long the line has come into slab i, to which it is not parallel, when it leaves slab j; negative
  /// where it has left before. Two hits of one slab may round to one, but a slab of no thickness is met at
  /// one t by any method: its two planes are the same number.
  [[nodiscard]] Scaled lead(std::size_t i, std::size_t j) const {
    const SlabMeeting<Ring>&into = met(i), &out_of = met(j);
    if (out_of.is_parallel() || (i == j && sign(into.high - into.low) == 0)) return endless();
    const Quotient entry = into.entry(), exit = out_of.exit();
    const Scaled gap = std::min(distance(i, sign(into.speed) > 0 ? into.low : into.high, exit),
                                distance(j, sign(out_of.speed) > 0 ? out_of.high : out_of.low, entry));
    return exit.compare(entry) < 0 ? -gap : gap;
  }

  const Box<double>& box_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Box<double>& box) {
  return std::make_unique<BoxIntersection>(question, box);
}

Judgement judge(const RayQuestion& question, const Box<double>& box, Precision precision,
                const RayAnswer& claimed) {
  return judge_quickly<BoxMeeting>(question, box, precision, claimed);
}

}  // namespace rayproof::oracle
