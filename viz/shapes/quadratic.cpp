#include <rayproof/quadratic/methods.hpp>

#include "viz/shapes/topics.hpp"
#include "viz/trace/record.hpp"

namespace rayproof::viz {
namespace {

std::optional<Walkthrough> walk_quadratic(const Case& one, const std::string& method) {
  return walk_topic<quadratic::Topic>(method, one.precision, [&]<class R>(std::type_identity<R>) {
    const auto q = convert<R>(std::get<Quadratic<double>>(one.question));
    return Quadratic<R>{named("a", q.a), named("b", q.b), named("c", q.c)};
  });
}

}  // namespace

TopicView quadratic_view() { return {quadratic::Topic::name, walk_quadratic}; }

}  // namespace rayproof::viz
