#pragma once
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/method/contract.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/spawn/surface_point.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::spawn {

/// From the point moved onto the surface, by the least length for which it is proven that the rounded origin
/// is strictly on its side.
///
/// Promise: whatever the direction, if it leaves the surface at the foot of `point`, the exact ray from the
/// rounded origin does not meet that surface again; and into a solid that is thicker than twice the offset in
/// every direction, the origin is strictly inside. Domain: lengths within 2^±28 in float, 2^±240 in double;
/// round bodies at least 64ε times as wide, and parallelepipeds 32ε times as thick, as the scene's
/// coordinates are large.
///
/// Derivation, in the notation of SurfacePoint. Let o = point + h·v + ρ be the rounded origin, |ρᵢ| <=
/// ε(|pointᵢ| + 2h|vᵢ|) with room for second orders; roomᵢ = errorᵢ + ε|pointᵢ|, and w = Σroomᵢ >= |room|,
/// which needs no square root and stands in terms of second order alone.
///
/// Along the normal, v = normal: the distance of o above s along N is at least h·N·v - Σ|Nᵢ|roomᵢ - 4εh. With
/// |Nᵢ| <= |nᵢ| + tilt and N·v >= 1 - tilt²/2 - 6ε it is more than 0 for h = flat = (1 + 2tilt + 32ε)·reach,
/// reach = Σ|nᵢ|roomᵢ + tilt·w, as long as tilt <= 1/4; the factor covers the roundings of this very line,
/// too. Of a flat surface there is nothing else to prove.
///
/// A round surface is a sphere of radius r in the map's space; there o is a above s and beside it by L <= g(w
/// + h) at most, and the foot of `point` is beside s by gw: a direction that leaves at the foot may go down
/// at s by φ = gw/r. The ray passes the centre at no less than r if a(1 - φ²) >= 3rφ² + 2φ·gh, and a point b
/// below s is inside if 2rb - b² > L². With c = bend·w <= 1/16 both hold for h = flat + 5·bend·(w + flat)².
///
/// Where c or the tilt is larger (the rim of a squeezed object), v = radial: N·v = 1 whatever the tilt, o is
/// beside s by gw alone, and a(1 - φ²) >= 3rφ² holds for h = 2·reach + 8·bend·w² while φ <= 1/2.
///
/// What underflow takes is outweighed by `least_offset`. Measured: docs/leaving-the-surface.md.
struct Proven {
  static constexpr const char* name = "proven";
  static constexpr const char* title = "the least offset that is proven from the point's own bounds";
  static constexpr Source source{"rayproof", "docs/leaving-the-surface.md", 2026};
  static constexpr bool is_proven = true;
  static constexpr bool moves_to_surface = true;

  template <class T>
  [[nodiscard]] static constexpr vec3<T> origin(const SurfacePoint<T>& from) {
    step<T>("Bound what the rounded point may be off",
            "In each component, the surface is within the error of the point, and the origin will be rounded "
            "once more.");
    const vec3<T> room = named("room", named("e", from.error) + T(unit<T>) * magnitudes<T>(from.point));
    const T beside = named("w", sum<T>(room));

    step<T>("Measure it along the normal",
            "Only what lies along the normal can bring the origin to the wrong side; the normal itself is "
            "known to its tilt.");
    const T tilt = named("tilt", from.tilt);
    const T reach = named("reach", dot(magnitudes<T>(from.normal), room) + tilt * beside);
    const T flat = named("flat", (T(1 + 32 * unit<T>) + T(2) * tilt) * reach);

    step<T>("Add what the curvature takes",
            "A curved surface falls away from its tangent plane by the square of a distance.");
    const T bend = named("bend", from.bend);
    const T along_normal = from.is_flat ? flat : flat + T(5) * (bend * square(beside + flat));
    const Mask<T> is_along_normal =
        from.is_flat ? tilt <= T(0.25) : bend * beside <= T(0.0625) && tilt <= T(0.25);

    step<T>("Leave the surface by that much",
            "h is more than all roundings can take away, that of o′ among them: o′ lies on the side of n.");
    const auto moved = [&](const T& length, const vec3<T>& way) {
      return named("o′", from.point + named("h", length + T(least_offset<T>)) * way);
    };
    if (in_all_lanes(is_along_normal)) return moved(along_normal, from.normal);
    const T along_radial = from.is_flat ? T(2) * reach : T(2) * reach + T(8) * (bend * square(beside));
    return moved(select(is_along_normal, along_normal, along_radial),
                 select_vector<T>(is_along_normal, from.normal, from.radial));
  }
};

}  // namespace rayproof::spawn

#include <rayproof/rounding/as_before.hpp>
