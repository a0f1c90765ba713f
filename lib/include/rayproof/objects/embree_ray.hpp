#pragma once
/// \file
/// A ray as Embree 3 takes it.

#include <embree3/rtcore.h>

#include <rayproof/ray.hpp>

namespace rayproof::objects {

/// The ray for rtcIntersect1, which has hit nothing yet: its geomID is RTC_INVALID_GEOMETRY_ID. Embree asks
/// for t_min >= 0.
[[nodiscard]] inline RTCRayHit embree_ray(const Ray<float>& ray) {
  RTCRayHit asked{};
  asked.ray.org_x = ray.origin.x, asked.ray.org_y = ray.origin.y, asked.ray.org_z = ray.origin.z;
  asked.ray.dir_x = ray.direction.x, asked.ray.dir_y = ray.direction.y, asked.ray.dir_z = ray.direction.z;
  asked.ray.tnear = ray.t_min;
  asked.ray.tfar = ray.t_max;
  asked.ray.mask = ~0U;
  asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return asked;
}

}  // namespace rayproof::objects
