#include <cmath>

#include "viz/walkthrough/bindings.hpp"

namespace rayproof::viz {
namespace {

/// A point on the sphere, in the direction of the ray point nearest the centre.
glm::dvec3 nearest_on_sphere(const NumbersByName& n) {
  const glm::dvec3 l = n.vector("l");
  const glm::dvec3 out = glm::length(l) > 0 ? l : across(n.direction());
  return n.vector("C") + resized(out, n["r"]);
}

/// The hypotenuse r of the right triangle whose legs are l and half the chord; where the line misses, r
/// beside l.
Items radius_and_distance(const NumbersByName& n) {
  if (!n.has_vector("l")) return {};
  const double half_chord = n.has("1/a") ? std::sqrt(n["D"] * n["1/a"]) : NAN;  // in t
  const glm::dvec3 tip = half_chord >= 0 ? n.at(n["t_c"] - half_chord) : nearest_on_sphere(n);
  return {segment(Role::edge, n.vector("C"), tip, "r", Pattern::dashed)};
}

}  // namespace

std::vector<Binding> sphere_bindings() {
  return {
      {"f", [](const NumbersByName& n) { return Items{arrow(Role::edge, n.vector("C"), n.origin(), "f")}; }},
      {"a", direction_arrow},
      {"t_c", [](const NumbersByName& n) { return Items{point(Role::nearest, n.at(n["t_c"]), "t_c")}; }},
      {"l",
       [](const NumbersByName& n) {
         return Items{arrow(Role::nearest, n.vector("C"), n.vector("C") + n.vector("l"), "l")};
       }},
      {"D", radius_and_distance},
      {"h", half_chords},
      {"√D",
       [](const NumbersByName& n) {
         // A formula as printed may give other ends.
         const double off = glm::length(n.at(n["t₀"]) - n.vector("C")) - n["r"];
         const bool is_chord = std::abs(off) < 1e-3 * n["r"];
         return Items{
             segment(Role::edge, n.at(n["t₀"]), n.at(n["t₁"]), is_chord ? "the chord" : "as printed")};
       }},
      answer("t₀"),
      answer("t₁"),
  };
}

}  // namespace rayproof::viz
