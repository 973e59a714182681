// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/batch/motion_ensemble.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <type_traits>

#if __has_include(<sys/file.h>)
#include <sys/file.h>
#endif
#if __has_include(<sys/stat.h>)
#include <sys/stat.h>

#include "tests/faults/full_disk.hpp"
#endif

#include "torsor/runtime/records/digest.hpp"
#include "torsor/runtime/records/record_file.hpp"
#include "tests/runtime/mechanisms.hpp"
#include "tests/runtime/temporary_folder.hpp"

namespace {

using namespace torsor::runtime;
using Oscillator = mechanisms::Oscillator<double>;
using CartesianPendulum = mechanisms::CartesianPendulum<double>;

constexpr RecordHead seven{123, 7, 3};

void squares(std::uint64_t index, std::span<double> record) {
  const auto i = static_cast<double>(index);
  record[0] = i;
  record[1] = i * i;
  record[2] = 1.0 / i;  // infinite for the first
}

class Ensemble : public TemporaryFolder {
 protected:
  std::filesystem::path file(const std::string& name = "results") const { return folder / name; }
  std::string whole() const {
    run_ensemble(file("whole"), seven, squares);
    return contents(file("whole"));
  }
};

TEST_F(Ensemble, WritesTheRecordsOfItsMembersInOrder) {
  const EnsembleProgress progress = run_ensemble(file(), seven, squares);
  EXPECT_EQ(progress.done, 7U);
  EXPECT_EQ(progress.found, 0U);
  const Records records = read_records(file());
  EXPECT_EQ(records.head, seven);
  ASSERT_TRUE(records.complete());
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(records[i][1], double(i * i));
    EXPECT_EQ(records[i][2], 1.0 / double(i));
  }
  // The layout that is documented: 7 words, then 5 for each record.
  EXPECT_EQ(contents(file()).size(), (7U + 7U * 5U) * 8U);
}

TEST_F(Ensemble, ResumesFromAFileThatEndsAnywhere) {
  const std::string expected = whole();
  for (std::size_t bytes = 0; bytes <= expected.size(); ++bytes) {
    put("results", expected.substr(0, bytes));
    std::uint64_t computed = 0;
    const EnsembleProgress progress = run_ensemble(file(), seven, [&](std::uint64_t index, std::span<double> record) {
      ++computed;
      squares(index, record);
    });
    ASSERT_EQ(contents(file()), expected) << "cut after " << bytes << " bytes";
    const std::uint64_t kept = bytes < 56 ? 0 : (bytes - 56) / 40;
    EXPECT_EQ(progress.found, kept) << bytes;
    EXPECT_EQ(computed, 7 - kept) << bytes;
  }
}

TEST_F(Ensemble, ReadsWhatIsThereOfAFileThatEndsAnywhere) {
  const std::string expected = whole();
  for (std::size_t bytes = 0; bytes <= expected.size(); ++bytes) {
    const Records records = read_records(put("results", expected.substr(0, bytes)));
    EXPECT_EQ(records.size(), bytes < 56 ? 0 : (bytes - 56) / 40) << bytes;
  }
}

// The head of a file is believed as far as there are bytes: neither memory nor time go into what it promises.
TEST_F(Ensemble, ReadsNothingOfRecordsThatAreLongerThanTheFile) {
  std::array<std::uint64_t, 7> head{};
  const std::string expected = whole();
  for (const std::uint64_t numbers : {std::uint64_t{1} << 40, std::uint64_t{1} << 61, ~std::uint64_t{0}, ~std::uint64_t{1}}) {
    std::memcpy(head.data(), expected.data(), sizeof head);
    head[4] = ~std::uint64_t{0};
    head[5] = numbers;
    head[6] = Digest{}.add(head[2]).add(head[3]).add(head[4]).add(head[5]).value();
    std::string text = expected;
    std::memcpy(text.data(), head.data(), sizeof head);
    const Records records = read_records(put("results", text));
    EXPECT_EQ(records.head.numbers, numbers);
    EXPECT_EQ(records.size(), 0U);
    EXPECT_FALSE(records.complete());
  }
}

