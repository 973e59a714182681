// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/contact_simulation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/evaluated_contacts.hpp"
#include "torsor/generator/cli/start_state.hpp"
#include "torsor/generator/cli/within_contact_step.hpp"
#include "torsor/generator/program/written_unit.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"

namespace torsor {
namespace {

using runtime::ContactEventKind;
using runtime::ContactRegime;
using runtime::ContactStatus;

const char* word_of(ContactEventKind kind, bool has_normal) {
  switch (kind) {
    case ContactEventKind::impact: return "impact of";
    case ContactEventKind::opens: return has_normal ? "opens:" : "is let go:";
    case ContactEventKind::slips: return "begins to slide:";
    case ContactEventKind::slip_ends: return "stops sliding:";
    case ContactEventKind::accumulation: return "end of the bounces of";
  }
  return "";
}

ContactRecord::EventKind kind_of(ContactEventKind kind) {
  using Kind = ContactRecord::EventKind;
  switch (kind) {
    case ContactEventKind::impact: return Kind::impact;
    case ContactEventKind::opens: return Kind::opens;
    case ContactEventKind::slips: return Kind::slips;
    case ContactEventKind::slip_ends: return Kind::slip_ends;
    case ContactEventKind::accumulation: return Kind::accumulation;
  }
  return Kind::impact;
}

std::string events_in_words(std::int64_t count, const NaturalLanguage& say) {
  return count == 1 ? say("one event") : say("{} events", count);
}

/// Decisions of regimes are taken between events too, where nothing changes.
std::string decisions_in_words(std::int64_t count, const NaturalLanguage& say) {
  return count == 1 ? say("one decision") : say("{} decisions", count);
}

/// Why a motion ended.
std::string reason_of(const runtime::ContactResult& end, const NaturalLanguage& say) {
  const auto known = [&say](std::string_view words) { return say.known(std::string(words)); };
  if (end.status != ContactStatus::integration_failed) return known(describe(end.status));
  if (end.integration_event != runtime::EventStatus::integration_failed && end.integration_event != runtime::EventStatus::reached_end) {
    return say("the integration between events failed: {}", known(describe(end.integration_event)));
  }
  // No integration failed: the mechanism could not be evaluated at its start or at an event.
  if (end.integration) return say("the accelerations, or positions that fulfil the constraints, could not be found");
  if (end.integration.status == runtime::IntegrationStatus::model_failure) {
    return say("the integration between events failed: {}", known(describe(end.integration.evaluation)));
  }
  return say("the integration between events failed: {}", known(describe(end.integration.status)));
}

static_assert(static_cast<std::size_t>(runtime::ImpactLaw::poisson) == 1 &&
              static_cast<std::size_t>(runtime::ImpactLaw::energetic) == 2 &&
              static_cast<std::size_t>(runtime::ImpactLaw::sequential) == 3);

runtime::ImpactLaw law_named(const std::string& name) {
  const auto named = std::find(impact_law_names.begin(), impact_law_names.end(), name);
  if (named != impact_law_names.end()) return static_cast<runtime::ImpactLaw>(named - impact_law_names.begin());
  throw UsageError(fmt::format("unknown law '{}' in --impact-law: {}use {}", name,
                               did_you_mean(name, {impact_law_names.begin(), impact_law_names.end()}),
                               fmt::join(impact_law_names, ", ")));
}

/// Moves a scene, whose state has room for more in an array of fixed size: what is more stays zero.
class ContactSimulation {
 public:
  static constexpr std::size_t most_numbers = 128;
  static constexpr auto most_contacts = static_cast<std::size_t>(runtime::most_contacts);
  using State = std::array<double, most_numbers>;

  ContactSimulation(const Scene& scene, EvaluatedContacts& contacts, const SimulationOptions& options, ContactRecord& record,
                    const NaturalLanguage& say)
      : contacts_(contacts), options_(options), record_(record), result_(record.motion), mechanism_(contacts),
        watched_(scene, contacts.motion(), options.events), say_(say) {}

  void run(const std::vector<double>& start) {
    if (options_.method == "radau") run_by<runtime::RadauIia5>(start);
    else run_by<runtime::DormandPrince853>(start);
  }

