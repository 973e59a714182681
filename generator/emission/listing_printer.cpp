// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/listing_printer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "torsor/generator/base/comment_text.hpp"
#include "torsor/generator/emission/formula_printer.hpp"

namespace torsor {
namespace {

constexpr std::size_t function_indentation = 4;

/// So many products in the check that results are finite wait for each other.
constexpr std::size_t finite_group = 16;

/// 0 times some results; of many a product of such products.
std::string zero_times(const std::string& zero, const std::vector<std::string>& of, std::size_t begin,
                       std::size_t end) {
  if (end - begin > finite_group) {
    const std::size_t middle = begin + (end - begin) / 2;
    const std::string first = zero_times(zero, of, begin, middle);
    return "(" + first + ") * (" + zero_times(zero, of, middle, end) + ")";
  }
  std::string product = zero;
  for (std::size_t i = begin; i < end; ++i) product += " * " + of[i];
  return product;
}

/// What becomes of a number that no normal float is near to.
std::string beyond_floats(const Number& number) {
  const float size = std::abs(number.to_float());
  if (number.is_zero() || (size >= std::numeric_limits<float>::min() && !std::isinf(size))) return "";
  const char* what = size == 0 ? "0" : std::isinf(size) ? "infinite" : "less than every normal float";
  return fmt::format("In float the next constant is {}.", what);
}

class ListingPrinter {
 public:
  ListingPrinter(const Listing& listing, const Language& language)
      : listing_(&listing),
        language_(&language),
        formulas_([this](ValueNumber quantity) { return name(quantity); },
                  [this](Function function) { return language_->function(function); }) {}

  std::string print() {
    read_ = read_quantities(*listing_, language_->computes_literals());
    std::string bindings;
    for (const ValueNumber quantity : listing_->given) {
      if (!is_read(quantity)) continue;
      const Quantity& each = listing_->quantity(quantity);
      bindings += language_->local(each.name, language_->access(each)) + "\n";
    }
    for (const Statement& each : listing_->statements) {
      if (is_needed(each, read_)) write(each);
    }
    for (const Output& output : listing_->outputs) {
      statement(fmt::format("{} = {};", language_->access(output.target), text(output.value)), output.meaning);
    }
    if (listing_->recurrence) write(*listing_->recurrence);
    for (const Statement& each : listing_->of_pivots) write(each);
    if (listing_->has_status) write_status();
    std::string constants;
    for (const FormulaPrinter::Constant& constant : formulas_.constants()) {
      const std::string note = language_->has_floats() ? beyond_floats(constant.number) : "";
      if (!note.empty()) constants += wrapped("// " + note, function_indentation) + "\n";
      constants +=
          wrapped(language_->local(constant.name, language_->constant(constant.number)), function_indentation) + "\n";
    }
    return constants + bindings + code_;
  }

 private:
  bool is_read(ValueNumber quantity) const { return read_[static_cast<std::size_t>(quantity)]; }
  std::string name(ValueNumber number) const {
    const Quantity& quantity = listing_->quantity(number);
    if (!quantity.name.empty()) return quantity.name;
    if (quantity.table == Table::output) return language_->access(listing_->outputs[quantity.index].target);
    return language_->access(quantity);
  }
  std::string text(const Signed& value) {
    return value.negative ? formulas_.print_negated(value.formula) : formulas_.print(value.formula);
  }

  void line(const std::string& code) { code_ += wrapped(code, function_indentation) + "\n"; }
  void lines(const std::vector<CodeLine>& all) {
    for (const CodeLine& each : all) statement(each.code, each.meaning);
  }
  void statement(const std::string& code, const std::string& meaning) {
    const std::string wrapped_code = wrapped(code, function_indentation);
    if (meaning.empty()) {
      code_ += wrapped_code + "\n";
      return;
    }
    const std::string comment = "// " + comment_text(meaning);
    const bool fits = wrapped_code.find('\n') == std::string::npos && wrapped_code.size() + comment.size() + 6 <= 120;
    code_ += fits ? wrapped_code + "  " + comment + "\n" : comment + "\n" + wrapped_code + "\n";
  }