TEST_F(Ensemble, DropsEverythingFromADamagedRecordOn) {
  const std::string expected = whole();
  for (std::size_t byte = 56; byte < expected.size(); ++byte) {
    std::string damaged = expected;
    damaged[byte] = static_cast<char>(damaged[byte] ^ 4);
    put("results", damaged);
    EXPECT_EQ(run_ensemble(file(), seven, squares).found, (byte - 56) / 40) << byte;
    ASSERT_EQ(contents(file()), expected) << byte;
  }
}

// A record that is right in itself, after the last one that the head promises.
TEST_F(Ensemble, DropsWhatFollowsTheLastRecord) {
  const std::string expected = whole();
  run_ensemble(file("longer"), {123, 8, 3}, squares);
  put("results", expected + contents(file("longer")).substr(56 + 7 * 40));
  ASSERT_EQ(RecordFile(file(), seven).written(), 7U);
  put("results", expected + contents(file("longer")).substr(56 + 7 * 40));
  EXPECT_EQ(run_ensemble(file(), seven, squares).found, 7U);
  EXPECT_EQ(contents(file()), expected);
}

TEST_F(Ensemble, RefusesTheFileOfAnotherQuestion) {
  const std::string expected = whole();
  const RecordHead others[] = {{124, 7, 3}, {123, 8, 3}, {123, 7, 4}};
  for (const RecordHead& other : others) {
    const std::string error = error_of<FileError>([&] { run_ensemble(file("whole"), other, squares); });
    EXPECT_TRUE(mentions(error, {"whole", "another question", "7 records of 3 numbers", "choose another file"}));
    EXPECT_EQ(contents(file("whole")), expected);
  }
}

TEST_F(Ensemble, RefusesWhatIsNoFileOfRecords) {
  const std::string good = whole();
  for (const std::string& text : {std::string("x"), std::string(500, 'x'), std::string("torsor ensemble, that is")}) {
    put("results", text);
    EXPECT_TRUE(mentions(error_of<FileError>([&] { run_ensemble(file(), seven, squares); }), {"results", "choose"}));
    EXPECT_EQ(contents(file()), text);
  }
  // Any byte of a whole head
  for (std::size_t byte = 0; byte < 56; ++byte) {
    std::string damaged = good;
    damaged[byte] = static_cast<char>(damaged[byte] ^ 1);
    put("results", damaged);
    EXPECT_NE(error_of<FileError>([&] { run_ensemble(file(), seven, squares); }), "") << byte;
    EXPECT_NE(error_of<FileError>([&] { (void)read_records(file()); }), "") << byte;
    EXPECT_EQ(contents(file()), damaged);
  }
  EXPECT_NE(error_of<FileError>([&] { run_ensemble(folder, seven, squares); }), "");
  EXPECT_NE(error_of<FileError>([&] { run_ensemble(folder / "none" / "results", seven, squares); }), "");
}

#if __has_include(<sys/stat.h>)
// Opening a pipe would wait for whoever is at its other end: for ever, where nobody is.
TEST_F(Ensemble, RefusesAPipeAndADevice) {
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  for (const std::filesystem::path& path : {file("pipe"), std::filesystem::path("/dev/null")}) {
    const std::string name = path.filename().string();
    EXPECT_TRUE(mentions(error_of<FileError>([&] { run_ensemble(path, seven, squares); }), {name.c_str(), "no regular file"}));
    EXPECT_TRUE(mentions(error_of<FileError>([&] { (void)read_records(path); }), {name.c_str(), "no regular file"}));
  }
}

