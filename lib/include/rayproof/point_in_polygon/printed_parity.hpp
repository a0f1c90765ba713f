#pragma once
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/method/method.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::point_in_polygon {

/// A side is hit where s = (y₀-yᵢ)/(yᵢ₊₁-yᵢ) lies in [0, 1], closed at both ends, **as printed** in the
/// source: a ray through a vertex counts it twice, and a horizontal side divides by 0.
///
/// Kept so that the property tests refute it. It knows no boundary. Parity is the mended form.
struct PrintedParity {
  static constexpr const char* name = "printed_parity";
  static constexpr const char* title = "as printed: sides closed at both ends";
  static constexpr Source source = sources::ban;
  static constexpr Contract contract{
      .standing = Standing::printed,
      .holds = always_claimed | Claims{Claim::scaled},
      .refuted = {{{Claim::robust, "a ray through a vertex crosses both of its sides and counts twice"},
                   {Claim::exact, "a vertex at the point's height counts twice where nothing is rounded"}}}};

  template <Branching T>
  [[nodiscard]] static Position locate(const PointAndPolygon<T>& question) {
    if (!polygon::is_finite(question)) return Position::outside;
    step<T>("Count the closed sides that a ray along +x meets, as printed",
            "A side counts for s in [0, 1], both ends included, so a ray through a vertex counts two sides "
            "there.");
    bool is_odd = false;
    polygon::for_each_side(question.vertices, [&](const Vec2<T>& a, const Vec2<T>& b) {
      const auto [s, t] = polygon::cross_side(question.point, a, b);
      if (T(0) <= s && s <= T(1) && t >= T(0)) is_odd = !is_odd;
    });
    return is_odd ? Position::inside : Position::outside;
  }
};

}  // namespace rayproof::point_in_polygon

#include <rayproof/rounding/as_before.hpp>
