/// \file
/// Embree is asked one triangle a scene (peers/embree.cpp). Here it gets a whole mesh as one scene, as a
/// renderer gives it: the leaks are not fewer.

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>

#include <gtest/gtest.h>
#include <rayproof/objects/embree_ray.hpp>

#include "leaks/judge.hpp"
#include "oracle/oracle.hpp"

namespace rayproof::leaks {
namespace {

/// A scene of some of a mesh's triangles.
class EmbreeScene {
 public:
  EmbreeScene(const ClosedMesh& mesh, const std::vector<std::size_t>& triangles, RTCSceneFlags flags)
      : scene_(rtcNewScene(device())) {
    rtcSetSceneFlags(scene_, flags);
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
    for (const glm::dvec3& v : mesh.vertices)
      for (int axis = 0; axis < 3; ++axis) *vertex++ = static_cast<float>(v[axis]);
    auto* corner = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size()));
    for (const std::size_t number : triangles)
      for (const std::size_t one : mesh.triangles[number]) *corner++ = static_cast<unsigned>(one);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() { rtcReleaseScene(scene_); }

  /// Whether it reports any hit between two t.
  [[nodiscard]] bool is_hit(const Ray<float>& ray, float near, float far) const {
    RTCRayHit asked = objects::embree_ray({ray.origin, ray.direction, near, far});
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &asked);
    return asked.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }

 private:
  static RTCDevice device() {
    static const RTCDevice made = rtcNewDevice("threads=1,set_affinity=0");
    return made;
  }
  RTCScene scene_;
};

/// The rays that a whole mesh loses, and those that its triangles lose, a scene each.
struct EmbreeLeaks {
  unsigned rays = 0, whole = 0, alone = 0;
};

/// About the exact t of a crossing: a hit within a thousandth of it counts as this one, if it is another.
double exact_t(const PatchCrossing& crossing) {
  for (std::size_t k = 0; k < crossing.cases.size(); ++k)
    if (crossing.is_hit[k]) return std::get<RayAnswer>(oracle::answer(crossing.cases[k])).hits.t[0];
  throw std::logic_error("the ray crosses the patch");
}

EmbreeLeaks leaks_under(RTCSceneFlags flags) {
  const ClosedMesh mesh = rounded(make_mesh("knot"), Precision::float32);
  const Targets targets = targets_of(mesh);
  std::vector<std::size_t> all(mesh.triangles.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const EmbreeScene whole(mesh, all, flags);
  EmbreeLeaks leaks;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const auto crossing = crossing_of(targets, number, 2022, Precision::float32);
    if (!crossing) continue;
    const auto ray = convert<float>(crossing->aim.ray);
    const double t = exact_t(*crossing);
    const auto near = static_cast<float>(0.999 * t), far = static_cast<float>(1.001 * t);
    bool is_hit_alone = false;
    for (const std::size_t triangle : crossing->aim.patch)
      is_hit_alone |= EmbreeScene(mesh, {triangle}, flags).is_hit(ray, near, far);
    ++leaks.rays;
    leaks.whole += !whole.is_hit(ray, near, far);
    leaks.alone += !is_hit_alone;
  }
  return leaks;
}

TEST(WholeScene, OfEmbreeLeaksNoLessThanItsTrianglesAlone) {
  const EmbreeLeaks leaks = leaks_under(RTC_SCENE_FLAG_NONE);
  EXPECT_GT(leaks.rays, 500U);
  EXPECT_GT(leaks.alone, leaks.rays / 50);
  EXPECT_GE(10 * leaks.whole, 9 * leaks.alone);
}

TEST(WholeScene, OfRobustEmbreeLeaksFarLess) {
  const EmbreeLeaks robust = leaks_under(RTC_SCENE_FLAG_ROBUST);
  EXPECT_LT(10 * robust.whole, leaks_under(RTC_SCENE_FLAG_NONE).whole);
}

}  // namespace
}  // namespace rayproof::leaks
#endif
