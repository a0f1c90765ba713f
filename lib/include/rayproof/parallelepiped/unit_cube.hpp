#pragma once
#include <rayproof/box/slabs.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/parallelepiped.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parallelepiped {

/// The ray taken to the coordinates in which the solid is the unit cube, and that tested against the slabs of
/// a box: t is the same number in both.
///
/// The map is the inverse of the matrix of the edges, row i being nᵢ = eⱼ×eₖ over nᵢ·eᵢ. Where rounding
/// leaves nᵢ·eᵢ = 0, of edges that nearly lie in one plane, there is no such map and no hit.
struct UnitCube {
  static constexpr const char* name = "unit_cube";
  static constexpr const char* title = "mapped to the unit cube";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 0.651, .promised = 8, .far_power = 1},
      .residual = {.measured = 2.12, .promised = 8},
      .hit = parallelepiped_hit_bounds,
      .domain = {.reach_float = 16, .reach_double = 150, .every_number = true},
      .holds = always_claimed | hit_claims |
               Claims{Claim::verdict, Claim::residual, Claim::moved, Claim::scaled, Claim::reversed,
                      Claim::bounded, Claim::exact},
      .refuted = {{{Claim::robust, parallelepiped_normals_turn}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Parallelepiped<T>& solid) {
    step<T>("Invert the map from the unit cube",
            "The edges are the columns of the map; row i of its inverse is nᵢ / (nᵢ·eᵢ), where each n·e is "
            "the volume of the solid.");
    const auto& [e0, e1, e2] = solid.edges;
    const vec3<T> n0 = named("n₀", cross(e1, e2));
    const vec3<T> n1 = named("n₁", cross(e2, e0));
    const vec3<T> n2 = named("n₂", cross(e0, e1));
    const vec3<T> volume = named("n·e", vec3<T>{dot(n0, e0), dot(n1, e1), dot(n2, e2)});

    step<T>("Take the ray to the unit cube",
            "The inverse map applies to origin and direction alike, so t is the same; from here on o and d "
            "are the ray in the cube's space.");
    const vec3<T> f = named("f", ray.origin - solid.corner);
    const vec3<T> d = ray.direction;
    const vec3<T> origin =
        named("o", vec3<T>{dot(n0, f) / volume.x, dot(n1, f) / volume.y, dot(n2, f) / volume.z});
    const vec3<T> direction =
        named("d", vec3<T>{dot(n0, d) / volume.x, dot(n1, d) / volume.y, dot(n2, d) / volume.z});

    const Box<T> cube{{T(0), T(0), T(0)}, {T(1), T(1), T(1)}};
    return box::Slabs::roots(Ray<T>{origin, direction, ray.t_min, ray.t_max}, cube);
  }
};

}  // namespace rayproof::parallelepiped

#include <rayproof/rounding/as_before.hpp>
