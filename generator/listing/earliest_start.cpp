// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/earliest_start.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace torsor {
namespace {

/// Cycles that one instruction more is worth.
constexpr int instruction = 8;

int latency_of(Function function) {
  switch (function) {
    case Function::sin:
    case Function::cos: return Latency::sine_cosine;
    case Function::sqrt: return Latency::square_root;
    case Function::abs:
    case Function::sign:
    case Function::maximum:
    case Function::select: return Latency::addition;
    default: return Latency::other;
  }
}

/// When the last multiplication of a product can begin, which a sum fuses with its own addition.
int last_factor(const EarliestStarts& starts, const Formula& product) {
  int time = starts(product.children[0]);
  for (std::size_t i = 1; i < product.children.size(); ++i) {
    const int factor = starts(product.children[i]);
    if (i > 1) time += Latency::multiplication;
    time = std::max(time, factor);
  }
  return time;
}

/// One term of a sum.
struct Part {
  std::size_t place = 0;  ///< among the sum's children
  bool product = false;
  bool negative = false;
  int whole = 0;     ///< when it is known
  int operands = 0;  ///< when what its addition needs is: of a product its factors
};

Part part_of(const EarliestStarts& starts, const Formula& sum, std::size_t place) {
  const Formula& child = sum.children[place];
  Part part{place, child.kind == Formula::Kind::product, sum.negative[place], 0, 0};
  part.operands = part.product ? last_factor(starts, child) : starts(child);
  part.whole = part.operands + (part.product ? Latency::multiplication : 0);
  return part;
}

/// Whether the first of two terms is a product that is fused with the second.
bool fuses_first(const std::vector<Part>& parts) { return parts.size() > 1 && parts[0].product && !parts[1].product; }

int start_of(const std::vector<Part>& parts) {
  const bool first_fused = fuses_first(parts);
  int time = first_fused ? parts[0].operands : parts[0].whole;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const bool fused = parts[i].product || (i == 1 && first_fused);
    time = std::max(time, parts[i].operands) + (fused ? Latency::fused : Latency::addition);
  }
  return time;
}

/// When the sum is known, and what more instructions than one for each addition are worth.
int cost(const std::vector<Part>& parts) {
  const bool single_product = parts[0].product && !fuses_first(parts);
  return start_of(parts) + (single_product ? instruction : 0);
}

/// The order of a sum's parts, which begins with one that is not subtracted: as they stand where no other is better.
std::vector<Part> ordered(const std::vector<Part>& parts) {
  if (parts.size() < 2) return parts;
  const auto with_first = [](std::vector<Part> order, const auto& fits) {
    const auto first = std::find_if(order.begin(), order.end(), fits);
    if (first != order.end()) std::rotate(order.begin(), first, first + 1);
    return order;
  };
  const auto positive = [](const Part& part) { return !part.negative; };
  std::vector<Part> best = with_first(parts, positive);
  const auto offer = [&best](std::vector<Part> order) {
    if (!order[0].negative && cost(order) < cost(best)) best = std::move(order);
  };
  std::vector<Part> by_start = parts;
  std::stable_sort(by_start.begin(), by_start.end(),
                   [](const Part& a, const Part& b) { return a.operands < b.operands; });
  by_start = with_first(by_start, positive);
  // A term that is no product first, or second where it is subtracted
  std::vector<Part> single_first = with_first(by_start, [](const Part& part) { return !part.product; });
  if (single_first[0].negative) std::swap(single_first[0], single_first[1]);
  offer(std::move(by_start));
  offer(std::move(single_first));
  return best;
}

std::vector<Part> parts_of(const EarliestStarts& starts, const Formula& sum) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < sum.children.size(); ++i) parts.push_back(part_of(starts, sum, i));
  return parts;
}

}  // namespace

