#pragma once
/// \file
/// A pixel as a case: its ray and one object, for explain, draw and every other tool.

#include "viz/render/hits.hpp"

namespace rayproof::render {

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

/// "shapes[3]", or for a mesh's triangle "triangle 17 of shapes[3]".
[[nodiscard]] std::string object_name(const RenderScene& scene, ObjectIndex object);

}  // namespace rayproof::render
