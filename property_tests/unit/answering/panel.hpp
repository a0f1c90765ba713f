#pragma once
/// \file
/// Functions asked one case after the other, as `answer_cases` asks them.

#include <string>
#include <utility>

#include "answer_cases.hpp"

namespace rayproof {

using F3 = glm::vec3;
using D3 = glm::dvec3;

/// What functions, asked together, say of a line; options among them hold for all.
template <class... G>
std::string answer_of(const std::string& line, G... given) {
  answering::FunctionPanel panel = answering::panel_of(std::move(given)...);
  std::string out;
  panel.answer(line, out);
  return out;
}

inline const std::string unit_sphere = R"("shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}})";

/// A case of a ray from (0, 0, z) along +z and the unit sphere; `rest` may hold more fields of the ray.
inline std::string sphere_case(const std::string& z, const std::string& rest = "",
                               const std::string& precision = "float32") {
  return R"({"id": 7, "precision": ")" + precision + R"(", "ray": {"origin": [0, 0, )" + z +
         R"(], "direction": [0, 0, 2])" + rest + "}, " + unit_sphere;
}

inline const std::string unsupported = "{\"id\": 7, \"unsupported\": true}\n";
inline const std::string miss = "{\"id\": 7, \"verdict\": \"miss\", \"hits\": []}\n";

/// The line of a hit with these t.
inline std::string hit_at(const std::string& t, const std::string& second = "") {
  const std::string more = second.empty() ? "" : ", {\"t\": " + second + "}";
  return "{\"id\": 7, \"verdict\": \"hit\", \"hits\": [{\"t\": " + t + "}" + more + "]}\n";
}

}  // namespace rayproof
