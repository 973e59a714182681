// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/listing_printer.hpp"

#include <fmt/format.h>

#include "generator/emission/comment_text.hpp"
#include "generator/emission/formula_printer.hpp"

namespace torsor {
namespace {

constexpr std::size_t function_indentation = 4;

/// So many products in the check that results are finite wait for each other.
constexpr std::size_t finite_group = 16;

/// 0 times some results; of many a product of such products.
std::string zero_times(const std::string& zero, const std::vector<std::string>& of, std::size_t begin, std::size_t end) {
  if (end - begin > finite_group) {
    const std::size_t middle = begin + (end - begin) / 2;
    const std::string first = zero_times(zero, of, begin, middle);
    return "(" + first + ") * (" + zero_times(zero, of, middle, end) + ")";
  }
  std::string product = zero;
  for (std::size_t i = begin; i < end; ++i) product += " * " + of[i];
  return product;
}

class ListingPrinter {
 public:
  ListingPrinter(const Listing& listing, const Language& language)
      : listing_(&listing),
        language_(&language),
        formulas_([this](Atom quantity) { return name(quantity); },
                  [this](Function function) { return language_->function(function); }) {}

  std::string print() {
    std::string bindings;
    for (const Atom quantity : listing_->given) {
      const Quantity& each = listing_->quantity(quantity);
      bindings += language_->local(each.name, language_->access(each)) + "\n";
    }
    for (const Statement& each : listing_->statements) write(each);
    for (const Output& output : listing_->outputs) {
      statement(fmt::format("{} = {};", language_->access(output.target), text(output.value)), output.meaning);
    }
    for (const Statement& each : listing_->of_pivots) write(each);
    if (listing_->has_status) write_status();
    std::string constants;
    for (const FormulaPrinter::Constant& constant : formulas_.constants()) {
      constants += wrapped(language_->local(constant.name, language_->constant(constant.number)), function_indentation) + "\n";
    }
    return constants + bindings + code_;
  }

 private:
  std::string name(Atom number) const {
    const Quantity& quantity = listing_->quantity(number);
    if (!quantity.name.empty()) return quantity.name;
    if (quantity.table == Table::output) return language_->access(listing_->outputs[quantity.index].target);
    return language_->access(quantity);
  }
  std::string text(const Signed& value) {
    return value.negative ? formulas_.print_negated(value.formula) : formulas_.print(value.formula);
  }

  void line(const std::string& code) { code_ += wrapped(code, function_indentation) + "\n"; }
  void lines(const std::vector<std::string>& all, const std::string& meaning = {}) {
    for (std::size_t i = 0; i + 1 < all.size(); ++i) line(all[i]);
    if (!all.empty()) statement(all.back(), meaning);
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
    const bool turns = each.right.kind == Formula::Kind::function &&
                       (each.right.function == Function::sin || each.right.function == Function::cos);
    const std::string value = turns ? name(each.right.children[0].atom) : formulas_.print(each.right);
    lines(language_->literal(name(each.quantity), each, value), each.meaning);
  }
  void write(const SinesAndCosines& group) {
    if (group.angles.size() == 1) {
      const SineCosine& only = group.angles[0];
      return lines(language_->sine_and_cosine(name(only.angle), name(*only.sine), name(*only.cosine)), only.meaning);
    }
    const std::string suffix = ++groups_ == 1 ? "_" : fmt::format("{}_", groups_);
    std::vector<std::string> angles;
    for (const SineCosine& each : group.angles) angles.push_back(name(each.angle));
    lines(language_->sines_and_cosines(angles, suffix));
    for (std::size_t i = 0; i < group.angles.size(); ++i) {
      const SineCosine& each = group.angles[i];
      std::string locals;
      const auto take = [&](const std::optional<Atom>& quantity, const char* array) {
        if (!quantity) return;
        const std::string value = fmt::format("{}{}[{}]", array, suffix, i);
        locals = locals.empty() ? language_->local(name(*quantity), value)
                                : fmt::format("{}, {} = {};", locals.substr(0, locals.size() - 1), name(*quantity), value);
      };
      take(each.sine, "sines");
      take(each.cosine, "cosines");
      statement(locals, each.meaning);
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
    std::vector<std::string> finite;
    for (const Output& output : listing_->outputs) {
      if (output.varies && !output.repeats) finite.push_back(language_->access(output.target));
    }
    if (!finite.empty()) {
      const std::string product = zero_times(formulas_.name(Number()), finite, 0, finite.size());
      line("// 0 x is 0 for every finite x and not a number for any other.");
      line(language_->local("zero", product));
      const std::string one = formulas_.name(Number(1));
      line(fmt::format("if (!{}) return {};", language_->regular(one, "zero"), language_->status("not_finite")));
    }
    line(fmt::format("return {};", language_->status("ok")));
  }

  const Listing* listing_;
  const Language* language_;
  FormulaPrinter formulas_;
  std::string code_;
  int groups_ = 0;
};

}  // namespace

std::string print(const Listing& listing, const Language& language) { return ListingPrinter(listing, language).print(); }

}  // namespace torsor
