// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/print_equations.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/mechanics/freedom_positions.hpp"
#include "torsor/generator/printing/contact_laws.hpp"
#include "torsor/generator/printing/definitions_view.hpp"
#include "torsor/generator/printing/derivation.hpp"
#include "torsor/generator/printing/eliminated_multipliers.hpp"
#include "torsor/generator/printing/first_integrals.hpp"
#include "torsor/generator/printing/integrable_conditions.hpp"
#include "torsor/generator/printing/kinks_of_state.hpp"
#include "torsor/generator/printing/lagrange_equations.hpp"
#include "torsor/generator/printing/linearised_equations.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/printing/page.hpp"
#include "torsor/generator/printing/reduced_equations.hpp"
#include "torsor/generator/printing/unused_parameters.hpp"

namespace torsor {
namespace printing {
namespace {

/// Names as formulas of LaTeX in a sentence.
std::vector<std::string> dollars(const std::vector<std::string>& names) {
  std::vector<std::string> formulas;
  for (const std::string& name : names) formulas.push_back("$" + latex_name(name) + "$");
  return formulas;
}

/// Writes the equations of one scene on one page.
class Printer {
 public:
  Printer(const Scene& scene, const PrintOptions& options, Page& page)
      : scene_(scene), options_(options), page_(page), say(page.say), equations_(scene, {options.terms, options.expansion}, options.derivation) {
    gather_long_results();
  }

  void print() {
    page_.title(scene_.content());
    parameters();
    coordinates();
    std::optional<Derivation> derivation;
    if (options_.derivation) {
      // A step is read, or it is no step: a fifth of what an equation may have.
      derivation.emplace(scene_, InlineLimits{options_.terms / 5, options_.expansion / 4}, page_);
      derivation->screws();
      derivation->kinetic_energies();
    }
    energies();
    if (derivation) {
      derivation->partial_derivatives(equations_.equations());
      derivation->forces();
    }
    lagrange();
    constraints();
    equations_without_multipliers();
    write_contacts(equations_.definitions(), {options_.terms, options_.expansion}, page_);
    write_first_integrals(equations_.definitions(), {options_.terms, options_.expansion}, page_, equations_.stretches());
    if (derivation) derivation->reactions();
    if (options_.linearisation) linearisation();
    definitions();
  }

 private:
  void gather_long_results() {
    std::vector<Value> results;
    const auto gather = [&results](const Quantity& quantity) {
      if (!quantity.sum) results.push_back(quantity.value);
    };
    gather(equations_.kinetic_energy());
    gather(equations_.force_function());
    for (std::size_t i = 0; i < equations_.equations().size(); ++i) {
      const LagrangeEquation& equation = equations_.equations()[i];
      if (equation.written_out()) continue;
      results.push_back(equation.inertia.value);
      for (const auto& arms : equations_.definitions().actions().inputs) results.push_back(arms[i]);
    }
    for (const ConstraintEquation& constraint : equations_.constraints()) gather(constraint.left);
    if (!results.empty()) definitions_.emplace(equations_.definitions().program(), results);
  }

  Written written(const Quantity& quantity, const Layout& layout = {}) const {
    return collected(quantity.sum ? *quantity.sum : definitions_->sum(quantity.value), layout);
  }

  void say_too_long(const std::string& what, const Quantity& quantity) {
    page_.note(
        say("{} too long to be written out (up to {:.2g} terms before anything cancels; limits: {} of "
            "those, {} to be read): named definitions are at the end.",
            what, quantity.terms, options_.expansion, options_.terms));
  }

  void parameters() {
    if (scene_.content().parameters.empty()) return;
    page_.section(say("Parameters"));
    for (const ParameterContent& parameter : scene_.content().parameters) {
      const std::optional<Sum> value =
          parameter.value ? equations_.view().sum(equations_.program().lower(*parameter.value)) : std::nullopt;
      if (value) {
        const bool number = level(*value) <= Level::constant;
        page_.value(*parameter.symbol, collected(*value), number);
      } else {
        page_.symbol(*parameter.symbol, parameter.value ? "" : say("given at run time"));
      }
    }
    const std::vector<std::string> unused = parameters_without_use(equations_);
    if (unused.empty()) return;
    const std::vector<std::string> formulas = dollars(unused);
    page_.formula(say("In no equation: {}.", fmt::join(unused, ", ")), say("In no equation: {}.", fmt::join(formulas, ", ")));
  }

