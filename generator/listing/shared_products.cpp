// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/shared_products.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/listing/earliest_start.hpp"
#include "torsor/generator/listing/factor_pair.hpp"
#include "torsor/generator/program/division_by_zero.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/program/sum_table.hpp"

namespace torsor {
namespace {

/// Sums of more terms are left as they are: each pair that is tried costs the square of their number.
constexpr std::size_t most_terms = 200;

/// A sum that is computed at every state, and what it costs.
struct StateSum {
  Polynomial sum;
  int operations = 0;
  int instructions = 0;             ///< where a product and the sum it is added to are one
  int start = 0;                    ///< the cycle in which it is known, if its operands are when they were before the pass
  std::vector<FactorPair> pairs{};  ///< that its formula multiplies, once for each time
  bool changed = true;              ///< since all pairs were tried
};

/// Products that are added at once.
int fusions(const Formula& formula) {
  int result = 0;
  for (const Formula& child : formula.children) result += fusions(child);
  if (formula.kind != Formula::Kind::sum) return result;
  const auto products = std::count_if(formula.children.begin(), formula.children.end(), [](const Formula& child) {
    return child.kind == Formula::Kind::product;
  });
  return result + static_cast<int>(std::min<std::ptrdiff_t>(products, std::ssize(formula.children) - 1));
}

class ProductSharing {
 public:
  ProductSharing(Program& program, const std::vector<Value>& values)
      : program_(&program), starts_(program), values_(values), live_(program.live(values)) {
    for (const ValueNumber value_number : live_) {
      const Definition& definition = program[value_number];
      if (definition.symbol || definition.function || definition.stage <= Stage::parameters) continue;
      if (const auto pair = as_pair(definition.polynomial)) products_.emplace(*pair, value_number);
      places_.emplace(value_number, add(definition.polynomial));
    }
    SumTable different;  // what is equal up to sign is computed once
    const std::size_t first = sums_.size();
    for (const Value& value : values_) {
      results_.emplace_back();
      if (program.stage(value) <= Stage::parameters) continue;
      const auto [sum, negative] = without_sign(value.polynomial());
      const auto [number, added] = different.add(sum);
      if (added) add(sum);
      results_.back() = Result{first + number, negative};
    }
  }

  std::vector<Value> run() {
    bool shared = false;
    while (share()) shared = true;
    if (!shared) return values_;
    for (const ValueNumber value_number : live_)
      define(value_number);  // operands before users, so that no recursion is deep
    std::vector<Value> values;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const std::optional<Result>& result = results_[i];
      if (!result) {
        values.push_back(values_[i]);
        continue;
      }
      Value value = rewritten(sums_[result->place].sum, values_[i].unit());
      values.push_back(result->negative ? -std::move(value) : std::move(value));
    }
    return values;
  }

 private:
  struct Result {
    std::size_t place = 0;
    bool negative = false;
  };
  using Uses = std::vector<std::size_t>;  ///< the sums that multiply a pair, once for each time

  /// Its pairs are not yet told.
  StateSum counted(Polynomial sum, const Formula& tree) const {
    const int operations = count(tree).total();
    return {std::move(sum), operations, operations - fusions(tree), starts_(tree)};
  }
  std::size_t add(Polynomial sum) {
    const Formula tree = starts_.scheduled(sum);
    StateSum all = counted(std::move(sum), tree);
    if (all.sum.terms().size() <= most_terms) add_pairs(tree, all.pairs);
    sums_.push_back(std::move(all));
    return sums_.size() - 1;
  }

  bool is_early(const FactorPair& pair) const {
    return (*program_)[pair.first].stage <= Stage::parameters &&
           (pair.other() == nullptr || (*program_)[*pair.other()].stage <= Stage::parameters);
  }
  ValueNumber product_of(const FactorPair& pair) {
    if (const auto known = products_.find(pair); known != products_.end()) return known->second;
    const Value product(*program_, pair.product(), Unit());  // read by sums only, that have their own
    // What is computed before any state all kernels share; only such a product is found by others.
    const ValueNumber value_number =
        *(is_early(pair) ? program_->bind(product) : program_->bind_apart(product)).value_number();
    products_.emplace(pair, value_number);
    return value_number;
  }

  /// One round through all pairs of sums that changed since the last one; whether any was taken out.
  bool share() {
    std::map<FactorPair, Uses> uses;
    for (std::size_t place = 0; place < sums_.size(); ++place) {
      for (const FactorPair& pair : sums_[place].pairs) uses[pair].push_back(place);
    }
    std::vector<const std::pair<const FactorPair, Uses>*> most_frequent;
    for (const auto& each : uses) {
      const bool changed = std::any_of(each.second.begin(), each.second.end(),
                                       [this](std::size_t place) { return sums_[place].changed; });
      if (changed && (each.second.size() > 1 || is_early(each.first))) most_frequent.push_back(&each);
    }
    std::stable_sort(most_frequent.begin(), most_frequent.end(),
                     [](const auto* a, const auto* b) { return a->second.size() > b->second.size(); });
    for (StateSum& sum : sums_) sum.changed = false;
    bool shared = false;
    for (const auto* each : most_frequent) shared = share(each->first, each->second) || shared;
    return shared;
  }

