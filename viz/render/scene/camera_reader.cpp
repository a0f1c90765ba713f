#include "viz/render/scene/camera_reader.hpp"

#include "case/independent.hpp"
#include "case/json/number_text.hpp"
#include "case/reader/shape_reader.hpp"
#include "viz/render/scene/scene.hpp"

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

}  // namespace rayproof::render
