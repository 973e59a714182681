// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/statics_text.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/motion/initial_numbers.hpp"
#include "torsor/generator/dynamics/theorems/flat_polynomials.hpp"
#include "torsor/generator/dynamics/theorems/forms_that_meet.hpp"
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"
#include "torsor/generator/dynamics/theorems/routh.hpp"
#include "torsor/generator/dynamics/theorems/stability.hpp"
#include "torsor/generator/mechanics/uncounted_contacts.hpp"
#include "torsor/generator/printing/formula_text.hpp"
#include "torsor/generator/printing/readable_page.hpp"
#include "torsor/generator/printing/statics_state.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

using About = printing::Assignments;

constexpr int digits = 50;
constexpr std::size_t most_freedoms = 4;  ///< of symbolic conditions: Hurwitz's determinants are for degrees up to 8

class StaticsWriter {
 public:
  /// `scene` has the values of `set` already.
  StaticsWriter(const Scene& scene, const About& about, const About& set, const PageStyle& style)
      : scene_(scene),
        equations_(scene, symbolic_but(scene, set)),
        statics_(equilibrium_equations(equations_, style.language)),
        page_(equations_.program(), scene.content()),
        about_(about),
        style_(style),
        say(style_.language) {
    std::string values;
    for (const auto& [name, value] : set) values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", name, value);
    if (!values.empty()) page_.note(say("With {}.", values));
  }

  std::string write() {
    equilibrium();
    if (about_.empty()) {
      second_derivatives(statics_.hessian);
      return finish();
    }
    const AtState at(equations_, printing::rest_state(scene_, about_));
    rest(at);
    lejeune_dirichlet_criterion(at);
    hurwitz(at);
    return finish();
  }

 private:
  static ModelOptions symbolic_but(const Scene& scene, const About& set) {
    ModelOptions options;
    options.symbolic_parameters = true;
    for (const auto& [name, value] : set) options.valued.insert(parse_formula(name, scene).as_symbol()->name);
    return options;
  }

  std::string finish() { return page_.finish(scene_.content(), style_); }

