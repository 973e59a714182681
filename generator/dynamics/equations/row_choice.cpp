// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/row_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace torsor {
namespace row_choice {
namespace {

using Row = std::vector<double>;
using Indices = std::vector<std::size_t>;

double product(const Row& a, const Row& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
double length(const Row& a) { return std::sqrt(product(a, a)); }

/// Takes from a row what lies along those directions, and tells how much; twice is enough (Golub & Van Loan, 5.2.8).
Row taken_along(Row& rest, const RowsHere& directions) {
  Row along(directions.size(), 0.0);
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double part = product(rest, directions[k]);
      along[k] += part;
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= part * directions[k][i];
    }
  }
  return along;
}

Indices others(std::size_t count, const Indices& kept) {
  Indices left_out;
  for (std::size_t j = 0; j < count; ++j) {
    if (std::find(kept.begin(), kept.end(), j) == kept.end()) left_out.push_back(j);
  }
  return left_out;
}

/// C with: rows left out = C times rows kept; nothing where these lose rank.
std::optional<RowsHere> combinations(const RowsHere& rows, const Indices& kept, const Indices& left_out) {
  RowsHere directions, lower;
  for (const std::size_t j : kept) {
    Row rest = rows[j];
    lower.push_back(taken_along(rest, directions));
    const double left = length(rest);
    if (!(left > 1e-9)) return std::nullopt;
    lower.back().push_back(left);
    for (double& entry : rest) entry /= left;
    directions.push_back(std::move(rest));
  }
  RowsHere all;
  for (const std::size_t j : left_out) {
    Row rest = rows[j], c(kept.size(), 0.0);
    Row along = taken_along(rest, directions);
    for (std::size_t k = kept.size(); k-- > 0;) {
      c[k] = along[k] / lower[k][k];
      for (std::size_t i = 0; i <= k; ++i) along[i] -= c[k] * lower[k][i];
    }
    all.push_back(std::move(c));
  }
  return all;
}

/// The combinations at all configurations where there are any.
std::vector<RowsHere> combinations(const std::vector<RowsHere>& configurations, const Indices& kept, const Indices& left_out) {
  std::vector<RowsHere> all;
  for (const RowsHere& rows : configurations) {
    if (auto c = combinations(rows, kept, left_out)) all.push_back(std::move(*c));
  }
  return all;
}

/// Rows that combinations tie together: places among those left out, and among those kept.
struct Tied {
  Indices left_out, kept;
};

std::vector<Tied> tied_rows(const std::vector<RowsHere>& combinations) {
  constexpr double part = 1e-9;
  const std::size_t d = combinations.front().size(), r = combinations.front().front().size();
  Indices group(d + r);
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (const RowsHere& c : combinations) {
    for (std::size_t i = 0; i < d; ++i) {
      for (std::size_t k = 0; k < r; ++k) {
        const std::size_t from = group[d + k], to = group[i];
        if (std::abs(c[i][k]) > part && from != to) std::replace(group.begin(), group.end(), from, to);
      }
    }
  }
  std::vector<Tied> all;
  for (std::size_t g = 0; g < d + r; ++g) {
    Tied tied;
    for (std::size_t place = 0; place < d + r; ++place) {
      if (group[place] != g) continue;
      if (place < d)
        tied.left_out.push_back(place);
      else
        tied.kept.push_back(place - d);
    }
    if (!tied.left_out.empty() && !tied.kept.empty()) all.push_back(std::move(tied));
  }
  return all;
}

/// ‖C‖² of those rows; after row i of them has changed places with row k of the others, if they are given:
///   the pivot C_ik becomes 1/C_ik, its row −C_ij/C_ik, its column C_lk/C_ik, and the rest C_lj − C_lk C_ij/C_ik.
double square(const RowsHere& c, const Tied& tied) {
  double sum = 0;
  for (const std::size_t i : tied.left_out) {
    for (const std::size_t k : tied.kept) sum += c[i][k] * c[i][k];
  }
  return sum;
}

double square_exchanged(const RowsHere& c, const Tied& tied, std::size_t i, std::size_t k) {
  const double pivot = c[i][k];
  double sum = 1;
  for (const std::size_t j : tied.kept) sum += j == k ? 0 : c[i][j] * c[i][j];
  for (const std::size_t l : tied.left_out) {
    if (l == i) continue;
    const double factor = c[l][k] / pivot;
    sum += c[l][k] * c[l][k];
    for (const std::size_t j : tied.kept) {
      const double entry = j == k ? 0 : (c[l][j] - factor * c[i][j]) * pivot;
      sum += entry * entry;
    }
  }
  return sum / (pivot * pivot);
}

double share(double square) { return 1 / std::sqrt(1 + square); }

template <class Square>
double least_share(const std::vector<RowsHere>& combinations, const Square& square_of) {
  double least = 1.0;
  for (const RowsHere& c : combinations) {
    const double here = share(square_of(c));
    if (!(here >= least)) least = std::isnan(here) ? 0.0 : here;
  }
  return least;
}

/// Among all choices of rows that are tied, if these are few, one that gives the worst configuration a larger share than that.
bool choose_among_few(const std::vector<RowsHere>& configurations, const Tied& tied, double best, Indices& kept,
                      Indices& left_out) {
  constexpr double few = 500;
  const std::size_t r = tied.kept.size(), d = tied.left_out.size();
  double choices = 1;
  for (std::size_t k = 1; k <= d; ++k) choices *= static_cast<double>(r + k) / static_cast<double>(k);
  if (choices > few) return false;
  Indices all;
  for (const std::size_t k : tied.kept) all.push_back(kept[k]);
  for (const std::size_t i : tied.left_out) all.push_back(left_out[i]);
  std::sort(all.begin(), all.end());
  Tied places;
  for (std::size_t k = 0; k < r; ++k) places.kept.push_back(k);
  for (std::size_t i = 0; i < d; ++i) places.left_out.push_back(i);
  std::vector<bool> taken(r + d, false);
  std::fill_n(taken.begin(), r, true);
  bool found = false;
  do {
    Indices one, other;
    for (std::size_t k = 0; k < r + d; ++k) (taken[k] ? one : other).push_back(all[k]);
    double least = 1.0;
    for (const RowsHere& rows : configurations) {
      const auto c = combinations(rows, one, other);
      least = std::min(least, c ? share(square(*c, places)) : 0.0);
      if (!(least > best)) break;
    }
    if (!(least > best)) continue;
    best = least * 1.000001;  // one that is better by rounding only is no better
    for (std::size_t k = 0; k < r; ++k) kept[tied.kept[k]] = one[k];
    for (std::size_t i = 0; i < d; ++i) left_out[tied.left_out[i]] = other[i];
    found = true;
  } while (std::prev_permutation(taken.begin(), taken.end()));
  return found;
}

/// Changes rows left out for others that are kept where that gives the worst configuration a larger share.
bool exchange(const std::vector<RowsHere>& configurations, const std::vector<RowsHere>& combinations, Indices& kept,
              Indices& left_out) {
  constexpr double enough = 0.1, worthwhile = 1.2;
  for (const Tied& tied : tied_rows(combinations)) {
    const double now = least_share(combinations, [&](const RowsHere& c) { return square(c, tied); });
    if (now >= enough) continue;
    double best = now * worthwhile;
    if (choose_among_few(configurations, tied, best, kept, left_out)) return true;
    std::optional<std::pair<std::size_t, std::size_t>> found;
    for (const std::size_t i : tied.left_out) {
      for (const std::size_t k : tied.kept) {
        const double then = least_share(combinations, [&](const RowsHere& c) { return square_exchanged(c, tied, i, k); });
        if (!(then > best)) continue;
        best = then * 1.000001;  // one that is better by rounding only is no better
        found.emplace(i, k);
      }
    }
    if (!found) continue;
    std::swap(left_out[found->first], kept[found->second]);
    return true;
  }
  return false;
}

void scale_by_largest(std::vector<RowsHere>& configurations) {
  for (std::size_t j = 0; j < configurations.front().size(); ++j) {
    double largest = 0;
    for (const RowsHere& rows : configurations) largest = std::max(largest, length(rows[j]));
    if (!(largest > 0)) continue;
    for (RowsHere& rows : configurations) {
      for (double& entry : rows[j]) entry /= largest;
    }
  }
}

RowChoice choose(std::vector<RowsHere> configurations, const Indices& kept) {
  RowChoice choice{kept, 1.0}, now = choice;
  if (configurations.empty() || kept.empty() || kept.size() == configurations.front().size()) return choice;
  scale_by_largest(configurations);
  Indices left_out = others(configurations.front().size(), kept);
  for (std::size_t round = 0; round <= 2 * (kept.size() + left_out.size()); ++round) {
    const std::vector<RowsHere> all = combinations(configurations, choice.kept, left_out);
    if (all.empty()) return choice;
    choice.least_share = 1.0;
    for (const Tied& tied : tied_rows(all)) {
      choice.least_share = std::min(choice.least_share, least_share(all, [&](const RowsHere& c) { return square(c, tied); }));
    }
    if (round == 0) now = choice;
    if (!exchange(configurations, all, choice.kept, left_out)) break;
  }
  if (choice.least_share < share_that_is_lost) return now;  // no better, or not by much
  std::sort(choice.kept.begin(), choice.kept.end());
  return choice;
}

bool alike(const RowsHere& one, const RowsHere& other, const Indices& kept) {
  constexpr double part = 1e-7;
  std::vector<RowsHere> both;
  for (const RowsHere* rows : {&one, &other}) {
    std::vector<RowsHere> here{*rows};
    scale_by_largest(here);
    const auto c = combinations(here.front(), kept, others(here.front().size(), kept));
    if (!c) return false;
    both.push_back(*c);
  }
  for (std::size_t i = 0; i < both[0].size(); ++i) {
    for (std::size_t k = 0; k < kept.size(); ++k) {
      if (std::abs(both[0][i][k] - both[1][i][k]) > part * (1 + std::abs(both[0][i][k]))) return false;
    }
  }
  return true;
}

}  // namespace
}  // namespace row_choice

RowChoice choose_rows(std::vector<RowsHere> configurations, const std::vector<std::size_t>& kept) {
  return row_choice::choose(std::move(configurations), kept);
}

bool repeat_alike(const RowsHere& one, const RowsHere& other, const std::vector<std::size_t>& kept) {
  return row_choice::alike(one, other, kept);
}

}  // namespace torsor
