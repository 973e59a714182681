// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/cpp_function.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "generator/emission/cpp_emitter.hpp"
#include "generator/emission/cpp_language.hpp"
#include "generator/emission/cpp_names.hpp"
#include "generator/emission/formula_printer.hpp"
#include "generator/emission/listing_printer.hpp"
#include "generator/emission/series_emitter.hpp"
#include "generator/emission/text_template.hpp"
#include "generator/expression/error.hpp"

namespace torsor {
namespace {

struct ArgumentText {
  Argument argument;
  Table table;
  const char* type;
  const char* name;
};
constexpr std::array<ArgumentText, 3> argument_texts{
    {{Argument::accelerations, Table::acceleration, "Accelerations", "accelerations"},
     {Argument::multipliers, Table::multiplier, "Multipliers", "multipliers"},
     {Argument::inputs, Table::input, "Inputs", "inputs"}}};

bool is_given(const Kernel& kernel, Argument argument) {
  return std::find(kernel.arguments.begin(), kernel.arguments.end(), argument) != kernel.arguments.end();
}

/// What a kernel may read.
Layout layout_of(const Layout& all, const Kernel& kernel) {
  Layout layout = all;
  if (!is_given(kernel, Argument::accelerations)) layout.accelerations.clear();
  if (!is_given(kernel, Argument::multipliers)) layout.multipliers.clear();
  if (!is_given(kernel, Argument::inputs)) layout.inputs.clear();
  return layout;
}

std::string documentation_text(const std::string& documentation) {
  std::string text;
  for (std::size_t begin = 0; begin < documentation.size();) {
    const std::size_t end = std::min(documentation.find('\n', begin), documentation.size());
    text += "/// " + comment_text(documentation.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return text;
}

std::string type_of(const Result& result) {
  return result.structure.empty() ? fmt::format("std::array<Scalar, {}>", result.size) : result.structure;
}

}  // namespace

Listing lower_kernel(const HeaderParts& parts, const Kernel& kernel, const Block& block) {
  Request request;
  for (const Assignment& each : kernel.assignments) request.results.push_back({each.target, each.value});
  request.pivots = kernel.pivots;
  request.has_status = kernel.series || !kernel.pivots.empty();
  const Layout layout = layout_of(parts.layout, kernel);
  try {
    return lower(*parts.program, block, request, {&layout, parts.schedule});
  } catch (const Error& error) {
    throw Error(fmt::format("the kernel '{}': {}", kernel.name, error.what()));
  }
}

FunctionText cpp_function(const HeaderParts& parts, const Kernel& kernel, const Block& block) {
  FunctionText function;
  const Listing listing = lower_kernel(parts, kernel, block);
  std::map<std::string, const Structure*> vectors;
  for (const Result& result : kernel.results) {
    for (const Structure& structure : parts.structures) {
      if (structure.name == result.structure) vectors.emplace(result.name, &structure);
    }
  }
  if (kernel.series) {
    FunctionEmitter emitter(*parts.program, "precomputed.parameters.");
    emitter.provide(parts.schedule->results, "precomputed.y");
    emitter.compute(block);
    write_series(emitter, *parts.program, *kernel.series, block);
    emitter.return_status(kernel.pivots);
    function = emitter.take();
  } else {
    function.body = print(listing, CppLanguage(parts.layout, "precomputed.parameters.", parts.members, vectors));
    function.operations = count(listing);
  }

  // An argument that this scene does not need has no name, so that nobody looks for it and no compiler warns.
  const auto parameter = [](const std::string& type, const std::string& name, bool used) {
    return used ? type + " " + name : type;
  };
  std::string signature =
      fmt::format("TORSOR_DEVICE static {} {}(", listing.has_status ? "torsor::Status" : "void", kernel.name);
  signature += parameter("const Precomputed&", "precomputed",
                         listing.reads(Table::precomputed) || listing.reads(Table::parameter));
  const bool reads_state =
      listing.reads(Table::time) || listing.reads(Table::coordinate) || listing.reads(Table::velocity);
  signature += ", " + parameter("const State&", "state", kernel.series || reads_state);
  for (const Argument argument : kernel.arguments) {
    const ArgumentText& given = *std::find_if(argument_texts.begin(), argument_texts.end(),
                                              [&](const ArgumentText& each) { return each.argument == argument; });
    signature += ", " + parameter(fmt::format("const {}&", given.type), given.name, listing.reads(given.table));
  }
  for (const Result& result : kernel.results) {
    const bool used = std::any_of(kernel.assignments.begin(), kernel.assignments.end(),
                                  [&](const Assignment& each) { return each.target.result == result.name; });
    signature += ", " + parameter(type_of(result) + "&", result.name, used);
  }
  if (kernel.series) {
    signature += fmt::format(", int order, std::array<Scalar, {}>* coefficients", kernel.series->state.size());
  }
  signature += ") noexcept {";
  function.body =
      documentation_text(kernel.documentation) + wrapped(signature, 2) + "\n" + indented(function.body, "  ") + "}\n";
  return function;
}

}  // namespace torsor
