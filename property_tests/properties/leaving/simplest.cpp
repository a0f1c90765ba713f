#include <fmt/format.h>

#include "case/writer.hpp"
#include "properties/leaving/search.hpp"
#include "properties/shrink/shrink.hpp"

namespace rayproof::leaving {

namespace {

oracle::Departure departure_of(const Strategy& strategy, const Situation& from) {
  return depart(strategy, from, strategy.origin(from));
}

/// The same hit left in the simplest direction in which the strategy fails that way: along an axis, along the
/// diagonals, or as it was.
std::optional<Situation> failing(const Strategy& strategy, const Departing& found, oracle::Departure way,
                                 const Case& incoming) {
  const glm::dvec3 directions[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 1, 1},
                                   {1, 0, 1}, {1, 1, 0}, {1, 1, 1}, found.direction};
  for (const glm::dvec3& direction : directions) {
    std::optional<Situation> tried = situation_of({incoming, found.hit, found.side, direction});
    if (!tried || tried->what.side != found.side) continue;
    if (departure_of(strategy, *tried) == way) return tried;
  }
  return std::nullopt;
}

std::string in_words(oracle::Departure way) {
  if (way == oracle::Departure::no_origin) return "starts nowhere";
  return way == oracle::Departure::skipped ? "starts outside of the solid" : "meets it again";
}

std::string numbers(const glm::dvec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

}  // namespace

WrongStart simplest(const Strategy& strategy, const Situation& found, const std::atomic<bool>& stop) {
  Case bare = found.what.incoming;
  bare.id.clear();
  bare.note.clear();
  const oracle::Departure way = departure_of(strategy, found);
  const auto breaks = [&](const Case& one) { return failing(strategy, found.what, way, one).has_value(); };
  const Case shrunk = shrink(bare, breaks, {.tries = 20'000, .stop = &stop});
  WrongStart failure{&strategy, failing(strategy, found.what, way, shrunk).value_or(found)};
  failure.is_shrunk = write_case(shrunk) != write_case(bare);
  const Situation& from = failure.from;
  failure.left = {.precision = from.precision(), .question = next_ray(strategy, from, strategy.origin(from))};
  const Ray<double>& ray = from.question().ray;
  failure.left.note =
      fmt::format("{} leaves the {} to the {} from its hit at {} by the ray {} + t*{}, and {}", strategy.name,
                  topic_of(from.what.incoming), from.what.side == spawn::Side::front ? "front" : "back",
                  numbers(from.from.hit), numbers(ray.origin), numbers(ray.direction), in_words(way));
  return failure;
}

}  // namespace rayproof::leaving