TEST_F(Ensemble, GoesOnFromWhatAFullDiskHeld) {
  const std::string expected = whole();
  for (const rlim_t room : {rlim_t{0}, rlim_t{40}, rlim_t{56}, rlim_t{130}, rlim_t{expected.size() - 1}}) {
    for (const unsigned threads : {1U, 2U}) {
      const auto path = file(std::to_string(room) + "_" + std::to_string(threads));
      std::string error;
      {
        const torsor::testing_files::FullDisk disk(room);
        error = error_of<FileError>([&] { run_ensemble(path, seven, squares, {.threads = threads}); });
      }
      EXPECT_TRUE(mentions(error, {"File too large", "has room"}));
      EXPECT_LE(contents(path).size(), room);
      run_ensemble(path, seven, squares, {.threads = threads});
      EXPECT_EQ(contents(path), expected) << room;
    }
  }
}
#endif

// A group is computed whole, from its first member on, wherever the file ends in it.
TEST_F(Ensemble, ResumesInsideAGroup) {
  const std::string expected = whole();
  for (const unsigned threads : {1U, 2U}) {
    for (std::uint64_t kept = 0; kept < 7; ++kept) {
      put("results", expected.substr(0, 56 + 40 * kept));
      std::mutex mutex;
      std::set<std::uint64_t> begun;
      const auto group = [&](std::uint64_t first, std::uint64_t count, std::span<double> records) {
        {
          const std::lock_guard lock(mutex);
          begun.insert(first);
        }
        EXPECT_EQ(count, std::min<std::uint64_t>(3, 7 - first));
        for (std::uint64_t i = 0; i < count; ++i) squares(first + i, records.subspan(3 * i, 3));
      };
      run_ensemble(file(), seven, EnsembleGroups{3, group}, {.threads = threads});
      EXPECT_EQ(contents(file()), expected) << kept;
      std::set<std::uint64_t> groups;
      for (std::uint64_t first = kept - kept % 3; first < 7; first += 3) groups.insert(first);
      EXPECT_EQ(begun, groups) << kept;
    }
  }
}

// The window goes round after 66 records, and the place of record 3, found in the file, is that of record 69: it waits
// for its own, however long that takes.
TEST_F(Ensemble, WaitsForEveryRecordAfterResumingInsideAGroup) {
  constexpr RecordHead many{123, 200, 3};
  run_ensemble(file("one"), many, squares);
  const std::string expected = contents(file("one"));
  put("results", expected.substr(0, 56 + 40 * 4));
  const auto group = [](std::uint64_t first, std::uint64_t count, std::span<double> records) {
    if (first == 69) std::this_thread::sleep_for(std::chrono::milliseconds(30));
    for (std::uint64_t i = 0; i < count; ++i) squares(first + i, records.subspan(3 * i, 3));
  };
  run_ensemble(file(), many, EnsembleGroups{3, group}, {.threads = 2});
  EXPECT_EQ(contents(file()), expected);
}

TEST_F(Ensemble, RefusesGroupsWithoutMembers) {
  for (const unsigned threads : {1U, 2U}) {
    const std::string error = error_of<std::invalid_argument>([&] {
      run_ensemble(file("empty"), seven, EnsembleGroups{0, [](auto, auto, auto) {}}, {.threads = threads});
    });
    EXPECT_TRUE(mentions(error, {"EnsembleGroups::together", "is 0", "1 or more"}));
    EXPECT_FALSE(std::filesystem::exists(file("empty")));
  }
}

TEST_F(Ensemble, RefusesAFileThatIsBeingWritten) {
  std::string error;
  run_ensemble(file(), seven, [&](std::uint64_t index, std::span<double> record) {
    if (index == 3) error = error_of<FileError>([&] { run_ensemble(file(), seven, squares); });
    squares(index, record);
  });
  EXPECT_TRUE(mentions(error, {"results", "being written"}));
  EXPECT_EQ(contents(file()), whole());
}

#if __has_include(<sys/file.h>)
// What another process is writing may be half a head, or grow before it is cut: it is not read before it is locked.
TEST_F(Ensemble, LocksTheFileBeforeItReadsIt) {
  const std::filesystem::path path = put("results", "something else");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> other(std::fopen(path.c_str(), "rb"), std::fclose);
  ASSERT_EQ(::flock(::fileno(other.get()), LOCK_EX | LOCK_NB), 0);
  EXPECT_TRUE(mentions(error_of<FileError>([&] { RecordFile(path, seven); }), {"results", "being written"}));
}