  void coordinates() {
    const SceneContent& scene = scene_.content();
    page_.section(say("Coordinates"));
    for (const CoordinateContent& c : scene.coordinates) {
      if (c.law) continue;
      if (!c.attitude) {
        page_.symbol(*c.q, c.released ? say("released: held at zero by the joint, its reaction is asked for") : "");
        continue;
      }
      for (const SymbolPointer& e : positions_with(scene, c)) page_.symbol(*e, say("component of a unit quaternion"));
      page_.symbol(*c.v, say("angular velocity in moving axes"));
    }
    for (const CoordinateContent& c : scene.coordinates) {
      if (!c.law) continue;
      for (const SymbolPointer& name : {c.q, c.v, c.a}) {
        const std::optional<Sum> law = equations_.view().law(name);
        if (law) page_.value(*name, collected(*law), level(*law) <= Level::constant);
      }
    }
    const std::vector<SymbolPointer> inputs = equations_.definitions().model().inputs();
    if (!inputs.empty()) page_.section(say("Inputs"));
    for (const SymbolPointer& input : inputs) page_.symbol(*input, "");
    if (!equations_.constraints().empty()) page_.section(say("Multipliers"));
    for (const ConstraintEquation& constraint : equations_.constraints()) {
      page_.symbol(*constraint.multiplier, say("of the constraint {}", constraint.name));
    }
    const Equations& equations = equations_.definitions();
    if (equations.constraints().empty()) return;
    for (const std::string& sentence : notes(equations.redundancy(), scene_, say)) page_.note(sentence);
  }

  void energies() {
    const auto print = [this](const std::string& heading, const std::string& name, const std::string& sentence,
                              const Quantity& quantity, const std::vector<KeptPiece>& pieces) {
      page_.section(heading);
      if (!quantity.sum) say_too_long(sentence, quantity);
      page_.equation("", named(name),
                     quantity.sum ? collected_around(*quantity.sum, pieces, equations_.view()) : written(quantity), "");
    };
    print(say("Kinetic energy [J]"), "T", say("The kinetic energy is"), equations_.kinetic_energy(), {});
    print(say("Force function [J]"), "U", say("The force function is"), equations_.force_function(),
          energy_pieces(equations_.stretches(), 1));
  }

  /// Σ_k ∂e_k/∂q_i u_k and the reaction: what stands on the right of an equation given by definitions.
  Written driving_side(std::size_t i) const {
    const Equations& equations = equations_.definitions();
    const std::vector<SymbolPointer> inputs = equations.model().inputs();
    Sum right;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      right += definitions_->sum(equations.actions().inputs[k][i]) * Sum::symbol(inputs[k]);
    }
    const SymbolPointer& reaction = equations_.equations()[i].reaction;
    if (reaction) right += Sum::symbol(reaction);
    return collected(right);
  }

  void lagrange() {
    page_.section(say("Lagrange's equations"));
    const bool multipliers = !equations_.constraints().empty();
    page_.formula(
        say("P_i = d/dt(dT/dq_i') - dT/dq_i on the left, the generalised forces Q_i{} on the right.",
                    multipliers ? " + sum_j lambda_j a_ji" : ""),
        say("$P_i = \\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}t}}\\frac{{\\partial T}}{{\\partial \\dot{{q}}_i}} - "
                    "\\frac{{\\partial T}}{{\\partial q_i}}$ on the left, the generalised forces $Q_i{}$ on the right.",
                    multipliers ? " + \\sum_j \\lambda_j a_{ji}" : ""));
    if (!scene_.content().attitudes.empty()) {
      page_.formula(
          say("Along the angular velocity w of an attitude, P = d/dt(dT/dw) + w x dT/dw, less the derivative of T along the "
              "same turn."),
          say("Along the angular velocity $\\omega$ of an attitude, $P = \\frac{\\mathrm{d}}{\\mathrm{d}t}\\frac{\\partial "
              "T}{\\partial \\omega} + \\omega \\wedge \\frac{\\partial T}{\\partial \\omega}$, less the derivative of "
              "$T$ along the same turn."));
    }
    const Quantity* longest = nullptr;
    for (const LagrangeEquation& equation : equations_.equations()) {
      if (equation.written_out()) continue;
      if (longest == nullptr || equation.inertia.terms > longest->terms) longest = &equation.inertia;
    }
    if (longest != nullptr) say_too_long(say("Equations below with everything but the inputs on the left are"), *longest);
    for (std::size_t i = 0; i < equations_.equations().size(); ++i) {
      const LagrangeEquation& equation = equations_.equations()[i];
      const Layout layout{equation.coordinate.a};
      if (!equation.written_out()) {
        page_.equation(equation.coordinate.q->name, written(equation.inertia, layout), driving_side(i), "");
        continue;
      }
      Sum right = *equation.force.sum;
      if (equation.reaction) right += Sum::symbol(equation.reaction);
      page_.equation(equation.coordinate.q->name, collected(*equation.inertia.sum, layout),
                     collected_around(right, force_pieces(equations_.stretches(), i), equations_.view()), "");
    }
  }

