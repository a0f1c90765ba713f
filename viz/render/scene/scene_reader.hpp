#pragma once
/// \file
/// A scene, a camera and figures in the case format's own terms; and how it is read from a JSON file:
/// `camera`, `size`, `precision` and `shapes` (docs/raycasting.md).

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <rayproof/camera.hpp>
#include <rayproof/triangle.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/json/text.hpp"
#include "case/reader/field.hpp"

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

/// A file that can't be read or is no mesh; the text says so in one sentence that names the file.
class UnreadableFile : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The triangles of a mesh file, unrounded. Throws UnreadableFile.
using ReadMesh = std::function<std::vector<Triangle<double>>(const std::filesystem::path&)>;

struct SceneOverrides {
  std::optional<Precision> precision{};
  std::optional<std::pair<int, int>> size{};  ///< width and height
};

/// No image is larger than this on either side.
inline constexpr int largest_side = 16384;

/// Reads the scene, its numbers rounded to its precision; meshes lie beside the scene's file unless their
/// path is absolute. Throws UnreadableFile, or a Refusal whose sentence names the file, the field and its
/// value.
[[nodiscard]] RenderScene read_scene(const std::filesystem::path& file, const ReadMesh& read_mesh,
                                     const SceneOverrides& overrides = {});

/// The camera of an object with `eye`, `center`, `up`, `fov_x` and `fov_y`, rounded to the precision, in
/// which its axes are sure to be numbers. Throws Refusal.
[[nodiscard]] Camera<double> read_camera(const Field& object, Precision precision);

/// The text at a path as `Field::path` writes it ("shapes[3].shape.radius"), shortened where it is long;
/// empty for an object, and where nothing stands there.
[[nodiscard]] std::string value_at(const json::Document& document, std::string_view path);

/// The triangles of an OFF file ("OFF", the numbers of vertices, faces and edges, the vertices, the faces; #
/// begins a comment; what follows a vertex's or face's numbers on its line, a colour say, is passed over). A
/// face with more than three corners becomes a fan. Throws UnreadableFile with file and line.
[[nodiscard]] std::vector<Triangle<double>> read_off(const std::filesystem::path& file);

}  // namespace rayproof::render
