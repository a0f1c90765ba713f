#include "viz/flat/projection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "viz/drawing/topics/figure.hpp"

namespace rayproof::viz {

double ScreenProjection::pixels_per_length() const {
  constexpr double margin = 56;  // pixels, for marks and labels
  const double half = std::min(frame.width / view_aspect - margin, frame.height - margin) / 2;
  return half / view.radius;
}

Point ScreenProjection::to_pixels(const glm::dvec3& p) const {
  const glm::dvec3 q = (p - view.centre) * pixels_per_length();
  const Point middle = frame.centre();
  return {middle.x + glm::dot(q, camera.right), middle.y - glm::dot(q, camera.up)};
}

std::vector<Point> ScreenProjection::to_pixels(const std::vector<glm::dvec3>& points) const {
  std::vector<Point> pixels;
  pixels.reserve(points.size());
  for (const glm::dvec3& p : points) pixels.push_back(to_pixels(p));
  return pixels;
}

std::vector<Point> ellipsoid_outline(const ScreenProjection& projection,
                                     const std::vector<glm::dvec3>& ellipsoid) {
  const Point centre = projection.to_pixels(ellipsoid.at(0));
  // The ball's image under the columns m: of all its points, the one farthest in the direction n is
  // M·Mᵀ·n / |Mᵀ·n|.
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 1; i < ellipsoid.size(); ++i) {
    const Point tip = projection.to_pixels(ellipsoid[i]);
    const double x = tip.x - centre.x;
    const double y = tip.y - centre.y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  std::vector<Point> outline;
  constexpr int sides = 96;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double size = std::sqrt(std::max(xx * c * c + 2 * xy * c * s + yy * s * s, 1e-300));
    outline.push_back({centre.x + (xx * c + xy * s) / size, centre.y + (xy * c + yy * s) / size});
  }
  return outline;
}

std::vector<Point> hull_outline(const std::vector<Point>& points) {
  std::vector<WorldPoint> exact;
  for (const Point& p : points) exact.push_back({p.x, p.y});
  std::vector<Point> outline;
  for (const WorldPoint& p : convex_hull(std::move(exact))) {
    outline.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  }
  return outline;
}

}  // namespace rayproof::viz
