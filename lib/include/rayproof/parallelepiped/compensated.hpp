#pragma once
#include <rayproof/box/exact_slab.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/parallelepiped.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parallelepiped {

/// FacePlanes with nothing rounded before the last step: normals, distances and every comparison of two t are
/// exact, so the verdict is the exact one, and an edge or corner that is touched counts once.
///
/// An answer is never rounded across an end of the ray's interval; entry and exit may round to one number and
/// are still two, with a discriminant of 1. Holds for all finite floats; for doubles while every number that
/// is not 0 lies within 2^±120, beyond which the products, of degree six, over- or underflow. Dependent edges
/// span no solid and are missed.
struct Compensated {
  static constexpr const char* name = "compensated";
  static constexpr const char* title = "face planes compared exactly by expansions";
  static constexpr Source source = sources::shewchuk;
  static constexpr Contract contract{
      .verdict = {.measured = 0, .promised = 0, .is_proven = true},
      .residual = {.measured = 0.474, .promised = 2},
      .ulp = {.measured = 0.5, .promised = 0.501},
      .hit = parallelepiped_hit_bounds,
      .domain = {.reach_float = 1000, .reach_double = 120, .every_number = true},
      .holds = robust_claims | hit_claims | Claims{Claim::residual, Claim::ulp, Claim::rounded}};

  template <std::floating_point T>
  [[nodiscard]] static Roots<T> roots(const Ray<T>& ray, const Parallelepiped<T>& solid) {
    const auto& [e0, e1, e2] = solid.edges;
    if (!are_finite(ray.origin, ray.direction, solid.corner, e0, e1, e2)) return no_roots<T>;

    step<T>("Form the normals and the distance to each face exactly",
            "Nothing is rounded; where the volume is exactly 0, the edges lie in one plane and there is no "
            "solid.");
    const auto f = exact_vector<double>(solid.corner) - exact_vector<double>(ray.origin);
    const auto d = exact_vector<double>(ray.direction);
    const std::array edges{exact_vector<double>(e0), exact_vector<double>(e1), exact_vector<double>(e2)};
    const auto volume = dot(cross(edges[1], edges[2]), edges[0]);
    if (sign(volume) == 0) return no_roots<T>;
    const auto slab = [&](std::size_t j, std::size_t k) {
      const auto n = cross(edges[j], edges[k]);
      const auto near_plane = dot(n, f) + decltype(volume)();
      const auto far_plane = dot(n, f) + volume;
      const bool is_mirrored = sign(volume) < 0;
      return box::ExactSlab(dot(n, d), is_mirrored ? far_plane : near_plane,
                            is_mirrored ? near_plane : far_plane);
    };

    return box::exact_chord(ray, std::array{slab(1, 2), slab(2, 0), slab(0, 1)});
  }
};

}  // namespace rayproof::parallelepiped

#include <rayproof/rounding/as_before.hpp>
