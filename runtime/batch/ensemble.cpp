// SPDX-License-Identifier: MIT
#include "torsor/runtime/batch/ensemble.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <ostream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "torsor/runtime/batch/parallel.hpp"

namespace torsor::runtime {

namespace {

/// Records on their way from the threads that compute them to the file, which takes them in order. At most `slots` are
/// under way, so that one slow member holds the others up instead of filling the memory.
class Window {
 public:
  Window(const RecordHead& head, std::uint64_t first, const EnsembleGroups& groups, std::size_t slots)
      : head_(head),
        groups_(groups),
        first_(first),
        next_(first - first % groups.together),
        written_(first),
        ready_(slots),
        values_(slots * head.numbers) {}

  /// Computes one group after the other until there is no more, or the run is ended.
  void compute() noexcept {
    std::unique_lock lock(mutex_);
    for (;;) {
      room_.wait(lock, [&] { return ended_ || next_ >= head_.count || has_room(); });
      if (ended_ || next_ >= head_.count) return;
      const std::uint64_t index = next_, count = std::min(groups_.together, head_.count - index);
      next_ += groups_.together;
      lock.unlock();
      std::exception_ptr failure;
      try {
        groups_.compute(index, count, slots(index, count));
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      if (failure && !failure_) failure_ = failure;
      ended_ = ended_ || failure;
      // What was in the file before is not written again.
      for (std::uint64_t i = std::max(index, first_); i < index + count; ++i) ready_[i % ready_.size()] = !failure;
      record_.notify_one();
      if (ended_) room_.notify_all();
    }
  }

  /// Waits for the next record and says how many follow it without a gap. Throws what a member threw.
  std::uint64_t wait() {
    std::unique_lock lock(mutex_);
    record_.wait(lock, [&] { return failure_ || ready_[written_ % ready_.size()]; });
    if (failure_) std::rethrow_exception(failure_);
    std::uint64_t count = 1;
    while (count < ready_.size() && ready_[(written_ + count) % ready_.size()]) ++count;
    return count;
  }

  void free(std::uint64_t count) {
    const std::lock_guard lock(mutex_);
    for (; count > 0; --count) ready_[written_++ % ready_.size()] = false;
    room_.notify_all();
  }

  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    room_.notify_all();
  }

  /// Places of records that follow each other; those of a group do, because the window holds whole groups.
  [[nodiscard]] std::span<double> slots(std::uint64_t index, std::uint64_t count) noexcept {
    return std::span(values_).subspan(index % ready_.size() * head_.numbers, count * head_.numbers);
  }

 private:
  /// Whether the next group overwrites none of which a record is still to be written.
  [[nodiscard]] bool has_room() const noexcept {
    return next_ + groups_.together <= written_ - written_ % groups_.together + ready_.size();
  }

  const RecordHead& head_;
  const EnsembleGroups& groups_;
  std::mutex mutex_;
  std::condition_variable room_, record_;
  std::uint64_t first_, next_, written_;
  std::vector<char> ready_;
  std::vector<double> values_;
  bool ended_ = false;
  std::exception_ptr failure_;
};

class Run {
 public:
  Run(RecordFile& file, const RecordHead& head, const EnsembleOptions& options)
      : file_(file), options_(options), progress_{file.written(), head.count, file.written()} {}

  /// False when the callback ends the run.
  bool tell() {
    file_.flush();
    progress_.done = file_.written();
    return !options_.progress || options_.progress(progress_);
  }

  void on_this_thread(const RecordHead& head, const EnsembleGroups& groups) {
    std::vector<double> records(groups.together * head.numbers);
    do {
      const std::uint64_t first = file_.written() - file_.written() % groups.together;
      const std::uint64_t count = std::min(groups.together, head.count - first);
      groups.compute(first, count, std::span(records).first(count * head.numbers));
      while (file_.written() < first + count) {
        file_.append(std::span(records).subspan((file_.written() - first) * head.numbers, head.numbers));
      }
    } while (tell() && !file_.complete());
  }

  void on_threads(const RecordHead& head, const EnsembleGroups& groups, unsigned threads) {
    const std::uint64_t slots =
        std::max<std::uint64_t>({64, 16 * std::uint64_t{threads}, 2 * threads * groups.together});
    Window window(head, file_.written(), groups, slots + (groups.together - slots % groups.together) % groups.together);
    std::vector<std::jthread> workers;
    // Whatever ends this function ends the workers first, which then join.
    struct Ending {
      Window& window;
      ~Ending() { window.end(); }
    } const ending{window};
    for (unsigned i = 0; i < threads; ++i) workers.emplace_back([&window] { window.compute(); });
    do {
      const std::uint64_t count = window.wait();
      for (std::uint64_t i = 0; i < count; ++i) file_.append(window.slots(file_.written(), 1));
      window.free(count);
    } while (tell() && !file_.complete());
  }

  [[nodiscard]] const EnsembleProgress& progress() const noexcept { return progress_; }

 private:
  RecordFile& file_;
  const EnsembleOptions& options_;
  EnsembleProgress progress_;
};

}  // namespace

EnsembleProgress run_ensemble(const std::filesystem::path& path, const RecordHead& head, const EnsembleGroups& groups,
                              const EnsembleOptions& options) {
  if (groups.together == 0) {
    throw std::invalid_argument(
        "run_ensemble: EnsembleGroups::together is 0, so that no group has a member: give the number of members that "
        "are computed together, 1 or more");
  }
  RecordFile file(path, head);
  Run run(file, head, options);
  if (!run.tell() || file.complete()) return run.progress();
  const unsigned threads = thread_count(options.threads);
  if (threads == 1)
    run.on_this_thread(head, groups);
  else
    run.on_threads(head, groups, threads);
  return run.progress();
}

EnsembleProgress run_ensemble(const std::filesystem::path& path, const RecordHead& head, const EnsembleMember& member,
                              const EnsembleOptions& options) {
  const auto alone = [&](std::uint64_t first, std::uint64_t, std::span<double> record) { member(first, record); };
  return run_ensemble(path, head, EnsembleGroups{1, alone}, options);
}

std::function<bool(const EnsembleProgress&)> progress_line(std::ostream& stream) {
  return [&stream, shown = std::uint64_t{1000}](const EnsembleProgress& progress) mutable {
    const std::uint64_t percent = progress.total == 0 ? 100 : progress.done * 100 / progress.total;
    if (percent == shown) return true;
    shown = percent;
    stream << '\r' << progress.done << " of " << progress.total << " members, " << percent << " %";
    if (progress.done == progress.total) stream << '\n';
    stream.flush();
    return true;
  };
}

}  // namespace torsor::runtime
