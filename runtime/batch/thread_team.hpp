// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace torsor::runtime {

/// Threads that stay, for work in many short parts. `run(count, work)` calls work(first, end) for consecutive ranges of
/// 0, ..., count - 1 and returns when all are done. The work must not throw. Threads that cannot be started are done
/// without.
class ThreadTeam {
 public:
  explicit ThreadTeam(unsigned threads = 1) {
    try {
      for (unsigned i = 1; i < threads; ++i) {
        workers_.emplace_back([this, i](const std::stop_token& stop) { serve(stop, i); });
      }
    } catch (const std::system_error&) {
    }
  }
  ~ThreadTeam() {
    for (std::jthread& worker : workers_) worker.request_stop();
    round_.fetch_add(1);
    round_.notify_all();
  }
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  [[nodiscard]] std::size_t size() const noexcept { return workers_.size() + 1; }

  template <class Work>
  void run(std::size_t count, const Work& work) {
    // Some microseconds of work are done sooner than a thread wakes.
    if (workers_.empty() || count < 64) {
      if (count > 0) work(std::size_t{0}, count);
      return;
    }
    count_ = count;
    work_ = [](const void* self, std::size_t first, std::size_t end) { (*static_cast<const Work*>(self))(first, end); };
    self_ = &work;
    left_.store(workers_.size());
    round_.fetch_add(1);
    round_.notify_all();
    part(0);
    for (std::size_t left = left_.load(); left > 0; left = left_.load()) left_.wait(left);
  }

 private:
  void part(std::size_t i) const { work_(self_, count_ * i / size(), count_ * (i + 1) / size()); }

  void serve(const std::stop_token& stop, unsigned i) {
    for (unsigned seen = 0;;) {
      round_.wait(seen);
      if (stop.stop_requested()) return;
      seen = round_.load();
      part(i);
      if (left_.fetch_sub(1) == 1) left_.notify_one();
    }
  }

  std::size_t count_ = 0;
  void (*work_)(const void*, std::size_t, std::size_t) = nullptr;
  const void* self_ = nullptr;
  std::atomic<unsigned> round_{0};
  std::atomic<std::size_t> left_{0};
  std::vector<std::jthread> workers_;
};

}  // namespace torsor::runtime
