// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/shared_products.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "generator/expression/arrival.hpp"
#include "generator/expression/formula.hpp"

namespace torsor {
namespace {

/// Two factors: an atom, and another (perhaps the same) or a number other than one.
struct FactorPair {
  Atom first = -1, second = -1;  ///< in this order; second < 0: the number
  Number number{1};
  friend auto operator<=>(const FactorPair& a, const FactorPair& b) {
    return std::tie(a.first, a.second, a.number) <=> std::tie(b.first, b.second, b.number);
  }
};

/// A sum that is computed at every state, and what it costs.
struct StateSum {
  Polynomial sum;
  int operations = 0;
  int instructions = 0;  ///< where a product and the sum it is added to are one
  int arrival = 0;       ///< the cycle in which it is known
  std::vector<FactorPair> pairs{};  ///< that its formula multiplies, once for each time
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

void add_pairs(const Formula& formula, std::vector<FactorPair>& pairs) {
  for (const Formula& child : formula.children) add_pairs(child, pairs);
  if (formula.kind != Formula::Kind::product) return;
  std::map<Atom, int> powers;
  const Number* number = nullptr;
  for (const Formula& child : formula.children) {
    if (child.kind == Formula::Kind::atom) ++powers[child.atom];
    if (child.kind == Formula::Kind::constant) number = &child.number;
  }
  for (auto one = powers.begin(); one != powers.end(); ++one) {
    const auto& [atom, power] = *one;
    if (number != nullptr) pairs.push_back({atom, -1, *number});
    for (int squares = power / 2; squares > 0; --squares) pairs.push_back({atom, atom, Number(1)});
    for (auto other = std::next(one); other != powers.end(); ++other) pairs.push_back({atom, other->first, Number(1)});
  }
}

int exponent_of(const Monomial& monomial, Atom atom) {
  const auto place =
      std::find_if(monomial.begin(), monomial.end(), [atom](const Factor& factor) { return factor.atom == atom; });
  return place == monomial.end() ? 0 : place->exponent;
}

/// The sum with `product` for the pair, wherever a term has both.
Polynomial replaced(const Polynomial& sum, const FactorPair& pair, Atom product) {
  Polynomial result;
  for (const Term& term : sum.terms()) {
    Monomial monomial = term.monomial;
    Number coefficient = term.coefficient;
    const int power = exponent_of(monomial, pair.first);
    int times = power;
    if (pair.second == pair.first) times = power / 2;
    if (pair.second >= 0 && pair.second != pair.first) times = std::min(power, exponent_of(monomial, pair.second));
    if (pair.second < 0) times = power > 0 && coefficient.abs() == pair.number ? 1 : 0;
    if (times > 0) {
      monomial = monomial * Monomial{{pair.first, -times}} * Monomial{{product, times}};
      if (pair.second >= 0)
        monomial = monomial * Monomial{{pair.second, -times}};
      else
        coefficient = Number(coefficient.sign());
    }
    result.add({std::move(monomial), std::move(coefficient)});
  }
  return result;
}

class ProductSharing {
 public:
  ProductSharing(Program& program, const std::vector<Value>& values)
      : program_(&program), values_(values), live_(program.live(values)) {
    for (const Atom atom : live_) {
      const Definition& definition = program[atom];
      if (!definition.symbol && !definition.function && definition.stage > Stage::parameters)
        places_.emplace(atom, add(definition.polynomial));
    }
    std::unordered_map<std::size_t, std::vector<std::size_t>> known;  // by hash: what is equal is computed once
    for (const Value& value : values_) {
      results_.emplace_back();
      if (program.stage(value) <= Stage::parameters) continue;
      Polynomial sum = value.polynomial();
      const bool negative = sum.sign() < 0;
      if (negative) sum *= Number(-1);
      std::vector<std::size_t>& bucket = known[sum.hash()];
      auto same = std::find_if(bucket.begin(), bucket.end(), [&](std::size_t k) { return sums_[k].sum == sum; });
      if (same == bucket.end()) same = bucket.insert(same, add(std::move(sum)));
      results_.back() = Result{*same, negative};
    }
  }

