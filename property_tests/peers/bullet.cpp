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

#include "peers/reproduction.hpp"
#include "peers/segment.hpp"

namespace rayproof {
namespace {

using glm::dvec3;
using Hit = std::optional<double>;
using Callback = btCollisionWorld::ClosestRayResultCallback;

unsigned ray_flags = btTriangleRaycastCallback::kF_None;

btVector3 bullet(const glm::vec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 wide(const glm::vec3& v) { return {v.x, v.y, v.z}; }

using peers::given;
using peers::LibraryCall;

/// A call that begins so, with the shape's numbers.
template <class... V>
LibraryCall call_on(const char* shape, const peers::Given<V>&... inputs) {
  LibraryCall call("btCollisionWorld::rayTestSingle", "#include <btBulletCollisionCommon.h>");
  call.add(shape, inputs...);
  return call;
}

/// How rayTestSingle is called on `shape`; `flags` is the line that sets the callback's.
void finish(LibraryCall& call, const char* flags, const glm::vec3& center,
            const peers::Segment<float>& segment) {
  call.add(R"(btCollisionObject object;
object.setCollisionShape(&shape), object.getWorldTransform().setOrigin(btVector3($center));
btVector3 start($start), end($end);
btTransform from(btQuaternion::getIdentity(), start), to(btQuaternion::getIdentity(), end);
btCollisionWorld::ClosestRayResultCallback callback(start, end);)",
           given("center", center), given("start", segment.start), given("end", segment.end));
  call.add(flags);
  call.add(
      R"(btCollisionWorld::rayTestSingle(from, to, &object, &shape, object.getWorldTransform(), callback);
std::printf("hit = %d, fraction = %.9g\n", callback.hasHit(), callback.m_closestHitFraction);)");
}

/// The nearest hit of a segment with a shape placed at `center`.
Hit meet(LibraryCall call, btCollisionShape& shape, const glm::vec3& center,
         const peers::Segment<float>& segment) {
  finish(call,
         ray_flags == btTriangleRaycastCallback::kF_None
             ? ""
             : "callback.m_flags = 1 << 3;  // kF_UseGjkConvexCastRaytest",
         center, segment);
  call.ask();
  const btVector3 start = bullet(segment.start), end = bullet(segment.end);
  btCollisionObject object;
  object.setCollisionShape(&shape);
  object.setWorldTransform(btTransform(btQuaternion::getIdentity(), bullet(center)));
  Callback callback(start, end);
  callback.m_flags = ray_flags;
  btCollisionWorld::rayTestSingle(btTransform(btQuaternion::getIdentity(), start),
                                  btTransform(btQuaternion::getIdentity(), end), &object, &shape,
                                  object.getWorldTransform(), callback);
  call.said(given("hit", callback.hasHit()), given("fraction", callback.m_closestHitFraction));
  if (!callback.hasHit()) return {};
  return segment.t_at(static_cast<double>(callback.m_closestHitFraction));
}

Hit sphere(const Ray<float>& ray, glm::vec3 center, float radius) {
  if (radius == 0) throw Unsupported();
  btSphereShape shape(radius);
  return meet(call_on("btSphereShape shape($radius);", given("radius", radius)), shape, center,
              peers::segment_past<float>(convert<double>(ray), wide(center), static_cast<double>(radius)));
}

Hit box(const Ray<float>& ray, glm::vec3 low, glm::vec3 high) {
  const glm::vec3 half = (high - low) / 2.0F, center = low + half;
  // Bullet's box has a center: asked are boxes that have one among the floats.
  if (center - half != low || center + half != high || half.x * half.y * half.z == 0) throw Unsupported();
  btBoxShape shape(bullet(half));
  return meet(call_on("btBoxShape shape(btVector3($half));", given("half", half)), shape, center,
              peers::segment_past<float>(convert<double>(ray), std::array{wide(low), wide(high)}));
}

Hit cylinder(const Ray<float>& ray, float rx, float ry, float height, bool capped) {
  if (!capped || height == 0) throw Unsupported();
  const glm::vec3 half(rx, ry, height / 2), center(0, 0, height / 2);
  if (rx != ry) throw Unsupported();  // it takes half extents, and looks at the first alone
  btCylinderShapeZ shape(bullet(half));
  return meet(call_on("btCylinderShapeZ shape(btVector3($half));", given("half", half)), shape, center,
              peers::segment_past<float>(convert<double>(ray), wide(center), glm::length(wide(half))));
}

Hit triangle(const Ray<float>& ray, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  btTriangleMesh mesh;
  mesh.addTriangle(bullet(a), bullet(b), bullet(c));
  btBvhTriangleMeshShape shape(&mesh, false);
  return meet(call_on("btTriangleMesh mesh;\n"
                      "mesh.addTriangle(btVector3($a), btVector3($b), btVector3($c));\n"
                      "btBvhTriangleMeshShape shape(&mesh, false);",
                      given("a", a), given("b", b), given("c", c)),
              shape, glm::vec3(0),
              peers::segment_past<float>(convert<double>(ray), std::array{wide(a), wide(b), wide(c)}, true));
}

/// The normal has length 1, says its manual; the plane is n·x = constant.
Hit plane(const Ray<float>& ray, glm::vec3 normal, float d) {
  const float length = glm::length(normal);
  const glm::vec3 unit = normal / length;
  const float constant = -d / length;
  btStaticPlaneShape shape(bullet(unit), constant);
  const double t = -(dot(wide(normal), wide(ray.origin)) + static_cast<double>(d)) /
                   dot(wide(normal), wide(ray.direction));
  const dvec3 passed = wide(ray.origin) + (std::isfinite(t) ? std::abs(t) : 1.0) * wide(ray.direction);
  const double reach = glm::length(passed - wide(ray.origin)) + glm::length(wide(ray.direction));
  return meet(call_on("btStaticPlaneShape shape(btVector3($normal), $constant);", given("normal", unit),
                      given("constant", constant)),
              shape, glm::vec3(0), peers::segment_past<float>(convert<double>(ray), passed, reach, true));
}

/// A box is a solid to it: a segment that begins inside hits at its start, which is another question.
Hit aabb(const Ray<float>& ray, glm::vec3 low, glm::vec3 high) {
  const auto segment = peers::segment_past<float>(convert<double>(ray), std::array{wide(low), wide(high)});
  if (glm::all(glm::lessThanEqual(low, segment.start)) && glm::all(glm::lessThanEqual(segment.start, high)))
    throw Unsupported();
  LibraryCall call("btRayAabb", R"(#include <LinearMath/btAabbUtil2.h>
btVector3 start($start), end($end), low($low), high($high), normal;
btScalar fraction = 1;
bool hit = btRayAabb(start, end, low, high, fraction, normal);
std::printf("hit = %d, fraction = %.9g\n", hit, fraction);)",
                   given("start", segment.start), given("end", segment.end), given("low", low),
                   given("high", high));
  call.ask();
  btScalar fraction = 1;
  btVector3 normal;
  const bool is_hit =
      btRayAabb(bullet(segment.start), bullet(segment.end), bullet(low), bullet(high), fraction, normal);
  call.said(given("hit", is_hit), given("fraction", fraction));
  if (!is_hit) return {};
  return segment.t_at(static_cast<double>(fraction));
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  const std::string_view which = count > 1 && arguments[1][0] != '-' ? arguments[1] : "";
  using Documented = std::vector<std::pair<std::string, std::string>>;
  const Documented approximate{
      {"residual:",
       "btRaycastCallback.h says of this ray caster, the default: \"an approximate but "
       "faster ray versus convex intersection algorithm\"."}};
  const int version = btGetVersion();
  peers::introduce(
      count, arguments,
      {"Bullet", std::to_string(version / 100) + "." + std::to_string(version % 100),
       peers::built_with("-I/usr/include/bullet -lBulletDynamics -lBulletCollision -lLinearMath"),
       "https://github.com/bulletphysics/bullet3/issues", which.empty() ? approximate : Documented()});
  if (which == "aabb") return answer_cases(aabb);
  if (which == "gjk") ray_flags = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
  return answer_cases(sphere, box, cylinder, triangle, takes<ImplicitPlane>(plane));
}
