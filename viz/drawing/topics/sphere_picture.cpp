#include "viz/drawing/topics/sphere_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/drawing/panels.hpp"
#include "viz/drawing/topics/ray_line.hpp"
#include "viz/drawing/topics/sphere_scene.hpp"
#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

void draw_sphere(Picture& picture, const View& view, const RayPlane& plane) {
  if (plane.radius == 0) {
    draw_mark(picture, view, Role::surface, MarkShape::dot, plane.centre());
    return;
  }
  const auto outline = circle_outline(view, plane.centre(), plane.radius);
  draw_area(picture, view, Role::surface, outline);
  draw_curve(picture, view, {Role::surface, {}, 2}, outline);
}

/// The ray on the picture's x axis.
RayLine line_of(const SphereScene& scene) {
  RayLine line;
  if (scene.has_start()) line.start = scene.start().x;
  if (scene.has_end()) line.end = scene.end().x;
  return line;
}

/// The line from the centre to the ray's nearest point, where there is room for it.
void draw_nearest(Picture& picture, const View& view, const RayPlane& plane) {
  if (plane.height * view.scale_y < 20 || !view.shows(plane.centre())) return;
  draw_curve(picture, view, {Role::nearest, {}, 1.5, Pattern::dashed}, {plane.centre(), {0, 0}});
  draw_mark(picture, view, Role::nearest, MarkShape::diamond, plane.centre());
  const Point at = view.to_pixels(plane.centre());
  picture.elements.emplace_back(
      Text{Role::nearest, {at.x + 12, at.y + 5}, rough(plane.height, 4), Anchor::start, 13, false, true});
}

void draw_scene(Picture& picture, const View& view, const SphereScene& scene, const std::string& caption) {
  draw_frame(picture, view.frame, caption);
  draw_sphere(picture, view, scene.plane);
  draw_ray_line(picture, view, line_of(scene));
  draw_nearest(picture, view, scene.plane);
  draw_marks(picture, view, scene.hits);
  draw_scale_bars(picture, view);
}

std::string geometry_of(const SphereScene& scene) {
  const RayPlane& plane = scene.plane;
  std::string gap;
  if (plane.gap() != 0) {
    gap = fmt::format(", {} {}", rough(abs(plane.gap()), 3), plane.gap() > 0 ? "outside" : "inside");
  }
  return fmt::format("Radius {}; origin {} from the centre; the line passes {} from it{}.",
                     rough(plane.radius, 4), rough(plane.distance, 4), rough(plane.height, 4), gap);
}

}  // namespace

Picture sphere_picture(const Case& one, const Answer* exact, const Answer* claimed) {
  const SphereScene scene = scene_of(one, exact, claimed);
  const char* const what = scene.plane.is_transformed
                               ? "Ray and transformed sphere, drawn in the sphere's own space,"
                               : "Ray and sphere";
  Picture picture = begin_picture(what, one, headline_of(one, exact, claimed), geometry_of(scene));
  const Panels panels;
  MainView main = main_view(scene, panels.left);
  const std::optional<Inset> inset = inset_of(scene, main.view, panels.right);
  if (!inset) main = main_view(scene, panels.whole);
  draw_scene(picture, main.view, scene,
             main.is_broken ? "The sphere to scale; the distance to it shortened" : "To scale");
  if (scene.has_start()) draw_start_beyond(picture, main.view, line_of(scene), abs(scene.start().x));
  draw_marks_beyond(picture, main.view, scene.hits);
  if (inset) {
    draw_focus(picture, main.view, inset->view);
    draw_scene(picture, inset->view, scene, magnification(main.view, inset->view));
    if (inset->measured) draw_measure(picture, inset->view, *inset->measured, inset->label);
  }
  finish_picture(picture, panels, "t", one, exact, claimed);
  return picture;
}

}  // namespace rayproof::viz
