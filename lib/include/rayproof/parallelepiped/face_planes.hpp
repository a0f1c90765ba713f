#pragma once
#include <rayproof/box/slab.hpp>
#include <rayproof/method/method.hpp>
#include <rayproof/parallelepiped.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parallelepiped {

/// One pair of parallel faces: with n = eⱼ×eₖ, their planes are `near_plane` = n·f and n·f + n·eᵢ ahead of a
/// ray that gains `speed` = n·d per unit of t, where f = corner - origin; `apart` is n·eᵢ.
///
/// Edges of the other handedness make n·eᵢ negative, and the second plane the first. Each pair has its own
/// n·eᵢ: in real numbers all three are one determinant, but rounded ones may differ in sign.
template <class T>
[[nodiscard]] constexpr box::Slab<T> slab_between_faces(const T& speed, const T& near_plane, const T& apart) {
  const T far_plane = near_plane + apart;
  const Mask<T> is_mirrored = apart < T(0);
  return box::slab_of(speed, select(is_mirrored, far_plane, near_plane),
                      select(is_mirrored, near_plane, far_plane));
}

/// Three pairs of parallel planes, met as the slabs of a box are.
///
/// A normal is off by a few ε of its edges' lengths. Of edges that nearly lie in one plane that turns it: the
/// ray may then meet a face far beside the solid, so the band grows with 1 over the volume. Edges that lie in
/// one plane span no solid; here they are taken for a flat one.
struct FacePlanes {
  static constexpr const char* name = "face_planes";
  static constexpr const char* title = "three pairs of parallel planes";
  static constexpr Source source{"E. Haines", "Fast Ray-Convex Polyhedron Intersection, Graphics Gems II",
                                 1991};
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 0.664, .promised = 8, .far_power = 1},
      .residual = {.measured = 2.13, .promised = 8},
      .hit = parallelepiped_hit_bounds,
      .domain = {.reach_float = 16, .reach_double = 150, .every_number = true},
      .holds = always_claimed | hit_claims |
               Claims{Claim::verdict, Claim::residual, Claim::moved, Claim::scaled, Claim::reversed,
                      Claim::bounded, Claim::exact},
      .refuted = {{{Claim::robust, parallelepiped_normals_turn}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Parallelepiped<T>& solid) {
    step<T>("Take the normals of the faces",
            "Each is the cross product of the two edges that span a pair of faces.");
    const auto& [e0, e1, e2] = solid.edges;
    const vec3<T> n0 = named("n₀", cross(e1, e2));
    const vec3<T> n1 = named("n₁", cross(e2, e0));
    const vec3<T> n2 = named("n₂", cross(e0, e1));

    step<T>(
        "Meet each pair of faces",
        "Two faces with one normal n bound a slab; the ray meets them at "
        "t = n·f / (n·d) and t = (n·f + n·e) / (n·d). In real numbers all three n·e are the volume of the "
        "solid.");
    const vec3<T> f = named("f", solid.corner - ray.origin);
    const vec3<T> d = ray.direction;
    const auto slab = [&](const vec3<T>& n, const vec3<T>& edge, const char* ahead, const char* thickness) {
      const T near_plane = named(ahead, dot(n, f));
      const T apart = named(thickness, dot(n, edge));
      return slab_between_faces<T>(dot(n, d), near_plane, apart);
    };
    const box::Slab<T> slab0 = slab(n0, e0, "n₀·f", "n₀·e₀");
    const box::Slab<T> slab1 = slab(n1, e1, "n₁·f", "n₁·e₁");
    const box::Slab<T> slab2 = slab(n2, e2, "n₂·f", "n₂·e₂");
    const auto [entry, exit] = box::overlap(slab0, slab1, slab2);
    return chord(entry, exit);
  }
};

}  // namespace rayproof::parallelepiped

#include <rayproof/rounding/as_before.hpp>
