#pragma once
/// \file
/// What the scene's reader is made of: its camera, and what stands at a field, for a sentence about it.

#include <rayproof/camera.hpp>
#include <string>
#include <string_view>

#include "case/json/text.hpp"
#include "case/reader/field.hpp"

namespace rayproof::render {

/// The camera of an object with `eye`, `center`, `up`, `fov_x` and `fov_y`, rounded to the precision, in
/// which its axes are sure to be numbers. Throws Refusal.
[[nodiscard]] Camera<double> read_camera(const Field& object, Precision precision);

/// The text at a path as `Field::path` writes it ("shapes[3].shape.radius"), shortened where it is long;
/// empty for an object, and where nothing stands there.
[[nodiscard]] std::string value_at(const json::Document& document, std::string_view path);

}  // namespace rayproof::render
