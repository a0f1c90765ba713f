#include "generators/generators.hpp"

namespace rayproof {

// Each in its topic's file; a new topic has its declaration and its name below.
std::vector<Family> sphere_families();
std::vector<Family> quadratic_families();
std::vector<Family> plane_families();
std::vector<Family> triangle_families();
std::vector<Family> polygon_families();
std::vector<Family> point_in_polygon_families();
std::vector<Family> box_families();
std::vector<Family> parallelepiped_families();
std::vector<Family> cylinder_families();

constexpr std::vector<Family> (*of_each_topic[])() = {
    sphere_families,            //
    quadratic_families,         //
    plane_families,             //
    triangle_families,          //
    polygon_families,           //
    point_in_polygon_families,  //
    box_families,               //
    parallelepiped_families,    //
    cylinder_families,          //
};

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> gathered;
    for (const auto of_topic : of_each_topic)
      for (Family& family : of_topic()) gathered.push_back(std::move(family));
    return gathered;
  }();
  return all;
}

}  // namespace rayproof