  void constraints() {
    if (equations_.constraints().empty()) return;
    page_.section(say("Constraints"));
    for (const ConstraintEquation& constraint : equations_.constraints()) {
      if (constraint.left.sum && constraint.left.sum->is_zero()) {
        page_.note(say("{} ({}) holds whatever the motion: it is no equation, and its multiplier is 0.", constraint.name,
                       constraint.holonomic ? say("holonomic") : say("non-holonomic")));
        continue;
      }
      if (!constraint.left.sum) say_too_long(say("The constraint {} is", constraint.name), constraint.left);
      Written left = written(constraint.left);
      // x^2 + y^2 - l^2 = 0 rather than -l^2 + x^2 + y^2 = 0.
      const auto is_plus = [](const WrittenTerm& term) { return term.coefficient.sign() > 0; };
      if (constraint.holonomic && !left.empty() && !is_plus(left[0])) std::stable_partition(left.begin(), left.end(), is_plus);
      page_.equation("", left, {},
                     constraint.holonomic ? say("{}, holonomic", constraint.name) : say("{}, non-holonomic", constraint.name));
    }
    for (const IntegrableCondition& condition : integrable_conditions(equations_)) {
      const std::string names = fmt::format("{}", fmt::join(condition.constraints, ", "));
      page_.stated({say("constant"), say("\\text{constant}")}, collected(condition.constant),
                   condition.constraints.size() == 1 ? say("{} is integrable", names) : say("{} are integrable together", names));
    }
  }

  void equations_without_multipliers() {
    const std::optional<FreeEquations> free = without_multipliers(equations_);
    if (!free) return;
    page_.section(say("Equations without multipliers"));
    const bool one = free->dependent.size() == 1, one_left = free->equations.size() == 1;
    const auto sentence = [&](const std::vector<std::string>& names) {
      const std::string from = fmt::format("{}", fmt::join(names, ", "));
      return one ? one_left ? say("The multipliers from the equation of {}, put into the other:", from)
                            : say("The multipliers from the equation of {}, put into the others:", from)
             : one_left ? say("The multipliers from the equations of {}, put into the other:", from)
                        : say("The multipliers from the equations of {}, put into the others:", from);
    };
    page_.formula(sentence(free->dependent), sentence(dollars(free->dependent)));
    if (!scene_.content().contacts.empty()) page_.note(say("They are those of the mechanism on which no contact acts."));
    for (const FreeEquation& equation : free->equations) {
      Sum left, right;
      for (const auto& [product, coefficient] : equation.residual.terms()) {
        const bool accelerates = std::any_of(product.begin(), product.end(), [](const Power& power) {
          return power.base->level == Level::acceleration;
        });
        if (accelerates) left.add(product, coefficient);
        else right.add(product, -coefficient);
      }
      // A minus before all that accelerates says nothing.
      const Written accelerating = collected(left, {equation.coordinate.a});
      if (std::all_of(accelerating.begin(), accelerating.end(), [](const WrittenTerm& t) { return t.coefficient.sign() < 0; })) {
        left = Number(-1) * left;
        right = Number(-1) * right;
      }
      page_.equation(equation.coordinate.q->name, collected(left, {equation.coordinate.a}), collected(right), "");
    }
    if (!free->can_fail()) return;
    page_.note(say("They hold where det C is not zero, C the factors of the multipliers in the equations that gave them:"));
    page_.stated({"det C", "\\det \\mathbf{C}"}, collected(free->determinant), "");
  }

