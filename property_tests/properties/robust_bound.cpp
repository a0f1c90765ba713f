#include "properties/robust_bound.hpp"

#include <rayproof/quadratic.hpp>
#include <rayproof/sphere.hpp>

namespace rayproof {

std::optional<double> robust_bound(std::string_view topic) {
  if (topic == "sphere") return sphere_robust_bound;
  if (topic == "quadratic") return quadratic_robust_bound;
  return std::nullopt;
}

}  // namespace rayproof
