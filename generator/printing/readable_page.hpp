// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/recursions/forward_dynamics.hpp"
#include "torsor/generator/printing/definitions_view.hpp"
#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/page.hpp"

namespace torsor::printing {

/// Values of one program on a page: written out where that is short enough, else by named definitions
/// that stand at the end.
class ReadablePage {
 public:
  ReadablePage(Program& program, const SceneContent& scene, const InlineLimits& limits = {})
      : program_(&program), view_(program, limits, scene) {}

  void section(const std::string& heading);
  void note(const std::string& sentence);
  /// label:  name = value    (remark)
  void equation(const std::string& label, const std::string& name, const Value& value, const std::string& remark = {});
  void equation(const std::string& label, const Value& left, const Value& right, const std::string& remark = {});
  /// The same with a name that is no symbol.
  void stated(const Spelling& left, const Value& value, const std::string& remark = {});
  /// value > 0
  void positive(const Value& value);
  void matrix(const Spelling& name, const std::string& entry, const ValueMatrix& matrix);
  void matrix(const std::string& name, const ValueMatrix& entries) { matrix(bold(name), name, entries); }

  /// The page, under the title of the scene.
  std::string finish(const SceneContent& scene, const PageStyle& style = {});

 private:
  void gather(const Value& value);
  Written written(const Value& value);
  /// Those whose names have been written.
  void laws_of_time(const SceneContent& scene, Page& page);

  const Program* program_;
  InlineView view_;
  std::vector<std::function<void(Page&)>> lines_;
  std::vector<Value> long_results_;
  std::optional<DefinitionsView> definitions_;
  std::set<const Symbol*> used_;  ///< looked up only
};

}  // namespace torsor::printing