  void linearisation() {
    page_.section(say("Linearised equations"));
    if (!equations_.written_out()) {
      page_.note(
          say("Not printed, because the equations are too long to be written out: generate the kernel linearisation."));
      return;
    }
    std::size_t terms = 0;
    for (const LagrangeEquation& equation : equations_.equations()) terms += equation.inertia.sum->size();
    if (options_.about.empty() && static_cast<int>(terms) > options_.terms) {
      page_.note(
          say("Not printed about any state, because the equations have {} terms together (limit {}): name "
              "a state by --about, or generate the kernel linearisation.",
              terms, options_.terms));
      return;
    }
    const LinearisedEquations linear = linearised(equations_, scene_, options_.about);
    page_.formula(say("M e'' + C e' + K e = F + E u, e the deviation from the state, in the order of the coordinates."),
                  say("$\\mathbf{M} \\ddot{\\varepsilon} + \\mathbf{C} \\dot{\\varepsilon} + \\mathbf{K} \\varepsilon = "
                  "\\mathbf{F} + \\mathbf{E} u$, $\\varepsilon$ the "
                  "deviation from the state, in the order of the coordinates."));
    if (!scene_.content().attitudes.empty()) {
      page_.formula(say("Along an attitude e is a turn in its moving axes; e' and e'' stand for w and w', w the deviation of its "
                        "angular velocity omega, w = de/dt + omega x e."),
                    say("Along an attitude $\\varepsilon$ is a turn in its moving axes; $\\dot{\\varepsilon}$ and "
                        "$\\ddot{\\varepsilon}$ stand for $w$ and $\\dot{w}$, $w$ the deviation of its angular velocity "
                        "$\\omega$, $w = \\frac{\\mathrm{d}\\varepsilon}{\\mathrm{d}t} + \\omega \\wedge \\varepsilon$."));
    }
    std::string state;
    for (const auto& [name, formula] : options_.about) state += fmt::format("{}{} = {}", state.empty() ? "" : ", ", name, formula);
    page_.note(state.empty() ? say("About any state without acceleration.")
                             : say("About {}; velocities and accelerations not named are zero.", state));
    if (!equations_.constraints().empty()) {
      page_.formula(say("At fixed multipliers, in all coordinates: A' dlambda and the linearised constraints come beside it."),
                    say("At fixed multipliers, in all coordinates: $\\mathbf{A}^{\\mathsf{T}}\\, \\delta\\lambda$ and the linearised "
                        "constraints come beside it."));
      if (!options_.about.empty()) what_the_state_leaves();
    }
    if (!options_.about.empty()) kinks();
    matrix("M", linear.M);
    matrix("C", linear.C);
    matrix("K", linear.K);
    matrix("F", column(linear.F), true);
    matrix("E", linear.E);
    if (!equations_.constraints().empty()) reduced_linearisation();
  }

  /// About a state that violates a constraint there is no motion that the matrices describe.
  void what_the_state_leaves() {
    for (const ConstraintLeft& each : constraints_left(scene_, {options_.terms, options_.expansion}, options_.about)) {
      const std::string what = each.rate ? say("the rate of {}", each.name) : each.name;
      const std::string verdict =
          each.open ? say("{}: must hold at this state", what) : say("{}: does not hold at this state", what);
      if (each.left) {
        page_.equation("", collected(*each.left), {}, verdict);
      } else {
        page_.note(say("What the state leaves of {} must vanish; it is too long to be written out.", what));
      }
    }
  }

  /// About a state where forces have two values, or slopes, the matrices are those of one form alone, or of none.
  void kinks() {
    const Equations& equations = equations_.definitions();
    AtState::Named state;
    for (const auto& [symbol, value] : named_state(scene_, options_.about)) state.emplace_back(symbol, value);
    const Kinks kinks = kinks_of_state(equations, state);
    if (kinks.conditions.empty()) return;
    page_.note(say("There is no linearisation: forces or their slopes have two values at this state, one on either side of"));
    InlineView view(equations.program(), {options_.terms, options_.expansion}, scene_.content());
    for (const Value& condition : kinks.conditions) {
      if (const std::optional<Sum> written = view.sum(condition)) {
        page_.equation("", collected(*written), {}, "");
      } else {
        page_.note(say("a condition that is too long to be written out"));
      }
    }
    if (!kinks.laws.empty()) page_.note(say("Laws with two forms there: {}.", fmt::format("{}", fmt::join(kinks.laws, ", "))));
    page_.note(say("The matrices are those of one form, or of what stands between them."));
  }

  static SumMatrix column(const std::vector<Sum>& entries) {
    SumMatrix rows;
    for (const Sum& sum : entries) rows.push_back({sum});
    return rows;
  }