 private:
  template <class Method>
  void run_by(const std::vector<double>& start) {
    State y{};
    std::copy(start.begin(), start.end(), y.begin());
    // Components that are there for room make the norm of the error smaller.
    const double share = std::sqrt(static_cast<double>(start.size()) / static_cast<double>(y.size()));
    tolerance_ = std::max(options_.tolerance * share, 1e-15);
    const Method method{.relative_tolerance = tolerance_, .absolute_tolerance = tolerance_};
    Watch watch{*this};
    runtime::ContactOptions laws;
    laws.law = law_named(options_.impact_law);
    laws.impact_without_collision = options_.impact_without_collision;
    runtime::ContactRun<most_numbers, most_contacts, Method, Watch> motion(mechanism_, y, method, laws, watch);
    motion_ = &motion.motion();
    if (motion.start(0.0)) write(motion.motion(), 0.0, y, start.size());
    const auto last = static_cast<long>(std::ceil(options_.duration / options_.step * (1 - 1e-12)));
    for (long k = 1; k <= last && motion.result(); ++k) {
      const double t = k == last ? options_.duration : static_cast<double>(k) * options_.step;
      next_row_ = t;
      if (motion.advance(t)) write(motion.motion(), t, y, start.size());
      if (options_.progress) options_.progress(t / options_.duration);
    }
    const runtime::ContactResult& end = motion.result();
    result_.steps = static_cast<decltype(result_.steps)>(end.integration.statistics.accepted);
    result_.remarks.push_back(say_("forces and impulses of contacts fulfil the laws of contact to {:.1g} of the largest",
                                   end.worst_residual));
    if (!end && !ended_) {
      const std::string dead = dead_centre(motion.motion(), end, y);
      const std::string why = reason_of(end, say_) + of_contact(end) + of_regimes(motion.motion(), end, y);
      result_.status = dead.empty() ? say_("{} at t = {:.9g} s", why, end.time) : dead;
    }
    if (end.ambiguous > 0) {
      result_.remarks.push_back(say_("in {} several motions fulfil the laws of contact: one was taken",
                                     decisions_in_words(end.ambiguous, say_)));
    }
    if (end.indeterminate > 0) {
      result_.remarks.push_back(say_("in {} reactions are indeterminate: other ones give the same motion",
                                     decisions_in_words(end.indeterminate, say_)));
    }
    if (end.order_matters > 0) {
      result_.remarks.push_back(say_("at {} the sequential law of impact depends on the order of contacts: another one gives "
                                     "other velocities", events_in_words(end.order_matters, say_)));
    }
  }

  struct Watch {
    ContactSimulation& simulation;
    bool operator()(const runtime::ContactEvent& event) const {
      // That of an accumulation is the limit of its impacts, which may be later.
      const bool now = event.kind != ContactEventKind::accumulation;
      if (now && !simulation.look(event.time, event.before)) return false;
      simulation.tell(event);
      return true;
    }
    bool operator()(const double& t, const State& y) const { return simulation.look(t, y); }
  };

  /// A step has ended, or a contact's event has set the state anew: rows where what is watched has passed zero since the last
  /// time, in the regimes that there were then. False where that ends the motion.
  bool look(double t, std::span<const double> y) {
    if (watched_.empty()) return true;
    std::vector<double> state(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(record_.numbers));
    const WithinContactStep<most_numbers> now(*motion_, t, std::move(state), tolerance_);
    std::swap(motion_->states, states_);
    motion_->changed();
    const bool goes_on = !last_ || write_between(*last_, now);
    std::swap(motion_->states, states_);
    motion_->changed();
    states_ = motion_->states;
    last_ = now.copy();
    return goes_on;
  }

  bool write_between(const MotionIntegrator& before, const MotionIntegrator& after) {
    for (const MetEvent& event : watched_.between(before, after)) {
      result_.events.push_back(fmt::format("{} at t = {:.15g} s", event.name, event.time));
      State there{};
      std::copy(event.motion->state().begin(), event.motion->state().end(), there.begin());
      if (event.ends || event.time < next_row_) write(*motion_, event.time, there, record_.numbers);
      ended_ = event.ends;
      if (ended_) return false;
    }
    return true;
  }

  std::string of_contact(const runtime::ContactResult& end) const {
    if (!end.contact || *end.contact >= contacts_.count()) return "";
    return fmt::format("; contact '{}'", contacts_.name(*end.contact));
  }

