#include "properties/leaving/strategy.hpp"

namespace rayproof::leaving {

namespace {

template <class T>
spawn::SurfacePoint<T> narrowed(const spawn::SurfacePoint<double>& from) {
  return {convert<T>(from.hit),     convert<T>(from.point), convert<T>(from.normal),
          convert<T>(from.radial),  convert<T>(from.error), static_cast<T>(from.tilt),
          static_cast<T>(from.bend)};
}

template <class S>
glm::dvec3 origin_by(const Situation& situation) {
  return in_precision(situation.precision(),
                      [&]<class T>(T) { return convert<double>(S::origin(narrowed<T>(situation.from))); });
}

}  // namespace

const std::vector<Strategy>& strategies() {
  static const std::vector<Strategy> all = [] {
    std::vector<Strategy> made;
    spawn::Strategies::for_each([&]<class S>(std::type_identity<S>) {
      made.push_back({S::name, S::title, S::source, S::is_proven, S::moves_to_surface, origin_by<S>});
    });
    return made;
  }();
  return all;
}

RayQuestion next_ray(const Strategy& strategy, const Situation& from, const glm::dvec3& origin) {
  RayQuestion ray = from.leaves_from(strategy.moves_to_surface ? from.from.point : from.from.hit);
  const int outward = from.what.side == spawn::Side::front ? 1 : -1;
  if (from.has_normal && oracle::climb(ray, from.piece) * outward < 0) ray.ray.direction = -ray.ray.direction;
  ray.ray.origin = origin;
  return ray;
}

oracle::Departure depart(const Strategy& strategy, const Situation& from, const glm::dvec3& origin) {
  if (!from.has_normal) return oracle::Departure::no_origin;
  return oracle::depart(next_ray(strategy, from, origin), from.piece, from.what.side);
}

bool is_failure(const Strategy& strategy, oracle::Departure departure) {
  return departure == oracle::Departure::false_hit || departure == oracle::Departure::no_origin ||
         (departure == oracle::Departure::skipped && strategy.is_proven);
}

}  // namespace rayproof::leaving
