// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz TARGET CORPUS [--inputs N | --seconds S] [--seed N] [--only NUMBER]: feeds a reader with damaged files of a folder.
// Input NUMBER of a seed is always the same: --only runs it alone, and writes it to the standard output first.
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include "torsor/generator/base/printable.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/target.hpp"

namespace {

using namespace torsor::fuzzing;

constexpr std::array targets{Target{"urdf", read_robot},
                             Target{"xacro", read_xacro},
                             Target{"expression", read_expression},
                             Target{"yaml", read_yaml},
                             Target{"exceptions", read_exceptions},
                             Target{"decimal", read_decimal},
                             Target{"unit", read_unit},
                             Target{"formula", read_formula},
                             Target{"name", name_everything},
                             Target{"records", read_record_file},
                             Target{"reference", read_reference_file},
                             Target{"table", read_table_head},
                             Target{"command", run_scene_command},
                             Target{"robot_command", run_robot_command},
#ifdef TORSOR_WITH_MUJOCO
                             Target{"mjcf", read_mjcf},
#endif
};
// For one input, sanitizers included: of the processor, and of a clock, since an input may wait for what never comes.
constexpr time_t processor_seconds = 20;
constexpr unsigned clock_seconds = 300;

struct Run {
  const Target* target = nullptr;
  std::filesystem::path corpus;
  std::uint64_t inputs = 1000, seed = 1;
  double seconds = 0.0;
  std::optional<std::uint64_t> only;
};

std::uint64_t current = 0, current_seed = 0;

/// A descriptor that no target closes or writes to.
const int error_stream = ::dup(STDERR_FILENO);

/// Says which input it was, whatever state the process is in.
void tell(const char* what) {
  std::array<char, 512> line;
  const int length = std::snprintf(line.data(), line.size(), "\nfuzz: --seed %llu --only %llu: %.400s\n",
                                   static_cast<unsigned long long>(current_seed), static_cast<unsigned long long>(current), what);
  if (length > 0 && ::write(error_stream, line.data(), static_cast<std::size_t>(length)) < 0) std::_Exit(3);
}
void on_signal(int signal) {
  tell(signal == SIGALRM || signal == SIGPROF ? "an input takes too long" : "an input crashes");
  std::_Exit(1);
}

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr,
               "fuzz: %s; usage: fuzz TARGET CORPUS [--inputs N | --seconds S] [--seed N] [--only NUMBER], where TARGET is one of",
               why.c_str());
  for (const Target& target : targets) std::fprintf(stderr, " %s", std::string(target.name).c_str());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

Run run_of(const std::vector<std::string>& words) {
  if (words.size() < 2) refuse("a target and a corpus are needed");
  Run run;
  const auto found = std::find_if(targets.begin(), targets.end(), [&](const Target& t) { return t.name == words[0]; });
  if (found == targets.end()) refuse("unknown target '" + words[0] + "'");
  run.target = &*found;
  run.corpus = words[1];
  for (std::size_t i = 2; i < words.size(); i += 2) {
    if (i + 1 == words.size()) refuse(words[i] + " takes a number");
    const std::uint64_t number = std::strtoull(words[i + 1].c_str(), nullptr, 10);
    if (words[i] == "--inputs") {
      run.inputs = number;
    } else if (words[i] == "--seconds") {
      run.seconds = static_cast<double>(number);
    } else if (words[i] == "--seed") {
      run.seed = number;
    } else if (words[i] == "--only") {
      run.only = number;
    } else {
      refuse("unknown option " + words[i]);
    }
  }
  return run;
}

std::vector<std::string> read_corpus(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file()) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> corpus;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  if (corpus.empty()) refuse("no file in '" + folder.string() + "'");
  return corpus;
}

/// Whether the target took the input, or refused it as it should.
bool passes(const Target& target, const std::string& input) {
  const itimerval processor{{0, 0}, {processor_seconds, 0}};
  ::setitimer(ITIMER_PROF, &processor, nullptr);
  ::alarm(clock_seconds);
  try {
    target.run(input);
    return true;
  } catch (const std::exception& error) {
    tell(torsor::printable(error.what()).c_str());
  } catch (...) {
    tell("something that is no exception is thrown");
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  const Run run = run_of({argv + 1, argv + argc});
  const std::vector<std::string> corpus = read_corpus(run.corpus);
  for (const int signal : {SIGALRM, SIGPROF, SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) std::signal(signal, on_signal);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
  // Address sanitizers take terabytes of addresses.
  const rlimit memory{rlim_t{2} << 30, rlim_t{2} << 30};
  ::setrlimit(RLIMIT_AS, &memory);
#endif
  current_seed = run.seed;
  if (run.only) {
    current = *run.only;
    const std::string input = damaged(corpus, run.seed, current);
    std::fwrite(input.data(), 1, input.size(), stdout);
    std::fflush(stdout);
    return passes(*run.target, input) ? 0 : 1;
  }
  const auto began = std::chrono::steady_clock::now();
  const auto goes_on = [&] {
    if (run.seconds == 0.0) return current < run.inputs;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() < run.seconds;
  };
  bool good = true;
  for (; goes_on(); ++current) good = passes(*run.target, damaged(corpus, run.seed, current)) && good;
  std::printf("%s: %llu inputs\n", std::string(run.target->name).c_str(), static_cast<unsigned long long>(current));
  return good ? 0 : 1;
}
