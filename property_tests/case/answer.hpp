#pragma once
/// \file
/// An answer to a case, whoever gave it: the oracle, one of our methods, or somebody else's program.

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <rayproof/polygon.hpp>
#include <rayproof/quadratic.hpp>
#include <span>
#include <variant>

namespace rayproof {

/// How the first hit touches, or why there is none.
enum class Contact { crossing, tangent, edge, vertex, rim, in_surface, parallel, degenerate, none };

/// The name of the case format; the names stand in the order of the enumeration.
[[nodiscard]] constexpr const char* name_of(Contact contact) {
  constexpr std::array names{"crossing",   "tangent",  "edge",       "vertex", "rim",
                             "in_surface", "parallel", "degenerate", "none"};
  return names.at(static_cast<std::size_t>(contact));
}

/// A short list of t, ascending. No shape of the format is met more than four times by a line.
struct HitList {
  std::array<double, 4> t{};
  std::size_t count = 0;
  void push_back(double value) { t.at(count++) = value; }
  [[nodiscard]] std::span<const double> view() const { return {t.data(), count}; }
};

/// The answer to a RayQuestion. The verdict is `hit` where `hits` is not empty.
struct RayAnswer {
  Contact contact = Contact::none;
  HitList hits{};
  bool nearest_only = false;                ///< the subject reports no hit but the first
  bool says_contact = true;                 ///< the subject says how it touches, or why it misses
  bool verdict_only = false;                ///< it says whether, and no t: that of a hit is NaN
  std::optional<glm::dvec3> point{};        ///< of the first hit
  std::optional<glm::dvec3> normal{};       ///< of the first hit, a unit vector
  std::optional<glm::dvec3> barycentric{};  ///< of a triangle's hit, [α, β, γ] of a, b, c
  std::optional<glm::dvec2> parameters{};  ///< of a parametric plane's hit, [α, β] of point + α·u + β·v
};

/// The name of the case format.
[[nodiscard]] constexpr const char* name_of(Position position) {
  constexpr std::array names{"outside", "boundary", "inside"};
  return names.at(static_cast<std::size_t>(position));
}

/// The name of the case format.
[[nodiscard]] constexpr const char* name_of(RootKind kind) {
  constexpr std::array names{"two", "double", "none", "linear", "constant", "everything"};
  return names.at(static_cast<std::size_t>(kind));
}

/// The answer to any case.
using Answer = std::variant<RayAnswer, QuadraticAnswer<double>, Position>;

}  // namespace rayproof
