#pragma once
/// \file
/// The registration of the bindings: each topic's table of how its named values look, a function and a line.

#include "viz/scene/items.hpp"

namespace rayproof::viz {

[[nodiscard]] std::vector<Binding> plane_bindings();
[[nodiscard]] std::vector<Binding> triangle_bindings();
[[nodiscard]] std::vector<Binding> sphere_bindings();
[[nodiscard]] std::vector<Binding> cylinder_bindings();
[[nodiscard]] std::vector<Binding> box_bindings();
[[nodiscard]] std::vector<Binding> parallelepiped_bindings();
[[nodiscard]] std::vector<Binding> quadratic_bindings();

/// A method's answer, which looks alike in every topic: a point on the ray where the rounded arithmetic has
/// it.
[[nodiscard]] Binding answer(const char* name);

/// A vector that is a place: its point, with its name.
[[nodiscard]] Binding marked(const char* name, Role role);

/// "W > 0": the sign of a number as the kernel has it.
[[nodiscard]] std::string with_sign(const char* name, const NumbersByName& n);

struct TopicBindings {
  const char* topic;
  std::vector<Binding> (*table)();
};
inline constexpr TopicBindings topic_bindings[] = {
    {"plane", plane_bindings},                    //
    {"triangle", triangle_bindings},              //
    {"sphere", sphere_bindings},                  //
    {"cylinder", cylinder_bindings},              //
    {"box", box_bindings},                        //
    {"parallelepiped", parallelepiped_bindings},  //
    {"quadratic", quadratic_bindings},            //
};

/// `v` with the length `length`: of what has the direction of an arrow but, being an area, no length.
[[nodiscard]] glm::dvec3 resized(const glm::dvec3& v, double length);

/// A vector at right angles to `v`, of the same length.
[[nodiscard]] glm::dvec3 across(const glm::dvec3& v);
[[nodiscard]] Items direction_arrow(const NumbersByName& n);

/// The chord of a round shape, as the centred methods have it: t_c in its middle, h to either side.
[[nodiscard]] Items half_chords(const NumbersByName& n);

/// From a corner along u and v to the point of the plane with these parameters.
[[nodiscard]] Items parameters_from(const NumbersByName& n, const glm::dvec3& corner);

/// From the ray's origin straight to the plane through `on_plane`, and on in the plane to that point.
[[nodiscard]] Items way_to_plane(const NumbersByName& n, const glm::dvec3& normal,
                                 const glm::dvec3& on_plane);

}  // namespace rayproof::viz
