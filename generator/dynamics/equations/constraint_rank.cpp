// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/constraint_rank.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/cholesky.hpp"
#include "torsor/generator/base/linear_algebra/orthonormal_rows.hpp"
#include "torsor/generator/dynamics/equations/configuration_sample.hpp"
#include "torsor/generator/dynamics/equations/constraint_sizes.hpp"
#include "torsor/generator/dynamics/forces/bearing_loads.hpp"
#include "torsor/generator/dynamics/forces/constraints.hpp"
#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/forces/virtual_power.hpp"

namespace torsor {
namespace {

using Row = RealRow;

Real decimal(const char* text) { return Real::parse(text); }
Real tolerance() { return Real::from_double(ConstraintRank::tolerance); }

class RankFinder {
 public:
  RankFinder(const Scene& scene, const ModelOptions& options)
      : program_(Model::resolver(scene, options)), model_(scene, program_, options), rows_(constraint_rows(model_)),
        sizes_(constraint_sizes(model_, rows_)), here_(model_) {
    n_ = static_cast<std::size_t>(model_.unknown_count());
    const std::vector<std::vector<Value>> mass = mass_matrix(model_.regrouped());
    for (std::size_t i = 0; i < n_; ++i) {
      const Real inertia = here_(mass[i][i]);
      metric_.push_back(inertia > Real(0) ? Real(1) / sqrt(inertia) : Real(1));
    }
    for (const bool holonomic : {true, false}) {
      for (std::size_t j = 0; j < rows_.size(); ++j) {
        if (rows_[j].holonomic == holonomic) order_.push_back(j);
      }
    }
    holonomic_count_ = static_cast<std::size_t>(
        std::count_if(rows_.begin(), rows_.end(), [](const ConstraintRow& row) { return row.holonomic; }));
    for (const ContactRows& contact : contact_rows(model_)) {
      if (contact.joint) rubbing_.push_back({contact.name, constraint_loads(model_, *contact.joint)});
    }
  }

  ConstraintRank find() {
    ConstraintRank result;
    const std::vector<std::size_t> held = basis(here_, holonomic_count_).independent();
    ConfigurationSample start = here_;
    result.closed = restore(start, held) && closed(start, Real(0));
    if (result.closed) here_ = start;
    result.rank_at_start = basis(here_, order_.size()).rank();
    ConfigurationSample away = here_;
    if (result.closed)
      away = displaced(held);
    else
      away.scatter();
    if (result.closed) result.least_share = choose_along_the_motion(away);
    const OrthonormalRows generic = basis(away, order_.size());
    result.kept = generic.independent();
    std::sort(result.kept.begin(), result.kept.end());
    result.determinate.assign(rows_.size(), true);
    const auto all = model_.coordinates().size();
    result.determinate_released.assign(all - n_, true);
    const std::vector<std::size_t> accepted = generic.independent();
    for (const auto& [index, c] : generic.combinations()) {
      result.dropped.push_back(index);
      result.determinate[index] = false;
      for (std::size_t k = 0; k < c.size(); ++k) {
        if (abs(c[k]) * length(row(away, accepted[k])) > length(row(away, index)) * tolerance())
          result.determinate[accepted[k]] = false;
      }
      const Repetition repeated{.index = index, .accepted = accepted, .c = c};
      if (result.closed) refuse_contradiction(away, repeated);
      for (std::size_t r = n_; r < all; ++r) {
        const bool shared = sharing_changes(
            away, [&](std::size_t j) { return rows_[j].column[r]; }, repeated);
        if (shared) result.determinate_released[r - n_] = false;
      }
      refuse_joint_friction(away, repeated);
    }
    std::sort(result.dropped.begin(), result.dropped.end());
    refuse_friction(result);
    if (result.closed && result.redundant()) refuse_other_values(away, result);
    ConfigurationSample& chosen = result.closed && !result.singular_start() ? here_ : away;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      Row scaled = row(chosen, j);
      const Real size = length(scaled);
      if (!size.is_zero()) {
        for (Real& entry : scaled) entry /= size;
      }
      result.scaled_rows.push_back(std::move(scaled));
    }
    return result;
  }

 private:
  /// A row in the metric: entries over √M_ii.
  Row row(ConfigurationSample& at, std::size_t j) const {
    Row entries;
    for (std::size_t i = 0; i < n_; ++i) entries.push_back(at(rows_[j].jacobian[i]) * metric_[i]);
    return entries;
  }

