#pragma once
/// \file
/// Threads that work on blocks in parallel and put their results out in order.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "programs/stream/line_blocks.hpp"

namespace rayproof {

/// Holds a bounded number of blocks, so that memory does not grow with the stream. Whoever finishes the
/// oldest block writes it; nobody waits for a block that has no predecessor in work.
class OrderedWorkers {
 public:
  using Work = std::function<std::string(const LineBlock&)>;
  using Write = std::function<void(const std::string&)>;

  /// `work` is called from several threads at once, `write` from one at a time.
  OrderedWorkers(std::size_t threads, Work work, Write write);
  OrderedWorkers(const OrderedWorkers&) = delete;
  OrderedWorkers& operator=(const OrderedWorkers&) = delete;
  ~OrderedWorkers();

  /// Hands over a block; waits while too many are in work. Throws what `work` or `write` has thrown.
  void add(LineBlock block);

  /// Waits until everything is written. Throws what `work` or `write` has thrown.
  void finish();

 private:
  struct Job {
    LineBlock block;
    std::string result{};
    bool is_done = false;
  };

  void run();
  void write_finished(std::unique_lock<std::mutex>& lock);
  void fail();
  void stop();

  Work work_;
  Write write_;
  std::size_t limit_;

  std::mutex mutex_{};
  std::condition_variable changed_for_workers_{};
  std::condition_variable changed_for_owner_{};
  std::deque<Job> jobs_{};   ///< oldest first; a deque keeps its elements in place
  std::size_t waiting_ = 0;  ///< how many of the newest jobs no thread has taken up
  bool is_writing_ = false;
  bool is_stopped_ = false;
  std::exception_ptr failure_{};

  std::vector<std::thread> threads_{};
};

}  // namespace rayproof
