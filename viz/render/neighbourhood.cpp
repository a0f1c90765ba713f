#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <rayproof/objects/bounds_tree.hpp>
#include <rayproof/objects/embree_tree.hpp>

#include "case/case.hpp"
#include "viz/render/figures.hpp"
#include "viz/render/hits.hpp"

#ifdef RAYPROOF_HAS_EMBREE
#endif

namespace rayproof::render {
namespace {

/// The objects' boxes in one of the library's trees; an object without a box is near every ray.
template <class Tree>
class NearInTree {
 public:
  NearInTree(const RenderScene& scene, double margin) : margin_(margin), tree_(boxes_of(scene)) {
    if (!boxed_.empty()) reach_ = objects::reach_of(tree_.bounds());
  }

  void visit(const Ray<double>& ray, const Meet& meet) const {
    double nearest = HUGE_VAL;
    for (const ObjectIndex object : unbounded_) nearest = meet(object);
    tree_.visit(objects::with_margin(ray, margin_, reach_), nearest,
                [&](std::uint32_t i) { return meet(boxed_[i]); });
  }

 private:
  std::vector<objects::Bounds> boxes_of(const RenderScene& scene) {
    std::vector<objects::Bounds> boxes;
    for (ObjectIndex i = 0; i < scene.objects.size(); ++i) {
      const auto box = bounds_of(scene.objects[i]);
      (box ? boxed_ : unbounded_).push_back(i);
      if (box) boxes.push_back(*box);
    }
    return boxes;
  }

  double margin_;
  std::vector<ObjectIndex> boxed_{}, unbounded_{};  // before the tree, whose boxes fill them
  Tree tree_;
  double reach_ = 0;
};

template <class Tree>
Neighbourhood near_in(const RenderScene& scene, double margin) {
  return [tree = std::make_shared<NearInTree<Tree>>(scene, margin)](
             const Ray<double>& ray, const Meet& meet) { tree->visit(ray, meet); };
}

/// "shapes[3]", or for a mesh's triangle "triangle 17 of shapes[3]".
std::string object_name(const RenderScene& scene, ObjectIndex object) {
  const std::size_t entry = scene.objects[object].entry;
  std::size_t first = object;
  while (first > 0 && scene.objects[first - 1].entry == entry) --first;
  const bool is_of_mesh =
      first != object || (object + 1 < scene.objects.size() && scene.objects[object + 1].entry == entry);
  const std::string shape = fmt::format("shapes[{}]", entry);
  return is_of_mesh ? fmt::format("triangle {} of {}", object - first, shape) : shape;
}

}  // namespace

std::optional<objects::Bounds> bounds_of(const Object& object) {
  const auto& kinds = figure_kinds();
  const auto kind = std::ranges::find(kinds, shape_name(object.shape), &FigureKind::shape);
  return kind == kinds.end() ? std::nullopt : kind->bounds(object);
}

Neighbourhood bounds_tree(const RenderScene& scene, double margin) {
  return near_in<objects::BoundsTree>(scene, margin);
}

Neighbourhood embree_tree([[maybe_unused]] const RenderScene& scene, [[maybe_unused]] double margin) {
#ifdef RAYPROOF_HAS_EMBREE
  return near_in<objects::EmbreeTree>(scene, margin);
#else
  return nullptr;
#endif
}

PixelHits hits_at(const RenderScene& scene, int x, int y, const Methods& methods) {
  const bool has_many = scene.objects.size() >= many_objects;
  const Neighbourhood near = has_many ? bounds_tree(scene, method_margin) : nullptr;
  return {exact_nearest_at(scene, bounds_tree(scene), x, y), nearest_at(scene, methods, near, x, y)};
}

Case pixel_case(const RenderScene& scene, int x, int y, ObjectIndex object, const PixelHits& hits) {
  const Object& asked = scene.objects[object];
  const auto in_words = [&](ObjectIndex hit) {
    return hit == no_object ? "nothing" : object_name(scene, hit);
  };
  Case one;
  one.precision = scene.precision;
  one.note = fmt::format(
      "pixel ({}, {}) of {} at {}x{}, about {}: exactly the ray meets {} first, by the methods {}", x, y,
      scene.file, scene.width, scene.height, object_name(scene, object), in_words(hits.exact),
      in_words(hits.claimed));
  one.question = RayQuestion{pixel_ray(scene, x, y), asked.shape, asked.transform};
  return one;
}

}  // namespace rayproof::render