  /// The first rows of the order (holonomic ones come first).
  OrthonormalRows basis(ConfigurationSample& at, std::size_t count) const {
    Real largest = *std::max_element(metric_.begin(), metric_.end());
    std::vector<Row> rows;
    for (std::size_t k = 0; k < count; ++k) {
      rows.push_back(row(at, order_[k]));
      largest = std::max(largest, length(rows.back()));
    }
    OrthonormalRows result(n_, largest * zero_tests::constraint_rows.bound(), tolerance());  // a row of rounding errors is null
    for (std::size_t k = 0; k < count; ++k) result.add(order_[k], rows[k]);
    return result;
  }

  void move(ConfigurationSample& at, const Row& in_metric, const Real& factor) const {
    Row delta;
    for (std::size_t i = 0; i < n_; ++i) delta.push_back(factor * metric_[i] * in_metric[i]);
    at.displace(delta);
  }

  /// Newton's method onto f = 0 for those rows, by displacements of least length; false when it does not converge.
  bool restore(ConfigurationSample& at, const std::vector<std::size_t>& held) const {
    if (held.empty()) return true;
    for (int iteration = 0; iteration < 15; ++iteration) {
      OrthonormalRows rows(n_, Real(0), tolerance());
      std::vector<Real> wanted;
      for (const std::size_t j : held) {
        const Row entries = row(at, j);
        const Real f = at(rows_[j].value);
        if (length(entries).is_nan() || f.is_nan() || !rows.add(j, entries)) return false;
        wanted.push_back(-f);
      }
      const Row delta = rows.least(wanted);
      move(at, delta, Real(1));
      Real longest(0);
      for (std::size_t i = 0; i < n_; ++i) longest = std::max(longest, abs(delta[i] * metric_[i]) / sizes_.reach[i]);
      if (longest > Real(1000)) return false;
      if (longest < decimal("1e-25")) return true;  // quadratic: the error left is its square
    }
    return false;
  }

  /// Whether every holonomic row holds, up to a small part of its usual size or of the displacement (in the metric).
  bool closed(ConfigurationSample& at, const Real& displacement) const {
    for (std::size_t k = 0; k < holonomic_count_; ++k) {
      const std::size_t j = order_[k];
      const Real size = length(row(at, j));
      const Real f = abs(at(rows_[j].value));
      const Real allowed = std::max(tolerance() * sizes_.size[j], size * displacement * decimal("1e-7"));
      if (f > allowed) return false;
    }
    return true;
  }

  /// A neighbour of the initial configuration that no accident distinguishes, and a later time.
  ConfigurationSample displaced(const std::vector<std::size_t>& held) const {
    ConfigurationSample start = here_;
    const OrthonormalRows normal = basis(start, holonomic_count_);
    unsigned long long random = 20061;
    const Row direction = random_direction(normal, random);
    const Real reach = twentieth(start, direction);
    // The rows that count at the start first.
    if (const auto away = beside(direction, reach, [&](ConfigurationSample&) { return held; })) return *away;
    // Where the start is singular: all rows together, from several sides. Where many loops branch at once, no set of rows
    // counts along all branches.
    Real size = reach, time = decimal("1/32");
    for (int attempt = 0; attempt < 12; ++attempt) {
      if (attempt % 4 == 3) size /= Real(8), time /= Real(8);
      const Row other = random_direction(normal, random);
      ConfigurationSample away = here_;
      away.set_time(time);
      move(away, other, size);
      const Real displacement = size * length(other);
      if (!settle(away, displacement) || !closed(away, displacement)) continue;
      if (basis(away, holonomic_count_).rank() > normal.rank()) return away;
    }
    const auto counting = [&](ConfigurationSample& at) { return basis(at, holonomic_count_).independent(); };
    if (const auto away = beside(direction, reach, counting)) return *away;
    refuse_rigid(start);
    return start;
  }

  /// How far along that direction something has turned by a twentieth of a radian, or moved by as much of the extent of the
  /// mechanism when nothing turns.
  Real twentieth(const ConfigurationSample& start, const Row& direction) const {
    Real turned(0), moved(0);
    for (std::size_t i = 0; i < n_; ++i) {
      const bool angle = model_.coordinates()[i].q->unit.is_dimensionless();
      Real& largest = angle ? turned : moved;
      largest = std::max(largest, abs(direction[i] * metric_[i]));
    }
    Real extent = start.extent(units::metre);
    if (extent.is_zero()) extent = Real(1);
    if (turned > decimal("1e-20")) return decimal("1/20") / turned;
    return moved > decimal("1e-20") ? extent * decimal("1/20") / moved : Real(0);
  }

