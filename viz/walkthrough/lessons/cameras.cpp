#include "viz/scene/items.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/lessons/camera_image.hpp"

namespace rayproof::viz {
namespace {

using namespace camera_image;

template <class R>
rayproof::Camera<R> named_camera() {
  return {named("eye", convert<R>(eye.eye)), named("center", convert<R>(eye.center)),
          named("up", convert<R>(eye.up)), named("half_w", R(eye.half_width)),
          named("half_h", R(eye.half_height))};
}

Binding axis(const char* name) {
  return {name, [=](const NumbersByName& n) {
            return Items{arrow(Role::edge, eye.eye, eye.eye + 0.6 * n.vector(name), name)};
          }};
}

Items placed_pixel(const NumbersByName& n) {
  return {pixel(Role::nearest, pixel_i, pixel_j),
          point(Role::nearest, on_image(n["x"], n["y"]), "pixel (4, 2)")};
}

/// Where the printed formula, without the half pixel, puts the pixel.
Items printed_corner(const NumbersByName& /*n*/) {
  return {point(Role::edge, corner_of(pixel_i, pixel_j), "corner (4, 2)")};
}

Items parts_of_direction(const NumbersByName& n) {
  const CameraAxes<double> axes = camera::axes(eye);
  const glm::dvec3 middle = eye.eye - axes.w;
  return {segment(Role::edge, middle, middle + n["α"] * axes.u, "α·u"),
          segment(Role::edge, middle + n["α"] * axes.u, middle + n["α"] * axes.u + n["β"] * axes.v, "β·v")};
}

}  // namespace

Stage camera_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const Walkthrough walk = record(one.precision, []<class R>(std::type_identity<R>) {
    const auto camera = named_camera<R>();
    const auto axes = camera::axes(camera);
    (void)camera::PixelCentre::ray(camera, axes, ImageSize<R>{R(width), R(height)}, R(pixel_i), R(pixel_j));
  });
  Setting setting = setting_of(report);
  setting.scene = grid();
  setting.scene.push_back(point(Role::ray, eye.eye, "eye"));
  setting.camera = behind_the_eye(39);
  Items in_sight = setting.scene;
  const CameraAxes<double> axes = camera::axes(eye);
  for (const glm::dvec3& axis : {axes.u, axes.v, axes.w})
    in_sight.push_back(arrow(Role::edge, eye.eye, eye.eye + 0.6 * axis));
  setting.near = setting.wide = view_of(extent_of(in_sight, setting.camera), setting.camera);
  setting.slider->origin = eye.eye;
  setting.slider->from = 0;
  setting.slider->to = 1.4;
  setting.slider->start = 1;
  setting.bindings = {axis("w"),
                      axis("u"),
                      axis("v"),
                      {"y", placed_pixel},
                      {"Place the pixel's centre in the image", printed_corner},
                      {"β", parts_of_direction},
                      {"d", [](const NumbersByName& n) {
                         return Items{arrow(Role::ray, eye.eye, eye.eye + 1.35 * n.vector("d"), "the ray")};
                       }}};
  Stage stage = run_stage(report, walk, setting);
  stage.slider->direction = std::get<RayQuestion>(one.question).ray.direction;
  stage.slider->readouts.clear();
  return stage;
}

}  // namespace rayproof::viz
