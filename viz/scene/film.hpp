#pragma once
/// \file
/// A stage as a film: what each of its pictures shows, and for how long.

#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// Pictures a second.
inline constexpr int film_rate = 8;

/// A picture of a film.
struct Shot {
  std::size_t step = 0;
  double t = 0;             ///< where p(t) is, where the step shows it
  bool is_arrival = false;  ///< the ray has come as far as p(t), and no farther
  int count = 1;            ///< for how many pictures of the film it stays
};

/// In the first step the ray travels and leaves a light where it meets something; in each step t runs to the
/// first hit, and then there is time to read.
[[nodiscard]] std::vector<Shot> shots_of(const Stage& stage);

/// The stage with a shot's step as the shot shows it.
[[nodiscard]] Stage stage_at(const Stage& stage, const Shot& shot);

}  // namespace rayproof::viz
