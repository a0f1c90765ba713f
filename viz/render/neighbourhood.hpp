#pragma once
/// \file
/// Which objects a ray may meet at all.

#include <functional>
#include <memory>

#include "viz/render/bounds.hpp"

namespace rayproof::render {

/// What is done with an object that a ray comes near: takes its index and gives back the nearest t found so
/// far, beyond which nothing matters.
using Meet = std::function<double(ObjectIndex)>;

/// Some structure over the objects of a scene.
class Neighbourhood {
 public:
  Neighbourhood() = default;
  Neighbourhood(const Neighbourhood&) = delete;
  Neighbourhood& operator=(const Neighbourhood&) = delete;
  virtual ~Neighbourhood() = default;

  /// Calls `meet` for every object whose box the ray meets, in any order, but for boxes that begin beyond the
  /// nearest t so far.
  virtual void visit(const Ray<double>& ray, const Meet& meet) const = 0;
};

/// Boxes of all objects, larger by `margin`; an object without a box is near every ray.
struct ObjectBounds {
  std::vector<Bounds> boxes{};
  std::vector<ObjectIndex> boxed{};      ///< whose box each is
  std::vector<ObjectIndex> unbounded{};  ///< those without one

  explicit ObjectBounds(const RenderScene& scene, double margin = 0);
};

/// A tree of boxes, searched in doubles with bounds on every rounding: it certainly leaves out no object that
/// the exact ray meets in its box.
[[nodiscard]] std::unique_ptr<Neighbourhood> bounds_tree(ObjectBounds bounds);

/// The same by Embree, the objects being its user geometries. Embree searches in float: the boxes want a
/// margin of some 2^-20 of the scene. Null in a build without Embree.
[[nodiscard]] std::unique_ptr<Neighbourhood> embree_tree(ObjectBounds bounds);

}  // namespace rayproof::render
