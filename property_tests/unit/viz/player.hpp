#pragma once
/// \file
/// Players to test, and what is to be found in their pictures.

#include <algorithm>
#include <string>
#include <vector>

#include "case/reader.hpp"
#include "viz/programs/plays_of.hpp"
#include "viz/player/player.hpp"

namespace rayproof::viz {

inline constexpr const char* sphere_case =
    R"({"precision":"float32","ray":{"origin":[-3.7,-0.9,0.4],"direction":[1.3,0.5,0.1]},)"
    R"("shape":{"type":"sphere","center":[0.2,0.1,0.3],"radius":1.4}})";

/// A player of one case.
[[nodiscard]] inline Player player_of(const std::string& text, const std::string& method) {
  return Player(plays_of(stage_of(report_of(read_case(text), method))));
}
[[nodiscard]] inline Player sphere_player() { return player_of(sphere_case, "sphere/centred"); }

[[nodiscard]] inline std::vector<Text> texts_of(const Picture& picture) {
  std::vector<Text> texts;
  for (const Element& element : picture.elements) {
    if (const auto* text = std::get_if<Text>(&element)) texts.push_back(*text);
  }
  return texts;
}
[[nodiscard]] inline bool has_text(const Picture& picture, const std::string& part) {
  const auto texts = texts_of(picture);
  return std::any_of(texts.begin(), texts.end(),
                     [&](const Text& text) { return text.text.find(part) != std::string::npos; });
}

[[nodiscard]] inline const Ray<double>& ray_of(const Player& player) {
  return std::get<RayQuestion>(player.stage().one.question).ray;
}
/// The handle of that grip; the test that asks for one that isn't there fails by the exception.
[[nodiscard]] inline Handle handle_of(const Player& player, Grip grip) {
  for (const Handle& handle : player.handles()) {
    if (handle.grip == grip) return handle;
  }
  throw std::logic_error("the picture has no such handle");
}
/// Where a handle is seen.
[[nodiscard]] inline Point seen(const Player& player, const Handle& handle) {
  return player.projection().to_pixels(handle.at);
}
inline void drag(Player& player, const Point& from, const Point& to) {
  player.press(from);
  player.drag_to(to);
  player.release();
}

}  // namespace rayproof::viz
