#include <rayproof/point_in_polygon/methods.hpp>

#include "viz/shapes/topics.hpp"
#include "viz/trace/record.hpp"

namespace rayproof::viz {
namespace {

/// Its methods count crossings in plain numbers: none of them can be recorded.
std::optional<Walkthrough> no_walk(const Case& /*one*/, const std::string& /*method*/) {
  return std::nullopt;
}

}  // namespace

TopicView point_in_polygon_view() { return {point_in_polygon::Topic::name, no_walk}; }

}  // namespace rayproof::viz
