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

constexpr std::pair<const char*, std::vector<Family> (*)()> of_each_topic[] = {
    {"sphere", sphere_families},                      //
    {"quadratic", quadratic_families},                //
    {"plane", plane_families},                        //
    {"triangle", triangle_families},                  //
    {"polygon", polygon_families},                    //
    {"point_in_polygon", point_in_polygon_families},  //
    {"box", box_families},                            //
    {"parallelepiped", parallelepiped_families},      //
    {"cylinder", cylinder_families},                  //
};

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> gathered;
    for (const auto& [topic, families_of_topic] : of_each_topic)
      for (Family& family : families_of_topic()) {
        family.topic = topic;
        gathered.push_back(std::move(family));
      }
    return gathered;
  }();
  return all;
}

}  // namespace rayproof
