// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/contact_laws.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/theorems/bearing_reactions.hpp"
#include "torsor/generator/printing/contact_letters.hpp"
#include "torsor/generator/printing/limit_met.hpp"
#include "torsor/generator/printing/notation.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor::printing {
namespace {

class ContactPage {
 public:
  ContactPage(const Equations& equations, const InlineLimits& limits, Page& page)
      : equations_(equations),
        contacts_(contact_rows(equations.model())),
        coefficients_(contact_coefficients(equations.model())),
        bearings_(bearing_reactions(equations)),
        view_(equations.program(), limits, equations.scene().content()),
        page_(page),
        say(page.say),
        letters_(equations.scene().content()) {
    for (const ContactRows& contact : contacts_) {
      normals_ = normals_ || contact.normal;
      turns_ = turns_ || contact.pressed_by;
      joints_ = joints_ || contact.joint;
      tangents_ = tangents_ || (contact.tangents() > 0 && !contact.pressed_by && !contact.joint);
    }
  }

  void write() {
    page_.section(say("Contacts that open and close"));
    note(normals_ ? say("g is the gap and w its rate (N) or a slip (T), of the first body on the second.")
                        : say("w is the slip."));
    for (std::size_t k = 0; k < contacts_.size(); ++k) geometry(k);
    forces();
    laws();
    percussions();
    page_.note(say("What follows of first integrals and small motions is that of the mechanism on which no contact acts."));
  }

 private:
  /// "T1" of two tangents, "T" of one, "N".
  static std::string component(const ContactRows& contact, std::size_t row) {
    if (contact.normal && row == 0) return "N";
    return contact.tangents() == 1 ? "T" : fmt::format("T{}", row + (contact.normal ? 0 : 1));
  }

  /// A sentence in the letters of this page.
  void law(const std::string& plain, const std::string& latex) { page_.formula(letters_.plain(plain), letters_.in_sentence(latex)); }
  void note(const std::string& sentence) { page_.note(letters_.plain(sentence)); }

  /// Whether it is written out.
  bool stated(const Spelling& left, const Value& value, const std::string& remark = {}) {
    const std::optional<Sum> sum = value.is_zero() ? Sum() : view_.sum(value);
    if (sum) {
      page_.stated(left, collected(*sum), remark);
    } else {
      too_long(left.plain, limit_met(view_, value, say));
    }
    return sum.has_value();
  }
  void too_long(const std::string& what, const std::string& limit) {
    page_.note(say("{} is too long to be written out ({}); the kernel contacts computes it.", what, limit));
  }

  void geometry(std::size_t k) {
    const ContactRows& contact = contacts_[k];
    const std::string who = named_object(contact.name).latex;
    const auto spelled = [&](const char* plain, const char* latex) {
      return Spelling{fmt::format("{}({})", letters_.plain(plain), contact.name), fmt::format("{}({})", letters_.latex(latex), who)};
    };
    const bool turn = contact.pressed_by.has_value();
    page_.note(contact.normal ? say("{}:", contact.name)
               : contact.joint ? say("{}, friction of a joint, pressed by what it transmits across its axis:", contact.name)
               : turn ? say("{}, w an angular velocity, pressed by {}:", contact.name, contacts_[*contact.pressed_by].name)
                      : say("{}, dry friction alone:", contact.name));
    if (contact.normal) stated(spelled("g", "g"), contact.gap);
    for (std::size_t row = 0; row < contact.rows.size(); ++row) {
      const std::string which = component(contact, row);
      const bool written = stated(spelled(("w_" + which).c_str(), ("w_{" + which + "}").c_str()), contact.rows[row].rate);
      if (!written) too_long_.push_back(&contact.rows[row]);
    }
    const ContactCoefficients& of = coefficients_[k];
    if (contact.joint) return bearing(k, spelled);
    if (turn) {
      stated(spelled("h", "h"), of.friction, say("a length"));
      return;
    }
    if (!contact.normal) {
      stated(spelled("b", "b"), of.bound, say("while it slides"));
      stated(spelled("b_s", "b_s"), of.static_bound, say("while it sticks"));
      return;
    }
    if (contact.tangents() > 0) {
      stated(spelled("f", "f"), of.friction, say("while it slides"));
      stated(spelled("f_s", "f_s"), of.static_friction, say("while it sticks"));
    }
    stated(spelled("e", "e"), of.restitution, say("restitution"));
  }

