#pragma once
/// \file
/// Figures of one shape, met by one method in one precision: the choice is made once a tile, not once a ray.

#include <memory>
#include <span>
#include <string_view>

#include "viz/scene/scene.hpp"

namespace rayproof::render {

/// The nearest hit of a ray so far; of two at the same t, that of the object which stands first in the scene.
template <class T>
struct Nearest {
  T t = T(infinity<T>);
  ObjectIndex object = no_object;

  void offer(T other, ObjectIndex index) {
    // Both comparisons are false where `other` is NaN. A miss is infinite and never less.
    if (other < t || (other == t && other < T(infinity<T>) && index < object)) {
      t = other;
      object = index;
    }
  }
};

template <class T>
class Figures {
 public:
  Figures() = default;
  Figures(const Figures&) = delete;
  Figures& operator=(const Figures&) = delete;
  virtual ~Figures() = default;

  /// Puts every figure to every ray; `nearest` has one element for each of them.
  virtual void meet_all(std::span<const Ray<T>> rays, std::span<Nearest<T>> nearest) const = 0;
  /// Puts one figure to one ray.
  virtual void meet(std::size_t figure, const Ray<T>& ray, Nearest<T>& nearest) const = 0;
};

/// The objects of a scene that are of one shape.
struct Members {
  const Scene* scene;
  std::vector<ObjectIndex> objects;
};

/// The topic's method of that name over the objects; null where it has none of that name. Defined for each
/// topic of rays and float and double.
template <class Topic, class T>
[[nodiscard]] std::unique_ptr<Figures<T>> make_figures(std::string_view method, const Members& members);

}  // namespace rayproof::render
