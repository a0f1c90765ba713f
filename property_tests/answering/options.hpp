#pragma once
/// \file
/// What a function needs or cannot do, beside what its parameters show.

namespace rayproof {

/// Given to `answer_cases`, or to `takes`, beside functions.
enum class Option {
  unit_direction,  ///< needs a direction of length 1: is given one, and its t is scaled back
  no_interval,     ///< takes a Ray and does not look at its t_min and t_max
  whole_line,      ///< gives the hits behind the origin, too; a miss is never shown by a negative t
  no_transform     ///< is not to be asked cases with a transform
};

inline constexpr Option unit_direction = Option::unit_direction;
inline constexpr Option no_interval = Option::no_interval;
inline constexpr Option whole_line = Option::whole_line;
inline constexpr Option no_transform = Option::no_transform;

namespace answering {

/// The options of one function.
struct FunctionOptions {
  bool needs_unit_direction = false;
  bool has_no_interval = false;
  bool sees_whole_line = false;
  bool has_no_transform = false;

  constexpr void set(Option option) {
    needs_unit_direction |= option == Option::unit_direction;
    has_no_interval |= option == Option::no_interval;
    sees_whole_line |= option == Option::whole_line;
    has_no_transform |= option == Option::no_transform;
  }
};

}  // namespace answering
}  // namespace rayproof