TEST_F(Ensemble, LosesNoRecordToAnotherWriter) {
  constexpr RecordHead many{5, 200, 3};
  std::atomic<std::uint64_t> kept{0};  // records of files that were closed
  std::atomic<bool> lost{false};
  const auto write = [&] {
    for (bool complete = false; !complete && !lost;) {
      const std::uint64_t before = kept;
      try {
        RecordFile records(file(), many);
        if (records.written() < before) lost = true;
        complete = records.complete();
        if (complete) continue;
        records.append(std::array{1.0, 2.0, 3.0});
        records.flush();
        kept = records.written();
      } catch (const FileError&) {  // the other is writing
      }
    }
  };
  std::jthread other(write);
  write();
  other.join();
  EXPECT_FALSE(lost);
  EXPECT_EQ(read_records(file()).size(), 200U);
}
#endif

TEST_F(Ensemble, WritesTheSameBytesOnAnyNumberOfThreads) {
  constexpr RecordHead many{5, 500, 3};
  run_ensemble(file("one"), many, squares);
  for (const unsigned threads : {2U, 4U, 0U, 100U}) {
    const auto path = file(std::to_string(threads));
    // Members that take longer or shorter finish in another order.
    run_ensemble(path, many,
                 [](std::uint64_t index, std::span<double> record) {
                   if (index % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(index));
                   squares(index, record);
                 },
                 {.threads = threads});
    EXPECT_EQ(contents(path), contents(file("one"))) << threads;
  }
}

TEST_F(Ensemble, StopsWhenTheProgressCallbackSaysSoAndGoesOnLater) {
  constexpr RecordHead many{5, 300, 3};
  run_ensemble(file("one"), many, squares);
  for (const unsigned threads : {1U, 3U}) {
    const auto path = file(std::to_string(threads));
    std::uint64_t last = 0, runs = 0;
    for (bool complete = false; !complete; ++runs) {
      ASSERT_LT(runs, 1000U);
      const auto until = [&](const EnsembleProgress& progress) {
        EXPECT_GE(progress.done, last);
        EXPECT_EQ(progress.total, 300U);
        last = progress.done;
        return progress.done < progress.found + 90;
      };
      const EnsembleProgress progress = run_ensemble(path, many, squares, {.threads = threads, .progress = until});
      EXPECT_EQ(progress.done, last);
      complete = progress.done == progress.total;
    }
    EXPECT_GT(runs, 1U);
    EXPECT_EQ(contents(path), contents(file("one")));
  }
}

TEST_F(Ensemble, PassesOnWhatAMemberThrowsAndKeepsWhatWasDone) {
  for (const unsigned threads : {1U, 4U}) {
    const auto path = file(std::to_string(threads));
    const auto fails = [](std::uint64_t index, std::span<double> record) {
      if (index == 4) throw std::runtime_error("member 4 has no start");
      squares(index, record);
    };
    EXPECT_EQ(error_of<std::runtime_error>([&] { run_ensemble(path, seven, fails, {.threads = threads}); }),
              "member 4 has no start");
    EXPECT_LE(read_records(path).size(), 4U);
    run_ensemble(path, seven, squares, {.threads = threads});
    EXPECT_EQ(contents(path), whole());
  }
}

TEST_F(Ensemble, ComputesNothingForACompleteFileOrNoMembers) {
  const std::string expected = whole();
  const auto never = [](std::uint64_t, std::span<double>) { FAIL(); };
  EXPECT_EQ(run_ensemble(file("whole"), seven, never).found, 7U);
  EXPECT_EQ(contents(file("whole")), expected);
  EXPECT_EQ(run_ensemble(file("none"), {1, 0, 3}, never, {.threads = 2}).total, 0U);
  EXPECT_TRUE(read_records(file("none")).complete());
}