  void write(const Statement& each) {
    std::visit([this](const auto& content) { write(content); }, each);
  }
  void write(const Assigned& each) {
    statement(language_->local(name(each.quantity), formulas_.print(each.right)), each.meaning);
  }
  void write(const Pi& each) { line(language_->local(name(each.quantity), language_->pi())); }
  void write(const Literal& each) {
    // A formula that is not printed names no numbers.
    if (!language_->computes_literals()) return lines(language_->literal(name(each.quantity), each, {}));
    const bool turns = each.right.kind == Formula::Kind::function &&
                       (each.right.function == Function::sin || each.right.function == Function::cos);
    const std::string value = turns ? name(*each.right.children[0].value_number) : formulas_.print(each.right);
    lines(language_->literal(name(each.quantity), each, value));
  }
  void write(const SinesAndCosines& group) {
    const bool both = group.angles.size() == 1;
    const auto optional_name = [&](const std::optional<ValueNumber>& quantity) {
      return quantity && (both || is_read(*quantity)) ? name(*quantity) : "";
    };
    std::vector<AngleText> angles;
    for (const SineCosinePair& each : group.angles) {
      angles.push_back({name(each.angle), optional_name(each.sine), optional_name(each.cosine), each.meaning});
    }
    lines(language_->sines_and_cosines(angles, ++groups_));
  }

  void write(const Recurrence& recurrence) {
    RecurrenceText text;
    text.size = recurrence.rates.size();
    text.one = formulas_.name(Number(1));
    for (const Statement& each : recurrence.steps) {
      const auto& step = std::get<Assigned>(each);
      text.steps.push_back({language_->local(name(step.quantity), formulas_.print(step.right)), step.meaning});
    }
    const std::string next =
        language_->access(Quantity{Table::order, static_cast<std::size_t>(OrderQuantity::next), ""});
    for (std::size_t i = 0; i < recurrence.rates.size(); ++i) {
      const Formula& rate = recurrence.rates[i];
      const bool product = rate.kind == Formula::Kind::product;
      const std::string text_of_rate =
          product || recurrence.constant[i] ? formulas_.print(rate) : formulas_.print_factor(rate);
      text.next.push_back(recurrence.constant[i] ? text_of_rate : next + " * " + text_of_rate);
    }
    for (const auto& [left, right] : recurrence.convolutions) text.convolutions.emplace_back(name(left), name(right));
    text.is_first_read =
        std::any_of(listing_->quantities.begin(), listing_->quantities.end(), [](const Quantity& each) {
          return each.table == Table::order && each.index == static_cast<std::size_t>(OrderQuantity::first);
        });
    if (text.is_first_read) text.zero = formulas_.name(Number());
    lines(language_->recurrence(text));
    for (std::size_t i = 0; i < recurrence.rates.size(); ++i) {
      if (!recurrence.constant[i]) finite_.push_back(language_->access(Target{"coefficients", "last", i}));
    }
  }

  void write_status() {
    std::string condition;
    for (const Pivot& each : listing_->pivots) {
      const std::string pivot = text(each.pivot);
      const std::string diagonal = text(each.diagonal);
      condition += (condition.empty() ? "" : " && ") + language_->regular(pivot, diagonal);
    }
    const auto unless = [this](const std::string& good, const char* status) {
      line(fmt::format("if (!({})) return {};", good, language_->status(status)));
    };
    if (!condition.empty()) unless(condition, "singular");
    for (const Output& output : listing_->outputs) {
      if (output.checked) finite_.push_back(language_->access(output.target));
    }
    if (!finite_.empty()) {
      const std::string product = zero_times(formulas_.name(Number()), finite_, 0, finite_.size());
      line("// 0 x is 0 for every finite x and not a number for any other.");
      line(language_->local("zero", product));
      line(fmt::format("if (!{}) return {};", language_->finite("zero"), language_->status("not_finite")));
    }
    line(fmt::format("return {};", language_->status("ok")));
  }

  const Listing* listing_;
  const Language* language_;
  FormulaPrinter formulas_;
  std::vector<bool> read_;  ///< by quantity
  std::string code_;
  std::vector<std::string> finite_;  ///< results that could be not finite
  int groups_ = 0;
};

}  // namespace

std::string print(const Listing& listing, const Language& language) {
  return ListingPrinter(listing, language).print();
}

}  // namespace torsor
