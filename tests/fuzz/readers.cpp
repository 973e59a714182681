// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of the generator: robots, expressions, numbers, units.
#include <optional>
#include <stdexcept>
#include <string>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/unit.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/import/urdf.hpp"
#include "torsor/generator/import/xacro.hpp"
#include "torsor/generator/import/xacro_expression.hpp"
#include "torsor/generator/import/yaml_subset.hpp"
#include "torsor/generator/printing/formula_text.hpp"
#include "torsor/generator/verification/verify.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/fuzz/text_rules.hpp"

namespace torsor::fuzzing {

void read_robot(std::string_view input) {
  UrdfOptions options;
  options.base = input.size() % 2 == 0 ? UrdfBase::fixed : UrdfBase::floating;
  try {
    const Scene scene = read_urdf_text(input, "robot.urdf", options).scene;
    // What is read is derived now and then only: it takes a hundred times as long.
    if (input.size() > 20000 || input.size() % 16 != 0) return;
    expect_source_text(emit_header(scene, {"inverse_dynamics"}));
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

void read_xacro(std::string_view input) {
  XacroOptions options;
  options.package_folders = {"/nowhere"};
  try {
    const ExpandedXacro expanded = expand_xacro(input, "robot.xacro", options);
    static_cast<void>(read_urdf_text(expanded.text, "robot.xacro", {}, expanded.lines));
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

void read_expression(std::string_view input) {
  try {
    const xacro::Surroundings nothing{[](const std::string& name) { return xacro::constant(name); },
                                      [](const std::string&, const auto&) { return std::optional<xacro::Value>(); }};
    static_cast<void>(xacro::evaluate(input, nothing));
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

void read_yaml(std::string_view input) {
  try {
    static_cast<void>(xacro::yaml_value(std::string(input), "parameters.yaml"));
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

void read_exceptions(std::string_view input) {
  try {
    static_cast<void>(parse_accuracy_exceptions(std::string(input)));
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

void read_decimal(std::string_view input) {
  try {
    const Number number = parse_decimal(input);
    if (!(parse_decimal(number.to_string()) == number))
      throw std::logic_error("a number is not read back as it is written: " + number.to_string());
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

void read_unit(std::string_view input) {
  try {
    const Unit unit = Unit::parse(input);
    if (!(Unit::parse(unit.to_string()) == unit))
      throw std::logic_error("a unit is not read back as it is written: " + unit.to_string());
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

void read_formula(std::string_view input) {
  static const Scene scene = [] {
    Scene made("pendulum");
    made.parameter("k", "N/m", 2);
    made.coordinate("theta", "rad");
    made.coordinate("x", "m");
    return made;
  }();
  try {
    Program program;
    static_cast<void>(program.lower(parse_formula(std::string(input), scene)));
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
}

}  // namespace torsor::fuzzing
