#pragma once
/// \file
/// Players to test, and what moves their handles.

#include <algorithm>
#include <string>
#include <vector>

#include "case/reader.hpp"
#include "viz/player/player.hpp"
#include "viz/programs/plays_of.hpp"

namespace rayproof::viz {

inline constexpr const char* sphere_case =
    R"({"precision":"float32","ray":{"origin":[-3.7,-0.9,0.4],"direction":[1.3,0.5,0.1]},)"
    R"("shape":{"type":"sphere","center":[0.2,0.1,0.3],"radius":1.4}})";

/// A player of one case.
[[nodiscard]] inline Player player_of(const std::string& text, const std::string& method) {
  return Player(plays_of(stage_of(report_of(read_case(text), method))));
}
[[nodiscard]] inline Player sphere_player() { return player_of(sphere_case, "sphere/centred"); }

[[nodiscard]] inline const RayQuestion& question_of(const Player& player) {
  return std::get<RayQuestion>(player.stage().one.question);
}
[[nodiscard]] inline const Ray<double>& ray_of(const Player& player) { return question_of(player).ray; }

[[nodiscard]] inline std::vector<std::string> handle_names(const Player& player) {
  std::vector<std::string> names;
  for (const Handle& handle : player.handles()) names.push_back(handle.name);
  return names;
}
/// The handle of that name; the test that asks for one that isn't there fails by the exception.
[[nodiscard]] inline Handle handle_of(const Player& player, const std::string& name) {
  for (const Handle& handle : player.handles()) {
    if (handle.name == name) return handle;
  }
  throw std::logic_error("the scene has no handle " + name);
}
/// Moves a handle by so much in the world.
inline void drag(Player& player, const std::string& name, const glm::dvec3& by, double resolution = 0.01) {
  const glm::dvec3 from = handle_of(player, name).at;
  player.grasp(name);
  player.drag_to(from + by, resolution);
  player.release();
}

}  // namespace rayproof::viz
