// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/theorem_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/dynamics/motion/frame_motion.hpp"
#include "torsor/generator/dynamics/theorems/theorem_equations.hpp"
#include "torsor/generator/mechanics/uncounted_contacts.hpp"
#include "torsor/generator/printing/formula_text.hpp"
#include "torsor/generator/printing/readable_page.hpp"

namespace torsor {
namespace {

Triple direction_of(const std::string& text, const Scene& scene) {
  if (text == "x") return axis::x;
  if (text == "y") return axis::y;
  if (text == "z") return axis::z;
  std::vector<Expression> components;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    components.push_back(parse_formula(text.substr(begin, end - begin), scene));
    begin = end + 1;
  }
  if (components.size() != 3) {
    throw UsageError(fmt::format("the direction '{}' is neither x, y, z nor three components, e.g. 0,1,0", text));
  }
  if (std::all_of(components.begin(), components.end(), [](const Expression& each) { return each.is_zero(); })) {
    throw UsageError(fmt::format("the direction '{}' is the null vector: give x, y, z or a direction, e.g. 0,1,0", text));
  }
  return {components[0], components[1], components[2]};
}

}  // namespace

PointReference point_at(Scene& scene, const std::string& name) {
  const auto& points = scene.content().points;
  if (std::any_of(points.begin(), points.end(), [&](const PointContent& p) { return p.name == name; }))
    return PointReference(name);
  const auto& frames = scene.content().frames;
  const auto frame = std::find_if(frames.begin(), frames.end(), [&](const FrameContent& f) { return f.name == name; });
  if (frame == frames.end()) return PointReference(name);  // whoever looks it up names those that there are
  std::string free = name;
  std::replace(free.begin(), free.end(), '.', '_');  // of a frame within a joint
  while (scene.content().names.count("point " + free) > 0) free += "_";
  return scene.point(free, FrameHandle{static_cast<int>(frame - frames.begin())}, {0, 0, 0});
}

namespace {

void report_contacts(printing::ReadablePage& page, const Scene& scene, const NaturalLanguage& say) {
  for (const std::string& sentence : uncounted_contacts(scene.content(), say)) page.note(sentence);
}

void report_unknowns(printing::ReadablePage& page, const TheoremEquation& equation, const NaturalLanguage& say) {
  std::vector<std::string> names;
  for (const SymbolPointer& unknown : equation.unknowns) names.push_back(unknown->name);
  for (const SymbolPointer& multiplier : equation.multipliers) names.push_back(multiplier->name);
  if (names.empty()) {
    page.note(say("No unknown of a joint enters: an equation of motion."));
    return;
  }
  page.note(say("Unknown: {}.", fmt::join(names, ", ")));
  if (!equation.unknowns.empty()) {
    page.note(
        say("[joint X], Y, Z, L, M, N: force and moment on the body that the joint carries, at the origin of that "
            "body's frame, along the axes of the joint's first frame that moves."));
  }
  if (!equation.multipliers.empty()) page.note(say("Multipliers are those of the scene's constraints."));
  for (const std::string& remark : equation.remarks) page.note(remark + ".");
}

}  // namespace

