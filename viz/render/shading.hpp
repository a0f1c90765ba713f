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

/// What a pixel's shadow ray comes to, beside the truth.
enum class Lighting : std::uint8_t {
  nothing,  ///< no surface there
  lit,
  shadow,
  acne,  ///< in shadow, though the light is seen from there
  leak   ///< lit, though something stands between
};

struct LightImage {
  int width = 0;
  int height = 0;
  std::vector<Lighting> pixels{};
  std::vector<double> cosine{};  ///< how squarely the light falls
  std::size_t acne = 0, leaks = 0;
};

/// The names of the strategies, in the order of the library's list.
[[nodiscard]] std::vector<std::string> strategy_names();

/// A shadow ray from each hit to the scene's light, by a strategy and the methods, all in the scene's
/// precision. The truth beside it is the same computed in double by the proven strategy, along the same pixel
/// rays. The scene has a light. Throws Stopped.
[[nodiscard]] LightImage light_up(const RenderScene& scene, const std::string& strategy,
                                  const Methods& methods, const Work& work);

/// The objects' colours, dark in shadow; acne red, leaks yellow.
[[nodiscard]] viz::Raster shaded(const RenderScene& scene, const LightImage& light, const HitImage& hits);

}  // namespace rayproof::render
