#include "viz/scene/space.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "viz/picture/picture.hpp"
#include "viz/scene/items.hpp"

namespace rayproof::viz {
namespace {

constexpr double elevation = 20;  ///< degrees, of the eye above the floor

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The world's z axis; for a ray that runs along it y.
glm::dvec3 upright_axis(const glm::dvec3& ray) {
  return std::abs(ray.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
}

/// From above the floor: from the stage's own side where that has the same axis up, else as near to it as can
/// be so that the ray and plane surfaces are seen.
glm::dvec3 side_of(const Stage& stage, const glm::dvec3& up, const glm::dvec3& ray) {
  const auto raised = [&](const glm::dvec3& level) {
    return std::cos(radians(elevation)) * level + std::sin(radians(elevation)) * up;
  };
  const glm::dvec3& toward = stage.camera.toward;
  if (glm::dot(stage.camera.up, up) > 0.7) return raised(glm::normalize(toward - glm::dot(toward, up) * up));
  std::vector<glm::dvec3> normals;
  for (const StageItem& item : stage.scene) {
    if (item.form != Form::polygon || item.points.size() < 3) continue;
    const glm::dvec3 n = glm::cross(item.points[1] - item.points[0], item.points[2] - item.points[0]);
    if (glm::length(n) > 0) normals.push_back(glm::normalize(n));
  }
  const glm::dvec3 x = up.z != 0 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1), y = glm::cross(up, x);
  glm::dvec3 best(0);
  double most = -std::numeric_limits<double>::infinity();
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const glm::dvec3 from = raised(std::cos(radians(degrees)) * x + std::sin(radians(degrees)) * y);
    const double along = glm::dot(from, ray);
    double seen = std::min(1.0, std::sqrt(1 - std::min(1.0, along * along)) / 0.8);
    for (const glm::dvec3& n : normals) seen = std::min(seen, std::abs(glm::dot(from, n)) / 0.5);
    const double score = 2 * seen + 0.5 * glm::dot(from, toward) + 0.3 * glm::dot(glm::cross(up, from), ray);
    if (score <= most) continue;
    most = score;
    best = from;
  }
  return best;
}

/// The middle of what the points take up as they are seen.
glm::dvec3 middle_of(const std::vector<glm::dvec3>& points, const StageCamera& camera) {
  glm::dvec3 middle(0);
  for (const glm::dvec3& axis : {camera.right, camera.up, camera.toward}) {
    const auto along = [&](const glm::dvec3& a, const glm::dvec3& b) {
      return glm::dot(a, axis) < glm::dot(b, axis);
    };
    const auto [least, most] = std::minmax_element(points.begin(), points.end(), along);
    middle += 0.5 * (glm::dot(*least, axis) + glm::dot(*most, axis)) * axis;
  }
  return middle;
}

/// The points that the stage's own view shows; of round things the outline as it is seen from the eye.
std::vector<glm::dvec3> points_in_view(const StageCamera& chosen, const StageView& view,
                                       const StageCamera& eye, const std::vector<ShownItem>& shown) {
  constexpr double a_little_more = 1.15;  // with the ray's head
  std::vector<glm::dvec3> points;
  for (const ShownItem& one : shown) {
    for (const glm::dvec3& p : extent_of(*one.item, eye)) {
      const glm::dvec3 q = in_view(view, p);
      const bool is_in = std::abs(glm::dot(q, chosen.right)) <= a_little_more * view_aspect &&
                         std::abs(glm::dot(q, chosen.up)) <= a_little_more && glm::length(q) <= reach;
      if (is_in) points.push_back(q);
    }
  }
  if (points.size() < 2) points = {chosen.up, -chosen.up};
  return points;
}

/// From where the camera looks at, so far that all points are in the picture.
double distance_for(const std::vector<glm::dvec3>& points, const SpaceCamera& camera, const StageCamera& eye,
                    double aspect) {
  const double half = std::tan(radians(view_angle / 2));
  double distance = 0;
  for (const glm::dvec3& p : points) {
    const glm::dvec3 q = p - camera.middle;
    const double size = std::max(std::abs(glm::dot(q, eye.right)) / aspect, std::abs(glm::dot(q, eye.up)));
    distance = std::max(distance, view_margin * size / half + glm::dot(q, eye.toward));
  }
  return distance;
}

/// How far the middle of what the points take up in the picture lies off the picture's.
glm::dvec3 off_the_middle(const std::vector<glm::dvec3>& points, const SpaceCamera& camera,
                          const StageCamera& eye) {
  glm::dvec3 off(0);
  for (const glm::dvec3& axis : {eye.right, eye.up}) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const glm::dvec3& p : points) {
      const glm::dvec3 q = p - camera.middle;
      const double seen = camera.distance * glm::dot(q, axis) / (camera.distance - glm::dot(q, eye.toward));
      least = std::min(least, seen);
      most = std::max(most, seen);
    }
    off += 0.5 * (least + most) * axis;
  }
  return off;
}

