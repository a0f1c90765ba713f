#pragma once
/// \file
/// All hits of a ray with a surface r(u, v) over the unit square, none of them missed.

#include <algorithm>
#include <rayproof/formulas/finite.hpp>
#include <rayproof/parametric/confirm.hpp>
#include <rayproof/parametric/piece.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parametric {

/// The search for the hits of one ray and one surface.
template <class Surface, std::floating_point T>
class HitSearch {
  using I = Interval<T>;

 public:
  HitSearch(const Ray<T>& ray, const Surface& r) : ray_(ray), r_(r), line_(ray), meeting_{r, line_} {}

  [[nodiscard]] PatchHits<T> within(std::size_t budget) {
    std::vector<Piece<Surface, T>> waiting{{r_, line_}};
    for (std::size_t next = 0; next < waiting.size(); ++next) {
      const Piece<Surface, T> piece = waiting[next];
      const Rectangle<T> X{piece.u, piece.v};
      const Jet<I> jet = piece.bounds();
      if (!may_hit(jet.value) || is_decided(X, jet)) continue;
      if (next >= budget || X.u.width() <= finest_piece<T> || X.v.width() <= finest_piece<T>) {
        add_undecided(X);
      } else {
        auto [lower, upper] = piece.halves();
        waiting.push_back(std::move(lower));
        waiting.push_back(std::move(upper));
      }
    }
    return hits();
  }

 private:
  struct Found : Confirmed<T> {
    bool is_certain;
  };

  [[nodiscard]] I t_of(const Seen<I>& seen) const { return seen.ahead / I(line_.direction[line_.k]); }
  [[nodiscard]] I in_interval(const I& t) const {
    return intersection(t, I::between(ray_.t_min, ray_.t_max));
  }

  [[nodiscard]] bool may_hit(const Seen<I>& seen) const {
    return seen.F.contains(T(0)) && seen.G.contains(T(0)) && !in_interval(t_of(seen)).is_empty();
  }

  /// Whether the piece is done with: it holds no root, or one that is proven, or one outside of the square.
  bool is_decided(const Rectangle<T>& X, const Jet<I>& jet) {
    const auto p = precondition(jet);
    if (!p) return false;
    const Rectangle<T> left = intersection(X, meeting_.image_of(X, *p));
    if (left.is_empty()) return true;
    if (!p->is_injective()) return false;
    const auto [u, v] = meeting_.polished(left.u.middle(), left.v.middle());
    const auto root = meeting_.confirmed(u, v);
    if (!root) return false;
    // The piece's one root is this one, if no other fits into both together.
    if (!X.contains(root->only_one) && !meeting_.is_injective(hull(X, root->only_one))) return false;
    add(*root);
    return true;
  }

  /// Once only, though neighbouring pieces find what lies on their common edge both.
  void add(const Confirmed<T>& one) {
    for (const Found& known : found_)
      if (known.is_certain && (known.only_one.contains(one.root) || one.only_one.contains(known.root)))
        return;
    found_.push_back({one, true});
  }

  void add_undecided(const Rectangle<T>& X) {
    found_.push_back({{X, X}, false});
    for (std::size_t i = found_.size() - 1; i-- > 0;) {  // touching ones become one
      Found& last = found_.back();
      if (found_[i].is_certain || intersection(found_[i].root, last.root).is_empty()) continue;
      last.root = hull(last.root, found_[i].root);
      found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(i));
      i = found_.size() - 1;
    }
  }

  [[nodiscard]] PatchHits<T> hits() const {
    PatchHits<T> all;
    for (const Found& one : found_) {
      const Rectangle<T> inside = intersection(one.root, Rectangle<T>::unit());
      if (inside.is_empty()) continue;
      const I t = t_of(meeting_.seen(inside.u, inside.v));
      const I t_inside = in_interval(t);
      if (t_inside.is_empty()) continue;
      const bool is_whole = inside.contains(one.root) && t_inside.contains(t);
      all.push_back({t_inside.middle(), inside.u.middle(), inside.v.middle(), 0, one.is_certain && is_whole,
                     t_inside, inside.u, inside.v});
      all.back().residual = residual(all.back());
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    return all;
  }

  /// The distance of r(u, v) from p(t), rounded up.
  [[nodiscard]] T residual(const PatchHit<T>& hit) const {
    const Vec3<I> off = r_(I(hit.u), I(hit.v)) - point_at(convert<I>(ray_), I(hit.t));
    return sqrt(square(off.x) + square(off.y) + square(off.z)).hi;
  }

  const Ray<T>& ray_;
  const Surface& r_;
  Line<T> line_;
  Meeting<Surface, T> meeting_;
  std::vector<Found> found_;
};

/// Every hit of a ray with r over the closed unit square, ascending by t.
///
/// Contract, for every finite ray and surface; what of it can be counted is `hits_contract`:
/// - no hit is missed: each p(t) = r(u, v) with t in [t_min, t_max] has its (t, u, v) in the ranges of one of
///   the answers;
/// - the ranges of a certain one hold exactly one, and lie inside the ray's interval and the unit square;
/// - what cannot be distinguished is undecided: hits on the square's edge or at an end of the interval within
///   rounding, silhouettes, lines in the surface, hits closer than `finest_piece`, and whatever is left when
///   `budget` pieces have been cut in two;
/// - of each, |r(u, v) - p(t)| is not larger than `residual`;
/// - a zero direction, and a NaN or infinite number in the ray or a NaN in the surface, has no hit.
///
/// Sources: J. T. Kajiya, "Ray Tracing Parametric Patches", 1982 (two planes through the ray); D. L. Toth,
/// "On Ray Tracing Parametric Surfaces", 1985 (subdivision until an interval test proves that Newton
/// converges).
template <class Surface, std::floating_point T>
[[nodiscard]] PatchHits<T> hits(const Ray<T>& ray, const Surface& r, std::size_t budget = default_pieces) {
  if (!is_searchable(ray)) return {};
  return HitSearch<Surface, T>(ray, r).within(budget);
}

}  // namespace rayproof::parametric

#include <rayproof/rounding/as_before.hpp>
