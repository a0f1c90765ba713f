#pragma once
#include <array>
#include <rayproof/box/bounded_slab.hpp>
#include <rayproof/box/exact_slab.hpp>
#include <rayproof/formulas/bounded_roots.hpp>
#include <rayproof/formulas/quotient_error.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/parallelepiped.hpp>
#include <rayproof/parallelepiped/correction.hpp>
#include <rayproof/parallelepiped/face_planes.hpp>
#include <rayproof/parallelepiped/prepared.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parallelepiped {

/// Correctly rounded: the verdict is the exact one, and each t the exact t rounded once, ties to even.
///
/// The slabs of FacePlanes are met in double for a ray in float, in double-double for one in double, in packs
/// too; that answer stands where the error bound below leaves no doubt of which comes first, entry or exit,
/// and of the rounding of both, which is nearly everywhere. The rest goes to normals, distances and
/// comparisons of two t with nothing rounded before the last step, so that an edge or corner that is touched
/// counts once.
///
/// An answer is never rounded across an end of the ray's interval; entry and exit may round to one number and
/// are still two, with a discriminant of 1. Holds for all finite floats; for doubles while every number that
/// is not 0 lies within 2^±120, beyond which the products, of degree six, over- or underflow; under a
/// transform within 2^±24. Dependent edges span no solid and are missed.
struct Rounded {
  static constexpr const char* name = "rounded";
  static constexpr const char* title =
      "correctly rounded: face planes with more digits, exact where in doubt";
  static constexpr Source source = sources::ziv;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 0.474, .promised = 2},
      .ulp = {.measured = 0.5, .promised = 0.501},
      .hit = parallelepiped_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 120, .every_number = true},
      .holds =
          robust_claims | hit_claims | Claims{Claim::residual, Claim::ulp, Claim::rounded, Claim::bounded}};

  /// What is tried first where the nearest hit alone is asked for.
  using Correction = parallelepiped::Correction;

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots(const Ray<T>& ray, const Parallelepiped<T>& solid) {
    return quick_or_exact_roots<Rounded>(ray, solid);
  }

  /// By expansions alone.
  template <std::floating_point T>
  [[nodiscard]] static Roots<T> exact_roots(const Ray<T>& ray, const Parallelepiped<T>& solid) {
    return met_exactly<Rounded>(ray, solid);
  }

  /// The same under a transform.
  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots_in_world(const ObjectSpace<T>& space, const Ray<T>& ray,
                                               const Parallelepiped<T>& solid) {
    return quick_or_exact_roots<Rounded>(space, ray, solid);
  }

  /// FacePlanes of a ray in object space whose numbers have bounds on their errors.
  template <class W>
  [[nodiscard]] static constexpr Enclosed<W> enclosed_in_space(const Ray<Bounded<W>>& ray,
                                                               const Parallelepiped<Bounded<W>>& solid) {
    return enclosed_by_bounds(FacePlanes::roots(ray, solid));
  }

  /// The chord of a ray from o along d, as met_exactly has them.
  template <std::floating_point T, class Number, class Unit>
  [[nodiscard]] static Roots<T> meet(const Ray<T>& ray, const Parallelepiped<T>& solid, const Vec3<Number>& o,
                                     const Vec3<Number>& d, const Unit& unit) {
    const auto& [e0, e1, e2] = solid.edges;
    if (!are_finite(solid.corner, e0, e1, e2)) return no_roots<T>;
    step<T>("Form the normals and the distance to each face exactly",
            "Nothing is rounded; where the volume is exactly 0, the edges lie in one plane and there is no "
            "solid.");
    const auto f = unit * exact_vector<double>(solid.corner) - o;
    const std::array edges{exact_vector<double>(e0), exact_vector<double>(e1), exact_vector<double>(e2)};
    const auto volume = unit * dot(cross(edges[1], edges[2]), edges[0]);
    if (sign(volume) == 0) return no_roots<T>;
    const bool is_mirrored = sign(volume) < 0;
    const auto slab = [&](std::size_t j, std::size_t k) {
      const auto n = cross(edges[j], edges[k]);
      const auto near_plane = dot(n, f) + decltype(volume)();
      const auto far_plane = dot(n, f) + volume;
      return box::ExactSlab(dot(n, d), is_mirrored ? far_plane : near_plane,
                            is_mirrored ? near_plane : far_plane);
    };

    return box::exact_chord(ray, std::array{slab(1, 2), slab(2, 0), slab(0, 1)});
  }

  /// What is known before the ray is.
  template <class W>
  [[nodiscard]] static constexpr Prepared<W> prepared(const Parallelepiped<W>& solid) {
    return prepared_faces(solid);
  }

  /// Three pairs of faces met in double on numbers that are floats, or in double-double on doubles, and what
  /// is known of it.
  ///
  /// With u the unit roundoff a normal, a cross product of two given edges, is off by no more than u of each
  /// component's size, and f = corner - o of each of its. So n·d and the volume n·e are off by 4.1u times the
  /// sizes of their terms, n·f by 5.1u, and n·f + n·e by 6.1u times the sizes of both.
  template <class W>
  [[nodiscard, gnu::always_inline]] static constexpr Enclosed<W> enclosed(const Ray<W>& ray,
                                                                          const Prepared<W>& solid) {
    const auto f = sized<W>(solid.corner - ray.origin), d = sized<W>(ray.direction);
    const auto& [first, second, third] = solid.pairs;
    return box::enclosed_chord(bounded_slab<W>(f, d, first), bounded_slab<W>(f, d, second),
                               bounded_slab<W>(f, d, third));
  }

 private:
  /// The slab between two faces. A ray is surely parallel to them where each term of n·d is 0, and then
  /// surely inside or outside where it is clear of both faces. Faces that may be one are not sure.
  template <class W>
  [[gnu::always_inline]] static constexpr box::BoundedSlab<W> bounded_slab(const Vec3<Sized<W>>& f,
                                                                           const Vec3<Sized<W>>& d,
                                                                           const FacePair<W>& pair) {
    const auto& [normal, apart] = pair;
    const Sized<W> speed = dot(normal, d), near_plane = dot(normal, f), far_plane = near_plane + apart;
    const auto [entry, exit] = slab_between_faces<W>(speed.value, near_plane.value, apart.value);
    using N = Leading<W>;
    const N per_speed = reciprocal_bound(abs(leading(speed.value)));
    const Mask<W> is_parallel = speed.size == N(0);
    const auto error_of = [&](const W& t) {
      return select(is_parallel, N(0), quotient_error(t, far_plane.size, speed.size, per_speed));
    };
    const Mask<W> is_clear = has_digits(near_plane) && has_digits(far_plane);
    return {entry, exit, error_of(entry), error_of(exit),
            (has_digits(speed) || (is_parallel && is_clear)) && has_digits(apart)};
  }
};

}  // namespace rayproof::parallelepiped

#include <rayproof/rounding/as_before.hpp>
