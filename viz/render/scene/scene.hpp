#pragma once
/// \file
/// A scene: a camera and figures, in the case format's own terms.

#include <cstddef>
#include <optional>
#include <rayproof/camera.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace rayproof::render {

/// One figure of the scene. All numbers are rounded to the scene's precision.
struct Object {
  Shape shape{};
  std::optional<glm::dmat4> transform{};  ///< object to world
  std::size_t entry = 0;                  ///< index into the file's `shapes`; a mesh's triangles share one
};

struct RenderScene {
  std::string file{};
  Precision precision = Precision::float64;
  Camera<double> camera{};
  int width = 0;  ///< of the image, in pixels
  int height = 0;
  std::vector<Object> objects{};
  std::optional<glm::dvec3> light{};  ///< a point that shines to all sides
};

/// Index into `RenderScene::objects`; `no_object` where there is none.
using ObjectIndex = std::uint32_t;
inline constexpr ObjectIndex no_object = 0xFFFFFFFF;

/// The camera in arithmetic T, which holds its numbers exactly.
template <class T>
[[nodiscard]] Camera<T> camera_in(const Camera<double>& c) {
  return {convert<T>(c.eye), convert<T>(c.center), convert<T>(c.up), T(c.half_width), T(c.half_height)};
}

/// Shoots the rays of an image, computed in T: the very numbers a case about a pixel holds.
template <class T>
class PixelRays {
 public:
  explicit PixelRays(const RenderScene& scene)
      : camera_(camera_in<T>(scene.camera)),
        axes_(camera::axes(camera_)),
        image_{static_cast<T>(scene.width), static_cast<T>(scene.height)} {}

  [[nodiscard]] Ray<T> operator()(int x, int y) const {
    return camera::PixelCentre::ray<T>(camera_, axes_, image_, static_cast<T>(x), static_cast<T>(y));
  }

 private:
  Camera<T> camera_;
  CameraAxes<T> axes_;
  ImageSize<T> image_;
};

}  // namespace rayproof::render
