/// \file
/// VTK's vtkTriangle, vtkPlane and vtkBox, in double. They take the ends of a segment, t running from 0 to 1;
/// ours goes a little beyond the shape, and its ends were computed beforehand, at no cost to VTK.
#include <vtkBox.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkTriangle.h>

#include <rayproof/plane/forms.hpp>

#include "bench/peers/peer.hpp"

namespace rayproof::report {

namespace {

struct VtkSegment {
  glm::dvec3 start, end;
  double t_end;
};

/// The segment from the ray's origin beyond everything within `radius` of `center`; none where its numbers
/// are not finite, or where it has no length.
std::optional<VtkSegment> segment_beyond(const Ray<double>& ray, const glm::dvec3& center, double radius) {
  const double length = glm::length(ray.direction);
  const double reach = (glm::length(center - ray.origin) + 2 * radius) / length;
  const double t_end = std::exp2(std::ceil(std::log2(reach)));  // keeps the numbers as short as the ray's
  const glm::dvec3 end = ray.origin + t_end * ray.direction;
  const double length2 = dot(end - ray.origin, end - ray.origin);
  if (!std::isfinite(length2) || length2 < 1e-300) return {};
  return VtkSegment{ray.origin, end, t_end};
}

struct OnVtkSegments {
  [[nodiscard]] std::optional<VtkSegment> prepared(const Ray<double>& ray) const {
    return segment_beyond(ray, center, radius);
  }
  [[nodiscard]] static double t_of(const VtkSegment& segment, double s) { return s * segment.t_end; }
  glm::dvec3 center{};
  double radius = 0;
};

/// Of a ray in its plane VTK says that it meets the triangle: as exact arithmetic says that it does not, that
/// is counted.
struct VtkTriangle : OnVtkSegments {
  explicit VtkTriangle(const Triangle<double>& t)
      : OnVtkSegments{t.a, glm::length(t.b - t.a) + glm::length(t.c - t.a)} {
    cell->GetPoints()->SetPoint(0, &t.a.x);
    cell->GetPoints()->SetPoint(1, &t.b.x);
    cell->GetPoints()->SetPoint(2, &t.c.x);
  }
  [[nodiscard]] double nearest(const VtkSegment& segment) const {
    double s = 0, x[3], coordinates[3];
    int part = 0;
    const int hit = cell->IntersectWithLine(&segment.start.x, &segment.end.x, 0, s, x, coordinates, part);
    return hit != 0 ? s : infinity<double>;
  }
  vtkNew<vtkTriangle> cell;
};

struct VtkPlane : OnVtkSegments {
  explicit VtkPlane(const Plane<double>& shape)
      : point(plane::point_of(shape)), normal(plane::normal_of(shape)) {}
  /// Beyond where the ray meets the plane.
  [[nodiscard]] std::optional<VtkSegment> prepared(const Ray<double>& ray) const {
    const double t = std::abs(dot(point - ray.origin, normal) / dot(ray.direction, normal));
    return segment_beyond(ray, ray.origin + (std::isfinite(t) ? t : 1.0) * ray.direction,
                          glm::length(ray.direction));
  }
  [[nodiscard]] double nearest(const VtkSegment& segment) const {
    double s = 0, x[3];
    glm::dvec3 n = normal, p = point;  // it does not promise to leave them alone
    const int hit = vtkPlane::IntersectWithLine(&segment.start.x, &segment.end.x, &n.x, &p.x, s, x);
    return hit != 0 ? s : infinity<double>;
  }
  glm::dvec3 point, normal;
};

struct VtkBox : OnVtkSegments {
  explicit VtkBox(const Box<double>& b)
      : OnVtkSegments{b.min, glm::length(b.max - b.min)}, bounds{b.min.x, b.max.x, b.min.y,
                                                                 b.max.y, b.min.z, b.max.z} {}
  /// A face of -1 says that the segment begins, or ends, inside.
  [[nodiscard]] double nearest(const VtkSegment& segment) const {
    double s[2] = {0, 0};
    int faces[2] = {-1, -1};
    const int hit = vtkBox::IntersectWithLine(bounds.data(), &segment.start.x, &segment.end.x, s[0], s[1],
                                              nullptr, nullptr, faces[0], faces[1]);
    if (hit == 0) return infinity<double>;
    return faces[0] >= 0 ? s[0] : faces[1] >= 0 ? s[1] : infinity<double>;
  }
  std::array<double, 6> bounds;
};

}  // namespace

std::vector<PeerRoutine> vtk_peers() {
  return {peer_by<VtkTriangle, double, Triangle>("triangle", "vtk"),
          peer_by<VtkPlane, double, Plane>("plane", "vtk"), peer_by<VtkBox, double, Box>("box", "vtk")};
}

}  // namespace rayproof::report
