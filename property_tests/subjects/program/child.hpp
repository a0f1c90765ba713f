#pragma once
/// \file
/// A child process, and the three pipes to it.

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace rayproof::program {

/// A shell line that runs in a process group of its own, which ends with the object, whole. Reading and
/// writing never block.
class Child {
 public:
  /// Throws std::system_error where the system gives no process.
  explicit Child(const std::string& command);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// Sends what it takes of `unsent`, which is cut by that, and appends what it has written to `received`, as
  /// soon as there is something to do or the time is over.
  void exchange(std::string& unsent, std::string& received, std::chrono::milliseconds limit);

  /// The number of its process group.
  [[nodiscard]] pid_t group() const { return id_; }

  /// From now on it reads the end of its input.
  void close_input();
  /// Whether it has closed its output, or has ended.
  [[nodiscard]] bool is_output_closed() const { return output_ < 0; }

  /// How it ended, "ended with exit status 3" or "was ended by signal 11 (Segmentation fault)", waiting a
  /// moment for that; where it goes on, nothing.
  [[nodiscard]] std::string how_it_ended();
  /// Its exit status; nothing while it runs, or where a signal ended it. After `how_it_ended`.
  [[nodiscard]] std::optional<int> exit_status() const;

  /// How many bytes it has written to its standard error, as far as they have been read.
  [[nodiscard]] std::uint64_t error_bytes() const { return error_bytes_; }

  /// The last lines of its standard error, as one line.
  [[nodiscard]] std::string last_words();

 private:
  /// How a process ended: by a signal or with an exit status, and which.
  struct End {
    bool is_signal;
    int number;
  };

  void write_some(std::string& unsent);
  /// Whether more may come.
  static bool read_some(int file, std::string& into);
  /// The same of the standard error, of which the end alone is kept.
  bool read_errors();
  bool has_ended(std::chrono::milliseconds patience);

  pid_t id_ = -1;
  int input_ = -1;   ///< the child's standard input
  int output_ = -1;  ///< its standard output
  int errors_ = -1;
  std::optional<End> end_{};
  std::string error_text_{};
  std::uint64_t error_bytes_ = 0;
};

}  // namespace rayproof::program
