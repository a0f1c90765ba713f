#pragma once
/// \file
/// What composed lessons are made of: library functions run in the recording arithmetic, told as a kernel's
/// run is.

#include <rayproof/arithmetics/recorded.hpp>
#include <type_traits>

#include "viz/record.hpp"
#include "viz/stage/lesson.hpp"
#include "viz/stage/setting.hpp"

namespace rayproof::viz {

/// The steps that `run(std::type_identity<R>{})` narrates in the recording arithmetic R of the precision.
template <class Run>
[[nodiscard]] Walkthrough record(Precision precision, Run&& run) {
  const auto record_as = [&]<class T>(std::type_identity<T>) {
    Tape tape;
    run(std::type_identity<Recorded<T, Shadow>>{});
    return tell_steps(tape, precision);
  };
  return precision == Precision::float32 ? record_as(std::type_identity<float>{})
                                         : record_as(std::type_identity<double>{});
}

/// The stage of a composed run: the given case's scene, a first step with the inputs, and the run's steps.
[[nodiscard]] Stage composed_stage(const Told& told, const Walkthrough& walk, const Setting& setting);

/// Lets a step show items of another space at the right of all that is in the world; the next step begins
/// anew.
void show_beside(Stage& stage, std::size_t step, const Items& items);

/// A last step on how far the run's own values part from the exact ones: the one that lost most, magnified.
[[nodiscard]] StageStep parting_of_values(const Walkthrough& walk, const Setting& setting,
                                          Precision precision);

}  // namespace rayproof::viz
