#pragma once
/// \file
/// Which objects a ray may meet at all.

#include <functional>
#include <rayproof/objects/hull.hpp>

#include "viz/render/scene/scene.hpp"

namespace rayproof::render {

/// What is done with an object that a ray comes near: takes its index and gives back the nearest t found so
/// far, beyond which nothing matters.
using Meet = std::function<double(ObjectIndex)>;

/// Calls `meet` for every object whose box the ray meets, in any order, but for boxes that begin beyond the
/// nearest t so far.
using Neighbourhood = std::function<void(const Ray<double>& ray, const Meet& meet)>;

/// A box around the object in the world: no point of the exact figure lies outside it. Nothing for a plane,
/// or where a number is beyond what can be reasoned about.
[[nodiscard]] std::optional<objects::Bounds> bounds_of(const Object& object);

/// By the library's tree of boxes. With no margin it certainly leaves out no object that the exact ray meets;
/// otherwise the boxes are larger by this part of the largest coordinates of boxes and ray's origin.
[[nodiscard]] Neighbourhood bounds_tree(const RenderScene& scene, double margin = 0);

/// The same by Embree. None in a build without it.
[[nodiscard]] Neighbourhood embree_tree(const RenderScene& scene, double margin);

}  // namespace rayproof::render
