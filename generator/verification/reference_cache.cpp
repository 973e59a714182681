// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/reference_cache.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/fnv.hpp"
#include "torsor/generator/base/output_file.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/verification/lagrange_derivation.hpp"

namespace torsor {
namespace {

/// To be raised whenever references are integrated in another way.
constexpr std::uint64_t method = 2;

class Question {
 public:
  Question& add(std::string_view text) {
    bytes_.add(text).add(std::string_view("", 1));  // a zero ends it: two texts in a row are told from others
    return *this;
  }
  Question& add(std::uint64_t value) { return add(std::to_string(value)); }
  Question& add(const Polynomial& polynomial) {
    for (const Term& term : polynomial.terms()) {
      add(term.coefficient.to_exact());
      for (const Factor& factor : term.monomial) add(fmt::format("{}^{}", factor.value_number, factor.exponent));
    }
    return add("");
  }
  std::uint64_t value() const { return bytes_.value(); }

 private:
  Fnv bytes_;
};

void add_definition(Question& digest, const Scene& scene, const Definition& definition, ValueNumber value_number) {
  digest.add(static_cast<std::uint64_t>(value_number));
  if (definition.function) {
    digest.add(to_string(*definition.function));
    for (const ValueNumber argument : definition.arguments) digest.add(static_cast<std::uint64_t>(argument));
  }
  digest.add(definition.polynomial);
  if (!definition.symbol) return;
  digest.add(definition.symbol->name).add(static_cast<std::uint64_t>(definition.symbol->kind));
  for (const ParameterContent& parameter : scene.content().parameters) {
    if (parameter.symbol != definition.symbol || !parameter.value) continue;
    digest.add(parameter_value(scene.content(), *parameter.value).to_string(Real::working_digits()));
  }
}

std::optional<std::string> kept(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) return std::nullopt;
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t end = text.rfind("# digest ");
  if (end == std::string::npos) return std::nullopt;
  const std::string rows = text.substr(0, end);
  if (text.substr(end) != fmt::format("# digest {:016x}\n", Question().add(rows).value())) return std::nullopt;
  return rows;
}

}  // namespace

std::uint64_t reference_digest(const Scene& scene, const ReferenceOptions& options) {
  const WorkingDigits precision(options.digits + 15);
  Question digest;
  digest.add(method).add(static_cast<std::uint64_t>(options.digits)).add(scene.name());
  digest.add(scene.command_line("reference"));
  for (const std::string& time : options.times) digest.add(time);
  for (const Real& value : initial_state(scene)) digest.add(value.to_string(options.digits + 10));

  const LagrangeDerivation derivation(scene);
  const Model& model = derivation.equations().model();
  std::vector<Value> values = derivation.forces();
  const auto append = [&values](const std::vector<Value>& more) {
    values.insert(values.end(), more.begin(), more.end());
  };
  append(derivation.operators_at_rest());
  for (const std::vector<Value>& row : derivation.mass()) append(row);
  for (const SymbolPointer& q : model.positions()) values.push_back(rate_of(model.program(), q));
  for (const ConstraintRow& row : derivation.equations().constraints()) {
    append(row.jacobian);
    append(row.column);
    values.push_back(row.gamma);
  }
  for (const Value& value : values) digest.add(value.polynomial());
  for (const ValueNumber value_number : model.program().live(values)) {
    add_definition(digest, scene, model.program()[value_number], value_number);
  }
  return digest.value();
}

ReferenceResult integrate_cached_reference(const Scene& scene, const ReferenceOptions& options, const std::string& folder) {
  const std::string path = fmt::format("{}/{}-{:016x}.csv", folder, scene.name(), reference_digest(scene, options));
  if (const auto known = kept(path)) return {*known, {}};
  ReferenceResult motion = integrate_reference(scene, options);
  if (!motion.shortfalls.empty()) return motion;  // what is kept is whole
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  write_file_if_changed(path, motion.text + fmt::format("# digest {:016x}\n", Question().add(motion.text).value()));
  return motion;
}

}  // namespace torsor
