#include "viz/walkthrough/setting.hpp"

#include <algorithm>
#include <cmath>

#include "viz/explain/case_report.hpp"
#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

Items parabola_items(const Quadratic<double>& q, const ParabolaFrame& frame) {
  Items items;
  const glm::dvec3 reach{1.08, 0, 0};
  items.push_back(arrow(Role::ray, -reach, reach, "x"));
  std::vector<glm::dvec3> curve;
  constexpr int pieces = 96;
  for (int i = 0; i <= pieces; ++i) {
    const double x = frame.left + (frame.right - frame.left) * i / pieces;
    const glm::dvec3 p = frame.at(x, (q.a * x + q.b) * x + q.c);
    if (std::abs(p.y) <= plot_height) curve.push_back(p);
  }
  items.push_back(polyline(Role::surface, curve, "ax² + bx + c"));
  return items;
}

Setting quadratic_setting(const CaseReport& report) {
  const auto& q = std::get<Quadratic<double>>(report.one.question);
  std::vector<double> roots = values_of(&report.exact);
  const ParabolaFrame frame = parabola_frame(q, roots);
  Setting setting;
  setting.scene = parabola_items(q, frame);
  setting.camera.is_flat = true;
  setting.near = setting.wide = view_of(extent_of(setting.scene, setting.camera), setting.camera);
  StageSlider slider;
  slider.symbol = "x";
  const double per_x = 2 / (frame.right - frame.left);
  slider.origin = {-(frame.left + frame.right) / 2 * per_x, 0, 0};
  slider.direction = {per_x, 0, 0};
  slider.from = frame.left;
  slider.to = frame.right;
  slider.start = roots.empty() ? (frame.left + frame.right) / 2 : roots.front();
  slider.shows_point = false;
  slider.readouts = {{"ax² + bx + c", {q.c, q.b, q.a}}};
  setting.slider = slider;
  return setting;
}

Setting polygon_setting(const CaseReport& report) {
  const auto& question = std::get<PointAndPolygon<double>>(report.one.question);
  std::vector<glm::dvec3> ring;
  for (const auto& vertex : question.vertices) ring.emplace_back(vertex.x, vertex.y, 0);
  const glm::dvec3 p(question.point.x, question.point.y, 0);
  std::vector<glm::dvec3> all = ring;
  all.push_back(p);
  Setting setting;
  setting.camera.is_flat = true;
  setting.near = setting.wide = view_of(all, setting.camera);
  setting.scene.push_back(polygon(Role::surface, ring));
  for (std::size_t i = 0; i < ring.size(); ++i)
    setting.scene.push_back(point(Role::surface, ring[i], "v" + subscript(i)));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    setting.scene.push_back(segment(Role::surface, ring[i], ring[(i + 1) % ring.size()]));
  }
  const glm::dvec3 end =
      p + glm::dvec3(1, 0, 0) *
              std::max(0.2, setting.near.centre.x + 0.95 * view_aspect * setting.near.radius - p.x);
  setting.scene.push_back(arrow(Role::ray, p, end, "+x"));
  setting.close_up = close_up_of(ring, p);
  setting.scene.push_back(point(Role::ray, p, "p"));
  return setting;
}

}  // namespace

ParabolaFrame parabola_frame(const Quadratic<double>& q, const std::vector<double>& roots) {
  const double vertex = q.a == 0 ? 0 : -q.b / (2 * q.a);
  double left = std::isfinite(vertex) ? vertex : 0;
  double right = left;
  for (const double root : roots) {
    if (!std::isfinite(root)) continue;
    left = std::min(left, root);
    right = std::max(right, root);
  }
  const double part = right > left ? (right - left) * 0.35 : std::max(1.0, std::abs(left));
  ParabolaFrame frame{left - part, right + part, 1};
  double low = 0;
  double high = 0;
  for (const double x : {frame.left, frame.right, std::clamp(vertex, frame.left, frame.right)}) {
    const double y = (q.a * x + q.b) * x + q.c;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  frame.height = high - low;
  if (!(frame.height > 0) || !std::isfinite(frame.height)) frame.height = 1;
  return frame;
}

Setting flat_setting(const CaseReport& report) {
  Setting setting = std::holds_alternative<Quadratic<double>>(report.one.question) ? quadratic_setting(report)
                                                                                   : polygon_setting(report);
  setting.to_world = [](const glm::dvec3& p) { return p; };
  return setting;
}

}  // namespace rayproof::viz