  /// Where the laws of contact end the motion: in which state, and which regimes there were and were found.
  std::string of_regimes(const runtime::ContactMotion& motion, const runtime::ContactResult& end, const State& y) const {
    const bool none = end.status == ContactStatus::no_solution || end.status == ContactStatus::no_impact ||
                      end.status == ContactStatus::not_found;
    if (!none && end.status != ContactStatus::jams && end.status != ContactStatus::energy_gained) return "";
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < record_.numbers; ++i) numbers.push_back(fmt::format("{} = {:.9g}", result_.names[1 + i], y[i]));
    const std::string regimes = regimes_of([&motion](int i) {
      const runtime::ContactState& state = motion.states[static_cast<std::size_t>(i)];
      return state.touches ? state.regime : ContactRegime::open;
    });
    std::string text = say_("; regimes until then: {}", regimes);
    if (none) text += say_("; regimes found: none");
    return text + say_("; state: {}", fmt::format("{}", fmt::join(numbers, ", ")));
  }

  template <class RegimeOf>
  std::string regimes_of(const RegimeOf& regime_of) const {
    std::vector<std::string> regimes;
    for (int i = 0; i < contacts_.count(); ++i) {
      regimes.push_back(contacts_.name(i) + " " + contacts_.regime(i, regime_of(i)));
    }
    return fmt::format("{}", fmt::join(regimes, ", "));
  }

  /// A dead centre: what a contact acts along is held by the loops, whatever the mechanism does.
  std::string dead_centre(runtime::ContactMotion& motion, const runtime::ContactResult& end, const State& y) const {
    if (end.status != ContactStatus::integration_failed || !motion.read(end.time, y)) return {};
    for (int i = 0; i < motion.count(); ++i) {
      if (!motion.states[static_cast<std::size_t>(i)].touches) continue;
      for (int row = motion.first_row(i); row < motion.first_row(i + 1); ++row) {
        if (motion.W()(row, row) > 0) continue;  // ContactDynamics leaves nothing of a row that loops hold
        return say_("at t = {:.9g} s the mechanism is at a dead centre of '{}', where the loops hold what it acts on and its force is "
                    "not determined: end the motion before (--to), or start elsewhere (--initial)", end.time, contacts_.name(i));
      }
    }
    return {};
  }

  void tell(const runtime::ContactEvent& event) {
    if (event.kind == ContactEventKind::impact && result_.rows.empty() && result_.before.empty()) {
      result_.before.assign(1, 0.0);
      for (std::size_t i = 0; i < record_.numbers; ++i) result_.before.push_back(event.before[i]);
    }
    std::string text = fmt::format("{} {} at t = {:.15g} s", word_of(event.kind, contacts_.rule(event.contact).normal),
                                   contacts_.name(event.contact), event.time);
    if (event.energy_lost != 0) text += fmt::format(", energy lost {:.6g} J", event.energy_lost);
    record_.events.push_back({kind_of(event.kind), event.time, static_cast<std::size_t>(event.contact), event.energy_lost,
                              letters([&event](std::size_t i) { return event.contacts[i]; })});
    std::vector<std::string> regimes;
    for (int i = 0; i < contacts_.count(); ++i) {
      const runtime::ContactState& state = event.contacts[static_cast<std::size_t>(i)];
      if (state.touches) regimes.push_back(fmt::format("{} {}", contacts_.name(i), contacts_.regime(i, state.regime)));
    }
    text += regimes.empty() ? "; then all are open" : fmt::format("; then {}", fmt::join(regimes, ", "));
    if (event.order_matters) text += "; another order of contacts gives other velocities";
    text += others("; other impulses are possible: ", event.struck) + others("; other regimes are possible: ", event.found);
    result_.events.push_back(std::move(text));
  }

  /// Regimes of all solutions but the one that was taken.
  std::string others(std::string_view first, std::span<const runtime::PerContact<ContactRegime>> found) const {
    std::string text;
    for (std::size_t k = 1; k < found.size(); ++k) {
      text += k == 1 ? first : " or ";
      text += regimes_of([&](int i) { return found[k][static_cast<std::size_t>(i)]; });
    }
    return text;
  }

  template <class StateOf>
  ContactRecord::Regimes letters(const StateOf& state_of) const {
    ContactRecord::Regimes regimes;
    for (int i = 0; i < contacts_.count(); ++i) {
      const runtime::ContactState& state = state_of(static_cast<std::size_t>(i));
      if (!state.touches) regimes += 'o';
      else if (contacts_.rule(i).tangents == 0) regimes += 'c';
      else if (state.regime == ContactRegime::open) regimes += 'o';
      else regimes += state.regime == ContactRegime::slides ? 'd' : 's';
    }
    return regimes;
  }