TEST_F(Ensemble, ShowsItsProgressInALine) {
  std::ostringstream shown;
  run_ensemble(file(), {5, 200, 3}, squares, {.progress = progress_line(shown)});
  EXPECT_TRUE(mentions(shown.str(),
                       {"\r0 of 200 members, 0 %", "\r100 of 200 members, 50 %", "\r200 of 200 members, 100 %\n"}));
}

Member<Oscillator> oscillator(std::uint64_t index) {
  // x'' = -k/m x from x = 1: cos(sqrt(k/m) t)
  return {{2.0, 2.0 + static_cast<double>(index)}, Oscillator::initial_state()};
}

TEST_F(Ensemble, IntegratesMembersWithParametersOfTheirOwn) {
  const std::vector<double> times{0.5, 1.0, 2.0};
  const auto ensemble =
      motion_ensemble<Oscillator>({.count = 9, .times = times}, oscillator,
                                  DormandPrince54{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11});
  run_ensemble(file(), ensemble.head(), ensemble, {.threads = 2});
  const Records records = read_records(file());
  ASSERT_TRUE(records.complete());
  for (std::size_t i = 0; i < 9; ++i) {
    const auto motion = member_motion<Oscillator>(records[i]);
    EXPECT_EQ(motion.status, IntegrationStatus::reached_end);
    EXPECT_EQ(motion.end, 2.0);
    EXPECT_GT(motion.calls, 0);
    ASSERT_EQ(motion.states.size(), times.size());
    const double omega = std::sqrt(1.0 + double(i) / 2.0);
    // Some dozen steps, each within the tolerance times 1 + omega, on a motion that amplifies nothing.
    for (std::size_t k = 0; k < times.size(); ++k) {
      EXPECT_NEAR(motion.states[k][0], std::cos(omega * times[k]), 1e-9);
      EXPECT_NEAR(motion.states[k][1], -omega * std::sin(omega * times[k]), 1e-9);
    }
  }
}

TEST_F(Ensemble, RecordsMotionsThatFail) {
  // Through the centre of the circle: singular there.
  const auto members = [](std::uint64_t index) {
    Member<CartesianPendulum> member;
    if (index == 1) member.state = {0.0, {{0.0, 0.0}}, {{1.0, 0.0}}};
    return member;
  };
  const auto ensemble =
      motion_ensemble<CartesianPendulum>({.count = 2, .times = {0.1, 0.2}}, members, RungeKutta4{.step = 0.01});
  run_ensemble(file(), ensemble.head(), ensemble);
  const Records records = read_records(file());
  EXPECT_EQ(member_motion<CartesianPendulum>(records[0]).states.size(), 2U);
  const auto failed = member_motion<CartesianPendulum>(records[1]);
  EXPECT_EQ(failed.status, IntegrationStatus::model_failure);
  EXPECT_EQ(failed.evaluation, Evaluation::singular);
  EXPECT_TRUE(failed.states.empty());
}

TEST(MotionEnsemble, AsksAnotherQuestionWhenAnythingChanges) {
  const std::vector<double> times{0.5, 1.0};
  const EnsemblePlan<double> plan{.count = 9, .times = times};
  const EnsemblePlan<double> other{.count = 9, .times = times, .label = "other"};
  const DormandPrince54 method;
  std::vector<std::uint64_t> questions{
      motion_ensemble<Oscillator>(plan, oscillator, method).head().question,
      motion_ensemble<Oscillator>({.count = 8, .times = times}, oscillator, method).head().question,
      motion_ensemble<Oscillator>({.count = 9, .times = {0.5, 1.5}}, oscillator, method).head().question,
      motion_ensemble<Oscillator>({.count = 9, .times = {0.5}}, oscillator, method).head().question,
      motion_ensemble<Oscillator>(plan, oscillator, DormandPrince54{.relative_tolerance = 1e-8}).head().question,
      motion_ensemble<Oscillator>(plan, oscillator, RungeKutta4{.step = 0.1}).head().question,
      motion_ensemble<Oscillator>(plan, oscillator, Midpoint{.step = 0.1}).head().question,
      motion_ensemble<Oscillator>(other, oscillator, method).head().question};
  for (std::uint64_t changed = 0; changed < 9; ++changed) {
    for (const int what : {0, 1, 2, 3, 4}) {
      const auto members = [=](std::uint64_t index) {
        Member<Oscillator> member = oscillator(index);
        double* const values[] = {&member.parameters.mass, &member.parameters.stiffness, &member.state.time,
                                  &member.state.q[0], &member.state.v[0]};
        if (index == changed) *values[what] += 0.25;
        return member;
      };
      questions.push_back(motion_ensemble<Oscillator>(plan, members, method).head().question);
    }
  }
  EXPECT_EQ(motion_ensemble<Oscillator>(plan, oscillator, method).head().question, questions.front());
  std::sort(questions.begin(), questions.end());
  EXPECT_EQ(std::adjacent_find(questions.begin(), questions.end()), questions.end());
}

