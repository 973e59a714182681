// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/precomputation.hpp"

#include <algorithm>
#include <functional>
#include <variant>

#include <fmt/format.h>

#include "torsor/generator/base/fnv.hpp"

namespace torsor {
namespace {

std::string written(const Formula& formula, const std::function<std::string(ValueNumber)>& leaf) {
  const auto children = [&](const char* separator) {
    std::string text;
    for (std::size_t i = 0; i < formula.children.size(); ++i) {
      const bool negative = formula.kind == Formula::Kind::sum && formula.negative[i];
      text += (i > 0 ? separator : "") + std::string(negative ? "-" : "") + written(formula.children[i], leaf);
    }
    return "(" + text + ")";
  };
  switch (formula.kind) {
    case Formula::Kind::value_number:
      return leaf(*formula.value_number);
    case Formula::Kind::constant:
      return formula.number.to_exact();
    case Formula::Kind::sum:
      return children("+");
    case Formula::Kind::product:
      return children("*");
    case Formula::Kind::quotient:
      return children("/");
    case Formula::Kind::function:
      return std::string(to_string(formula.function)) + children(",");
  }
  return {};
}

std::string digest(const std::string& text) { return fmt::format("{:016x}", Fnv().add(text).value()); }

/// The formula with its leaves at other places.
Formula moved(Formula formula, const std::vector<ValueNumber>& places) {
  if (formula.kind == Formula::Kind::value_number)
    formula.value_number = places[static_cast<std::size_t>(*formula.value_number)];
  for (Formula& child : formula.children) child = moved(std::move(child), places);
  return formula;
}

/// Whether a local variable is called by its number only.
bool is_numbered(const std::string& name) {
  return name.size() > 1 && name[0] == 'z' && std::all_of(name.begin() + 1, name.end(), [](char letter) {
           return letter >= '0' && letter <= '9';
         });
}

}  // namespace

std::string Precomputation::exactly(const Formula& formula) const {
  return written(formula, [](ValueNumber quantity) { return fmt::format("#{}", quantity); });
}

std::string Precomputation::content(const Formula& formula) const {
  return digest(
      written(formula, [this](ValueNumber quantity) { return contents_[static_cast<std::size_t>(quantity)]; }));
}

ValueNumber Precomputation::add(Quantity quantity, const std::string& formula, const std::string& content) {
  const auto number = static_cast<ValueNumber>(listing_.quantities.size());
  listing_.quantities.push_back(std::move(quantity));
  contents_.push_back(content);
  quantities_.emplace(formula, number);
  return number;
}

template <class MakeStatement>
ValueNumber Precomputation::quantity(const std::string& formula, const std::string& content, const std::string& name,
                              const MakeStatement& statement) {
  if (const auto known = quantities_.find(formula); known != quantities_.end()) return known->second;
  const ValueNumber number = add({Table::local, 0, local_name(name)}, formula, content);
  listing_.statements.emplace_back(statement(number));
  return number;
}

void Precomputation::define(const Listing& once, const Assigned& each, Places& places) {
  const Formula right = moved(each.right, places);
  places[static_cast<std::size_t>(each.quantity)] =
      quantity(exactly(right), content(right), once.quantity(each.quantity).name,
               [&](ValueNumber number) { return Assigned{number, right, each.meaning}; });
}

void Precomputation::define(const Listing& once, const Literal& each, Places& places) {
  const Formula right = moved(each.right, places);
  places[static_cast<std::size_t>(each.quantity)] =
      quantity("literal " + exactly(right), content(right), once.quantity(each.quantity).name,
               [&](ValueNumber number) { return Literal{number, right, each.rounded, each.meaning}; });
}

void Precomputation::define(const Listing& once, const Pi& each, Places& places) {
  places[static_cast<std::size_t>(each.quantity)] = quantity(
      "pi", digest("pi"), once.quantity(each.quantity).name, [](ValueNumber number) { return Pi{number}; });
}

std::string Precomputation::local_name(const std::string& name) {
  return is_numbered(name) ? fmt::format("z{}", numbered_++) : name;
}

ValueNumber Precomputation::turned(const std::string& name, const char* function, ValueNumber angle) {
  return add({Table::local, 0, local_name(name)}, fmt::format("{}(#{})", function, angle),
             digest(function + contents_[static_cast<std::size_t>(angle)]));
}

/// Of a pair that stands in another function's group only what lacks is added, there.
void Precomputation::define(const Listing& once, const SinesAndCosines& group, Places& places) {
  SinesAndCosines fresh;
  const auto known_pair = [this](ValueNumber angle) -> SineCosinePair* {
    for (Statement& statement : listing_.statements) {
      auto* const known = std::get_if<SinesAndCosines>(&statement);
      if (known == nullptr) continue;
      for (SineCosinePair& pair : known->angles) {
        if (pair.angle == angle) return &pair;
      }
    }
    return nullptr;
  };
  for (const SineCosinePair& each : group.angles) {
    const ValueNumber angle = places[static_cast<std::size_t>(each.angle)];
    SineCosinePair* pair = known_pair(angle);
    if (pair == nullptr) {
      fresh.angles.push_back({angle, {}, {}, each.meaning});
      pair = &fresh.angles.back();
    }
    const auto take = [&](const std::optional<ValueNumber>& wanted, std::optional<ValueNumber>& here,
                          const char* function) {
      if (!wanted) return;
      if (!here) here = turned(once.quantity(*wanted).name, function, angle);
      places[static_cast<std::size_t>(*wanted)] = *here;
    };
    take(each.sine, pair->sine, "sin");
    take(each.cosine, pair->cosine, "cos");
  }
  if (fresh.angles.empty()) return;
  if (fresh.angles.size() == 1) {  // a group of one gives both
    SineCosinePair& only = fresh.angles[0];
    if (!only.sine) only.sine = turned("z0", "sin", only.angle);
    if (!only.cosine) only.cosine = turned("z0", "cos", only.angle);
  }
  listing_.statements.emplace_back(std::move(fresh));
}

std::vector<std::size_t> Precomputation::add(const Listing& once) {
  Places places(once.quantities.size());  // each is given or defined before it is used
  for (const ValueNumber given : once.given) {
    const Quantity& argument = once.quantity(given);
    const std::string formula = fmt::format("given {}", argument.name);
    const auto known = quantities_.find(formula);
    if (known != quantities_.end()) {
      places[static_cast<std::size_t>(given)] = known->second;
      continue;
    }
    places[static_cast<std::size_t>(given)] = add(argument, formula, digest(argument.name));
    listing_.given.push_back(places[static_cast<std::size_t>(given)]);
  }
  for (const Statement& statement : once.statements) {
    std::visit([&](const auto& each) { define(once, each, places); }, statement);
  }
  std::vector<std::size_t> members;
  for (const Output& output : once.outputs) {
    Formula right = moved(output.value.formula, places);
    if (output.value.negative) right = negated(std::move(right));
    const auto [place, added] = places_.emplace(exactly(right), members_.size());
    members.push_back(place->second);
    if (!added) continue;
    const std::string whole = content(right);
    std::string name = "m_" + whole.substr(0, 8);
    const auto is_taken = [&name](const PrecomputedMember& other) { return other.name == name; };
    if (std::any_of(members_.begin(), members_.end(), is_taken)) name = "m_" + whole;
    members_.push_back({name, output.meaning});
    listing_.outputs.push_back({{"precomputed", name}, {std::move(right)}, false, {}});
  }
  return members;
}

}  // namespace torsor
