// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/verify.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"

namespace torsor {
namespace {

/// What a search goes uphill on.
enum class Objective { potential, scaled };

/// Nothing where there is no way uphill, which is below everything.
std::optional<double> height(const Accuracy& accuracy, Objective objective) {
  if (!accuracy.counted) return std::nullopt;
  // An infinite bound has lost its meaning, and with it the way uphill.
  if (objective == Objective::potential) {
    return accuracy.potential < 1e300 ? std::optional(accuracy.potential) : std::nullopt;
  }
  return std::isnan(accuracy.scaled) ? std::numeric_limits<double>::infinity() : accuracy.scaled;
}

struct Found {
  Accuracy accuracy;
  std::optional<StressState> state;
  std::uint64_t seed = 0;
  bool searched = false;

  void keep(const Found& other, Objective objective) {
    if (!state || height(other.accuracy, objective) > height(accuracy, objective)) *this = other;
  }
};

/// The worst that is known of one group.
struct Record {
  Found by_error, by_bound;
  double potential = 0;
  int states = 0, undefined = 0;

  void keep(const Found& found) {
    if (found.accuracy.undefined) ++undefined;
    if (!found.accuracy.counted) return;
    ++states;
    potential = std::max(potential, found.accuracy.potential);
    by_error.keep(found, Objective::scaled);
    by_bound.keep(found, Objective::potential);
  }
};

class Search {
 public:
  Search(const Scene& scene, const VerifyOptions& options, Precision precision, KernelAccuracy& accuracy)
      : scene_(scene), options_(options), format_(precision == Precision::in_double ? double_states : float_states),
        accuracy_(accuracy), records_(accuracy.groups().size()) {
    format_.large = std::min(format_.large, options.range);
  }

  std::vector<Record> run() {
    for (int s = 0; s < options_.states; ++s) {
      const std::uint64_t seed = options_.seed + static_cast<std::uint64_t>(s);
      const StressState state(scene_, accuracy_.symbols(), seed, format_);
      accuracy_.move_to(state);
      for (std::size_t g = 0; g < records_.size(); ++g) records_[g].keep({accuracy_.estimate(g), state, seed, false});
    }
    for (std::size_t g = 0; g < records_.size(); ++g) {
      for (int climb = 0; climb < options_.climbs; ++climb) {
        search(g, climb % 2 == 0 ? Objective::potential : Objective::scaled, static_cast<std::uint64_t>(climb));
      }
    }
    return records_;
  }

 private:
  Found look(std::size_t group, const StressState& state, std::uint64_t seed) {
    accuracy_.move_to(state);
    Found found{accuracy_.estimate(group), state, seed, true};
    records_[group].keep(found);
    return found;
  }

  /// Uphill by coordinates: of a few steps of each the best is taken.
  void search(std::size_t group, Objective objective, std::uint64_t number) {
    constexpr int sweeps = 3, steps = 3, jitters = 12;
    Found here = objective == Objective::potential ? records_[group].by_bound : records_[group].by_error;
    if (!here.state) return;
    std::mt19937_64 random(here.seed + 1000003 * number);
    const std::vector<SymbolPointer>& all = here.state->symbols();
    std::vector<std::size_t> movable;
    for (const SymbolPointer& symbol : accuracy_.symbols(group)) {
      movable.push_back(static_cast<std::size_t>(std::find(all.begin(), all.end(), symbol) - all.begin()));
    }
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      bool moved = false;
      for (const std::size_t symbol : movable) {
        for (int step = 0; step < steps; ++step) {
          const Found there = look(group, here.state->with_step(symbol, random), here.seed);
          if (height(there.accuracy, objective) > height(here.accuracy, objective)) here = there, moved = true;
        }
      }
      if (!moved) break;
    }
    for (int jitter = 0; jitter < jitters; ++jitter) look(group, here.state->jittered(random), here.seed);
  }

  const Scene& scene_;
  const VerifyOptions& options_;
  StateFormat format_;
  KernelAccuracy& accuracy_;
  std::vector<Record> records_;
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

bool fits(const std::string& pattern, const std::string& name) { return pattern == "*" || pattern == name; }

bool applies(const AccuracyException& e, const VerifyRow& row) {
  return fits(e.kernel, row.kernel) && fits(e.group, row.group) && fits(e.scalar, row.scalar);
}

void apply_exceptions(VerifyRow& row, const std::string& scene, const std::vector<AccuracyException>& exceptions) {
  for (const AccuracyException& e : exceptions) {
    if (!fits(e.scene, scene) || !applies(e, row)) continue;
    row.limit = e.limit;
    row.reason = e.reason;
    return;
  }
}

}  // namespace

std::vector<AccuracyException> parse_accuracy_exceptions(const std::string& text) {
  std::vector<AccuracyException> exceptions;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (trimmed(line).empty() || trimmed(line)[0] == '#') continue;
    std::vector<std::string> parts;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, '|');) parts.push_back(trimmed(field));
    double limit = 0;
    bool read = parts.size() == 6 && !parts[5].empty();
    if (read) {
      const char* const end = parts[4].data() + parts[4].size();
      const auto result = std::from_chars(parts[4].data(), end, limit);
      read = result.ec == std::errc() && result.ptr == end;
    }
    if (!read) {
      throw UsageError(
          fmt::format("an exception is 'scene | kernel | group | scalar | limit | reason', not '{}'", line));
    }
    exceptions.push_back({parts[0], parts[1], parts[2], parts[3], limit, parts[5]});
  }
  return exceptions;
}

std::vector<VerifyRow> verify_scene(const Scene& scene, const VerifyOptions& options) {
  const std::vector<std::string>& kernels = options.kernels.empty() ? usual_kernel_names() : options.kernels;
  std::vector<VerifyRow> rows;
  for (const Precision precision : options.precisions) {
    const std::unique_ptr<KernelAccuracy> accuracy = kernel_accuracy(scene, options.model, kernels, precision);
    const std::vector<Record> records = Search(scene, options, precision, *accuracy).run();
    for (std::size_t g = 0; g < records.size(); ++g) {
      const OutputGroup& group = accuracy->groups()[g];
      VerifyRow row;
      row.kernel = accuracy->kernels()[group.kernel].kernel.name;
      row.group = group.name;
      row.scalar = precision == Precision::in_double ? "double" : "float";
      row.states = records[g].states;
      row.undefined = records[g].undefined;
      row.potential = records[g].potential;
      if (const Found& worst = records[g].by_error; worst.state) {
        accuracy->move_to(*worst.state);
        row.worst = accuracy->certify(g, options.digits);
        row.seed = worst.seed;
        row.searched = worst.searched;
        row.state = worst.state->to_string(accuracy->symbols(g));
        for (const SymbolPointer& symbol : accuracy->symbols(g)) row.numbers[symbol->name] = worst.state->value(symbol);
      }
      apply_exceptions(row, scene.name(), options.exceptions);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::vector<AccuracyException> needless_exceptions(const std::string& scene, const std::vector<VerifyRow>& rows,
                                                   const std::vector<AccuracyException>& exceptions) {
  std::vector<AccuracyException> needless;
  for (const AccuracyException& e : exceptions) {
    const bool needed = std::any_of(rows.begin(), rows.end(), [&](const VerifyRow& row) {
      return applies(e, row) && row.worst.counted && !(row.worst.scaled <= accuracy_bar);
    });
    if (fits(e.scene, scene) && !needed) needless.push_back(e);
  }
  return needless;
}

}  // namespace torsor
