#include "subjects/program/program.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayproof::program {
namespace {

using std::chrono::milliseconds;

/// What loading an interpreter and large libraries may take.
constexpr milliseconds time_to_load{10000};
/// A program that loses more time than this to crashes and silence has been heard; one that is slow to start
/// may lose the time of some starts.
constexpr milliseconds patience{8000};
constexpr int patient_starts = 16;
constexpr milliseconds most_patience{15000};
/// A crash is over at once, and one in many cases hides nothing of the others: a third of its time counts.
constexpr int crashes_for_silence = 3;
/// Failures that are heard however long they take: the first silence takes as long as ten later ones.
constexpr std::uint64_t failures_heard = 8;
/// So often may it fail without ever giving an answer.
constexpr std::uint64_t first_failures = 6;

std::int64_t in_milliseconds(Program::Clock::duration time) {
  return std::chrono::duration_cast<milliseconds>(time).count();
}

}  // namespace

milliseconds Program::first_case_time() const {
  if (!has_answered()) return case_time_ + time_to_load;
  return case_time_ + 2 * milliseconds(slowest_start_) + milliseconds(500);
}

void Program::note_start(Clock::duration time) {
  const std::int64_t taken = in_milliseconds(time);
  std::int64_t slowest = slowest_start_;
  while (taken > slowest && !slowest_start_.compare_exchange_weak(slowest, taken)) {
  }
}

void Program::note_trouble(std::size_t count, Clock::duration lost, bool is_silence) {
  troubles_ += count;
  lost_ += in_milliseconds(lost) / (is_silence ? 1 : crashes_for_silence);
  if (!has_answered() && troubles_ >= first_failures)
    give_up(fmt::format("it failed on all of the first {} cases", troubles_.load()));
  else if (troubles_ >= failures_heard &&
           milliseconds(lost_) >
               std::clamp(patient_starts * milliseconds(slowest_start_), patience, most_patience))
    give_up(fmt::format("it failed on {} cases, which takes too long", troubles_.load()));
}

void Program::give_up(const std::string& why) {
  const std::lock_guard lock(mutex_);
  if (is_given_up_) return;
  why_ = why;
  is_given_up_ = true;
}

std::string Program::why_given_up() {
  const std::lock_guard lock(mutex_);
  return why_;
}

}  // namespace rayproof::program
