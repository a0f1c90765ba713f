#pragma once
/// \file
/// Embree by itself: its own spheres and triangles, met by its own routines.

#include <embree3/rtcore.h>

#include <memory>
#include <rayproof/objects/embree_ray.hpp>

#include "bench/scenes/random_scene.hpp"

namespace rayproof::report {

class EmbreeOnly {
 public:
  explicit EmbreeOnly(const RandomScene& shapes) {
    if (!shapes.spheres.empty()) add(spheres(shapes.spheres));
    if (!shapes.triangles.empty()) add(triangles(shapes.triangles));
    rtcCommitScene(scene_.get());
  }

  /// t of the nearest hit by rtcIntersect1; infinity where there is none.
  [[nodiscard]] float nearest(const Ray<float>& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit asked = objects::embree_ray(ray);
    rtcIntersect1(scene_.get(), &context, &asked);
    return asked.hit.geomID == RTC_INVALID_GEOMETRY_ID ? infinity<float> : asked.ray.tfar;
  }

  [[nodiscard]] RTCScene get() const { return scene_.get(); }

 private:
  static RTCDevice device() {
    static const std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> made(rtcNewDevice(nullptr),
                                                                        rtcReleaseDevice);
    return made.get();
  }

  void add(RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
  }

  static RTCGeometry spheres(const std::vector<Sphere<float>>& all) {
    RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* to = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), all.size()));
    for (const auto& sphere : all) *to++ = {sphere.center, sphere.radius};
    return geometry;
  }

  static RTCGeometry triangles(const std::vector<Triangle<float>>& all) {
    RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * all.size()));
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), all.size()));
    unsigned count = 0;
    for (const auto& triangle : all)
      for (const glm::vec3& corner : {triangle.a, triangle.b, triangle.c}) {
        *vertex++ = corner;
        *index++ = count++;
      }
    return geometry;
  }

  std::unique_ptr<RTCSceneTy, void (*)(RTCScene)> scene_{rtcNewScene(device()), rtcReleaseScene};
};

}  // namespace rayproof::report
