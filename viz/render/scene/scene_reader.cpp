#include "viz/render/scene/scene_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "case/files.hpp"
#include "case/json/number_text.hpp"
#include "case/reader.hpp"
#include "case/reader/shape_reader.hpp"

namespace rayproof::render {
namespace {

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!is_readable(in, file)) throw UnreadableFile(fmt::format("the file {} can't be read", file.string()));
  return whole_text(in, file.string());
}

int read_side(const Field& field) {
  double pixels{};
  read_value(field, Precision::float64, pixels);
  if (!(pixels >= 1 && pixels <= largest_side && pixels == std::floor(pixels)))
    field.refuse(fmt::format("must be a whole number of pixels from 1 to {}", largest_side));
  return static_cast<int>(pixels);
}

double rounded(const Field& field, Precision precision, double x) {
  const double number = round_to(precision, x);
  if (!std::isfinite(number))
    field.refuse("names a mesh with a coordinate that is not finite in this precision");
  return number;
}

void add_shape(RenderScene& scene, const Field& field, const std::optional<glm::dmat4>& transform,
               std::size_t entry) {
  Object& object = scene.objects.emplace_back(Object{{}, transform, entry});
  try {
    read_shape(field, scene.precision, object.shape);
  } catch (const Refusal& why) {
    // A shape that does not hold together is refused by its own field, without the path to it.
    const std::string path = field.path();
    if (why.field().starts_with(path)) throw;
    throw Refusal(path + "." + why.field(), fmt::format("{}.{}: {}", path, why.field(), why.what()));
  }
}

void add_mesh(RenderScene& scene, const ReadMesh& read_mesh, const Field& field,
              const std::optional<glm::dmat4>& transform, std::size_t entry) {
  const std::filesystem::path beside = std::filesystem::path(scene.file).parent_path();
  const auto vertex = [&](const glm::dvec3& v) {
    return glm::dvec3(rounded(field, scene.precision, v.x), rounded(field, scene.precision, v.y),
                      rounded(field, scene.precision, v.z));
  };
  for (const Triangle<double>& t : read_mesh(beside / read_string(field)))
    scene.objects.push_back({Triangle<double>{vertex(t.a), vertex(t.b), vertex(t.c)}, transform, entry});
}

/// Reads `shapes`.
void read_objects(RenderScene& scene, const ReadMesh& read_mesh, const Field& shapes) {
  const std::vector<Field> entries = shapes.elements("must be an array of shapes and meshes");
  scene.objects.reserve(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    ObjectReader reader(entries[i]);
    const auto mesh = reader.find("mesh");
    const Field shape = mesh ? *mesh : reader.need("shape");
    std::optional<glm::dmat4> transform;
    if (const auto field = reader.find("transform")) transform = read_transform(*field, scene.precision);
    reader.refuse_unknown();
    if (mesh)
      add_mesh(scene, read_mesh, shape, transform, i);
    else
      add_shape(scene, shape, transform, i);
  }
}

void read_size(RenderScene& scene, ObjectReader& reader, const SceneOverrides& overrides) {
  const Field field = reader.need("size");
  const std::vector<Field> sides = field.elements("must be an array of 2 numbers, width and height", 2);
  scene.width = read_side(sides[0]);
  scene.height = read_side(sides[1]);
  if (overrides.size) std::tie(scene.width, scene.height) = *overrides.size;
}

void read_members(RenderScene& scene, const json::Document& document, const ReadMesh& read_mesh,
                  const SceneOverrides& overrides) {
  const Field whole{.document = &document};
  ObjectReader reader(whole);
  scene.precision = read_precision(reader);
  if (overrides.precision) scene.precision = *overrides.precision;
  read_size(scene, reader, overrides);
  scene.camera = read_camera(reader.need("camera"), scene.precision);
  const Field shapes = reader.need("shapes");
  if (const auto light = reader.find("light")) read_value(*light, scene.precision, scene.light.emplace());
  if (const auto note = reader.find("note")) static_cast<void>(read_string(*note));
  reader.refuse_unknown();
  read_objects(scene, read_mesh, shapes);
}

/// The case reader's sentence, with the file before it and the value behind it.
std::string sentence_about(const std::string& file, const Refusal& why, const std::string& value) {
  std::string sentence = why.what();
  for (const std::string_view whole : {"the case ", "the line "}) {
    if (sentence.starts_with(whole)) sentence.replace(0, whole.size(), "the scene ");
  }
  return fmt::format("{}: {}{}", file, sentence, value.empty() ? "" : fmt::format(" (here: {})", value));
}

}  // namespace

RenderScene read_scene(const std::filesystem::path& file, const ReadMesh& read_mesh,
                       const SceneOverrides& overrides) {
  const std::string text = read_text(file);
  RenderScene scene;
  scene.file = file.string();
  json::Document document;
  try {
    document = json::parse(text);
    read_members(scene, document, read_mesh, overrides);
  } catch (const Refusal& why) {
    throw Refusal(why.field(), sentence_about(scene.file, why, value_at(document, why.field())));
  }
  return scene;
}

}  // namespace rayproof::render
