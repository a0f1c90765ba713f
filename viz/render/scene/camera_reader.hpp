#pragma once
/// \file
/// Reads a scene's camera.

#include <rayproof/camera.hpp>

#include "case/reader/field.hpp"

namespace rayproof::render {

/// The camera of an object with `eye`, `center`, `up`, `fov_x` and `fov_y`, rounded to the precision, in
/// which its axes are sure to be numbers. Throws Refusal.
[[nodiscard]] Camera<double> read_camera(const Field& object, Precision precision);

}  // namespace rayproof::render
