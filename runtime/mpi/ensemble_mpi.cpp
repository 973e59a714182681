// SPDX-License-Identifier: MIT
#include "torsor/runtime/mpi/ensemble_mpi.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "torsor/runtime/batch/parallel.hpp"

namespace torsor::runtime {

namespace {

constexpr int report_tag = 1, values_tag = 2, text_tag = 3, order_tag = 4;

/// What a worker says when it asks for work: the members it brings, or that it failed, and the length of the text.
struct Report {
  std::uint64_t first = 0, count = 0, failed = 0, letters = 0;
};
/// What it is told: members to compute, none when there is nothing left to do.
struct Order {
  std::uint64_t first = 0, count = 0;
};

template <class Words>
void send_words(const Words& words, int to, int tag, MPI_Comm communicator) {
  MPI_Send(&words, sizeof(Words) / sizeof(std::uint64_t), MPI_UINT64_T, to, tag, communicator);
}
template <class Words>
Words receive_words(int& from, int tag, MPI_Comm communicator) {
  Words words;
  MPI_Status status;
  MPI_Recv(&words, sizeof(Words) / sizeof(std::uint64_t), MPI_UINT64_T, from, tag, communicator, &status);
  from = status.MPI_SOURCE;
  return words;
}

std::string text_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an ensemble member failed";
  }
}

/// The records of consecutive members, each computed by whichever thread is free. Throws what a member threw.
std::vector<double> compute(const Order& order, const RecordHead& head, const EnsembleMember& member,
                            unsigned threads) {
  std::vector<double> values(order.count * head.numbers);
  std::atomic<std::uint64_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  in_parts(threads, threads, [&](std::size_t, std::size_t, std::size_t) {
    try {
      for (std::uint64_t i = next++; i < order.count; i = next++)
        member(order.first + i, std::span(values).subspan(i * head.numbers, head.numbers));
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = order.count;
    }
  });
  if (failure) std::rethrow_exception(failure);
  return values;
}

/// A process that computes. Returns what its own member threw, if any.
std::exception_ptr work(MPI_Comm communicator, const RecordHead& head, const EnsembleMember& member, unsigned threads) {
  std::exception_ptr failure;
  std::vector<double> values;
  Report report;
  for (int writer = 0;;) {
    send_words(report, writer, report_tag, communicator);
    if (report.count > 0) {
      MPI_Send(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, writer, values_tag, communicator);
    }
    if (report.failed != 0) {
      const std::string text = text_of(failure);
      MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, writer, text_tag, communicator);
    }
    const auto order = receive_words<Order>(writer, order_tag, communicator);
    if (order.count == 0) return failure;
    report = {order.first, order.count, 0, 0};
    try {
      values = compute(order, head, member, threads);
    } catch (...) {
      failure = std::current_exception();
      report = {0, 0, 1, text_of(failure).size()};
    }
  }
}

/// The process that writes. Records that come before their turn wait here, at most as many as are handed out in 16
/// rounds: whoever asks for more waits too.
class Writer {
 public:
  Writer(RecordFile& file, const RecordHead& head, const MpiEnsembleOptions& options, int workers)
      : communicator_(options.communicator),
        file_(file),
        head_(head),
        options_(options),
        limit_(16 * options.at_once * static_cast<std::uint64_t>(workers)),
        next_(file.written()),
        working_(workers),
        progress_{file.written(), head.count, file.written()} {}

  /// Until every worker was told to stop. What went wrong is in `failure` and `text`.
  void run() {
    guarded([&] { tell(); });
    while (working_ > 0) {
      int worker = MPI_ANY_SOURCE;
      const auto report = receive_words<Report>(worker, report_tag, communicator_);
      if (report.count > 0) take(worker, report);
      if (report.failed != 0) take_failure(worker, report);
      idle_.push_back(worker);
      guarded([&] { write(); });
      while (!idle_.empty() && give(idle_.front())) idle_.pop_front();
    }
  }

  [[nodiscard]] const EnsembleProgress& progress() const noexcept { return progress_; }
  std::exception_ptr failure;       ///< in this process
  std::optional<std::string> text;  ///< of this or another process's failure, if any; it may be empty

 private:
  struct Arrived {
    std::uint64_t count = 0;
    std::vector<double> values;
  };

  template <class Action>
  void guarded(const Action& action) {
    if (failure) return;
    try {
      action();
    } catch (...) {
      failure = std::current_exception();
      text = text_of(failure);
      ended_ = true;
    }
  }

  void take(int worker, const Report& report) {
    auto& [count, values] = waiting_[report.first];
    count = report.count;
    values.resize(report.count * head_.numbers);
    MPI_Recv(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, worker, values_tag, communicator_,
             MPI_STATUS_IGNORE);
  }
  void take_failure(int worker, const Report& report) {
    std::string words(report.letters, ' ');
    MPI_Recv(words.data(), static_cast<int>(words.size()), MPI_CHAR, worker, text_tag, communicator_,
             MPI_STATUS_IGNORE);
    if (!text) text = words;
    ended_ = true;
  }

