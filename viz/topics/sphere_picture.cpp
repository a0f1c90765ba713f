#include "viz/topics/sphere_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/answers.hpp"
#include "viz/numbers.hpp"
#include "viz/panels.hpp"
#include "viz/topics/sphere_scene.hpp"

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

/// The stretch of the line that is the ray, solid; the rest of the line, dotted; an arrow's head at its end.
void draw_ray(Picture& picture, const View& view, const SphereScene& scene) {
  const Shadow left = view.centre.x - view.half_width();
  const Shadow right = view.centre.x + view.half_width();
  const Shadow from = scene.has_start() ? std::clamp<Shadow>(scene.start().x, left, right) : left;
  const Shadow to = scene.has_end() ? std::clamp<Shadow>(scene.end().x, left, right) : right;
  draw_curve(picture, view, {Role::muted, {}, 1.5, Pattern::dotted}, {{left, 0}, {right, 0}});
  draw_curve(picture, view, {Role::ray, {}, 2}, {{from, 0}, {to, 0}});
  if (to == right && from < right && view.shows({right - view.half_width() / 100, 0})) {
    const Point tip = view.to_pixels({right, 0});
    picture.elements.emplace_back(
        Line{Role::ray, {{tip.x - 12, tip.y - 6}, {tip.x - 1, tip.y}, {tip.x - 12, tip.y + 6}}, 2});
  }
  if (scene.has_start()) draw_mark(picture, view, Role::ray, MarkShape::dot, scene.start());
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

/// What can't be shown at this scale: the start beyond a break, hits beyond the frame.
void draw_beyond(Picture& picture, const View& view, const SphereScene& scene) {
  const Box& frame = view.frame;
  const double y = view.to_pixels({view.centre.x, 0}).y;
  if (scene.has_start() && !view.shows(scene.start())) {
    const bool is_left = scene.start().x < view.centre.x;
    const double sign = is_left ? 1 : -1;
    const double x = (is_left ? frame.left : frame.right()) + 16 * sign;
    picture.elements.emplace_back(Mark{Role::ray, MarkShape::dot, {x, y}});
    for (const double shift : {20.0, 27.0}) {
      const double at = x + sign * shift;
      picture.elements.emplace_back(Line{Role::text, {{at - 4, y + 9}, {at + 4, y - 9}}, 2});
    }
    picture.elements.emplace_back(Text{Role::text,
                                       {x, y - 18},
                                       fmt::format("start, {} off", rough(abs(scene.start().x), 4)),
                                       is_left ? Anchor::start : Anchor::end,
                                       13});
  }
  draw_marks_beyond(picture, view, scene.hits);
}

void draw_scene(Picture& picture, const View& view, const SphereScene& scene, const std::string& caption) {
  draw_frame(picture, view.frame, caption);
  draw_sphere(picture, view, scene.plane);
  draw_ray(picture, view, scene);
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
             main.is_broken ? "The sphere to scale; the way to it shortened" : "To scale");
  draw_beyond(picture, main.view, scene);
  if (inset) {
    draw_focus(picture, main.view, inset->view);
    draw_scene(picture, inset->view, scene, magnification(main.view, inset->view));
    if (inset->measured) draw_measure(picture, inset->view, *inset->measured, inset->label);
  }
  finish_picture(picture, panels, "t", one, exact, claimed);
  return picture;
}

}  // namespace rayproof::viz