int EarliestStarts::operator()(const Formula& formula) const {
  switch (formula.kind) {
    case Formula::Kind::value_number: return (*this)(*formula.value_number);
    case Formula::Kind::constant: return 0;
    case Formula::Kind::function: {
      int last = 0;
      for (const Formula& child : formula.children) last = std::max(last, (*this)(*child.value_number));
      return last + latency_of(formula.function);
    }
    case Formula::Kind::product: return last_factor(*this, formula) + Latency::multiplication;
    case Formula::Kind::quotient: {
      const int numerator = (*this)(formula.children[0]);
      return std::max(numerator, (*this)(formula.children[1])) + Latency::division;
    }
    case Formula::Kind::sum: return start_of(parts_of(*this, formula));
  }
  return 0;
}

int EarliestStarts::operator()(ValueNumber value_number) const {
  // Operands come before users: nothing is asked for that is not known.
  while (known_.size() <= static_cast<std::size_t>(value_number)) {
    known_.push_back(of((*program_)[static_cast<ValueNumber>(known_.size())]));
  }
  return known_[static_cast<std::size_t>(value_number)];
}

int EarliestStarts::of(const Definition& definition) const {
  if (definition.symbol || definition.stage == Stage::generation || definition.stage == Stage::parameters) return 0;
  if (definition.function) return (*this)(formula(*program_, definition));
  Formula sum = expanded(definition.polynomial);
  return (*this)(program_->passes().scheduling ? in_order(std::move(sum)) : sum);
}

void EarliestStarts::for_each_delay(const Formula& formula, const std::function<void(ValueNumber, int)>& call) const {
  const auto within = [&](const Formula& child, int after) {
    for_each_delay(child, [&](ValueNumber value_number, int cycles) { call(value_number, cycles + after); });
  };
  // From the factors to the beginning of the last multiplication, and `after` from there on
  const auto factors = [&](const Formula& product, int after) {
    const int count = static_cast<int>(product.children.size());
    for (int i = 0; i < count; ++i) {
      const int multiplications = count - 1 - std::max(i, 1);
      within(product.children[static_cast<std::size_t>(i)], after + Latency::multiplication * multiplications);
    }
  };
  switch (formula.kind) {
    case Formula::Kind::constant: return;
    case Formula::Kind::value_number: return call(*formula.value_number, 0);
    case Formula::Kind::function:
      for (const Formula& child : formula.children) call(*child.value_number, latency_of(formula.function));
      return;
    case Formula::Kind::product: return factors(formula, Latency::multiplication);
    case Formula::Kind::quotient:
      for (const Formula& child : formula.children) within(child, Latency::division);
      return;
    case Formula::Kind::sum: break;
  }
  const std::vector<Part> parts = parts_of(*this, formula);
  const bool first_fused = fuses_first(parts);
  int after = 0;
  for (std::size_t i = parts.size(); i-- > 0;) {
    const bool fused = parts[i].product || (i == 1 && first_fused);
    if (i > 0) after += fused ? Latency::fused : Latency::addition;
    const Formula& child = formula.children[i];
    if (!parts[i].product)
      within(child, after);
    else
      factors(child, after + (i == 0 && !first_fused ? Latency::multiplication : 0));
  }
}

Formula EarliestStarts::in_order(Formula formula) const {
  for (Formula& child : formula.children) child = in_order(std::move(child));
  if (formula.kind != Formula::Kind::sum) return formula;
  Formula sum;
  sum.kind = Formula::Kind::sum;
  for (const Part& part : ordered(parts_of(*this, formula))) {
    sum.children.push_back(std::move(formula.children[part.place]));
    sum.negative.push_back(part.negative);
  }
  return sum;
}

Formula EarliestStarts::scheduled(const Polynomial& sum) const {
  Formula right = formula(*program_, sum);
  return program_->passes().scheduling ? in_order(std::move(right)) : right;
}

Formula EarliestStarts::scheduled(const Definition& definition) const {
  return definition.function ? formula(*program_, definition) : scheduled(definition.polynomial);
}

}  // namespace torsor
