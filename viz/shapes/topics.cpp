#include "viz/shapes/topics.hpp"

#include <rayproof/topics.hpp>

#include "viz/shapes/ray_walk.hpp"

namespace rayproof::viz {
namespace {

std::optional<Walkthrough> walk_quadratic(const Case& one, const std::string& method) {
  return walk_topic<quadratic::Topic>(method, one.precision, [&]<class R>(std::type_identity<R>) {
    const auto q = convert<R>(std::get<Quadratic<double>>(one.question));
    return Quadratic<R>{named("a", q.a), named("b", q.b), named("c", q.c)};
  });
}

}  // namespace

Figure figure_of(const Sight& sight) {
  return std::visit([&](const auto& shape) { return figure_of(sight, in_library(shape)); },
                    sight.question.shape);
}

std::optional<Walkthrough> recorded_walk(const Case& one, const std::string& method) {
  if (std::holds_alternative<Quadratic<double>>(one.question)) return walk_quadratic(one, method);
  std::optional<Walkthrough> walk;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    // The others count crossings in plain numbers: none of their methods can be recorded.
    if constexpr (requires(typename Topic::template Problem<double> problem) { problem.shape; }) {
      if (topic_of(one) == Topic::name) walk = walk_ray<Topic>(one, method);
    }
  });
  return walk;
}

}  // namespace rayproof::viz
