#include "viz/render/scene/scene_reader.hpp"

#include <fmt/format.h>

#include "case/independent.hpp"
#include "case/json/number_text.hpp"
#include "case/reader/shape_reader.hpp"

namespace rayproof::render {

namespace {

double read_angle(const Field& field) {
  double degrees{};
  read_value(field, Precision::float64, degrees);
  if (!(degrees > 0 && degrees < 180)) field.refuse("must be more than 0 and less than 180 degrees");
  return degrees;
}

/// Whether the camera's axes come out as numbers in its precision: no square overflows, and what is exactly
/// independent is so after rounding.
bool has_axes(const Camera<double>& camera, Precision precision) {
  const auto is_unit = [](const auto& v) { return dot(v, v) > 0.5F && dot(v, v) < 2; };  // false for NaN
  const auto are_units = [&](const auto& axes) {
    return is_unit(axes.u) && is_unit(axes.v) && is_unit(axes.w);
  };
  return in_precision(precision, [&]<class T>(T) { return are_units(camera::axes(camera_in<T>(camera))); });
}

using json::Document;
using json::Kind;

/// Whether a path goes through a node's own, or ends there.
bool goes_through(std::string_view path, std::string_view own) {
  return path.starts_with(own) &&
         (path.size() == own.size() || path[own.size()] == '.' || path[own.size()] == '[');
}

/// The text on one line, shortened to whole characters of UTF-8.
std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string line;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!is_blank) line += c;
    if (is_blank && !line.ends_with(' ')) line += ' ';
  }
  if (line.size() <= longest) return line;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
  return line.substr(0, end) + "…";
}

}  // namespace

Camera<double> read_camera(const Field& object, Precision precision) {
  ObjectReader reader(object);
  Camera<double> camera{};
  const Field center = reader.need("center"), up = reader.need("up");
  read_value(reader.need("eye"), precision, camera.eye);
  read_value(center, precision, camera.center);
  read_value(up, precision, camera.up);
  camera.half_width = round_to(precision, half_extent(read_angle(reader.need("fov_x"))));
  camera.half_height = round_to(precision, half_extent(read_angle(reader.need("fov_y"))));
  reader.refuse_unknown();
  if (camera.eye == camera.center) center.refuse("must not be the camera's eye");
  if (!are_independent(camera.up, camera.eye - camera.center))
    up.refuse("must not point along the camera's view");
  if (!has_axes(camera, precision))
    object.refuse("has numbers too large, too small or too nearly along a line for axes in this precision");
  return camera;
}

std::string value_at(const Document& document, std::string_view path) {
  if (document.empty() || path.empty()) return "";
  std::size_t at = 0;
  std::string here;
  while (here != path) {
    const std::size_t container = at;
    std::size_t position = 0;
    std::string next;
    // Of several members of one name the last, as the reader has it.
    for (std::size_t child = container + 1; child < document[container].end; child = document[child].end) {
      std::string own = here;
      if (document[container].kind == Kind::object)
        json::append_member(own, json::unquote(document[child].key));
      else
        own += fmt::format("[{}]", position++);
      if (!goes_through(path, own)) continue;
      at = child;
      next = own;
    }
    if (at == container) return "";
    here = next;
  }
  return document[at].kind == Kind::object ? "" : shortened(document[at].text);
}

}  // namespace rayproof::render