  /// R of a joint in its components, and the coefficients: lengths where it turns.
  template <class Spelled>
  void bearing(std::size_t k, const Spelled& spelled) {
    for (std::size_t c = 0; c < bearings_[k].size(); ++c) {
      const std::string which = bearings_[k].size() == 1 ? "R" : fmt::format("R{}", c + 1);
      const BearingReaction& component = bearings_[k][c];
      const Spelling name = spelled(which.c_str(), bearings_[k].size() == 1 ? "R" : fmt::format("R_{}", c + 1).c_str());
      std::optional<Sum> sum = component.without_contacts.is_zero() ? Sum() : view_.sum(component.without_contacts);
      Value too_long = sum ? Value() : component.without_contacts;
      std::size_t row = 0;
      for (const ContactRows& contact : contacts_) {
        for (std::size_t own = 0; own < contact.rows.size(); ++own, ++row) {
          if (component.by_reactions[row].is_zero() || !sum) continue;
          const std::optional<Sum> factor = view_.sum(component.by_reactions[row]);
          if (factor) {
            *sum += *factor * Sum::symbol(reaction(contact, own));
          } else {
            sum.reset();
            too_long = component.by_reactions[row];
          }
        }
      }
      if (sum) {
        page_.stated(name, collected(*sum), "");
      } else {
        this->too_long(name.plain, limit_met(view_, too_long, say));
      }
    }
    const bool turns = !coefficients_[k].friction.unit().is_dimensionless();
    stated(turns ? spelled("h", "h") : spelled("f", "f"), coefficients_[k].friction, say("while it slides"));
    stated(turns ? spelled("h_s", "h_s") : spelled("f_s", "f_s"), coefficients_[k].static_friction, say("while it sticks"));
  }

  /// Q_i = Σ_k J_ki r_k, of all contacts together.
  void forces() {
    page_.formula(say("Their reactions add Q_i = sum r dw/dq_i' to the right of Lagrange's equations, r = N or T of each w:"),
                  say("Their reactions add $Q_i = \\sum r\\, \\frac{\\partial w}{\\partial \\dot{q}_i}$ to the right of "
                  "Lagrange's equations, $r = N$ or $T$ of each $w$:"));
    const auto& coordinates = equations_.model().coordinates();
    std::string left_out;
    for (std::size_t i = 0; i < static_cast<std::size_t>(equations_.model().unknown_count()); ++i) {
      const std::string& q = coordinates[i].attitude ? coordinates[i].v->name : coordinates[i].q->name;
      if (const std::optional<Sum> force = force_along(i); !force) {
        left_out += (left_out.empty() ? "Q_" : ", Q_") + q;
      } else if (!force->is_zero()) {
        page_.stated({"Q_" + q, fmt::format("Q_{{{}}}", latex_name(q))}, collected(*force), "");
      }
    }
    if (left_out.empty()) return;
    page_.note(say("Too long to be written out: {}; the kernel contacts computes what they are made of.", left_out));
  }

  /// Nothing where it is too long to be read: so is a factor where the rate is that it belongs to.
  std::optional<Sum> force_along(std::size_t i) {
    Sum force;
    for (const ContactRows& contact : contacts_) {
      for (std::size_t row = 0; row < contact.rows.size(); ++row) {
        const Value& entry = contact.rows[row].jacobian[i];
        if (entry.is_zero()) continue;
        const bool is_read = std::find(too_long_.begin(), too_long_.end(), &contact.rows[row]) == too_long_.end();
        const std::optional<Sum> factor = is_read ? view_.sum(entry) : std::nullopt;
        if (!factor) return std::nullopt;
        force += *factor * Sum::symbol(reaction(contact, row));
        if (static_cast<int>(written_terms(force)) > view_.limits().terms) return std::nullopt;
      }
    }
    return force;
  }