  bool share(const FactorPair& pair, const Uses& uses) {
    const ValueNumber product = product_of(pair);
    const auto own = places_.find(product);
    const int cost = is_early(pair) || own != places_.end() ? 0 : 1;
    int operations = -cost, instructions = -cost;  // saved
    std::vector<std::pair<std::size_t, StateSum>> cheaper;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const std::size_t place = uses[i];
      if ((i > 0 && uses[i - 1] == place) || (own != places_.end() && own->second == place)) continue;
      const StateSum& before = sums_[place];
      Polynomial sum = pair.replaced(before.sum, product);
      const Formula tree = starts_.scheduled(sum);
      StateSum after = counted(std::move(sum), tree);
      if (after.operations >= before.operations || after.instructions > before.instructions) continue;
      if (after.start > before.start) continue;
      if (!same_factoring(starts_.scheduled(before.sum), tree, pair, product)) continue;
      add_pairs(tree, after.pairs);
      operations += before.operations - after.operations;
      instructions += before.instructions - after.instructions;
      cheaper.emplace_back(place, std::move(after));
    }
    if (operations <= 0 || instructions < 0) return false;
    for (auto& [place, sum] : cheaper) sums_[place] = std::move(sum);
    if (cost > 0) places_.emplace(product, add((*program_)[product].polynomial));
    return true;
  }

  /// What stands for a value number now: itself, plus or minus another, or a number.
  const Value& define(ValueNumber value_number) {
    if (const auto known = defined_.find(value_number); known != defined_.end()) return known->second;
    Value value = program_->value_of_number(value_number);
    const auto function = (*program_)[value_number].function;
    if (function && (*program_)[value_number].stage > Stage::parameters) {
      // Numbers with units may have made the argument a pure number: its value number's own unit does not tell.
      const Definition call = (*program_)[value_number];
      const std::vector<Unit> units = argument_units(*function, call.unit);
      std::vector<Value> arguments;
      for (std::size_t i = 0; i < units.size(); ++i) {
        arguments.emplace_back(*program_, define(call.arguments[i]).polynomial(), units[i]);
      }
      value = program_->apply(*function, arguments);
    } else if (const auto place = places_.find(value_number); place != places_.end()) {
      const Unit unit = (*program_)[value_number].unit;
      const std::string name = (*program_)[value_number].name;
      value = bound(rewritten(sums_[place->second].sum, unit), name);
    }
    return defined_.emplace(value_number, std::move(value)).first->second;
  }
  /// Definitions stand in the order that they had; those that became equal are one.
  Value bound(const Value& value, const std::string& name) {
    const auto [sum, negative] = without_sign(value.polynomial());
    const auto [number, added] = different_.add(sum);
    if (added) bound_.push_back(program_->bind_apart({*program_, sum, value.unit()}, name));
    return negative ? -bound_[number] : bound_[number];
  }
  Value rewritten(const Polynomial& sum, const Unit& unit) {
    Polynomial result;
    for (const Term& term : sum.terms()) {
      Term product{{}, term.coefficient};
      for (const Factor& factor : term.monomial) {
        const Polynomial& now = define(factor.value_number).polynomial();
        // What turned out to be equal may have cancelled: nothing is left, or a number.
        if (now.is_zero() && factor.exponent < 0) throw DivisionByZero();
        const Term only = now.is_zero() ? Term{{}, Number()} : now.terms()[0];
        product.monomial = product.monomial * pow(only.monomial, factor.exponent);
        product.coefficient = product.coefficient * only.coefficient.pow(factor.exponent);
      }
      result.add(std::move(product));
    }
    return {*program_, std::move(result), unit};
  }

  Program* program_;
  EarliestStarts starts_;
  std::vector<Value> values_;
  std::vector<ValueNumber> live_;
  std::vector<StateSum> sums_;
  std::unordered_map<ValueNumber, std::size_t> places_;  ///< of definitions among the sums
  std::map<FactorPair, ValueNumber> products_;           ///< definitions that are one, live or tried
  std::vector<std::optional<Result>> results_;    ///< of values: nothing for those known before
  std::unordered_map<ValueNumber, Value> defined_;       ///< what stands for old value numbers
  SumTable different_;        ///< of new definitions, with
  std::vector<Value> bound_;  ///< what each is bound to
};

}  // namespace

std::vector<Value> with_shared_products(Program& program, const std::vector<Value>& values) {
  return ProductSharing(program, values).run();
}

}  // namespace torsor
