/// \file
/// The nearest hit among N small spheres or triangles in a cube, by plain and by exact methods: by a list, by
/// trees over it, and by Embree's own spheres and triangles (rtcIntersect1). Items per second are rays.

#include <benchmark/benchmark.h>

#include <rayproof/rayproof.hpp>
#include <string>
#include <utility>
#include <vector>

#ifdef RAYPROOF_HAS_EMBREE
#include <embree3/rtcore.h>

#include <rayproof/objects/embree_tree.hpp>
#endif

#include "generators/random.hpp"

namespace {

using namespace rayproof;

constexpr float half_side = 100;
constexpr std::size_t counts[] = {1, 3, 10, 30, 100, 1'000, 10'000, 100'000, 1'000'000};

glm::vec3 draw_vector(Random& random, float length) {
  const auto draw = [&] { return static_cast<float>(random.uniform(-1, 1)) * length; };
  const float x = draw(), y = draw(), z = draw();
  return {x, y, z};
}

/// Rays from far outside the cube to points in it.
std::vector<Ray<float>> draw_rays() {
  Random random(18);
  std::vector<Ray<float>> rays;
  while (rays.size() < 4096) {
    const glm::vec3 target = draw_vector(random, half_side);
    const glm::vec3 origin = 3.0F * draw_vector(random, half_side);
    rays.push_back({origin, target - origin});
  }
  return rays;
}

/// The size at which N objects together cover the view of the cube about once.
float size_for(std::size_t count) { return half_side / std::sqrt(static_cast<float>(count)); }

std::vector<Sphere<float>> draw_spheres(std::size_t count) {
  Random random(count);
  std::vector<Sphere<float>> spheres;
  while (spheres.size() < count) spheres.push_back({draw_vector(random, half_side), size_for(count)});
  return spheres;
}

std::vector<Triangle<float>> draw_triangles(std::size_t count) {
  Random random(count);
  const float size = 2 * size_for(count);
  std::vector<Triangle<float>> triangles;
  while (triangles.size() < count) {
    const glm::vec3 a = draw_vector(random, half_side);
    const glm::vec3 b = a + draw_vector(random, size), c = a + draw_vector(random, size);
    triangles.push_back({a, b, c});
  }
  return triangles;
}

/// Asks about each ray in turn by `is_hit(ray)`; says how many of them hit something.
template <class IsHit>
void time_rays(benchmark::State& state, const IsHit& is_hit) {
  const std::vector<Ray<float>> rays = draw_rays();
  std::size_t next = 0, hits = 0;
  for (auto _ : state) {
    hits += is_hit(rays[next]) ? 1 : 0;
    next = (next + 1) % rays.size();
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["hit_share"] = static_cast<double>(hits) / static_cast<double>(state.iterations());
}

template <class Choice, class Shape>
ObjectList<float, Choice> list_of(const std::vector<Shape>& shapes) {
  ObjectList<float, Choice> list;
  for (const Shape& shape : shapes) list.add(shape);
  return list;
}

template <class Choice, class Search, class Draw>
void add_tree(const std::string& name, const Draw& draw, std::size_t count) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    const ObjectTree<float, Choice, Search> tree(list_of<Choice>(draw(count)));
    time_rays(state, [&](const Ray<float>& ray) { return tree.nearest(ray).has_value(); });
  });
}

template <class Choice, class Draw>
void add_objects(const std::string& name, const Draw& draw) {
  for (const std::size_t count : counts) {
    const std::string end = name + "/" + std::to_string(count);
    if (count <= 1000)
      benchmark::RegisterBenchmark(("objects/list/" + end).c_str(), [=](benchmark::State& state) {
        const auto list = list_of<Choice>(draw(count));
        time_rays(state, [&](const Ray<float>& ray) { return list.nearest(ray).has_value(); });
      });
    add_tree<Choice, objects::BoundsTree>("objects/bounds_tree/" + end, draw, count);
#ifdef RAYPROOF_HAS_EMBREE
    add_tree<Choice, objects::EmbreeTree>("objects/embree_tree/" + end, draw, count);
#endif
  }
}

#ifdef RAYPROOF_HAS_EMBREE
RTCGeometry embree_geometry(RTCDevice device, const std::vector<Sphere<float>>& spheres) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* to = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), spheres.size()));
  for (const auto& sphere : spheres) *to++ = {sphere.center, sphere.radius};
  return geometry;
}

RTCGeometry embree_geometry(RTCDevice device, const std::vector<Triangle<float>>& triangles) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * triangles.size()));
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
  unsigned count = 0;
  for (const auto& triangle : triangles)
    for (const glm::vec3& corner : {triangle.a, triangle.b, triangle.c}) {
      *vertex++ = corner;
      *index++ = count++;
    }
  return geometry;
}

bool is_hit_by_embree(RTCScene scene, const Ray<float>& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit asked = objects::embree_ray(ray);
  rtcIntersect1(scene, &context, &asked);
  return asked.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

template <class Draw>
void add_embree(const std::string& name, const Draw& draw) {
  for (const std::size_t count : counts)
    benchmark::RegisterBenchmark(
        ("objects/embree/" + name + "/" + std::to_string(count)).c_str(), [=](benchmark::State& state) {
          RTCDevice device = rtcNewDevice(nullptr);
          RTCScene scene = rtcNewScene(device);
          RTCGeometry geometry = embree_geometry(device, draw(count));
          rtcCommitGeometry(geometry);
          rtcAttachGeometry(scene, geometry);
          rtcReleaseGeometry(geometry);
          rtcCommitScene(scene);
          time_rays(state, [&](const Ray<float>& ray) { return is_hit_by_embree(scene, ray); });
          rtcReleaseScene(scene);
          rtcReleaseDevice(device);
        });
}
#endif

[[maybe_unused]] const bool objects_are_registered = [] {
  add_objects<PlainMethods>("spheres", draw_spheres);
  add_objects<ExactMethods>("spheres_exactly", draw_spheres);
  add_objects<PlainMethods>("triangles", draw_triangles);
  add_objects<ExactMethods>("triangles_exactly", draw_triangles);
#ifdef RAYPROOF_HAS_EMBREE
  add_embree("spheres", draw_spheres);
  add_embree("triangles", draw_triangles);
#endif
  return true;
}();

}  // namespace
