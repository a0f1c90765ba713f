#pragma once
/// \file
/// What each pixel of an image sees: the nearest hit over all objects, by float methods or exactly.

#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <rayproof/objects/hull.hpp>
#include <span>
#include <string>

#include "viz/picture/raster.hpp"
#include "viz/render/scene/scene_reader.hpp"

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

/// The nearest hit of a ray so far; of two at the same t, that of the object which stands first in the scene.
template <class T>
struct Nearest {
  T t = T(infinity<T>);
  ObjectIndex object = no_object;

  /// A hit, which may have rounded to infinity.
  void take(T hit, ObjectIndex index) {
    if (hit < t || (hit == t && index < object)) {
      t = hit;
      object = index;
    }
  }
  /// What a method answers: a miss is infinite, and NaN is no hit either.
  void offer(T answer, ObjectIndex index) {
    if (answer < T(infinity<T>)) take(answer, index);
  }
};

/// For each pixel, by rows from the top, the nearest hit's t and object.
struct HitImage {
  int width = 0;
  int height = 0;
  std::vector<double> t{};  ///< infinite where nothing is hit
  std::vector<ObjectIndex> object{};

  HitImage(int w, int h)
      : width(w), height(h), t(viz::pixel_index(w, 0, h), HUGE_VAL), object(t.size(), no_object) {}

  [[nodiscard]] std::size_t index(int x, int y) const { return viz::pixel_index(width, x, y); }
  template <class T>
  void set(int x, int y, const Nearest<T>& nearest) {
    t[index(x, y)] = static_cast<double>(nearest.t);
    object[index(x, y)] = nearest.object;
  }
};

struct Work {
  int jobs = 0;                             ///< threads; 0 for as many as the machine has
  const std::atomic<bool>* stop = nullptr;  ///< ends the work where it becomes true
  std::function<void(double done)>
      progress{};  ///< hears the share that is done; called by one thread at a time
};

class Stopped : public std::exception {};

/// The method for each shape: {"sphere", "centred"}.
using Methods = std::map<std::string, std::string>;

/// A sound and quick method for each shape that a ray can meet.
[[nodiscard]] Methods default_methods();

/// Every method that can render, as "sphere/centred".
[[nodiscard]] std::vector<std::string> renderable_methods();

/// From this many objects on, a method is asked only about rays that come near an object's box.
inline constexpr std::size_t many_objects = 65;

/// How far around a box a method is still asked: this part of the largest coordinates of the boxes and the
/// ray's origin.
inline constexpr double method_margin = 0x1p-16;

/// Hits by float methods in the scene's precision. With no neighbourhood every object is tested against every
/// ray. Throws Stopped.
[[nodiscard]] HitImage trace(const RenderScene& scene, const Methods& methods,
                             const Neighbourhood& neighbourhood, const Work& work);

/// The exact hits: of each pixel's rounded ray, t correctly rounded. Of two objects with the same rounded t
/// it is the one that stands first in the scene. `neighbourhood` must leave out no object that the ray meets.
/// Throws Stopped.
[[nodiscard]] HitImage trace_exactly(const RenderScene& scene, const Neighbourhood& neighbourhood,
                                     const Work& work);
[[nodiscard]] ObjectIndex nearest_at(const RenderScene& scene, const Methods& methods,
                                     const Neighbourhood& neighbourhood, int x, int y);
[[nodiscard]] ObjectIndex exact_nearest_at(const RenderScene& scene, const Neighbourhood& neighbourhood,
                                           int x, int y);

/// The first exact hit of one object, rounded correctly; infinite for a miss. (`is_hit` distinguishes a hit
/// that rounds to infinity.)
struct ExactHit {
  bool is_hit = false;
  double t = HUGE_VAL;
};
[[nodiscard]] ExactHit exact_hit(const RenderScene& scene, ObjectIndex object, const Ray<double>& ray);

/// Not below any exact t that rounds to `t`, be it in float: a normal float's neighbour is at most 2^-23 of
/// it away, and the others are 2^-149 apart.
[[nodiscard]] inline double beyond_rounding(double t) {
  return std::isinf(t) ? HUGE_VAL : t + std::abs(t) * 0x1p-22 + 0x1p-148;
}

[[nodiscard]] Ray<double> pixel_ray(const RenderScene& scene, int x, int y);

/// Pixels (x, y) with left <= x < right and top <= y < bottom.
struct Tile {
  int left, top, right, bottom;
};

inline constexpr int tile_side = 32;

/// The tiles of an image by rows: every pixel is in one of them, and in only one.
[[nodiscard]] std::vector<Tile> tiles_of(int width, int height);

template <class Body>
void for_each_pixel(const Tile& tile, Body&& body) {
  for (int y = tile.top; y < tile.bottom; ++y) {
    for (int x = tile.left; x < tile.right; ++x) body(x, y);
  }
}

/// Calls `body` for each tile, on several threads. Throws Stopped.
void for_each_tile(int width, int height, const Work& work, const std::function<void(const Tile&)>& body);

template <class Body>
void for_each_pixel(int width, int height, const Work& work, Body&& body) {
  for_each_tile(width, height, work, [&](const Tile& tile) { for_each_pixel(tile, body); });
}

struct PixelHits {
  ObjectIndex exact = no_object;    ///< the nearest object in truth
  ObjectIndex claimed = no_object;  ///< the nearest object by the methods
};

/// Asks the oracle and the methods about one pixel, every object.
[[nodiscard]] PixelHits hits_at(const RenderScene& scene, int x, int y, const Methods& methods);

/// Which object a pixel's case is about: the exact one, or where nothing is there the methods' one; with
/// neither, none.
[[nodiscard]] inline ObjectIndex object_of(const PixelHits& hits) {
  return hits.exact != no_object ? hits.exact : hits.claimed;
}

/// The case of pixel (x, y) and an object; its note says where it comes from and why this object.
[[nodiscard]] Case pixel_case(const RenderScene& scene, int x, int y, ObjectIndex object,
                              const PixelHits& hits);

}  // namespace rayproof::render
