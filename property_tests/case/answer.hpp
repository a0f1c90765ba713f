#pragma once
/// \file
/// An answer to a case, whoever gave it: the oracle, one of our methods, or somebody else's program.

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <rayproof/polygon.hpp>
#include <rayproof/quadratic.hpp>
#include <span>
#include <variant>

namespace rayproof {

/// How the first hit touches, or why there is none; the names of the case format.
enum class Contact { crossing, tangent, edge, vertex, rim, in_surface, parallel, degenerate, none };

/// The name of the case format.
[[nodiscard]] constexpr const char* name_of(Contact contact) {
  switch (contact) {
    case Contact::crossing:
      return "crossing";
    case Contact::tangent:
      return "tangent";
    case Contact::edge:
      return "edge";
    case Contact::vertex:
      return "vertex";
    case Contact::rim:
      return "rim";
    case Contact::in_surface:
      return "in_surface";
    case Contact::parallel:
      return "parallel";
    case Contact::degenerate:
      return "degenerate";
    case Contact::none:
      break;
  }
  return "none";
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
  std::optional<glm::dvec3> point{};        ///< of the first hit
  std::optional<glm::dvec3> normal{};       ///< of the first hit, a unit vector
  std::optional<glm::dvec3> barycentric{};  ///< of a triangle's hit, [α, β, γ] of a, b, c
};

/// The name of the case format.
[[nodiscard]] constexpr const char* name_of(Position position) {
  if (position == Position::inside) return "inside";
  return position == Position::boundary ? "boundary" : "outside";
}

/// The name of the case format.
[[nodiscard]] constexpr const char* name_of(RootKind kind) {
  switch (kind) {
    case RootKind::two:
      return "two";
    case RootKind::twice:
      return "double";
    case RootKind::linear:
      return "linear";
    case RootKind::constant:
      return "constant";
    case RootKind::everything:
      return "everything";
    case RootKind::none:
      break;
  }
  return "none";
}

/// The answer to any case.
using Answer = std::variant<RayAnswer, QuadraticAnswer<double>, Position>;

}  // namespace rayproof
