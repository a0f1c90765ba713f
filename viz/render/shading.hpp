#pragma once
/// \file
/// Hits as a picture of the scene.

#include "viz/picture/raster.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {

enum class Shade {
  normal,  ///< an object's colour, the darker the more the surface turns away from the eye
  flat     ///< an object's colour
};

/// One pixel a hit, each shape (or mesh) of the scene in a colour of its own.
[[nodiscard]] viz::Raster shaded(const RenderScene& scene, const HitImage& hits, Shade shade,
                                 const Work& work);

}  // namespace rayproof::render
