#include "programs/stream/ordered_workers.hpp"

#include <utility>

namespace rayproof {

OrderedWorkers::OrderedWorkers(std::size_t threads, Work work, Write write)
    : work_(std::move(work)), write_(std::move(write)), limit_(4 * threads) {
  for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

OrderedWorkers::~OrderedWorkers() { stop(); }

void OrderedWorkers::add(LineBlock block) {
  std::unique_lock lock(mutex_);
  changed_for_owner_.wait(lock, [this] { return jobs_.size() < limit_ || failure_; });
  if (failure_) std::rethrow_exception(failure_);
  jobs_.push_back({std::move(block)});
  ++waiting_;
  changed_for_workers_.notify_one();
}

void OrderedWorkers::finish() {
  std::unique_lock lock(mutex_);
  changed_for_owner_.wait(lock, [this] { return (jobs_.empty() && !is_writing_) || failure_; });
  if (failure_) std::rethrow_exception(failure_);
}

void OrderedWorkers::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_for_workers_.wait(lock, [this] { return waiting_ > 0 || is_stopped_; });
    if (is_stopped_) return;
    Job& job = jobs_[jobs_.size() - waiting_];
    --waiting_;
    try {
      lock.unlock();
      job.result = work_(job.block);
      lock.lock();
      job.is_done = true;
      write_finished(lock);
    } catch (...) {
      if (!lock.owns_lock()) lock.lock();
      fail();
    }
  }
}

/// Writes the finished jobs at the front of the queue, unless another thread is at it: that one will see them
/// too.
void OrderedWorkers::write_finished(std::unique_lock<std::mutex>& lock) {
  while (!is_writing_ && !jobs_.empty() && jobs_.front().is_done) {
    is_writing_ = true;
    const std::string result = std::move(jobs_.front().result);
    jobs_.pop_front();
    lock.unlock();
    write_(result);
    lock.lock();
    is_writing_ = false;
    changed_for_owner_.notify_one();
  }
}

/// Keeps the first exception for the owner and ends all work. The lock is held.
void OrderedWorkers::fail() {
  if (!failure_) failure_ = std::current_exception();
  is_stopped_ = true;
  changed_for_workers_.notify_all();
  changed_for_owner_.notify_one();
}

void OrderedWorkers::stop() {
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  changed_for_workers_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

}  // namespace rayproof
