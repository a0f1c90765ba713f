/// \file
/// The oracle for ray and box, and for ray and parallelepiped.

#include <algorithm>

#include "oracle/geometry/slabs.hpp"
#include "oracle/shapes/flat.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {
namespace {

Scaled position_of(const Box<double>& box) { return norm(box.min) + norm(box.max); }
std::array<Scaled, 3> normal_sizes_of(const Box<double>&) { return {Scaled(1), Scaled(1), Scaled(1)}; }

Scaled position_of(const Parallelepiped<double>& solid) {
  return norm(solid.corner) + norm(solid.edges[0]) + norm(solid.edges[1]) + norm(solid.edges[2]);
}
std::array<Scaled, 3> normal_sizes_of(const Parallelepiped<double>& solid) {
  const Scaled e0 = norm(solid.edges[0]), e1 = norm(solid.edges[1]), e2 = norm(solid.edges[2]);
  return {e1 * e2, e2 * e0, e0 * e1};
}

template <class Solid>
class SolidIntersection final : public PlanarIntersection {
 public:
  SolidIntersection(const RayQuestion& question, const Solid& solid)
      : PlanarIntersection(question), solid_(solid), met_(meetings(ray(), solid)) {}

  [[nodiscard]] ExactContacts hits() const override {
    std::optional<Quotient> entry, exit;  // the normals are independent: no line is parallel to all slabs
    for (const SlabMeeting& slab : met_) {
      if (slab.is_parallel() && !slab.is_inside()) return {};
      if (slab.is_parallel()) continue;
      Quotient in = slab.entry(), out = slab.exit();
      if (!entry || in.compare(*entry) > 0) entry = std::move(in);
      if (!exit || out.compare(*exit) < 0) exit = std::move(out);
    }
    ExactContacts all;
    const int length = exit->compare(*entry);
    if (length >= 0) add(all, std::move(*entry), length == 0 ? Contact::tangent : Contact::crossing);
    if (length > 0) add(all, std::move(*exit), Contact::crossing);
    return all;
  }

  /// Outward from the face that holds the point; nothing on an edge or corner, where several do.
  [[nodiscard]] std::optional<ExactNormal> normal(const ExactContact& hit) const override {
    const auto& t = std::get<Quotient>(hit.t);
    std::optional<ExactNormal> normal;
    int faces = 0;
    for (const SlabMeeting& met : met_) {
      const bool is_low = sign(met.beyond(met.low, t)) == 0;
      const bool is_high = sign(met.beyond(met.high, t)) == 0;
      if (is_low || is_high) normal = {is_high ? met.normal : -met.normal};
      faces += static_cast<int>(is_low) + static_cast<int>(is_high);
    }
    return faces == 1 ? normal : std::nullopt;
  }