  std::vector<Value> run() {
    bool shared = false;
    while (share()) shared = true;
    if (!shared) return values_;
    for (const Atom atom : live_) define(atom);  // operands before users, so that no recursion is deep
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

  StateSum counted(Polynomial sum) const {
    const Formula tree = formula(*program_, sum);
    const int operations = count(tree).total();
    StateSum counted{std::move(sum), operations, operations - fusions(tree), arrival(*program_, tree)};
    add_pairs(tree, counted.pairs);
    return counted;
  }
  std::size_t add(Polynomial sum) {
    sums_.push_back(counted(std::move(sum)));
    return sums_.size() - 1;
  }

  Value product_of(const FactorPair& pair) const {
    const Value first = program_->atom_value(pair.first);
    return pair.second < 0 ? pair.number * first : first * program_->atom_value(pair.second);
  }
  bool is_early(const FactorPair& pair) const {
    return (*program_)[pair.first].stage <= Stage::parameters &&
           (pair.second < 0 || (*program_)[pair.second].stage <= Stage::parameters);
  }

  /// One round through all pairs that there are now; whether any was taken out.
  bool share() {
    std::map<FactorPair, std::vector<std::size_t>> uses;  // the sums that multiply it, once for each time
    for (std::size_t place = 0; place < sums_.size(); ++place) {
      for (const FactorPair& pair : sums_[place].pairs) uses[pair].push_back(place);
    }
    std::vector<const decltype(uses)::value_type*> most_frequent;
    for (const auto& each : uses) {
      if (each.second.size() > 1 || is_early(each.first)) most_frequent.push_back(&each);
    }
    std::stable_sort(most_frequent.begin(), most_frequent.end(),
                     [](const auto* a, const auto* b) { return a->second.size() > b->second.size(); });
    bool shared = false;
    for (const auto* each : most_frequent) shared = share(each->first, each->second) || shared;
    return shared;
  }

  bool share(const FactorPair& pair, const std::vector<std::size_t>& uses) {
    const Atom product = *program_->bind(product_of(pair)).atom();
    const auto known = places_.find(product);
    const int own = is_early(pair) || known != places_.end() ? 0 : 1;
    int operations = -own, instructions = -own;  // saved
    std::vector<std::pair<std::size_t, StateSum>> cheaper;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const std::size_t place = uses[i];
      if ((i > 0 && uses[i - 1] == place) || (known != places_.end() && known->second == place)) continue;
      const StateSum& before = sums_[place];
      StateSum after = counted(replaced(before.sum, pair, product));
      if (after.operations >= before.operations || after.arrival > before.arrival) continue;
      operations += before.operations - after.operations;
      instructions += before.instructions - after.instructions;
      cheaper.emplace_back(place, std::move(after));
    }
    if (operations <= 0 || instructions < 0) return false;
    for (auto& [place, sum] : cheaper) sums_[place] = std::move(sum);
    if (known == places_.end() && !is_early(pair)) places_.emplace(product, add((*program_)[product].polynomial));
    return true;
  }

  /// What stands for an atom now: itself, plus or minus another, or a number.
  const Value& define(Atom atom) {
    if (const auto known = defined_.find(atom); known != defined_.end()) return known->second;
    const Definition definition = (*program_)[atom];  // a copy: more are appended
    Value value = program_->atom_value(atom);
    if (definition.function && definition.stage > Stage::parameters) {
      // Numbers with units may have made the argument a pure number: its atom's own unit does not tell.
      const Unit unit = *definition.function == Function::sqrt ? definition.unit.pow(2) : Unit();
      value = program_->apply(*definition.function, {*program_, define(definition.argument).polynomial(), unit});
    } else if (const auto place = places_.find(atom); place != places_.end()) {
      const Value sum = rewritten(sums_[place->second].sum, definition.unit);
      value = program_->bind_again(sum, definition.name);  // in the order that there was
    }
    return defined_.emplace(atom, std::move(value)).first->second;
  }
  Value rewritten(const Polynomial& sum, const Unit& unit) {
    Polynomial result;
    for (const Term& term : sum.terms()) {
      Term product{{}, term.coefficient};
      for (const Factor& factor : term.monomial) {
        const Polynomial& now = define(factor.atom).polynomial();
        // What turned out to be equal may have cancelled: nothing is left, or a number.
        const Term only = now.is_zero() ? Term{{}, Number()} : now.terms()[0];
        product.monomial = product.monomial * pow(only.monomial, factor.exponent);
        product.coefficient = product.coefficient * only.coefficient.pow(factor.exponent);
      }
      result.add(std::move(product));
    }
    return {*program_, std::move(result), unit};
  }

  Program* program_;
  std::vector<Value> values_;
  std::vector<Atom> live_;
  std::vector<StateSum> sums_;
  std::unordered_map<Atom, std::size_t> places_;  ///< of definitions among the sums
  std::vector<std::optional<Result>> results_;    ///< of values: nothing for those known before
  std::unordered_map<Atom, Value> defined_;       ///< what stands for old atoms
};

}  // namespace

std::vector<Value> with_shared_products(Program& program, const std::vector<Value>& values) {
  if (!program.passes().sharing || !program.passes().products) return values;
  return ProductSharing(program, values).run();
}

}  // namespace torsor
