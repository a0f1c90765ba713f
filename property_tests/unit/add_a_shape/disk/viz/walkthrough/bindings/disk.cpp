#include "viz/walkthrough/bindings.hpp"

namespace rayproof::viz {
namespace {

Items radius_and_offset(const NumbersByName& n) {
  const glm::dvec3 center = n.vector("C"), q = n.vector("q");
  return {segment(Role::nearest, center, center + q, "|q|"),
          segment(Role::edge, center, center + resized(q, n["r"]), "r")};
}

}  // namespace

std::vector<Binding> disk_bindings() {
  return {
      {"f",
       [](const NumbersByName& n) {
         return Items{arrow(Role::edge, n.origin(), n.vector("C"), "f"),
                      way_to_plane(n, n.vector("n"), n.vector("C"))[0]};
       }},
      {"q",
       [](const NumbersByName& n) {
         return Items{arrow(Role::edge, n.vector("C"), n.vector("C") + n.vector("q"), "q")};
       }},
      {"r²", radius_and_offset},
  };
}

}  // namespace rayproof::viz