  /// Which rows repeat the others may change along the motion: those kept are then rows that count all along. They come first
  /// in the order. Their least share (RowChoice).
  double choose_along_the_motion(const ConfigurationSample& from) {
    ConfigurationSample start = from;
    const OrthonormalRows normal = basis(start, holonomic_count_);
    const std::vector<std::size_t> kept = normal.independent();
    if (kept.size() == holonomic_count_) return 1.0;
    std::vector<RowsHere> places{rows_in_doubles(start)};
    // As many steps as are soon made; some 120, a full turn, for a loop of six rows.
    const double work = static_cast<double>(holonomic_count_ * holonomic_count_ * n_);
    const int steps = std::clamp(static_cast<int>(4e6 / work), 8, 126);
    const auto follow = [&](const auto& next) {
      ConfigurationSample at = from;
      for (int step = 0; step < steps && next(at, step); ++step) {
        RowsHere rows = rows_in_doubles(at);
        if (step == 0 && repeat_alike(places.front(), rows, by_order(kept))) return;
        places.push_back(std::move(rows));
      }
    };
    unsigned long long random = 1848;
    const Real reach = twentieth(start, random_direction(OrthonormalRows(n_, Real(0), tolerance()), random));
    follow([&](ConfigurationSample& at, int step) {  // as laws of time move it
      at.set_time(Real(step + 1) / Real(16));
      return settle(at, reach) && closed(at, reach);
    });
    Row direction = random_direction(normal, random);
    for (int walk = 0; walk < (kept.size() + 1 == n_ ? 2 : 4); ++walk) {
      if (walk == 2) direction = random_direction(normal, random);
      Row onward = direction;
      for (Real& entry : onward) entry *= Real(walk % 2 == 0 ? 1 : -1);
      follow([&](ConfigurationSample& at, int) { return advance(at, onward); });
    }
    const RowChoice choice = choose_rows(places, by_order(kept));
    std::vector<std::size_t> chosen;
    for (const std::size_t k : choice.kept) chosen.push_back(order_[k]);
    std::stable_partition(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(holonomic_count_), [&](std::size_t j) {
      return std::find(chosen.begin(), chosen.end(), j) != chosen.end();
    });
    return choice.least_share;
  }

  /// The places of holonomic rows in the order.
  std::vector<std::size_t> by_order(const std::vector<std::size_t>& rows) const {
    std::vector<std::size_t> places;
    for (const std::size_t j : rows)
      places.push_back(static_cast<std::size_t>(std::find(order_.begin(), order_.end(), j) - order_.begin()));
    return places;
  }

  RowsHere rows_in_doubles(ConfigurationSample& at) const {
    RowsHere rows;
    for (std::size_t k = 0; k < holonomic_count_; ++k) {
      rows.emplace_back();
      for (const Real& entry : row(at, order_[k])) rows.back().push_back(entry.to_double());
    }
    return rows;
  }

  /// A small step to a closed configuration, as straight on from that direction as the constraints let; false: there is none.
  bool advance(ConfigurationSample& at, Row& direction) const {
    const OrthonormalRows normal = basis(at, holonomic_count_);
    for (const Row& n : normal.directions()) {
      const Real part = product(direction, n);
      for (std::size_t i = 0; i < n_; ++i) direction[i] -= part * n[i];
    }
    const Real size = length(direction);
    if (!(size > decimal("1e-20"))) return false;
    for (Real& entry : direction) entry /= size;
    const Real reach = twentieth(at, direction);
    move(at, direction, reach);
    return settle(at, reach) && closed(at, reach);
  }

  /// The first of smaller and smaller steps along a direction, and later times, from where those rows can be satisfied;
  /// nothing when others are not satisfied there.
  template <class Rows>
  std::optional<ConfigurationSample> beside(const Row& direction, Real factor, const Rows& rows_at) const {
    Real time = decimal("1/32");
    for (int attempt = 0; attempt < 12; ++attempt, factor /= Real(2), time /= Real(2)) {
      ConfigurationSample away = here_;
      away.set_time(time);
      move(away, direction, factor);
      if (!restore(away, rows_at(away))) continue;
      if (closed(away, factor * length(direction))) return away;
      break;  // these rows can be satisfied and others not: a smaller step would only hide it
    }
    return std::nullopt;
  }

