// SPDX-License-Identifier: GPL-3.0-or-later
// The part of series_text.hpp that solves for accelerations.
#include "generator/emission/series_text.hpp"

namespace torsor {

void SeriesText::write_solve(std::vector<std::string>& steps) {
  const auto nodes = static_cast<int>(nodes_.size());
  for (int id = 0; id < nodes; ++id) {
    if (marked(id) && !is_unknown(id)) write_partial(id, steps);
  }
  write_accelerations(steps);
  std::vector<bool> wanted(nodes_.size(), false);
  const auto want = [&](int id) {
    if (marked(id)) wanted[static_cast<std::size_t>(id)] = true;
  };
  for (int id = nodes; id-- > 0;) {
    const SeriesNode& each = node(id);
    if (is_nonlinear(each)) {
      want(each.left);
      want(each.right);
      if (each.kind == Kind::quotient) want(id);
    }
    if (!wanted[static_cast<std::size_t>(id)]) continue;
    for (const SeriesForm::Term& term : each.form.terms) want(term.node);
  }
  for (int id = 0; id < nodes; ++id) {
    if (!wanted[static_cast<std::size_t>(id)] || is_unknown(id)) continue;
    const std::string text = with_marked(id, [this](int operand) { return x(operand); });
    steps.push_back(fmt::format("const Scalar {} = {};", x(id), text));
  }
}

void SeriesText::write_partial(int id, std::vector<std::string>& steps) {
  const SeriesNode& each = node(id);
  std::string text;
  OperationCount operations;
  if (each.kind == Kind::sum) {
    text = with_terms(
        "", each.form, [this](int operand) { return !marked(operand); }, [this](int operand) { return x(operand); });
  } else if (each.kind == Kind::product) {
    const auto [with, other] = factors_of(each);
    const std::string value = begin(with);
    text = fmt::format("{} + {} * {}", sum_of(id), value, x(other));
    operations = {.additions = 1, .multiplications = 1};
  } else {
    const std::string value = begin(id);
    const std::string factor = inverse(id);
    text = fmt::format("({} + {} * {}) * -{}", sum_of(id), value, x(each.right), factor);
    operations = {.additions = 1, .multiplications = 2};
  }
  emitter_.add_operations(operations);
  const auto place = static_cast<std::size_t>(id);
  if (!text.empty()) {
    without_[place] = fmt::format("o{}", id);
    steps.push_back(fmt::format("const Scalar {} = {};", without_[place], text));
  }
  const std::string all = with_marked(id, [this](int operand) { return partial_[static_cast<std::size_t>(operand)]; });
  if (all == without_[place]) {
    partial_[place] = all;
  } else {
    partial_[place] = fmt::format("p{}", id);
    steps.push_back(fmt::format("const Scalar {} = {};", partial_[place], all));
  }
}

void SeriesText::write_accelerations(std::vector<std::string>& steps) {
  const SeriesSolve& solve = *series_.solve;
  const std::size_t n = solve.unknowns.size(), given = series_.state.size() - n;
  OperationCount operations;
  std::vector<std::string> rest(n);
  const auto subtract = [&](std::string& text, std::size_t row, std::size_t column, const std::string& value) {
    const Polynomial& coefficient = solve.lower[row][column].polynomial();
    if (coefficient.is_zero() || value.empty()) return;
    bool negative = false;
    const std::string size = factor(coefficient, negative);
    text += text.empty() ? (negative ? "" : "-") : (negative ? " + " : " - ");
    text += size.empty() ? value : size + " * " + value;
    operations.additions += 1;
    operations.multiplications += size.empty() ? 0 : 1;
  };
  for (std::size_t k = n; k-- > 0;) {
    const auto name = [this](int operand) {
      return marked(operand) ? partial_[static_cast<std::size_t>(operand)] : x(operand);
    };
    const std::string left = with_terms(
        "", series_.program.outputs()[given + k], [&](int operand) { return !name(operand).empty(); }, name);
    std::string text = left.empty() ? "" : "-(" + left + ")";
    for (std::size_t i = n; i-- > k + 1;) subtract(text, i, k, rest[i]);
    if (text.empty()) continue;
    rest[k] = fmt::format("r{}", k);
    steps.push_back(fmt::format("const Scalar {} = {};", rest[k], text));
  }
  for (std::size_t k = 0; k < n; ++k) {
    bool negative = false;
    const std::string size = factor(solve.inverse_pivots[k].polynomial(), negative);
    std::string text = rest[k].empty() ? "" : (negative ? "-" : "") + (size.empty() ? "" : size + " * ") + rest[k];
    operations.multiplications += 1;
    for (std::size_t i = 0; i < k; ++i) subtract(text, k, i, rate(i));
    steps.push_back(fmt::format("const Scalar {} = {};", rate(k), text.empty() ? emitter_.name(Number(0)) : text));
  }
  emitter_.add_operations(operations);
}

}  // namespace torsor
