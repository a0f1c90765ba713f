#include "generators/generators.hpp"

namespace rayproof {

namespace {

std::vector<Family> every_family() {
  std::vector<Family> all;
  for (const auto topic : {
           sphere_families,     //
           quadratic_families,  //
       })
    for (Family& family : topic()) all.push_back(std::move(family));
  return all;
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = every_family();
  return all;
}

}  // namespace rayproof