/// A drawing in a frame that is wider than a view: as near as its height allows.
SpaceCamera fitted(SpaceCamera camera, const Stage& stage, const StageView& view,
                   const std::vector<ShownItem>& shown, double aspect) {
  if (aspect <= view_aspect) return camera;
  constexpr PixelBox whole{-view_aspect, -1, 2 * view_aspect, 2};
  double half = view_aspect / aspect;
  for (const ShownItem& one : shown) {
    std::vector<Point> line;
    for (const glm::dvec3& p : extent_of(*one.item, stage.camera)) {
      const glm::dvec3 q = in_view(view, p);
      line.push_back({glm::dot(q, stage.camera.right), glm::dot(q, stage.camera.up)});
    }
    if (line.size() == 1) line.push_back(line.front());
    for (const std::vector<Point>& part : clip_line(line, whole))
      for (const Point& p : part) half = std::max(half, std::abs(p.y));
  }
  camera.half = view_margin * half;
  return camera;
}

}  // namespace

double SpaceCamera::unit() const {
  return (is_flat ? half : distance * std::tan(radians(view_angle / 2))) / view_margin;
}

SpaceCamera space_camera(const Stage& stage, std::size_t step, const std::vector<ShownItem>& shown,
                         double aspect) {
  SpaceCamera camera{stage.camera.up, stage.camera.toward,
                     glm::dvec3(0),   view_margin / std::tan(radians(view_angle / 2)),
                     view_margin,     true};
  if (stage.camera.is_flat || (stage.steps.at(step).is_apart && !stage.steps.at(step).is_other_space))
    return fitted(camera, stage, stage.steps[step].view, shown, aspect);
  camera.is_flat = false;
  const auto* const asked = std::get_if<RayQuestion>(&stage.one.question);
  const bool has_ray = asked != nullptr && glm::length(asked->ray.direction) > 0;
  const glm::dvec3 ray = has_ray ? glm::normalize(asked->ray.direction) : stage.camera.right;
  camera.up = upright_axis(ray);
  camera.toward = side_of(stage, camera.up, ray);
  const glm::dvec3 right = glm::normalize(glm::cross(camera.up, camera.toward));
  const StageCamera eye{right, glm::cross(camera.toward, right), camera.toward};
  const std::vector<glm::dvec3> points = points_in_view(stage.camera, stage.steps.at(step).view, eye, shown);
  camera.middle = middle_of(points, eye);
  // What is near takes up more of the picture: its middle is found step by step.
  for (int i = 0; i < 4; ++i) {
    camera.distance = distance_for(points, camera, eye, aspect);
    camera.middle += off_the_middle(points, camera, eye);
  }
  camera.distance = distance_for(points, camera, eye, aspect);
  return camera;
}

}  // namespace rayproof::viz
