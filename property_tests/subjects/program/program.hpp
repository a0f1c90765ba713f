#pragma once
/// \file
/// A program on trial: its command, and what all its instances know of it.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string>

namespace rayproof::program {

/// A command that the shell can't start; one sentence.
class CannotStart : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What the instances of a program share. Every member may be used by several threads at once.
class Program {
 public:
  using Clock = std::chrono::steady_clock;

  Program(std::string command, std::chrono::milliseconds case_time, const std::atomic<bool>* stop = nullptr)
      : command_(std::move(command)), case_time_(case_time), stop_(stop) {}

  [[nodiscard]] const std::string& command() const { return command_; }
  /// How long it may be silent while a case waits for its answer.
  [[nodiscard]] std::chrono::milliseconds case_time() const { return case_time_; }
  /// The same of a process that has answered nothing yet, which may have much to load.
  [[nodiscard]] std::chrono::milliseconds first_case_time() const;
  /// How long it may be silent once it is known to be so on some cases: those are waited for no longer.
  [[nodiscard]] std::chrono::milliseconds patience_of_case() const {
    return silences_ > 0 ? case_time_ / 4 : case_time_;
  }
  /// It was asked a case alone, and gave no answer in its time.
  void note_silence() { ++silences_; }
  [[nodiscard]] bool is_known_for_silence() const { return silences_ > 0; }
  /// Whether whoever asks wants no more answers.
  [[nodiscard]] bool is_stopped() const { return stop_ != nullptr && *stop_; }

  /// The first of `count` numbers in a row that no case has had.
  [[nodiscard]] std::uint64_t next_ids(std::size_t count) { return next_id_.fetch_add(count); }

  /// A process took this long to its first answer.
  void note_start(Clock::duration time);
  void note_answers(std::size_t count) { answers_ += count; }
  /// It has answered a case twice: from now on it pays to wait for that.
  void note_repeat() { has_repeated_ = true; }
  [[nodiscard]] bool repeats() const { return has_repeated_; }
  /// It has answered all that it was asked, with its input open: it holds answers back seldom, if at all.
  void note_complete_round() { has_completed_ = true; }
  /// Whether it is worth the time to see if it answers once its input is closed: of one that has answered all
  /// before, for its first silence alone, since it may flush some hundred lines at a time. Notes that
  /// silence.
  [[nodiscard]] bool begin_look_for_held_back() {
    return !has_completed_ || !was_seen_silent_.exchange(true);
  }
  /// Something went wrong, and this time was lost to it; `count` cases have no answer for that.
  void note_trouble(std::size_t count, Clock::duration lost, bool is_silence);
  /// It has written this many bytes more to standard error; false where it is too much to go on.
  [[nodiscard]] bool may_write_errors(std::uint64_t bytes) {
    constexpr std::uint64_t most = std::uint64_t{1} << 30U;
    return (error_bytes_ += bytes) <= most;
  }
  /// No more is to be asked of it, for this reason.
  void give_up(const std::string& why);

  [[nodiscard]] bool was_given_up() const { return is_given_up_; }
  /// Why, in one sentence; empty where it was not.
  [[nodiscard]] std::string why_given_up();
  [[nodiscard]] bool has_answered() const { return answers_ > 0; }

 private:
  std::string command_;
  std::chrono::milliseconds case_time_;
  const std::atomic<bool>* stop_;
  std::atomic<std::uint64_t> next_id_{1}, answers_{0}, troubles_{0}, silences_{0}, error_bytes_{0};
  std::atomic<std::int64_t> lost_{0}, slowest_start_{0};  ///< in milliseconds
  std::atomic<bool> is_given_up_{false}, has_repeated_{false}, has_completed_{false}, was_seen_silent_{false};
  std::mutex mutex_{};
  std::string why_{};
};

}  // namespace rayproof::program
