/// \file
/// Embree's own spheres and triangles, in float: rtcIntersect1, and as a batch rtcIntersect16. Its manual
/// excludes coordinates beyond ±1.844E18.
#include "bench/peers/peer.hpp"
#include "bench/scenes/embree_scene.hpp"

namespace rayproof::report {

namespace {

constexpr std::size_t lanes = 16;

bool is_in_range(const glm::vec3& v) {
  constexpr float largest = 1.8e18F;
  return std::abs(v.x) < largest && std::abs(v.y) < largest && std::abs(v.z) < largest;
}

RandomScene scene_of(const Sphere<float>& sphere) { return {.spheres = {sphere}}; }
RandomScene scene_of(const Triangle<float>& triangle) { return {.triangles = {triangle}}; }
bool has_range(const Sphere<float>& s) { return is_in_range(s.center) && is_in_range(s.center + s.radius); }
bool has_range(const Triangle<float>& t) { return is_in_range(t.a) && is_in_range(t.b) && is_in_range(t.c); }

/// A scene of one shape.
template <template <class> class Shape>
struct EmbreeAlone {
  explicit EmbreeAlone(const Shape<float>& given)
      : shape_is_in_range(has_range(given)), scene(scene_of(given)) {}
  [[nodiscard]] std::optional<Ray<float>> prepared(const Ray<float>& ray) const {
    if (!shape_is_in_range || !is_in_range(ray.origin) || !is_in_range(ray.direction)) return {};
    return ray;
  }
  [[nodiscard]] float nearest(const Ray<float>& ray) const { return scene.nearest(ray); }
  [[nodiscard]] static float t_of(const Ray<float>& /*ray*/, float t) { return t; }

  bool shape_is_in_range;
  EmbreeOnly scene;
};

/// The nearest hits of rays that `ray(i)` gives, 16 at a time.
template <class RayOf>
void intersect_16(const EmbreeOnly& scene, std::size_t count, const RayOf& ray_of, float* t) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t from = 0; from < count; from += lanes) {
    RTCRayHit16 asked;
    alignas(64) int valid[lanes];
    for (std::size_t i = 0; i < lanes; ++i) {
      valid[i] = from + i < count ? -1 : 0;
      const Ray<float> ray = ray_of(std::min(from + i, count - 1));
      asked.ray.org_x[i] = ray.origin.x, asked.ray.org_y[i] = ray.origin.y, asked.ray.org_z[i] = ray.origin.z;
      asked.ray.dir_x[i] = ray.direction.x, asked.ray.dir_y[i] = ray.direction.y;
      asked.ray.dir_z[i] = ray.direction.z;
      asked.ray.tnear[i] = ray.t_min, asked.ray.tfar[i] = ray.t_max;
      asked.ray.time[i] = 0, asked.ray.mask[i] = ~0U, asked.ray.flags[i] = 0;
      asked.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID, asked.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, scene.get(), &context, &asked);
    for (std::size_t i = 0; i < std::min(lanes, count - from); ++i)
      t[from + i] = asked.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? infinity<float> : asked.ray.tfar[i];
  }
}

template <template <class> class Shape>
Answer answer_among_16(const Case& one) {
  const auto problem = Reading<RayTopic<Shape>>::template problem<float>(one);
  RayAnswer answer;
  answer.nearest_only = true;
  float t[lanes];
  intersect_16(
      EmbreeOnly(scene_of(problem.shape)), lanes, [&](std::size_t) { return problem.ray; }, t);
  if (!std::isfinite(t[0]) || !in_interval(problem.ray, t[0])) return answer;
  answer.contact = Contact::crossing;
  answer.hits.push_back(static_cast<double>(t[0]));
  return answer;
}

template <template <class> class Shape>
std::vector<Contender> time_both(const std::string& library, const std::vector<Case>& cases) {
  std::vector<Contender> both = time_routine<EmbreeAlone<Shape>, float, Shape>(library, cases);
  const auto rays = std::make_shared<ShapeRays<Shape, float>>(cases);
  const auto scene = std::make_shared<const EmbreeOnly>(scene_of(rays->shape));
  const auto pass = [=](std::size_t count) {
    const auto ray_of = [&](std::size_t i) {
      return rays->space ? to_object(*rays->space, rays->ray(i)) : rays->ray(i);
    };
    intersect_16(*scene, count, ray_of, rays->t.data());
  };
  if (!both.empty()) both.push_back({library, Arrangement::batch, pass});
  return both;
}

template <template <class> class Shape>
PeerRoutine embree_peer(const char* topic) {
  PeerRoutine peer = peer_by<EmbreeAlone<Shape>, float, Shape>(topic, "embree");
  peer.contenders = time_both<Shape>;
  peer.subject.answer_in_batch = answer_among_16<Shape>;
  peer.most_cases = 1024;  // each builds a scene of its own
  return peer;
}

}  // namespace

std::vector<PeerRoutine> embree_peers() {
  return {embree_peer<Sphere>("sphere"), embree_peer<Triangle>("triangle")};
}

}  // namespace rayproof::report