  /// In independent freedoms, without multipliers' deviations.
  void reduced_linearisation() {
    page_.section(say("Linearised equations in independent freedoms"));
    // Entries are quotients: what is longer than a fifth of an equation nobody reads.
    const int most = options_.terms / 5;
    std::optional<ReducedEquations> reduced;
    try {
      reduced = reduced_equations(scene_, {most, options_.expansion}, options_.about);
    } catch (const SceneError& error) {
      page_.note(say("Not reduced: {}.", error.what()));
      return;
    }
    if (!reduced) {
      page_.note(options_.about.empty() ? say("An entry has more than {} terms: name a state by --about, or generate the kernel linearisation.", most)
                                        : say("An entry has more than {} terms: generate the kernel linearisation.", most));
      return;
    }
    // Four pages of quotients are not read either.
    const std::size_t together = reduced->terms();
    const int most_together = options_.terms / 2;
    if (options_.about.empty() && static_cast<int>(together) > most_together) {
      page_.note(say("The entries have {} terms together (limit {}): name a state by --about, or generate the kernel linearisation.",
                     together, most_together));
      return;
    }
    if (reduced->velocities.empty()) {
      page_.note(say("None is left: the constraints determine all velocities."));
      return;
    }
    const auto listed = [](const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); };
    if (reduced->rates_are_velocities()) {
      page_.formula(say("M_r e'' + C_r e' + K_r e = F_r + E_r u, e the deviations of the freedoms below; the others follow."),
                    say("$\\mathbf{M}_r \\ddot{e} + \\mathbf{C}_r \\dot{e} + \\mathbf{K}_r e = \\mathbf{F}_r + \\mathbf{E}_r u$, $e$ "
                        "the deviations of the freedoms below; the others follow."));
      page_.formula(say("Independent: {}. Multipliers are those of the state.", listed(reduced->coordinates)),
                    say("Independent: {}. Multipliers are those of the state.", listed(dollars(reduced->coordinates))));
    } else {
      page_.formula(say("M_r w' + C_r w + K_r e = F_r + E_r u, e' = D e + N w, e and w the deviations below; the others follow."),
                    say("$\\mathbf{M}_r \\dot{w} + \\mathbf{C}_r w + \\mathbf{K}_r e = \\mathbf{F}_r + \\mathbf{E}_r u$, $\\dot{e} = "
                        "\\mathbf{D} e + \\mathbf{N} w$, $e$ and $w$ the deviations below; the others follow."));
      page_.formula(say("e: of {}; w: of the rates of {}. Multipliers are those of the state.", listed(reduced->coordinates),
                        listed(reduced->velocities)),
                    say("$e$: of {}; $w$: of the rates of {}. Multipliers are those of the state.", listed(dollars(reduced->coordinates)),
                        listed(dollars(reduced->velocities))));
    }
    const auto write = [this](const std::string& name, const SumMatrix& entries, bool right_side = false) {
      matrix({name + "_r", fmt::format("\\mathbf{{{}}}_r", name)}, name + "_r", entries, right_side);
    };
    write("M", reduced->M);
    write("C", reduced->C);
    write("K", reduced->K);
    write("F", column(reduced->F), true);
    write("E", reduced->E);
    if (reduced->rates_are_velocities()) return;
    matrix("D", reduced->D);
    matrix("N", reduced->N);
  }

  void matrix(const std::string& name, const SumMatrix& entries, bool right_side = false) {
    matrix(bold(name), name, entries, right_side);
  }

  /// A right side is written term by term, as that of an equation.
  void matrix(const Spelling& name, const std::string& entry, const SumMatrix& matrix, bool right_side) {
    std::vector<std::vector<Written>> rows;
    for (const auto& row : matrix) {
      std::vector<Written> entries;
      for (const Sum& sum : row) entries.push_back(right_side ? collected(sum) : collected_entry(sum));
      rows.push_back(std::move(entries));
    }
    page_.matrix(name, entry, rows);
  }

  void definitions() {
    const auto products = equations_.named_products();
    if (!definitions_ && products.empty()) return;
    page_.section(say("Definitions"));
    for (const auto& [product, sum] : products) {
      page_.equation("", named(product.symbol->name), collected(sum), say("normal of the plane times axis of the disc at {}", product.point));
    }
    if (!definitions_) return;
    for (const DefinitionsView::Line& line : definitions_->lines()) {
      page_.equation("", collected(Sum::definition(line.number)), line.right, meaning_of(line, say));
    }
  }

  const Scene& scene_;
  const PrintOptions& options_;
  Page& page_;
  const NaturalLanguage& say;
  LagrangeEquations equations_;
  std::optional<DefinitionsView> definitions_;
};

}  // namespace
}  // namespace printing

std::string print_equations(const Scene& scene, Format format, const PrintOptions& options) {
  validate(scene);
  const std::unique_ptr<printing::Page> page = printing::page_of({format, options.document, options.language});
  printing::Printer(scene, options, *page).print();
  return page->finish();
}

Format parse_format(const std::string& name) {
  if (name == "text") return Format::text;
  if (name == "latex") return Format::latex;
  throw UsageError(fmt::format("unknown format '{}': {}use text or latex", name, did_you_mean(name, {"text", "latex"})));
}

}  // namespace torsor