  SymbolPointer reaction(const ContactRows& contact, std::size_t row) {
    const std::string name = fmt::format("{}_{}", component(contact, row), contact.name);
    for (const SymbolPointer& known : reactions_) {
      if (known->name == name) return known;
    }
    const int index = 1'000'000 + static_cast<int>(reactions_.size());
    reactions_.push_back(std::make_shared<const Symbol>(Symbol{name, Unit(), SymbolKind::parameter, index, nullptr}));
    return reactions_.back();
  }

  void laws() {
    page_.section(say("Laws of contact"));
    if (normals_) {
      law(say("Signorini: 0 <= g, 0 <= N, N g = 0; while g = 0 and w_N = 0: 0 <= dw_N/dt, 0 <= N, N dw_N/dt = 0."),
          say("Signorini: $0 \\le g$, $0 \\le N$, $N g = 0$; while $g = 0$ and $w_N = 0$: $0 \\le \\dot{w}_N$, $0 \\le "
          "N$, $N \\dot{w}_N = 0$."));
      law(say("Open: g > 0, N = 0, T = 0."), say("Open: $g > 0$, $N = 0$, $T = 0$."));
    }
    if (turns_) {
      law(say("Resistance to rolling and spinning: |T| <= h N while w_T = 0, T = -h N w_T/|w_T| while it turns, T a "
              "moment, N that of the contact that presses."),
          say("Resistance to rolling and spinning: $|T| \\le h N$ while $w_T = 0$, $T = -h N \\frac{w_T}{|w_T|}$ while "
              "it turns, $T$ a moment, $N$ that of the contact that presses."));
    }
    if (joints_) {
      law(say("Friction of joints: |T| <= f_s |R| while w_T = 0, T = -f |R| w_T/|w_T| while they slide, h_s and h in "
              "the place of f_s and f where they turn, R what the joint transmits across its axis."),
          say("Friction of joints: $|T| \\le f_s |R|$ while $w_T = 0$, $T = -f |R| \\frac{w_T}{|w_T|}$ while they "
              "slide, $h_s$ and $h$ in the place of $f_s$ and $f$ where they turn, $R$ what the joint transmits across "
              "its axis."));
    }
    if (!tangents_) return;
    const bool bounds = std::any_of(contacts_.begin(), contacts_.end(),
                                    [](const ContactRows& c) { return !c.normal && !c.pressed_by && !c.joint; });
    const std::string and_bound = bounds ? say(" (b_s of dry friction alone)") : "";
    const std::string and_bound_latex = bounds ? say(" ($b_s$ of dry friction alone)") : "";
    law(say("Sticks: w_T = 0, |T| <= f_s N{}.", and_bound),
        say("Sticks: $w_T = 0$, $|T| \\le f_s N${}.", and_bound_latex));
    law(say("Slides: T = -f N w_T/|w_T|{}; where a slip begins, along dw_T/dt in the place of w_T.",
                    bounds ? say(", b in the place of f N for dry friction alone") : ""),
        say("Slides: $T = -f N \\frac{{w_T}}{{|w_T|}}${}; where a slip begins, along $\\dot{{w}}_T$ in the "
                    "place of $w_T$.",
                    bounds ? say(", $b$ in the place of $f N$ for dry friction alone") : ""));
  }