  [[nodiscard]] Scaled residual(const Quotient& t) const override {
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i) reduce(nearest, distance(i, t));
    return nearest;
  }
  [[nodiscard]] Scaled off_surface(const Vector<Ring>& point, const Quotient& t) const override {
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i) {
      const Ring position = dot(met_[i].normal, point);
      for (const Ring& gap : {position - met_[i].low, position - met_[i].high})
        reduce(nearest, ratio(abs(approximate(gap)), sizes().unit(i, t.estimate())));
    }
    return nearest;
  }

  /// The six faces.
  [[nodiscard]] SurfaceParts parts(const Quotient& t) const override {
    SurfaceParts all;
    for (std::size_t i = 0; i < 3; ++i) {
      const SlabMeeting& met = met_[i];
      const Scaled condition = sizes().normals[i] / (approximate(ray().scale) * norm(met.normal));
      // A line in a plane is exactly in it, however its distance is measured.
      const auto apart = [&](const Ring& bound) {
        return sign(met.beyond(bound, t)) == 0 ? Scaled{} : distance(i, bound, t);
      };
      all.push_back({{-met.normal}, apart(met.low), condition});
      all.push_back({{met.normal}, apart(met.high), condition});
    }
    return all;
  }

  /// The line is in the solid where it has come into every slab and left none: the condition that is broken
  /// most, or the one that holds most narrowly. An end of the ray counts where the line meets the solid.
  [[nodiscard]] Scaled margin(bool may_merge) const override {
    Scaled narrowest = endless();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (i != j || may_merge)
          reduce(narrowest, met_[i].is_parallel() ? depth(i, Quotient(0.0)) : lead(i, j));
    Scaled nearest = abs(narrowest), beyond;
    for (const double end : finite_ends(question().ray)) {
      const Quotient at(end);
      Scaled inside = endless();
      for (std::size_t i = 0; i < 3; ++i) {
        const SlabMeeting& met = met_[i];
        reduce(inside, depth(i, at));
        const int side = sign(met.beyond(met.high, at)) > 0 ? 1 : std::min(sign(met.beyond(met.low, at)), 0);
        if (stays_beyond(side * sign(met.speed), end)) beyond = std::max(beyond, abs(depth(i, at)));
      }
      if (narrowest.sign() >= 0) reduce(nearest, abs(inside));
    }
    return std::max(nearest, beyond);
  }

 protected:
  [[nodiscard]] Scaled position() const override { return position_of(solid_); }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override { return normal_sizes_of(solid_); }

 private:
  /// How far p(t) is from one plane of a slab, in the contract's units. In a box's own space nothing is
  /// rounded but a difference and a quotient on each axis, so that distances there are measured as |s - t| /
  /// (|s| + |t|) of the planes' own t.
  [[nodiscard]] Scaled distance(std::size_t slab, const Ring& bound, const Quotient& t) const {
    const SlabMeeting& met = met_[slab];
    const bool is_box = std::is_same_v<Solid, Box<double>> && !question().transform;
    if (is_box && met.is_parallel()) return endless();  // inside or outside is decided without rounding
    const Scaled gap = abs(approximate(met.beyond(bound, t))) / approximate(t.denominator());
    if (!is_box) return ratio(gap, sizes().unit(slab, t.estimate()));
    const Scaled run = abs(approximate(met.speed) * t.estimate());
    return ratio(gap, run + abs(approximate(bound - met.position)));
  }
  /// The same from the nearer plane.
  [[nodiscard]] Scaled distance(std::size_t slab, const Quotient& t) const {
    return std::min(distance(slab, met_[slab].low, t), distance(slab, met_[slab].high, t));
  }
  /// How far inside a slab p(t) is; negative outside.
  [[nodiscard]] Scaled depth(std::size_t slab, const Quotient& t) const {
    const auto beyond = [&](const Ring& bound, int side) {
      const Scaled gap = distance(slab, bound, t);
      return side * sign(met_[slab].beyond(bound, t)) < 0 ? -gap : gap;
    };
    return std::min(beyond(met_[slab].low, 1), beyond(met_[slab].high, -1));
  }
  /// How long the line has come into slab i, to which it is not parallel, when it leaves slab j; negative
  /// where it has left before. Two hits of one slab may round to one, but a slab of no thickness is met at
  /// one t by any method: its two planes are the same number.
  [[nodiscard]] Scaled lead(std::size_t i, std::size_t j) const {
    const SlabMeeting &into = met_[i], &out_of = met_[j];
    if (out_of.is_parallel() || (i == j && sign(into.high - into.low) == 0)) return endless();
    const Quotient entry = into.entry(), exit = out_of.exit();
    const Scaled gap = std::min(distance(i, sign(into.speed) > 0 ? into.low : into.high, exit),
                                distance(j, sign(out_of.speed) > 0 ? out_of.high : out_of.low, entry));
    return exit.compare(entry) < 0 ? -gap : gap;
  }

  const Solid& solid_;
  SlabMeetings met_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Box<double>& box) {
  return std::make_unique<SolidIntersection<Box<double>>>(question, box);
}

ExactPointer intersection_of(const RayQuestion& question, const Parallelepiped<double>& solid) {
  return std::make_unique<SolidIntersection<Parallelepiped<double>>>(question, solid);
}

}  // namespace rayproof::oracle
