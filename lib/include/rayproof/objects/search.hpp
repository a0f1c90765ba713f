#pragma once
/// \file
/// What a ray meets among objects: the nearest hit, any, or all, whoever says which objects are to be asked.
///
/// `visit(meet)` calls `meet` with one object after another. It gets back the t beyond which no hit matters
/// any more, or NaN where no hit matters at all: the search is over.

#include <algorithm>
#include <functional>
#include <rayproof/objects/listed_object.hpp>
#include <utility>

namespace rayproof::objects {

/// The nearest hit in the ray's interval; of several at one t, that of the least index.
template <class Choice, class T, class Visit>
[[nodiscard]] std::optional<HitRecord<T>> nearest_of(const Ray<T>& ray, const Visit& visit) {
  std::optional<HitRecord<T>> best;
  visit([&](const auto& object) {
    const auto roots = object.template roots<Choice>(ray);
    if (any(ray, roots)) {
      const T t = nearest(ray, roots);
      if (!best || std::pair(t, object.index) < std::pair(best->t, best->index))
        best = object.record(ray, t, roots);
    }
    return best ? best->t : infinity<T>;
  });
  return best;
}

/// Whether anything is hit in the ray's interval.
template <class Choice, class T, class Visit>
[[nodiscard]] bool any_of(const Ray<T>& ray, const Visit& visit) {
  bool is_hit = false;
  visit([&](const auto& object) {
    is_hit = any(ray, object.template roots<Choice>(ray));
    return is_hit ? not_a_number<T> : infinity<T>;
  });
  return is_hit;
}

/// Every hit in the ray's interval, ascending; of a solid both, of a tangent one.
template <class Choice, class T, class Visit>
[[nodiscard]] std::vector<HitRecord<T>> all_of(const Ray<T>& ray, const Visit& visit) {
  std::vector<HitRecord<T>> hits;
  visit([&](const auto& object) {
    const auto roots = object.template roots<Choice>(ray);
    if (in_interval(ray, roots.lo)) hits.push_back(object.record(ray, roots.lo, roots));
    const bool is_one = roots.discriminant == T(0);
    if (!is_one && in_interval(ray, roots.hi)) hits.push_back(object.record(ray, roots.hi, roots));
    return infinity<T>;
  });
  std::ranges::sort(hits, std::less{}, [](const HitRecord<T>& hit) { return std::pair(hit.t, hit.index); });
  return hits;
}

}  // namespace rayproof::objects