  /// A pseudo-random direction in the metric along which none of those rows changes.
  Row random_direction(const OrthonormalRows& normal, unsigned long long& random) const {
    Row direction;
    for (std::size_t i = 0; i < n_; ++i) {
      random = (random * 1103515245ULL + 12345ULL) % 2147483648ULL;
      direction.push_back(Real(Number::rational(static_cast<int>(random % 2001ULL) - 1000, 1000), zero_tests::constraint_rows.digits));
    }
    for (const Row& n : normal.directions()) {
      const Real part = product(direction, n);
      for (std::size_t i = 0; i < n_; ++i) direction[i] -= part * n[i];
    }
    return direction;
  }

  /// Onto f = 0 for all holonomic rows at once, those that repeat others included: δ = −Jᵀ (J Jᵀ + μ 1)⁻¹ f with
  /// μ = |f|² over the square of the displacement, rows scaled to length 1 where it starts. Quadratic wherever the rank of
  /// J is constant, be it less than its rows (Yamashita & Fukushima, On the rate of convergence of the
  /// Levenberg-Marquardt method, 2001).
  bool settle(ConfigurationSample& at, const Real& displacement) const {
    std::vector<std::size_t> acting;
    std::vector<Real> scale;
    for (std::size_t k = 0; k < holonomic_count_; ++k) {
      const Real size = length(row(at, order_[k]));
      if (!(size > displacement * decimal("1e-20"))) continue;  // closed() looks whether it holds by itself
      acting.push_back(order_[k]);
      scale.push_back(Real(1) / size);
    }
    const std::size_t m = acting.size();
    for (int iteration = 0; iteration < 40 && m > 0; ++iteration) {
      RealRows jacobian;
      Row f;
      for (std::size_t k = 0; k < m; ++k) {
        jacobian.push_back(row(at, acting[k]));
        for (Real& entry : jacobian.back()) entry *= scale[k];
        f.push_back(at(rows_[acting[k]].value) * scale[k]);
      }
      const Real off = length(f) / displacement;
      if (off.is_nan() || off > Real(1000)) return false;
      if (off < decimal("1e-20")) return true;  // its square is left of what the last step leaves
      RealRows normal_equations(m, Row(m));
      for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t l = 0; l <= k; ++l) normal_equations[k][l] = product(jacobian[k], jacobian[l]);
        normal_equations[k][k] += off * off;
      }
      const Row multipliers = Cholesky<Real>(std::move(normal_equations)).solve(std::move(f));
      Row delta(n_, Real(0));
      for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t i = 0; i < n_; ++i) delta[i] -= jacobian[k][i] * multipliers[k];
      }
      move(at, delta, Real(1));
    }
    return false;
  }

  /// Beside the initial configuration no other satisfies all holonomic constraints: right if they leave no freedom.
  void refuse_rigid(ConfigurationSample& start) const {
    const OrthonormalRows holonomic = basis(start, holonomic_count_);
    if (holonomic.combinations().empty()) return;
    const std::string& name = rows_[holonomic.combinations().front().first].name;
    throw SceneError(fmt::format(
        "constraint '{}' depends on those before it at the initial configuration, and no neighbouring "
        "configuration satisfies them all: it contradicts them, or the closed loop cannot move; drop it, or "
        "correct the dimensions",
        name));
  }

  /// A constraint that repeats others: its row is the sum of theirs, times c.
  struct Repetition {
    std::size_t index;
    const std::vector<std::size_t>& accepted;  ///< the others
    const std::vector<Real>& c;
  };

  /// Whether what a unit multiplier of each constraint adds makes a sum that another sharing among them changes.
  template <class Load>
  bool sharing_changes(ConfigurationSample& at, const Load& load_of, const Repetition& repeated) const {
    const auto& [index, accepted, c] = repeated;
    Real difference = at(load_of(index));
    Real size = abs(difference);
    for (std::size_t k = 0; k < c.size(); ++k) {
      const Real part = c[k] * at(load_of(accepted[k]));
      difference -= part;
      size += abs(part);
    }
    return abs(difference) > size * tolerance();
  }

  /// Friction in proportion to what a joint transmits moves the mechanism by how constraints share their forces.
  void refuse_joint_friction(ConfigurationSample& at, const Repetition& repeated) const {
    for (const RubbingJoint& joint : rubbing_) {
      for (const std::vector<Value>& loads : joint.loads) {
        if (!sharing_changes(
                at, [&loads](std::size_t j) { return loads[j]; }, repeated))
          continue;
        throw SceneError(fmt::format(
            "the friction '{}' is in proportion to what its joint transmits, which is indeterminate, and the "
            "motion with it: constraint '{}' repeats others; leave out what repeats, or give the bound of a "
            "dry_friction",
            joint.name, rows_[repeated.index].name));
      }
    }
  }

  void refuse_contradiction(ConfigurationSample& at, const Repetition& repeated) const {
    const auto& [index, accepted, c] = repeated;
    // Σ a_i q̇_i = b: the same combination must hold for b, that is for minus the rate at rest.
    Real difference = at(rows_[index].rate);
    Real size = abs(difference);
    for (std::size_t k = 0; k < c.size(); ++k) {
      const Real part = c[k] * at(rows_[accepted[k]].rate);
      difference -= part;
      size += abs(part);
    }
    if (!(abs(difference) > size * decimal("1e-7")) || !(abs(difference) > tolerance() * sizes_.size[index])) return;
    throw SceneError(
        fmt::format("constraint '{}' asks for a velocity that contradicts the constraints it depends on: "
                    "no motion satisfies them all; drop it or correct its law of time",
                    rows_[index].name));
  }

  /// A parameter that may change later must not make a constraint that was left out count.
  void refuse_other_values(const ConfigurationSample& away, const ConstraintRank& rank) const {
    std::vector<SymbolPointer> all;
    for (const ParameterContent& parameter : model_.scene().parameters) {
      const ModelOptions& options = model_.options();
      if (parameter.run_time || options.all_run_time || options.run_time.contains(parameter.symbol->name))
        all.push_back(parameter.symbol);
    }
    if (all.empty()) return;
    const std::optional<std::size_t> row = counting_at_other_values(away, rank, all);
    if (!row) return;
    std::string names;
    const auto add = [&names](const SymbolPointer& p) { names += (names.empty() ? "'" : ", '") + p->name + "'"; };
    for (const SymbolPointer& parameter : all) {
      if (counting_at_other_values(away, rank, {parameter})) add(parameter);
    }
    if (names.empty()) std::for_each(all.begin(), all.end(), add);
    throw SceneError(
        fmt::format("constraint '{}' repeats others only at the values that the run-time parameters {} have in the scene: "
                    "at others it counts, and would not be enforced; make them constant, or leave the constraint out",
                    rows_[*row].name, names));
  }

  /// A row left out that others do not imply once these parameters have changed a little and the rows kept were
  /// satisfied anew.
  std::optional<std::size_t> counting_at_other_values(const ConfigurationSample& away, const ConstraintRank& rank,
                                                      const std::vector<SymbolPointer>& parameters) const {
    std::vector<std::size_t> held;
    for (const std::size_t j : rank.kept) {
      if (rows_[j].holonomic) held.push_back(j);
    }
    Real part = decimal("1/32");
    for (int attempt = 0; attempt < 8; ++attempt, part /= Real(2)) {
      ConfigurationSample other = away;
      other.vary(parameters, part);
      if (!restore(other, held)) continue;
      const std::vector<std::size_t> counting = basis(other, order_.size()).independent();
      for (const std::size_t j : rank.dropped) {
        if (std::find(counting.begin(), counting.end(), j) != counting.end()) return j;
        if (rows_[j].holonomic && abs(other(rows_[j].value)) > tolerance() * sizes_.size[j]) return j;
      }
      return std::nullopt;
    }
    return std::nullopt;
  }

  void refuse_friction(const ConstraintRank& rank) const {
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      if (!rows_[j].friction || rank.determinate[j]) continue;
      throw SceneError(
          fmt::format("constraint '{}' carries friction but repeats other constraints: its normal force is "
                      "indeterminate, and the motion with it; release one of the constraints",
                      rows_[j].name));
    }
  }

  Program program_;
  Model model_;
  std::vector<ConstraintRow> rows_;
  ConstraintSizes sizes_;
  ConfigurationSample here_;
  std::size_t n_ = 0, holonomic_count_ = 0;
  std::vector<Real> metric_;
  std::vector<std::size_t> order_;  ///< holonomic rows, then the others
  struct RubbingJoint {
    std::string name;                      ///< of the friction
    std::vector<std::vector<Value>> loads;  ///< by direction across its axis, by constraint
  };
  std::vector<RubbingJoint> rubbing_;
};

}  // namespace

ConstraintRank constraint_rank(const Scene& scene, const ModelOptions& options) {
  const WorkingDigits precision(zero_tests::constraint_rows.digits);
  return RankFinder(scene, options).find();
}

}  // namespace torsor
