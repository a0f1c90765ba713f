#pragma once
/// \file
/// One tame ray, and a shape of every type and form that it hits: the lines of unit/shapes/NAME.jsonl.

#include <fstream>
#include <stdexcept>

#include "case/reader.hpp"
#include "unit/shape_types.hpp"

namespace rayproof::viz {

inline constexpr const char* ray_head =
    R"({"precision":"float32","ray":{"origin":[0.25,0.25,-5],"direction":[0,0,1]},"shape":)";

[[nodiscard]] inline Case with_shape(const std::string& shape) { return read_case(ray_head + shape + "}"); }

/// The lines of a type's file.
[[nodiscard]] inline std::vector<std::string> shapes_of(const std::string& type) {
  std::ifstream file(RAYPROOF_SOURCE_DIR "/property_tests/unit/shapes/" + type + ".jsonl");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// Of every form that the case format has; fails where a form is missing.
[[nodiscard]] inline std::vector<std::string> shapes() {
  std::vector<std::string> all;
  std::vector<bool> is_there(std::variant_size_v<Shape>);
  for (const std::string& type : ray_topics()) {
    for (const std::string& shape : shapes_of(type)) {
      all.push_back(shape);
      is_there[std::get<RayQuestion>(with_shape(shape).question).shape.index()] = true;
    }
  }
  for (std::size_t form = 0; form < is_there.size(); ++form)
    if (!is_there[form]) throw std::logic_error("no line of unit/shapes is of form " + std::to_string(form));
  return all;
}

}  // namespace rayproof::viz
