/// \file
/// Embree 3.13, rtcIntersect1 on a scene of one triangle, quad or sphere, in float; `robust` sets
/// RTC_SCENE_FLAG_ROBUST. Its manual excludes segments that start behind the origin, and coordinates beyond
/// ±1.844E18 (rtcCommitScene); directions need not have length 1. A quad is two triangles: asked are
/// parallelograms alone. Whether a hit exactly at an end of the segment counts is open, says rtcIntersect1's
/// page.
#include <embree3/rtcore.h>

#include <limits>
#include <rayproof/objects/embree_ray.hpp>
#include <string_view>

#include "peers/reproduction.hpp"

namespace rayproof {
namespace {

using glm::vec3;

RTCSceneFlags scene_flags = RTC_SCENE_FLAG_NONE;

/// What a scene hits.
struct SurfaceHit {
  float t;
  vec3 normal;
};

constexpr float largest = 1.844E18F;

void refuse_large(const vec3& v) {
  if (!(std::abs(v.x) < largest && std::abs(v.y) < largest && std::abs(v.z) < largest)) throw Unsupported();
}

RTCDevice device() {
  static const RTCDevice made = rtcNewDevice("threads=1,set_affinity=0");
  return made;
}

using peers::given;
using peers::LibraryCall;

/// A call that begins so, with the geometry's numbers.
template <class... V>
LibraryCall call_on(const char* geometry, const peers::Given<V>&... inputs) {
  LibraryCall call("rtcIntersect1", R"(#include <embree3/rtcore.h>
RTCDevice device = rtcNewDevice(nullptr); RTCScene scene = rtcNewScene(device);)");
  if (scene_flags == RTC_SCENE_FLAG_ROBUST) call.add("rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);");
  call.add(geometry, inputs...);
  return call;
}

/// The nearest hit of a scene that holds `geometry` alone, which it takes over.
std::optional<SurfaceHit> nearest_hit(LibraryCall call, RTCGeometry geometry, const Ray<float>& ray) {
  call.add(R"(rtcCommitGeometry(geometry), rtcAttachGeometry(scene, geometry), rtcCommitScene(scene);
RTCIntersectContext context; RTCRayHit asked = {{$origin, $t_min, $direction, 0, $t_max, ~0u}, {0, 0, 0, 0, 0, 0, RTC_INVALID_GEOMETRY_ID}};
rtcInitIntersectContext(&context), rtcIntersect1(scene, &context, &asked);
std::printf("hit = %d, t = %.9g\n", asked.hit.geomID != RTC_INVALID_GEOMETRY_ID, asked.ray.tfar);)",
           given("origin", ray.origin), given("t_min", ray.t_min), given("direction", ray.direction),
           given("t_max", ray.t_max));
  call.ask();
  const RTCScene scene = rtcNewScene(device());
  rtcSetSceneFlags(scene, scene_flags);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  RTCRayHit asked = objects::embree_ray(ray);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &asked);
  rtcReleaseScene(scene);
  call.said(given("hit", asked.hit.geomID != RTC_INVALID_GEOMETRY_ID), given("t", asked.ray.tfar));
  if (asked.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  for (const float end : {ray.t_min, ray.t_max})
    if (std::abs(asked.ray.tfar - end) < 1e-6F * std::abs(end)) throw Unsupported();
  return SurfaceHit{asked.ray.tfar, glm::normalize(vec3(asked.hit.Ng_x, asked.hit.Ng_y, asked.hit.Ng_z))};
}

void refuse_behind(const Ray<float>& ray) {
  if (ray.t_min < 0) throw Unsupported();
  refuse_large(ray.origin);
}

/// A flat geometry with these corners and the indices 0, 1, 2, …; its type and format as a program has them.
std::optional<float> flat(const std::string& type_name, const std::string& format_name, RTCGeometryType type,
                          RTCFormat format, std::span<const vec3> corners, const Ray<float>& ray) {
  refuse_behind(ray);
  const RTCGeometry geometry = rtcNewGeometry(device(), type);
  auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corners.size()));
  auto* const indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, format, corners.size() * sizeof(unsigned), 1));
  for (unsigned i = 0; i < corners.size(); ++i) {
    refuse_large(corners[i]);
    for (int axis = 0; axis < 3; ++axis) vertices[3 * i + static_cast<unsigned>(axis)] = corners[i][axis];
    indices[i] = i;
  }
  auto call = call_on(R"(RTCGeometry geometry = rtcNewGeometry(device, $type);
float corners[][3] = {$vertices, {}}; unsigned order[] = {0, 1, 2, 3};
rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, corners, 0, 12, $n);
rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, $format, order, 0, 16, 1);)",
                      given("type", type_name), given("format", format_name), given("vertices", corners),
                      given("n", static_cast<int>(corners.size())));
  if (corners.size() == 3)
    call.add("", given("a", corners[0]), given("b", corners[1]), given("c", corners[2]));
  const auto hit = nearest_hit(std::move(call), geometry, ray);
  return hit ? std::optional(hit->t) : std::nullopt;
}

std::optional<float> triangle(const Ray<float>& ray, vec3 a, vec3 b, vec3 c) {
  return flat("RTC_GEOMETRY_TYPE_TRIANGLE", "RTC_FORMAT_UINT3", RTC_GEOMETRY_TYPE_TRIANGLE, RTC_FORMAT_UINT3,
              std::array{a, b, c}, ray);
}

std::optional<float> quad(const Ray<float>& ray, const std::vector<vec3>& vertices) {
  if (vertices.size() != 4) throw Unsupported();
  const auto diagonals =
      glm::dvec3(vertices[0]) + glm::dvec3(vertices[2]) - glm::dvec3(vertices[1]) - glm::dvec3(vertices[3]);
  if (diagonals != glm::dvec3(0)) throw Unsupported();
  return flat("RTC_GEOMETRY_TYPE_QUAD", "RTC_FORMAT_UINT4", RTC_GEOMETRY_TYPE_QUAD, RTC_FORMAT_UINT4,
              vertices, ray);
}

std::optional<SurfaceHit> sphere(const Ray<float>& ray, vec3 center, float radius) {
  refuse_behind(ray);
  if (radius == 0) throw Unsupported();  // has no normal
  refuse_large(center);
  refuse_large(center + radius);
  const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* const point = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), 1));
  for (int axis = 0; axis < 3; ++axis) point[axis] = center[axis];
  point[3] = radius;
  auto call = call_on(R"(RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
float sphere[] = {$center, $radius};
rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sphere, 0, 16, 1);)",
                      given("center", center), given("radius", radius));
  return nearest_hit(std::move(call), geometry, ray);
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  peers::introduce(
      count, arguments,
      {"Embree",
       RTC_VERSION_STRING,
       peers::built_with("-lembree3"),
       "https://github.com/RenderKit/embree/issues",
       {{"exactly at t_min",
         "The page of rtcIntersect1 does not say whether an end of the interval belongs to it."},
        {"exactly at t_max",
         "The page of rtcIntersect1 does not say whether an end of the interval belongs to it."}}});
  if (count > 1 && std::string_view(arguments[1]) == "robust") scene_flags = RTC_SCENE_FLAG_ROBUST;
  return answer_cases(triangle, quad, sphere);
}