  void write(runtime::ContactMotion& motion, double t, const State& y, std::size_t size) {
    const std::vector<double> state(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(size));
    std::vector<double> row{t};
    row.insert(row.end(), state.begin(), state.end());
    const std::vector<double> observed = contacts_.motion().observe(t, state);
    row.insert(row.end(), observed.begin(), observed.end());
    const bool solved = motion.solve(t, y) == runtime::Evaluation::ok;
    for (int i = 0; i < motion.count(); ++i) {
      if (motion.rule(i).normal) row.push_back(motion.reading().gap[static_cast<std::size_t>(i)]);
      for (int k = motion.first_row(i); k < motion.first_row(i + 1); ++k) {
        row.push_back(solved ? motion.reactions()(k) : std::nan(""));
      }
    }
    result_.rows.push_back(std::move(row));
    record_.regimes.push_back(letters([&motion](std::size_t i) { return motion.states[i]; }));
  }

  EvaluatedContacts& contacts_;
  const SimulationOptions& options_;
  ContactRecord& record_;
  Simulation& result_;
  const EvaluatedMechanism mechanism_;
  WatchedEvents watched_;
  runtime::ContactMotion* motion_ = nullptr;
  std::unique_ptr<MotionIntegrator> last_;  ///< where what is watched was looked at last
  runtime::PerContact<runtime::ContactState> states_{};  ///< and the regimes there
  double tolerance_ = 0, next_row_ = 0;
  bool ended_ = false;  ///< by what is watched
  const NaturalLanguage& say_;
};

void add_columns(EvaluatedContacts& contacts, ContactRecord& record) {
  Simulation& result = record.motion;
  const auto add = [&](const std::string& name, const std::string& unit) {
    result.names.push_back(name);
    result.units.push_back(unit);
  };
  EvaluatedMotion& motion = contacts.motion();
  add("time", "s");
  for (const SymbolPointer& symbol : motion.symbols()) add(symbol->name, written_unit(*symbol));
  for (const EvaluatedMotion::Observed& each : motion.observed()) add(each.name, each.unit);
  record.numbers = motion.symbols().size();
  for (const SymbolPointer& input : motion.equations().model().inputs()) record.inputs.push_back(input->name);
  for (int i = 0; i < contacts.count(); ++i) {
    const runtime::ContactRule rule = contacts.rule(i);
    ContactRecord::Contact contact{contacts.name(i), rule.normal, {}, contacts.gap_unit(i), contacts.force_unit(i)};
    if (rule.normal) {
      add(contact.name + "_gap", contact.gap_unit);
      contact.reactions.emplace_back("N");
    }
    for (int k = 0; k < rule.tangents; ++k) contact.reactions.push_back(rule.tangents == 1 ? "T" : fmt::format("T{}", k + 1));
    for (const std::string& reaction : contact.reactions) add(fmt::format("{}_{}", contact.name, reaction), contact.unit);
    record.contacts.push_back(std::move(contact));
  }
  require_distinct_columns(result);
}

}  // namespace

bool has_contacts(const Scene& scene) { return !scene.content().contacts.empty(); }

ContactRecord record_contacts(const Scene& scene, const SimulationOptions& options, const NaturalLanguage& say) {
  if (!options.project) {
    throw UsageError("--no-projection is for motions without contacts: those with contacts are put back on them");
  }
  if (options.method != "dp853" && options.method != "radau") {
    throw UsageError(fmt::format("--method {} is for motions without contacts: those with contacts are moved from event to event "
                                 "by dp853 or radau",
                                 options.method));
  }
  EvaluatedContacts contacts(scene, options.model, options.parameters, options.inputs);
  ContactRecord record;
  add_columns(contacts, record);
  EvaluatedMotion& motion = contacts.motion();
  const std::vector<double> y = closed_start(motion, options.initial);
  if (y.size() > ContactSimulation::most_numbers ||
      static_cast<std::size_t>(contacts.count()) > ContactSimulation::most_contacts) {
    throw UsageError(fmt::format(
        "the scene '{}' has {} coordinates and velocities and {} contacts, and simulate moves scenes with contacts up to "
        "{} and {}: generate its header and move it by runtime/contacts (docs/contacts.md)",
        scene.name(), y.size(), contacts.count(), ContactSimulation::most_numbers, ContactSimulation::most_contacts));
  }
  ContactSimulation(scene, contacts, options, record, say).run(y);
  return record;
}

Simulation simulate_contacts(const Scene& scene, const SimulationOptions& options) {
  return record_contacts(scene, options).motion;
}

}  // namespace torsor