  void percussions() {
    if (!normals_) return;
    const bool multipliers = !equations_.constraints().empty();
    page_.section(say("Percussions"));
    law(say("[[X]] = X+ - X- at an impact: [[dT/dq_i']] = sum P dw/dq_i'{}, P = P_N or P_T of each w.",
                    multipliers ? " + sum_j Lambda_j a_ji" : ""),
        say("$[\\![X]\\!] = X^+ - X^-$ at an impact: $\\left[\\!\\left[\\frac{{\\partial T}}{{\\partial "
                    "\\dot{{q}}_i}}\\right]\\!\\right] = \\sum P\\, \\frac{{\\partial w}}{{\\partial \\dot{{q}}_i}}"
                    "{}$, $P = P_N$ or $P_T$ of each $w$.",
                    multipliers ? " + \\sum_j \\Lambda_j a_{ji}" : ""));
    note(say("Impulses stand where reactions stand above; bounded forces have none."));
    law(say("Newton-Moreau: 0 <= w_N+ + e w_N-, 0 <= P_N, P_N (w_N+ + e w_N-) = 0."),
        say("Newton-Moreau: $0 \\le w_N^+ + e\\, w_N^-$, $0 \\le P_N$, $P_N (w_N^+ + e\\, w_N^-) = 0$."));
    if (joints_) note(say("Joints rub by |P_T| <= f |P_R|, P_R the impulse that they transmit."));
    if (tangents_) {
      law(say("Friction: |P_T| <= f P_N where w_T+ = 0, P_T = -f P_N w_T+/|w_T+| elsewhere."),
          say("Friction: $|P_T| \\le f P_N$ where $w_T^+ = 0$, $P_T = -f P_N \\frac{w_T^+}{|w_T^+|}$ elsewhere."));
    }
    if (moves_by_itself()) {
      law(say("Carnot's loss: T- - T+ = -1/2 sum P (w+ + w-) + sum P b{}, b what w is where all velocities are 0: surfaces that move by "
              "themselves give energy, too.",
              drives_loops() ? " - sum_j Lambda_j b_j" : ""),
          say("Carnot's loss: $T^- - T^+ = -\\frac{{1}}{{2}} \\sum P\\,(w^+ + w^-) + \\sum P\\, b{}$, $b$ what $w$ is where all "
              "velocities are 0: surfaces that move by themselves give energy, too.",
              drives_loops() ? " - \\sum_j \\Lambda_j b_j" : ""));
      return;
    }
    law(say("Carnot's loss: T- - T+ = -1/2 sum P (w+ + w-); of one contact without friction -1/2 (1 - e) P_N w_N- >= 0."),
        say("Carnot's loss: $T^- - T^+ = -\\frac{1}{2} \\sum P\\,(w^+ + w^-)$; of one contact without friction "
        "$-\\frac{1}{2} (1 - e) P_N w_N^- \\ge 0$."));
  }

  Value at_rest(const Value& rate) const {
    Program& program = equations_.program();
    Substitution rest(program, [&program](const SymbolPointer& symbol) -> std::optional<Value> {
      if (symbol->kind != SymbolKind::velocity) return std::nullopt;
      return program.number(Number(), symbol->unit);
    });
    return rest(rate);
  }

  /// Whether a surface has a velocity that none of the mechanism's is: a belt, or what a law of time moves.
  bool moves_by_itself() const {
    const auto moves = [this](const ContactRow& row) { return !identically_zero(at_rest(row.rate)); };
    return drives_loops() || std::any_of(contacts_.begin(), contacts_.end(), [&moves](const ContactRows& contact) {
      return std::any_of(contact.rows.begin(), contact.rows.end(), moves);
    });
  }
  bool drives_loops() const {
    const std::vector<ConstraintRow>& rows = equations_.constraints();
    return std::any_of(rows.begin(), rows.end(), [this](const ConstraintRow& row) { return !identically_zero(at_rest(row.rate)); });
  }

  const Equations& equations_;
  const std::vector<ContactRows> contacts_;
  const std::vector<ContactCoefficients> coefficients_;
  const std::vector<std::vector<BearingReaction>> bearings_;
  InlineView view_;
  Page& page_;
  const NaturalLanguage& say;
  const ContactLetters letters_;
  std::vector<SymbolPointer> reactions_;
  std::vector<const ContactRow*> too_long_;  ///< rates that are not written out
  bool normals_ = false, tangents_ = false, turns_ = false, joints_ = false;
};

}  // namespace

void write_contacts(const Equations& equations, const InlineLimits& limits, Page& page) {
  if (equations.scene().content().contacts.empty()) return;
  ContactPage(equations, limits, page).write();
}

}  // namespace torsor::printing
