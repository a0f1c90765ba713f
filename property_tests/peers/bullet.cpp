/// \file
/// Bullet 3.24 in float: btCollisionWorld::rayTestSingle on a sphere, box, cylinder, triangle mesh and plane
/// (no argument: its default, SubsimplexConvexCast, of which its header says "approximate but faster"; `gjk`:
/// kF_UseGjkConvexCastRaytest), and `aabb`: btRayAabb. All take the ends of a segment and give the nearest
/// hit. Of rays that begin inside a shape nothing is documented. Boxes and cylinders hold their margin
/// inside.
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include <memory>
#include <string_view>

#include "peers/segment.hpp"

namespace rayproof {
namespace {

using glm::dvec3;
using Hit = std::optional<double>;
using Callback = btCollisionWorld::ClosestRayResultCallback;

unsigned ray_flags = btTriangleRaycastCallback::kF_None;

btVector3 bullet(const glm::vec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 wide(const glm::vec3& v) { return {v.x, v.y, v.z}; }

/// The nearest hit of a segment with a shape placed at `center`.
Hit meet(btCollisionShape& shape, const glm::vec3& center, const peers::Segment<float>& segment) {
  const btVector3 start = bullet(segment.start), end = bullet(segment.end);
  btCollisionObject object;
  object.setCollisionShape(&shape);
  object.setWorldTransform(btTransform(btQuaternion::getIdentity(), bullet(center)));
  Callback callback(start, end);
  callback.m_flags = ray_flags;
  btCollisionWorld::rayTestSingle(btTransform(btQuaternion::getIdentity(), start),
                                  btTransform(btQuaternion::getIdentity(), end), &object, &shape,
                                  object.getWorldTransform(), callback);
  if (!callback.hasHit()) return {};
  return segment.t_at(static_cast<double>(callback.m_closestHitFraction));
}

Hit sphere(const Ray<float>& ray, glm::vec3 center, float radius) {
  if (radius == 0) throw Unsupported();
  btSphereShape shape(radius);
  return meet(shape, center,
              peers::segment_past<float>(convert<double>(ray), wide(center), static_cast<double>(radius)));
}

Hit box(const Ray<float>& ray, glm::vec3 low, glm::vec3 high) {
  const glm::vec3 half = (high - low) / 2.0F, center = low + half;
  // Bullet's box has a center: asked are boxes that have one among the floats.
  if (center - half != low || center + half != high || half.x * half.y * half.z == 0) throw Unsupported();
  btBoxShape shape(bullet(half));
  return meet(shape, center,
              peers::segment_past<float>(convert<double>(ray), std::array{wide(low), wide(high)}));
}

Hit cylinder(const Ray<float>& ray, float rx, float ry, float height, bool capped) {
  if (!capped || height == 0) throw Unsupported();
  const glm::vec3 half(rx, ry, height / 2), center(0, 0, height / 2);
  if (rx != ry) throw Unsupported();  // it takes half extents, and looks at the first alone
  btCylinderShapeZ shape(bullet(half));
  return meet(shape, center,
              peers::segment_past<float>(convert<double>(ray), wide(center), glm::length(wide(half))));
}

Hit triangle(const Ray<float>& ray, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  btTriangleMesh mesh;
  mesh.addTriangle(bullet(a), bullet(b), bullet(c));
  btBvhTriangleMeshShape shape(&mesh, false);
  return meet(shape, glm::vec3(0),
              peers::segment_past<float>(convert<double>(ray), std::array{wide(a), wide(b), wide(c)}, true));
}

/// The normal has length 1, says its manual; the plane is n·x = constant.
Hit plane(const Ray<float>& ray, glm::vec3 normal, float d) {
  const float length = glm::length(normal);
  btStaticPlaneShape shape(bullet(normal / length), -d / length);
  const double t = -(dot(wide(normal), wide(ray.origin)) + static_cast<double>(d)) /
                   dot(wide(normal), wide(ray.direction));
  const dvec3 passed = wide(ray.origin) + (std::isfinite(t) ? std::abs(t) : 1.0) * wide(ray.direction);
  const double reach = glm::length(passed - wide(ray.origin)) + glm::length(wide(ray.direction));
  return meet(shape, glm::vec3(0), peers::segment_past<float>(convert<double>(ray), passed, reach, true));
}

/// A box is a solid to it: a segment that begins inside hits at its start, which is another question.
Hit aabb(const Ray<float>& ray, glm::vec3 low, glm::vec3 high) {
  const auto segment = peers::segment_past<float>(convert<double>(ray), std::array{wide(low), wide(high)});
  if (glm::all(glm::lessThanEqual(low, segment.start)) && glm::all(glm::lessThanEqual(segment.start, high)))
    throw Unsupported();
  btScalar fraction = 1;
  btVector3 normal;
  if (!btRayAabb(bullet(segment.start), bullet(segment.end), bullet(low), bullet(high), fraction, normal))
    return {};
  return segment.t_at(static_cast<double>(fraction));
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  const std::string_view which = count > 1 ? arguments[1] : "";
  if (which == "aabb") return answer_cases(aabb);
  if (which == "gjk") ray_flags = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
  return answer_cases(sphere, box, cylinder, triangle, takes<ImplicitPlane>(plane));
}
