/// \file
/// The oracle for ray and parallelepiped.

#include <algorithm>

#include "oracle/geometry/clearance.hpp"
#include "oracle/shapes/solid_meeting.hpp"

namespace rayproof::oracle {
namespace {

/// What the sizes of a judgement are made of.
template <class Size>
struct ParallelepipedLengths {
  Size corner;
  std::array<Size, 3> edges;

  explicit ParallelepipedLengths(const Parallelepiped<double>& solid)
      : corner(length_of(solid.corner)),
        edges{Size(length_of(solid.edges[0])), Size(length_of(solid.edges[1])),
              Size(length_of(solid.edges[2]))} {}

  [[nodiscard]] Size position() const { return corner + edges[0] + edges[1] + edges[2]; }
  [[nodiscard]] std::array<Size, 3> normals() const {
    return {edges[1] * edges[2], edges[2] * edges[0], edges[0] * edges[1]};
  }
  /// 1 over the volume of the solid with edges of length 1.
  template <class R>
  [[nodiscard]] double far(const ObjectRay<R>& ray, const SlabMeeting<R>& met) const {
    return value(approximate(ray.scale) * (edges[0] * edges[1] * edges[2]) / approximate(met.high - met.low));
  }
};

class ParallelepipedMeeting final : public SolidMeeting {
 public:
  ParallelepipedMeeting(const RayQuestion& question, const Parallelepiped<double>& solid)
      : SolidMeeting(question, solid), solid_(solid) {}

  void measure() {
    lengths_.emplace(solid_);
    measure_by(lengths_->position(), lengths_->normals());
  }
  [[nodiscard]] double far() const { return lengths_->far(ray(), met(0)); }

 private:
  const Parallelepiped<double>& solid_;
  std::optional<ParallelepipedLengths<long double>> lengths_;
};

class ParallelepipedIntersection final : public SolidIntersection {
 public:
  ParallelepipedIntersection(const RayQuestion& question, const Parallelepiped<double>& solid)
      : SolidIntersection(question, solid), solid_(solid) {}

  /// How near the ray comes to an edge between a face that it enters by and one that it leaves by, or one of
  /// its ends to the solid's surface; of two hits taken for one, also how thin the solid is.
  [[nodiscard]] Scaled margin(bool may_merge) const override {
    Scaled nearest = distance_to_edges(question().ray.t_min, question().ray.t_max, true);
    for (const double end : finite_ends(question().ray)) {
      reduce(nearest, distance_to_edges(end, end, false));
      for (std::size_t slab = 0; slab < 3; ++slab)
        for (const Ring& bound : {met(slab).low, met(slab).high})
          reduce(nearest, height_over_face(slab, bound, end));
    }
    for (std::size_t slab = 0; may_merge && slab < 3; ++slab) {
      const Scaled normal = sqrt(approximate(dot(met(slab).normal, met(slab).normal)));
      const Scaled thickness = approximate(met(slab).high - met(slab).low) / normal;
      reduce(nearest, thickness / (approximate(ray().scale) * sizes().origin));
    }
    return nearest;
  }

  [[nodiscard]] double far() const override {
    return ParallelepipedLengths<Scaled>(solid_).far(ray(), met(0));
  }

 protected:
  [[nodiscard]] Scaled position() const override { return ParallelepipedLengths<Scaled>(solid_).position(); }
  [[nodiscard]] std::array<Scaled, 3> normal_sizes() const override {
    return ParallelepipedLengths<Scaled>(solid_).normals();
  }

 private:
  /// The least distance of the ray between two t from the solid's edges, in units of L(t). An edge in the
  /// `outline` has a face on each side of which the ray enters by one and leaves by the other, or runs along
  /// it.
  [[nodiscard]] Scaled distance_to_edges(double t_min, double t_max, bool outline) const {
    const Scaled scale = approximate(ray().scale);
    const RayPart part{ray().direction, t_min, t_max, scale * sizes().origin, scale * sizes().direction};
    const auto edge = [&](std::size_t i) { return Vector<Ring>::from(solid_.edges[i % 3]); };
    const auto seen = [&](const Vector<Ring>& place) { return ray().scale * place - ray().origin; };
    Scaled nearest = endless();
    for (std::size_t i = 0; i < 3; ++i)
      for (const int j : {0, 1})
        for (const int k : {0, 1}) {
          const int turn = (j == k ? 1 : -1) * sign(met((i + 1) % 3).speed) * sign(met((i + 2) % 3).speed);
          if (outline && turn > 0) continue;
          const Vector<Ring> from =
              Vector<Ring>::from(solid_.corner) + Ring(j) * edge(i + 1) + Ring(k) * edge(i + 2);
          reduce(nearest, part.distance_to(seen(from), seen(from + edge(i))));
        }
    return nearest;
  }

  /// The distance of p(t) from a face in units of L(t), where its foot on the face's plane lies in the face;
  /// endless beside it, where its edges are nearest.
  [[nodiscard]] Scaled height_over_face(std::size_t slab, const Ring& bound, double t) const {
    const Vector<Ring>& normal = met(slab).normal;
    const Ring squared = dot(normal, normal), height = met(slab).position + met(slab).speed * Ring(t) - bound;
    const Vector<Ring> foot = squared * (ray().origin + Ring(t) * ray().direction) - height * normal;
    for (const std::size_t other : {(slab + 1) % 3, (slab + 2) % 3}) {
      const Ring place = dot(met(other).normal, foot);
      if (sign(place - squared * met(other).low) < 0 || sign(squared * met(other).high - place) < 0)
        return endless();
    }
    const Scaled reach = approximate(ray().scale) * sizes().reach(Scaled(t));
    return ratio(abs(approximate(height)), sqrt(approximate(squared)) * reach);
  }

  const Parallelepiped<double>& solid_;
};

}  // namespace

ExactPointer intersection_of(const RayQuestion& question, const Parallelepiped<double>& solid) {
  return std::make_unique<ParallelepipedIntersection>(question, solid);
}

Judgement judge(const RayQuestion& question, const Parallelepiped<double>& solid, Precision precision,
                const RayAnswer& claimed) {
  return judge_quickly<ParallelepipedMeeting>(question, solid, precision, claimed);
}

}  // namespace rayproof::oracle
