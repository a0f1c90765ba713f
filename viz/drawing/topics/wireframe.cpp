#include "viz/drawing/topics/wireframe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/drawing/even_odd.hpp"
#include "viz/drawing/panels.hpp"
#include "viz/drawing/topics/wireframe_scene.hpp"
#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

void draw_figure(Picture& picture, const View& view, const WireframeScene& scene, const ViewCamera& camera) {
  const Figure& figure = scene.figure;
  if (figure.ring.empty()) {
    draw_area(picture, view, Role::surface, convex_hull(camera.see(figure.extent)));
  } else {
    draw_even_odd(picture, view, Role::surface, camera.see(figure.ring));
  }
  for (const Stroke& stroke : figure.strokes(camera.toward)) {
    PixelLine line{Role::surface, {}, stroke.is_edge ? 2.0 : 1.0};
    if (stroke.is_hidden) line = {Role::surface, {}, 1.2, Pattern::dashed};
    draw_curve(picture, view, line, camera.see(stroke.points));
  }
}

/// The names of the figure's points, outward from its middle, but for those where a hit has its own name.
void draw_labels(Picture& picture, const View& view, const WireframeScene& scene, const ViewCamera& camera) {
  const std::vector<NamedMark> marks = scene.marks(camera);
  const Extent extent = Extent::of(camera.see(scene.figure.extent));
  const Point middle = view.to_pixels({(extent.left + extent.right) / 2, (extent.bottom + extent.top) / 2});
  if (extent.half_size() * view.scale_x < 30) return;
  const PixelBox& frame = view.frame;
  for (const auto& [name, place] : scene.figure.labels) {
    if (!view.shows(camera.see(place))) continue;
    const Point at = view.to_pixels(camera.see(place));
    const bool hides_hit = std::any_of(marks.begin(), marks.end(), [&](const NamedMark& mark) {
      const Point hit = view.to_pixels(mark.at);
      return std::hypot(hit.x - at.x, hit.y - at.y) < 36;
    });
    if (hides_hit) continue;
    const double away = std::max(1.0, std::hypot(at.x - middle.x, at.y - middle.y));
    const double x = std::clamp(at.x + 16 * (at.x - middle.x) / away, frame.left + 28, frame.right() - 28);
    const double y = std::clamp(at.y + 14 * (at.y - middle.y) / away, frame.top + 10, frame.bottom() - 10);
    picture.elements.emplace_back(Text{Role::surface, {x, y + 5}, name, Anchor::middle, 13, false, true});
  }
}

void draw_panel(Picture& picture, const View& view, const WireframeScene& scene, const ViewCamera& camera,
                const std::string& caption) {
  draw_frame(picture, view.frame, caption);
  draw_figure(picture, view, scene, camera);
  draw_ray_line(picture, view, scene.line(camera));
  draw_scale_bars(picture, view);
}

void draw_inset(Picture& picture, const WireframeInset& inset, const WireframeScene& scene,
                const View& main) {
  const bool is_stretched = inset.view.scale_x != inset.view.scale_y;
  draw_panel(picture, inset.view, scene, inset.camera,
             magnification(main, inset.view) + (is_stretched ? ", turned" : ", seen from another side"));
  if (inset.surface) {
    const auto& [from, to] = *inset.surface;
    draw_curve(picture, inset.view, {Role::surface, {}, 2}, {inset.camera.see(from), inset.camera.see(to)});
  }
  draw_marks(picture, inset.view, scene.marks(inset.camera));
  if (inset.measured) draw_measure(picture, inset.view, *inset.measured, inset.label);
}

std::string geometry_of(const WireframeScene& scene, const ViewCamera& camera) {
  const Extent extent = Extent::of(camera.see(scene.figure.extent));
  std::string text = fmt::format("Direction of length {}", rough(scene.direction_size, 4));
  if (scene.figure.borders.empty()) return text + "; a patch of the plane is drawn.";
  text += fmt::format("; the figure is seen {} across", rough(2 * extent.half_size(), 3));
  if (const auto nearest = nearest_of(scene)) {
    text += nearest->gap > ldexp(extent.half_size(), -200)
                ? fmt::format("; the ray passes {} from its outline", rough(nearest->gap, 3))
                : "; the ray passes through its outline";
  }
  return text + ".";
}

std::string caption_of(const Fitted& fitted) {
  if (fitted.leaves_ray_out) return "The figure alone, to scale; the ray passes too far off to be shown";
  return fitted.leaves_start_out ? "The figure to scale; the distance to it shortened" : "To scale";
}

}  // namespace

Picture wireframe_picture(FigureMaker figure, const Case& one, const Answer* exact, const Answer* claimed) {
  const WireframeScene scene = scene_of(figure, one, exact, claimed);
  const ViewCamera camera = scene.main_camera();
  const bool is_moved = scene.sight.question.transform.has_value();
  Picture picture = begin_picture(fmt::format("Ray and {}{}", is_moved ? "transformed " : "", topic_of(one)),
                                  one, headline_of(one, exact, claimed), geometry_of(scene, camera));
  const Panels panels;
  const std::vector<NamedMark> marks = scene.marks(camera);
  const RayLine line = scene.line(camera);
  const Extent extent = Extent::of(camera.see(scene.figure.extent));
  Fitted main = fit(panels.left, extent, line, marks);
  const auto inset = inset_of(scene, camera, main.view, panels.right);
  if (!inset) main = fit(panels.whole, extent, line, marks);
  draw_panel(picture, main.view, scene, camera, caption_of(main));
  if (!main.leaves_ray_out) {
    draw_marks(picture, main.view, marks);
    draw_marks_beyond(picture, main.view, marks);
    const Place start = scene.at(scene.sight.ray.t_min);
    if (line.start) draw_start_beyond(picture, main.view, line, length(start - camera.origin));
  }
  draw_labels(picture, main.view, scene, camera);
  if (inset) {
    View seen_in_main = inset->view;
    seen_in_main.centre = camera.see(inset->middle);
    draw_focus(picture, main.view, seen_in_main);
    draw_inset(picture, *inset, scene, main.view);
  }
  finish_picture(picture, panels, "t", one, exact, claimed);
  return picture;
}

}  // namespace rayproof::viz