  void write() {
    const std::uint64_t before = file_.written();
    for (auto next = waiting_.find(file_.written()); next != waiting_.end(); next = waiting_.find(file_.written())) {
      const Arrived records = std::move(next->second);
      waiting_.erase(next);
      for (std::size_t i = 0; i < records.count; ++i) {  // also where they have no numbers
        file_.append(std::span(records.values).subspan(i * head_.numbers, head_.numbers));
      }
    }
    if (file_.written() != before) tell();
  }
  void tell() {
    file_.flush();
    progress_.done = file_.written();
    if (options_.progress && !options_.progress(progress_)) ended_ = true;
  }

  /// False when the worker has to wait until what is under way has come.
  bool give(int worker) {
    Order order;
    if (!ended_ && next_ < head_.count) {
      if (next_ - file_.written() >= limit_) return false;
      order = {next_, std::min(options_.at_once, head_.count - next_)};
      next_ += order.count;
    }
    if (order.count == 0) --working_;
    send_words(order, worker, order_tag, communicator_);
    return true;
  }

  MPI_Comm communicator_;
  RecordFile& file_;
  const RecordHead& head_;
  const MpiEnsembleOptions& options_;
  std::uint64_t limit_, next_;
  int working_;
  bool ended_ = false;
  std::map<std::uint64_t, Arrived> waiting_;
  std::deque<int> idle_;
  EnsembleProgress progress_;
};

/// Tells all processes whether one failed, which the first knows, with its words, and throws in all of them if so.
void agree(MPI_Comm communicator, const std::exception_ptr& own, const std::optional<std::string>& failure) {
  std::string text = failure.value_or("");
  std::array<std::uint64_t, 2> words{failure ? 1U : 0U, text.size()};  // whether, and how many letters
  MPI_Bcast(words.data(), 2, MPI_UINT64_T, 0, communicator);
  if (words[0] == 0) return;
  text.resize(words[1]);
  MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, communicator);
  if (own) std::rethrow_exception(own);
  throw EnsembleError(text);
}

void require_one_question(MPI_Comm communicator, const RecordHead& head, bool writer) {
  std::array<std::uint64_t, 3> words{head.question, head.count, head.numbers}, first = words;
  MPI_Bcast(first.data(), 3, MPI_UINT64_T, 0, communicator);
  int different = words != first ? 1 : 0, any = 0;
  MPI_Reduce(&different, &any, 1, MPI_INT, MPI_MAX, 0, communicator);
  std::optional<std::string> text;
  if (writer && any != 0) {
    text = "the processes of an ensemble were given different questions: mechanism, members, times and method must be "
           "the same in all of them";
  }
  agree(communicator, nullptr, text);
}

}  // namespace

EnsembleProgress run_ensemble_over_mpi(const std::filesystem::path& path, const RecordHead& head,
                                       const EnsembleMember& member, const MpiEnsembleOptions& options) {
  const MPI_Comm communicator = options.communicator;
  int rank = 0, size = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &size);
  if (size == 1) return run_ensemble(path, head, member, {.threads = options.threads, .progress = options.progress});
  require_one_question(communicator, head, rank == 0);

  const unsigned threads = thread_count(options.threads);
  // A message has fewer numbers than an int counts.
  const std::uint64_t most = (std::uint64_t{1} << 30) / std::max<std::uint64_t>(1, head.numbers);
  MpiEnsembleOptions known = options;
  if (known.at_once == 0) known.at_once = std::uint64_t{4} * threads;
  known.at_once = std::clamp<std::uint64_t>(known.at_once, 1, std::max<std::uint64_t>(1, most));

  std::array<std::uint64_t, 3> reached{};
  std::exception_ptr own;
  std::optional<std::string> text;
  std::unique_ptr<RecordFile> file;
  if (rank == 0) {
    try {
      file = std::make_unique<RecordFile>(path, head);
    } catch (...) {
      own = std::current_exception();
      text = text_of(own);
    }
  }
  agree(communicator, own, text);
  if (rank == 0) {
    Writer writer(*file, head, known, size - 1);
    writer.run();
    own = writer.failure;
    text = writer.text;
    reached = {writer.progress().done, writer.progress().total, writer.progress().found};
  } else {
    own = work(communicator, head, member, threads);
  }
  agree(communicator, own, text);
  MPI_Bcast(reached.data(), 3, MPI_UINT64_T, 0, communicator);
  return {reached[0], reached[1], reached[2]};
}

}  // namespace torsor::runtime