  std::string state_text() const {
    std::string text;
    for (const auto& [name, formula] : about_)
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, formula);
    return text;
  }

  static std::string name_of(const SymbolPointer& rate) {
    std::string name = rate->name;
    while (!name.empty() && name.back() == '\'') name.pop_back();
    return name;
  }

  std::string potential_name() const { return statics_.driven ? "-(U + T0)" : "-U"; }

  void equilibrium() {
    page_.section(say("Equations of equilibrium"));
    for (const std::string& sentence : uncounted_contacts(scene_.content(), say)) page_.note(sentence);
    if (statics_.from_potential) page_.stated({potential_name(), statics_.driven ? "-(U + T_{0})" : "-U"}, statics_.potential, say("in J"));
    for (const std::string& remark : statics_.remarks) page_.note(remark + ".");
    std::vector<std::string> idle;
    for (std::size_t i = 0; i < statics_.rows.size(); ++i) {
      const std::string name = name_of(statics_.freedoms[i]);
      if (!identically_zero(statics_.rows[i])) {
        page_.equation(name, Value(), statics_.rows[i]);
        continue;
      }
      idle.push_back(name);
    }
    if (idle.size() == 1) page_.note(say("The equation of {} holds everywhere: nothing acts along it at rest.", idle[0]));
    if (idle.size() > 1) {
      page_.note(say("The equations of {} hold everywhere: nothing acts along them at rest.", fmt::format("{}", fmt::join(idle, ", "))));
    }
    for (const Value& condition : statics_.conditions) page_.equation("", Value(), condition, say("constraint"));
    if (time_stands()) page_.note(say("Time stands in these equations: a rest fulfils them at every t."));
  }

  bool time_stands() const { return depend_on_time(statics_.rows) || depend_on_time(statics_.conditions); }

  bool depend_on_time(const std::vector<Value>& values) const { return torsor::depend_on_time(equations_.model(), values); }

  void second_derivatives(const ValueMatrix& hessian) {
    page_.section(say("Second derivatives of {} at any configuration", potential_name()));
    if (!may_conclude()) return;
    page_.matrix("H", hessian);
    page_.note(
        say("Where it is positive definite a rest is stable (Lejeune-Dirichlet); elsewhere the criterion cannot "
            "conclude. Name a rest by --about for the conditions there."));
  }

  bool may_conclude() {
    if (!equations_.constraints().empty()) {
      page_.note(
          say("Lejeune-Dirichlet cannot conclude: the scene has constraints; describe it with independent coordinates, "
              "or let the runtime project the second derivatives on the tangent space."));
      return false;
    }
    if (!statics_.from_potential) {
      page_.note(say("Lejeune-Dirichlet cannot conclude: {}.", statics_.remarks.front()));
      return false;
    }
    if (statics_.depends_on_time) {
      page_.note(say("Lejeune-Dirichlet cannot conclude: T or U depends on time explicitly, and the energy is no integral."));
      return false;
    }
    return true;
  }

  void rest(const AtState& at) {
    page_.section(say("At {}", state_text()));
    bool balanced = true;
    const auto left_over = [&](const std::string& label, const Value& value) {
      if (value.is_zero() || identically_zero(value)) return;
      balanced = false;
      page_.equation(label, Value(), value, say("must hold for a rest"));
    };
    const std::vector<Value> rows = at(statics_.rows), conditions = at(statics_.conditions);
    for (std::size_t i = 0; i < rows.size(); ++i) left_over(name_of(statics_.freedoms[i]), rows[i]);
    for (const Value& condition : conditions) left_over("", condition);
    if (!balanced) return;
    const bool instant = std::any_of(about_.begin(), about_.end(), [](const auto& named) { return named.first == "t"; });
    rest_is_proved_ = !(instant && time_stands());
    page_.note(!rest_is_proved_
                   ? say("Every equation of equilibrium holds at this instant.")
                   : say("Every equation of equilibrium holds: a rest, whatever the parameters."));
  }

  /// Whether the state lies where two forms of the values meet; says so.
  bool lies_between_forms(std::vector<Value> values, const ValueMatrix& matrix, const AtState& at) {
    for (const std::vector<Value>& row : matrix) values.insert(values.end(), row.begin(), row.end());
    const WorkingDigits precision(digits);
    const std::vector<Value> conditions = forms_that_meet(equations_.program(), values, at, scene_values({at(values)}));
    if (conditions.empty()) return false;
    page_.note(say("Cannot conclude: forces or their slopes have two values at this state, one on either side of"));
    for (const Value& condition : conditions) page_.equation("", Value(), condition);
    return true;
  }

  void lejeune_dirichlet_criterion(const AtState& at) {
    page_.section(say("Lejeune-Dirichlet"));
    if (!may_conclude() || lies_between_forms(statics_.rows, statics_.hessian, at)) return;
    const ValueMatrix hessian = at(statics_.hessian);
    page_.matrix("H", hessian);
    page_.note(say("H: second derivatives of {} there.", potential_name()));
    if (hessian.size() <= most_freedoms) {
      write_conditions(
          say("Stable where H is positive definite, else it cannot conclude (a condition that always holds is left out):"),
          sylvester_conditions(equations_.program(), hessian), say("H is positive definite"));
    }
    const auto values = scene_values(hessian);
    if (!values) return;
    const WorkingDigits precision(digits);
    EquilibriumEquations there = statics_;
    there.rows = at(statics_.rows);
    there.hessian = hessian;
    there.mass = at(statics_.mass);
    const LejeuneDirichlet verdict = lejeune_dirichlet(equations_, there, *values, say);
    const bool rest =
        std::all_of(verdict.residual.begin(), verdict.residual.end(), [](const Real& r) { return is_negligible(r); });
    if (!rest) {
      page_.note(say("With the scene's values this is no rest: nothing is concluded."));
      return;
    }
    page_.note(say("With the scene's values: {}.", verdict.reason));
  }

  void hurwitz(const AtState& at) {
    page_.section(say("Routh and Hurwitz, linearised equations"));
    if (!equations_.constraints().empty()) {
      page_.note(
          say("Cannot conclude here: the scene has constraints; the kernel linearisation reduces them, and the runtime "
              "finds the eigenvalues."));
      return;
    }
    const std::size_t n = statics_.rows.size();
    if (n > most_freedoms) {
      page_.note(
          say("Not written: {} freedoms, and formulas are for {} at most; the runtime finds the eigenvalues.", n,
              most_freedoms));
      return;
    }
    const Linearisation linear = linearisation(equations_);
    for (const ValueMatrix* matrix : {&linear.M, &linear.C, &linear.K}) {
      if (std::none_of(matrix->begin(), matrix->end(), [&](const auto& row) { return depend_on_time(row); })) continue;
      page_.note(
          say("Cannot conclude: M, C or K depends on time, and such equations can grow although every root has Re s < 0 at "
              "every instant; where they are periodic, the multipliers of Floquet decide."));
      return;
    }
    ValueMatrix matrices = linear.M;
    for (const ValueMatrix* matrix : {&linear.C, &linear.K}) matrices.insert(matrices.end(), matrix->begin(), matrix->end());
    if (lies_between_forms(equations_.bias(), matrices, at)) return;
    const ValueMatrix M = at(linear.M), C = at(linear.C), K = at(linear.K);
    Program& program = equations_.program();
    std::vector<Value> polynomial, conditions;
    try {
      polynomial = characteristic_polynomial(program, M, C, K);
      conditions = hurwitz_conditions(program, polynomial);
    } catch (const UsageError& error) {
      page_.note(say("Not written: {}.", error.what()));
      return;
    }
    page_.note(say("det(M s^2 + C s + K) has the coefficients"));
    for (std::size_t k = 0; k < polynomial.size(); ++k) {
      page_.equation("", fmt::format("a{}", polynomial.size() - 1 - k), polynomial[k]);
    }
    const bool zero = std::any_of(conditions.begin(), conditions.end(),
                                  [](const Value& c) { return c.is_zero() || identically_zero(c); });
    if (zero) {
      page_.note(
          say("Cannot conclude that it is stable: a determinant of Hurwitz vanishes whatever the parameters, so that "
              "some root has Re s >= 0."));
      if (!is_no_rest(at)) report_roots(polynomial);
      return;
    }
    write_conditions(say("All roots have Re s < 0, and the rest is asymptotically stable, exactly where"), conditions,
                     say("all roots have Re s < 0"));
    const auto signs = signs_at_scene_values(conditions);
    if (!signs) return;
    if (is_no_rest(at)) {
      page_.note(say("With the scene's values this is no rest: nothing is concluded."));
      return;
    }
    const bool marginal = std::find(signs->begin(), signs->end(), 0) != signs->end();
    const bool stable = std::all_of(signs->begin(), signs->end(), [](int sign) { return sign > 0; });
    conclude(marginal ? say("cannot conclude, a condition is an equality")
             : stable ? say("asymptotically stable")
                      : say("unstable, a root has Re s > 0"));
  }

  void conclude(const std::string& verdict) {
    page_.note(rest_is_proved_ ? say("With the scene's values: {}.", verdict)
                               : say("With the scene's values: {}, if this is a rest.", verdict));
  }

  /// Whether the scene's values tell that some force is left over at the state.
  bool is_no_rest(const AtState& at) {
    const std::vector<Value> rows = at(statics_.rows);
    const auto values = scene_values({rows});
    if (!values) return false;
    const WorkingDigits precision(digits);
    Evaluator<Real> evaluate(equations_.program(), *values);
    return std::any_of(rows.begin(), rows.end(), [&](const Value& row) { return !is_negligible(evaluate(row)); });
  }

  /// Counted exactly where the scene's values make numbers of the coefficients. Elsewhere a negative coefficient still tells of a
  /// root with Re s > 0.
  void report_roots(const std::vector<Value>& polynomial) {
    if (const std::optional<RootCount> roots = roots_at_scene_values(polynomial)) {
      conclude(roots->right > 0 ? say("unstable, a root has Re s > 0")
                                : say("no root has Re s > 0, and {} of {} have Re s = 0", roots->imaginary + roots->zero,
                                      polynomial.size() - 1));
      return;
    }
    const auto signs = signs_at_scene_values(polynomial);
    const bool negative = signs && std::find(signs->begin(), signs->end(), -1) != signs->end();
    if (negative) conclude(say("unstable, for a coefficient is negative"));
  }

  /// Inputs are taken as zero. Nothing where a coefficient is no exact number then, or the first one is zero.
  std::optional<RootCount> roots_at_scene_values(const std::vector<Value>& polynomial) {
    Program& program = equations_.program();
    std::optional<Substitution> with_values;
    with_values.emplace(program, [&](const SymbolPointer& symbol) -> std::optional<Value> {
      if (symbol->kind == SymbolKind::input) return program.number(Number(), symbol->unit);
      for (const ParameterContent& parameter : scene_.content().parameters) {
        if (parameter.symbol == symbol && parameter.value) return (*with_values)(program.lower(*parameter.value));
      }
      return std::nullopt;
    });
    std::vector<Value> numbers;
    for (const Value& coefficient : polynomial) {
      numbers.push_back((*with_values)(coefficient));
      if (!numbers.back().is_constant()) return std::nullopt;
    }
    return numbers.front().is_zero() ? std::nullopt : routh_table(program, numbers).count;
  }

  /// "12 k m > 0" a line, or that they hold.
  void write_conditions(const std::string& heading, const std::vector<Value>& conditions, const std::string& holds) {
    if (std::any_of(conditions.begin(), conditions.end(),
                    [](const Value& c) { return c.is_zero() || identically_zero(c); })) {
      page_.note(say("Cannot conclude: a condition reads 0 > 0 whatever the parameters."));
      return;
    }
    const auto holds_always = [](const Value& c) { return c.is_constant() && c.polynomial().constant().sign() > 0; };
    if (std::all_of(conditions.begin(), conditions.end(), holds_always)) {
      page_.note(say("Whatever the parameters, {}.", holds));
      return;
    }
    page_.note(heading);
    for (const Value& condition : conditions) {
      if (!holds_always(condition)) page_.positive(condition);
    }
  }

  /// Values of all symbols when every parameter has one and nothing else than inputs, taken as zero, is left in there.
  std::optional<Evaluator<Real>::SymbolValue> scene_values(const ValueMatrix& matrix) const {
    const auto& parameters = scene_.content().parameters;
    const bool valued =
        std::all_of(parameters.begin(), parameters.end(), [](const auto& p) { return p.value.has_value(); });
    if (!valued) return std::nullopt;
    std::vector<Value> entries;
    for (const std::vector<Value>& row : matrix) entries.insert(entries.end(), row.begin(), row.end());
    for (const ValueNumber value_number : equations_.program().live(entries)) {
      const SymbolPointer& symbol = equations_.program()[value_number].symbol;
      if (symbol && (symbol->kind == SymbolKind::coordinate || symbol->kind == SymbolKind::velocity ||
                     symbol->kind == SymbolKind::time))
        return std::nullopt;
    }
    const WorkingDigits precision(digits);
    auto numbers = std::make_shared<InitialNumbers>(scene_);
    return [numbers](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::input) return Real(0);
      const Sized number = numbers->sized(symbol);
      return number.cancels() ? Real(0) : number.value;
    };
  }

  /// Signs there, 0 where terms cancel to their last digits; -1, 0 or 1 for each.
  std::optional<std::vector<int>> signs_at_scene_values(const std::vector<Value>& values) const {
    const auto numbers = scene_values({values});
    if (!numbers) return std::nullopt;
    const WorkingDigits precision(digits);
    Evaluator<Sized> evaluate(equations_.program(), [&](const SymbolPointer& symbol) { return Sized((*numbers)(symbol)); });
    std::vector<int> signs;
    for (const Value& value : values) {
      const Sized number = value.is_zero() ? Sized(Real(0)) : evaluate(value);
      signs.push_back(number.cancels() || !number.is_number() ? 0 : number.value > Real(0) ? 1 : -1);
    }
    return signs;
  }

  const Scene& scene_;
  Equations equations_;
  EquilibriumEquations statics_;
  printing::ReadablePage page_;
  const About& about_;
  PageStyle style_;
  bool rest_is_proved_ = false;  ///< whatever the parameters
  const NaturalLanguage& say;
};

}  // namespace

std::string statics_text(const Scene& scene, const About& about, const About& set, const PageStyle& style) {
  validate(scene);
  return StaticsWriter(printing::with_parameters(scene, set), about, set, style).write();
}

}  // namespace torsor
