#pragma once
#include <rayproof/method/contract.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/spawn/surface_point.hpp>

namespace rayproof::spawn {

/// From the point moved onto the surface, by the least length for which it is proven that the rounded origin
/// is strictly on its side.
///
/// Promise: whatever the direction, if it leaves the surface at the foot of the hit, the exact ray from the
/// rounded origin does not meet that surface again; and into a solid that is thicker than twice the offset in
/// every direction, the origin is strictly inside.
///
/// Derivation, in the notation of SurfacePoint. Let o = point + h·v + ρ be the rounded origin, |ρᵢ| <=
/// ε(|pointᵢ| + 2h|vᵢ|) with room for second orders, and roomᵢ = errorᵢ + ε|pointᵢ|.
///
/// Along the normal, v = normal: its distance above s along N is N·(o - s) >= h·N·v - Σ|Nᵢ|roomᵢ - 4εh. With
/// |Nᵢ| <= |nᵢ| + tilt and N·v >= 1 - tilt²/2 - 6ε it is more than 0 for h = (1 + 2tilt + 32ε)·reach, reach =
/// Σ(|nᵢ| + tilt)·roomᵢ, as long as tilt <= 1/4; the factor covers the roundings of this very line, too. Of a
/// flat surface there is nothing else to prove.
///
/// A curved one is left from beside s, by w <= Σroomᵢ + h at most, and bend·(w + slide)² more is needed. This
/// is of second order, and less than half of h nearly always; h then grows by half at most, and so does w.
///
/// Where it is not so, or the normal is tilted by more (a squeezed object's rim), v = radial: N·v = 1 whatever
/// the tilt, and from along `radial` nothing is beside s but by Σroomᵢ. There the factor is 2.
///
/// A flush to zero is outweighed by `least_offset`. Measured: docs/leaving-the-surface.md.
struct Proven {
  static constexpr const char* name = "proven";
  static constexpr const char* title = "the least offset that is proven from the point's own bounds";
  static constexpr Source source{"rayproof", "docs/leaving-the-surface.md", 2026};
  static constexpr bool is_proven = true;

  template <class T>
  [[nodiscard]] static constexpr vec3<T> origin(const SurfacePoint<T>& from) {
    step<T>("Bound what the rounded point may be off",
            "In each component, the surface is within the error of the point, and the origin will be rounded "
            "once more.");
    const vec3<T> room = named("room", from.error + T(unit<T>) * magnitudes<T>(from.point));
    const T beside = sum<T>(room);

    step<T>("Measure it along the normal",
            "Only what lies along the normal can bring the origin to the wrong side; the normal itself is "
            "known to its tilt.");
    const T reach = dot(magnitudes<T>(from.normal), room) + from.tilt * beside;
    const T flat = named("h", (T(1 + 32 * unit<T>) + T(2) * from.tilt) * reach);

    step<T>("Add what the curvature takes",
            "A curved surface falls away from its tangent plane by the square of a distance.");
    const T curved = from.bend * square(T(1.5) * flat + beside + from.slide);
    const Mask<T> is_along_normal = curved <= T(0.5) * flat && from.tilt <= T(0.25);
    const T along_radial = T(2) * (reach + from.bend * square(beside + from.slide));
    const T length = select(is_along_normal, flat + curved, along_radial) + T(least_offset<T>);

    step<T>("Leave the surface by that much", "Rounding has been paid for: nothing is rounded away.");
    const vec3<T> way{select(is_along_normal, from.normal.x, from.radial.x),
                      select(is_along_normal, from.normal.y, from.radial.y),
                      select(is_along_normal, from.normal.z, from.radial.z)};
    return named("o", from.point + length * way);
  }
};

}  // namespace rayproof::spawn