std::string theorem_text(const Scene& given, const TheoremRequest& request, const PageStyle& style) {
  validate(given);
  const bool energy = request.kind == "energy", moment = request.kind == "moment";
  if (!energy && !moment && request.kind != "resultant") {
    throw UsageError(fmt::format("unknown kind '{}' of theorem: {}use resultant, moment or energy", request.kind,
                                 did_you_mean(request.kind, {"resultant", "moment", "energy"})));
  }
  if (moment && request.point.empty()) {
    throw UsageError(
        "a theorem of moment needs the point at which moments are taken: --at POINT, or a frame's name for its origin");
  }
  if (energy && (!request.point.empty() || request.direction != "x" || request.axes != "ground")) {
    throw UsageError("the energy theorem has no point and no direction: leave --at, --direction and --axes out, or ask for "
                     "--kind resultant or moment");
  }
  if (!energy && !moment && !request.point.empty()) {
    throw UsageError("the theorem of the resultant has no point: leave --at out, or ask for --kind moment");
  }
  const NaturalLanguage& say = style.language;
  Scene scene = given;
  const PointReference point = point_at(scene, request.point.empty() ? scene.content().frames[0].name : request.point);
  const Triple direction = direction_of(request.direction, scene);
  ModelOptions options;
  options.symbolic_parameters = true;
  const Equations equations(scene, options);
  const BodyNames bodies = request.bodies.empty() ? moving_bodies(equations.model()) : request.bodies;
  const std::string whom = fmt::format("{}", fmt::join(bodies, ", "));
  const std::string seen = request.observer == "ground" ? "" : say(", seen from {}", request.observer);
  printing::ReadablePage page(equations.program(), scene.content());
  if (energy) {
    const EnergyEquation theorem = energy_equation(equations, bodies, request.observer, say);
    page.section(say("Energy theorem for {}{}", whom, seen));
    page.equation("", "T", theorem.kinetic_energy, say("in J"));
    page.equation("", "P_ext", theorem.external_power, say("power of the actions from outside, in W"));
    page.equation("", "P_int", theorem.internal_power, say("power of the actions between the bodies, in W"));
    page.equation("dT/dt = P_ext + P_int", theorem.equation.left, theorem.equation.right);
    report_unknowns(page, theorem.equation, say);
    report_contacts(page, given, say);
    return page.finish(given.content(), style);
  }
  const TheoremEquation theorem =
      theorem_equation(equations, bodies,
                       {.screw = {point, request.axes, request.observer},
                        .theorem = moment ? Theorem::moment : Theorem::resultant,
                        .direction = direction},
                       say);
  page.section(say("Newton-Euler for {}: {}{} along {} of {}{}", whom, moment ? say("moment") : say("resultant"),
                   moment ? say(" at {}", request.point) : "", request.direction, request.axes, seen));
  page.equation("", theorem.left, theorem.right);
  report_unknowns(page, theorem, say);
  report_contacts(page, given, say);
  return page.finish(given.content(), style);
}

std::string screw_text(const Scene& given, const ScrewRequest& request, const PageStyle& style) {
  validate(given);
  if (request.point.empty()) {
    throw UsageError("a screw needs the point at which it is reduced: --at POINT, or a frame's name for its origin");
  }
  const NaturalLanguage& say = style.language;
  Scene scene = given;
  const ScrewQuery query{point_at(scene, request.point), request.axes, request.observer};
  ModelOptions options;
  options.symbolic_parameters = true;
  const Equations equations(scene, options);
  const Model& model = equations.model();
  const BodyNames bodies = request.bodies.empty() ? all_bodies(model) : request.bodies;
  printing::ReadablePage page(equations.program(), scene.content());
  const printing::Spelling at = printing::named_object(request.point);
  const auto column = [&](const printing::Spelling& name, const std::string& entry, const Vector& vector) {
    page.matrix(name, entry, {{vector[0]}, {vector[1]}, {vector[2]}});
  };
  page.section(say("Screws of {} at {} along the axes of {}{}", fmt::join(bodies, ", "), request.point, request.axes,
                   request.observer == "ground" ? "" : say(", seen from {}", request.observer)));
  const MomentumScrew momentum = momentum_screw(model, bodies, query);
  const DynamicScrew dynamic = dynamic_screw(model, bodies, query);
  if (bodies.size() == 1) {
    const BodyContent& body = scene.content().bodies[as_index(body_indices(model, bodies, "a screw")[0])];
    const int link = model.place(body.frame, "a screw").link;
    const Twist twist = as_asked(model, relative_twist(model, link, model.place(query.observer, "a screw").link), link, query);
    page.note(say("Twist: angular velocity [rad/s], velocity of the body's own point [m/s]."));
    column({"Omega", "\\vec{\\Omega}"}, "Omega", twist.angular);
    column({fmt::format("V({})", at.plain), fmt::format("\\vec{{V}}({})", at.latex)}, "V", twist.linear);
  }
  page.note(say("Momentum screw: [kg m/s], [N m s]."));
  column({"m V_G", "m \\vec{V}_G"}, "p", momentum.resultant);
  column({fmt::format("sigma({})", at.plain), fmt::format("\\vec{{\\sigma}}({})", at.latex)}, "sigma", momentum.moment);
  page.note(say("Dynamic screw: [N], [N m]."));
  column({"m Gamma_G", "m \\vec{\\Gamma}_G"}, "D", dynamic.resultant);
  column({fmt::format("delta({})", at.plain), fmt::format("\\vec{{\\delta}}({})", at.latex)}, "delta", dynamic.moment);
  page.note(say("Kinetic energy [J]."));
  page.equation("", "T", kinetic_energy(model, bodies, query.observer));
  return page.finish(given.content(), style);
}

}  // namespace torsor
