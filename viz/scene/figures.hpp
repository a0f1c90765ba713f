#pragma once
/// \file
/// Figures of one shape, met by one method in one precision: the choice is made once a tile, not once a ray.

#include <memory>
#include <span>
#include <string_view>

#include "viz/scene/hits.hpp"

namespace rayproof::render {

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
