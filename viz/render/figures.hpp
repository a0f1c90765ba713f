#pragma once
/// \file
/// Figures of one shape, met by one method in one precision (the choice is made once a tile, not once a ray),
/// and all figures of a scene: what rays of any kind are asked of.

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "case/case.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {

/// Intersects one of the figures, or every one, with every ray; `nearest` has one element for each of them.
template <class T>
using Figures = std::function<void(std::optional<std::size_t> only, std::span<const Ray<T>> rays,
                                   std::span<Nearest<T>> nearest)>;

/// The objects of a scene that are of one shape.
struct Members {
  const RenderScene* scene;
  std::vector<ObjectIndex> objects;
};

/// The method of that name over the objects; none where the shape has none of that name.
template <class T>
using MakeFigures = Figures<T> (*)(std::string_view method, const Members& members);

/// What a shape brings to a scene.
struct FigureKind {
  std::string shape;                   ///< "sphere"
  std::string default_method;          ///< "centred": the topic's plain one
  std::vector<std::string> methods{};  ///< all that can render
  MakeFigures<float> in_float = nullptr;
  MakeFigures<double> in_double = nullptr;
  /// A box that holds an object of the shape; nothing for a shape without end, which every ray asks.
  std::optional<objects::Bounds> (*bounds)(const Object& object) = nullptr;

  template <class T>
  [[nodiscard]] MakeFigures<T> make() const {
    if constexpr (std::is_same_v<T, float>)
      return in_float;
    else
      return in_double;
  }
};

/// Every shape that a ray can meet, in the order of the registries.
[[nodiscard]] const std::vector<FigureKind>& figure_kinds();

template <class T>
class AllFigures {
 public:
  AllFigures(const RenderScene& scene, const Methods& methods) : places_(scene.objects.size()) {
    std::map<std::string, Members> by_shape;
    for (ObjectIndex i = 0; i < scene.objects.size(); ++i) {
      Members& members =
          by_shape.try_emplace(shape_name(scene.objects[i].shape), Members{&scene, {}}).first->second;
      places_[i].figure = static_cast<std::uint32_t>(members.objects.size());
      members.objects.push_back(i);
    }
    for (const FigureKind& kind : figure_kinds()) {
      const auto members = by_shape.find(kind.shape);
      if (members == by_shape.end()) continue;
      for (const ObjectIndex object : members->second.objects)
        places_[object].group = static_cast<std::uint32_t>(groups_.size());
      groups_.push_back(kind.make<T>()(methods.at(kind.shape), members->second));
    }
  }

  void meet_all(std::span<const Ray<T>> rays, std::span<Nearest<T>> nearest) const {
    for (const Figures<T>& group : groups_) group({}, rays, nearest);
  }
  void meet(ObjectIndex object, const Ray<T>& ray, Nearest<T>& nearest) const {
    groups_[places_[object].group](places_[object].figure, {&ray, 1}, {&nearest, 1});
  }

 private:
  struct FigureIndex {
    std::uint32_t group = 0, figure = 0;
  };
  std::vector<FigureIndex> places_;
  std::vector<Figures<T>> groups_{};
};

/// Intersects the rays with all objects, or with those in their neighbourhood.
template <class T>
[[nodiscard]] std::vector<Nearest<T>> meet(const AllFigures<T>& figures, const Neighbourhood& neighbourhood,
                                           std::span<const Ray<T>> rays) {
  std::vector<Nearest<T>> nearest(rays.size());
  if (!neighbourhood) {
    figures.meet_all(rays, nearest);
    return nearest;
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    auto ask = [&](ObjectIndex object) {
      figures.meet(object, rays[i], nearest[i]);
      return static_cast<double>(nearest[i].t);
    };
    neighbourhood(convert<double>(rays[i]), ask);
  }
  return nearest;
}

}  // namespace rayproof::render