template <class Method, class... Change>
void expect_a_question_for_each(const Change&... changes) {
  std::vector<Method> methods{Method{}};
  (changes(methods.emplace_back()), ...);
  std::vector<std::uint64_t> questions;
  for (const Method& method : methods) {
    Digest digest;
    add_to_digest(digest, method);
    questions.push_back(digest.value());
  }
  std::sort(questions.begin(), questions.end());
  EXPECT_EQ(std::adjacent_find(questions.begin(), questions.end()), questions.end());
}

TEST(MotionEnsemble, AsksAnotherQuestionForEveryOptionOfAMethod) {
  const auto step = [](auto& m) { m.step = 0.03125; };
  const auto compensated = [](auto& m) { m.compensated = !m.compensated; };
  const auto limit = [](auto& m) { m.step_limit = 77; };
  expect_a_question_for_each<Midpoint>(step, limit, compensated);
  expect_a_question_for_each<RungeKutta4>(step, limit, compensated);
  const auto relative = [](auto& m) { m.relative_tolerance = 3e-7; };
  const auto absolute = [](auto& m) { m.absolute_tolerance = 3e-7; };
  const auto first = [](auto& m) { m.first_step = 0.03125; };
  const auto largest = [](auto& m) { m.largest_step = 0.03125; };
  expect_a_question_for_each<DormandPrince54>(relative, absolute, first, largest, limit, compensated);
  expect_a_question_for_each<DormandPrince853>(relative, absolute, first, largest, limit, compensated);
  expect_a_question_for_each<Taylor>(relative, absolute, first, largest, limit, compensated,
                                     [](Taylor& m) { m.order = m.order == 12 ? 13 : 12; });
}

TEST(Digest, TellsTwoTextsInARowFromTheirLettersDividedOtherwise) {
  using std::string_view_literals::operator""sv;
  EXPECT_NE(Digest().add("ab"sv).add("c"sv).value(), Digest().add("a"sv).add("bc"sv).value());
  EXPECT_NE(Digest().add("abc"sv).add(""sv).value(), Digest().add(""sv).add("abc"sv).value());
}

/// What a header becomes that is written again, with another mass folded in say.
template <unsigned long long version>
struct WrittenAgain : Oscillator {
  static constexpr unsigned long long fingerprint = version;
};

TEST(MotionEnsemble, AsksAnotherQuestionOfAnotherHeaderOfTheSameName) {
  const auto question = []<class M>(std::type_identity<M>) {
    const auto members = [](std::uint64_t) { return Member<M>{}; };
    return motion_ensemble<M>({.count = 2, .times = {0.5}}, members, DormandPrince54{}).head().question;
  };
  const std::uint64_t without = question(std::type_identity<Oscillator>{});
  const std::uint64_t first = question(std::type_identity<WrittenAgain<1>>{});
  EXPECT_NE(first, without);
  EXPECT_NE(first, question(std::type_identity<WrittenAgain<2>>{}));
  EXPECT_EQ(first, question(std::type_identity<WrittenAgain<1>>{}));
}

}  // namespace
