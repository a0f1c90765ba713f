#pragma once
/// \file
/// All figures of a scene, each shape's by its method: what rays of any kind are asked of.

#include "case/case.hpp"
#include "viz/render/figures.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {

/// All figures of a scene, by shape.
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
    for (const auto& group : groups_) group->meet_all(rays, nearest);
  }
  void meet(ObjectIndex object, const Ray<T>& ray, Nearest<T>& nearest) const {
    groups_[places_[object].group]->meet(places_[object].figure, ray, nearest);
  }

 private:
  struct FigureIndex {
    std::uint32_t group = 0, figure = 0;
  };
  std::vector<FigureIndex> places_;
  std::vector<std::unique_ptr<Figures<T>>> groups_{};
};

/// Intersects the rays with all objects, or with those in their neighbourhood.
template <class T>
[[nodiscard]] std::vector<Nearest<T>> meet(const AllFigures<T>& figures, const Neighbourhood* neighbourhood,
                                           std::span<const Ray<T>> rays) {
  std::vector<Nearest<T>> nearest(rays.size());
  if (neighbourhood == nullptr) {
    figures.meet_all(rays, nearest);
    return nearest;
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    auto ask = [&](ObjectIndex object) {
      figures.meet(object, rays[i], nearest[i]);
      return static_cast<double>(nearest[i].t);
    };
    neighbourhood->visit(convert<double>(rays[i]), ask);
  }
  return nearest;
}

}  // namespace rayproof::render
