// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/report.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/base64.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/cli/katex.hpp"
#include "torsor/generator/cli/start_state.hpp"
#include "torsor/generator/dynamics/equations/massless.hpp"
#include "torsor/generator/dynamics/theorems/equilibrium_equations.hpp"
#include "torsor/generator/dynamics/theorems/unknowns_report.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/javascript_module.hpp"
#include "torsor/generator/emission/text_template.hpp"
#include "torsor/generator/printing/html_text.hpp"
#include "torsor/generator/printing/page.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "torsor/generator/printing/statics_text.hpp"

namespace torsor {
namespace {

/// A template without the line that names its licence, which the page says once.
std::string part(std::string_view name, const NaturalLanguage& say) {
  const std::string_view text = embedded_template(fmt::format("report/{}", name));
  return say.said_in(text.substr(text.find('\n') + 1));
}

std::string bytes_of(std::string_view hexadecimal) {
  const auto digit = [](char c) { return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10); };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2) {
    bytes += static_cast<char>(digit(hexadecimal[i]) << 4 | digit(hexadecimal[i + 1]));
  }
  return bytes;
}

/// KaTeX's rules without its own font faces, and those fonts that the page carries.
std::string formula_style() {
  std::string style(katex_style());
  for (std::size_t at = style.find("@font-face"); at != std::string::npos; at = style.find("@font-face", at)) {
    style.erase(at, style.find('}', at) + 1 - at);
  }
  for (const KatexFont& font : katex_fonts()) {
    const std::string name(font.name);
    const std::string family = name.substr(0, name.find('-'));
    style += fmt::format(
        "@font-face{{font-family:KaTeX_{};font-weight:{};font-style:{};src:url(data:font/woff2;base64,{}) "
        "format('woff2')}}\n",
        family, name.find("Bold") == std::string::npos ? 400 : 700,
        name.find("Italic") == std::string::npos ? "normal" : "italic", base64(bytes_of(font.digits)));
  }
  return style;
}

bool same_redundancy(const Scene& scene, const ModelOptions& a, const ModelOptions& b) {
  return Equations(scene, a).redundancy().kept == Equations(scene, b).redundancy().kept;
}

/// All parameters are left to the reader of the page where they can be. One whose value is a formula of others follows these.
ModelOptions options_of_motion(const Scene& scene, const ModelOptions& given) {
  constexpr std::size_t most = 40;  // parameters that a page can offer: a robot has hundreds
  if (given.all_run_time || !given.run_time.empty() || scene.content().parameters.size() > most) return given;
  const auto follows = [](const ParameterContent& each) {
    return !each.run_time && each.value && !each.value->symbols().empty();
  };
  ModelOptions all = given;
  for (const ParameterContent& parameter : scene.content().parameters) {
    if (!follows(parameter)) all.run_time.insert(parameter.symbol->name);
  }
  if (all.run_time.size() == scene.content().parameters.size()) {
    all.run_time.clear();
    all.all_run_time = true;
  }
  if (scene.content().constraints.empty()) return all;
  try {
    if (same_redundancy(scene, given, all)) return all;
  } catch (const SceneError&) {
  }
  return given;
}

struct Motion {
  std::string module = "null";
  std::string remark;     ///< why there is none
  std::string recording;  ///< JSON, of a motion that the page plays back
  std::string given;      ///< JSON: start values and inputs that replace the scene's; empty: none
  std::string invented;   ///< parameters without a value, for which the page takes 1
  bool varies_in_time = false;  ///< time enters the masses or the forces at rest: there are no modes
};

std::vector<std::string> without_value(const SceneContent& content) {
  std::vector<std::string> names;
  for (const ParameterContent& parameter : content.parameters) {
    if (!parameter.value) names.push_back(parameter.symbol->name);
  }
  return names;
}

/// The page cannot solve contacts: it plays back what was moved here.
Motion recorded_motion(const Scene& scene, const ReportOptions& options) {
  Motion motion;
  if (const std::vector<std::string> open = without_value(scene.content()); !open.empty()) {
    motion.remark = options.language("the parameter '{}' has no value, and a page that plays a motion back needs one: give it in the scene",
                                     open.front());
    return motion;
  }
  try {
    motion.recording = report_recording(scene, options);
    motion.module = module_as_object(emit_javascript(lower_mechanism(scene, {"energy", "first_integrals", "poses"}, options.model)));
  } catch (const Error& error) {
    const bool asked = !options.initial.empty() || !options.inputs.empty();  // for names that the scene may not have
    if (asked && dynamic_cast<const UsageError*>(&error) != nullptr) throw;
    motion.recording.clear();
    motion.remark = error.what();
  }
  return motion;
}

/// Where `simulate` starts with these values: the page starts there too.
std::vector<double> start_of_simulate(const Scene& scene, const ReportOptions& options) {
  NamedNumbers parameters;
  for (const std::string& name : without_value(scene.content())) parameters[name] = 1.0;  // as motion.js
  EvaluatedMotion motion(scene, options.model, parameters, {});
  return closed_start(motion, options.initial);
}

std::string given_values(const Scene& scene, const Model& model, const ReportOptions& options) {
  const auto names = [](const std::vector<SymbolPointer>& symbols) {
    std::vector<std::string> all;
    for (const SymbolPointer& symbol : symbols) all.push_back(symbol->name);
    return all;
  };
  std::vector<std::string> known = names(model.positions());
  for (int i = 0; i < model.unknown_count(); ++i) known.push_back(model.coordinates()[static_cast<std::size_t>(i)].v->name);
  require_known(options.initial, known, "coordinate or rate", "--initial");
  require_whole_quaternions(scene.content(), options.initial);
  require_known(options.inputs, names(model.inputs()), "input", "--input");
  if (options.initial.empty() && options.inputs.empty()) return {};
  nlohmann::ordered_json given{{"initial", options.initial}, {"inputs", options.inputs}};
  const bool constrained = !scene.content().constraints.empty() && model.unknown_count() > 0;
  if (constrained && !options.initial.empty()) given["closed"] = start_of_simulate(scene, options);
  return given.dump();
}

Motion motion_of(const Scene& scene, const ReportOptions& options) {
  const SceneContent& content = scene.content();
  if (!content.contacts.empty()) return recorded_motion(scene, options);
  const ModelOptions& given = options.model;
  std::vector<std::string> names{"forward_dynamics", "energy", "first_integrals", "poses"};
  const bool constrained = !content.constraints.empty();
  constexpr std::size_t most = 12;  // freedoms, attitudes' too, whose modes a reader looks at one by one
  if (constrained) names.emplace_back("constraints");  // and M: projection in its metric
  const bool modes = content.coordinates.size() <= most;
  if (constrained || modes) names.emplace_back("mass_matrix");
  const ModelOptions left_to_reader = options_of_motion(scene, given);
  const MechanismListing mechanism = lower_mechanism(scene, names, left_to_reader);
  Motion motion;
  for (const AskedKernel& kernel : mechanism.asked) {
    if (kernel.name == "forward_dynamics" && !kernel.skipped.empty()) {
      motion.remark = lack_of_mass(*mechanism.equations, options.language);
    }
  }
  motion.module = module_as_object(emit_javascript(mechanism));
  motion.given = given_values(scene, mechanism.equations->model(), options);
  motion.invented = fmt::format("{}", fmt::join(without_value(content), ", "));
  if (modes) motion.varies_in_time = equilibrium_equations(Equations(scene, left_to_reader)).depends_on_time;
  return motion;
}

/// What another command says, or why it cannot.
template <class Say>
std::string words(const Say& say) {
  try {
    return say();
  } catch (const Error& error) {
    return error.what();
  }
}

/// The same where HTML is expected. Names that the command line gives (`asked`) and the scene does not have end the command.
template <class Say>
std::string markup(const Say& say, bool asked = false) {
  try {
    return say();
  } catch (const Error& error) {
    if (asked && dynamic_cast<const UsageError*>(&error) != nullptr) throw;
    return fmt::format("<p>{}</p>\n", html_escaped(error.what()));
  }
}

std::string picture(const Scene& scene, const std::string& kind, const NaturalLanguage& say) {
  return markup([&] { return graph_text(scene, {.kind = kind, .format = "svg"}, say); });
}

/// Sections that would fill more than a reader reads are left out, and the page says so.
std::string without_long_sections(const std::string& sections, const std::string& command, const NaturalLanguage& say) {
  constexpr std::size_t most = 120'000;  // characters
  static constexpr std::string_view begin = "<details", title_end = "</summary>\n", end = "</details>\n";
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = sections.find(begin); at != std::string::npos; at = sections.find(begin, done)) {
    const std::size_t body = sections.find(title_end, at) + title_end.size(), close = sections.find(end, body);
    const bool too_long = close - body > most;
    result += sections.substr(done, (too_long ? body : close) - done);
    if (too_long) result += "<p>" + html_escaped(say("Too long for a page, above {} characters: the command {} prints it.", most, command)) + "</p>\n";
    done = close;
  }
  return result + sections.substr(done);
}

std::string unknowns_page(const Scene& scene, const NaturalLanguage& say) {
  ModelOptions options;
  options.symbolic_parameters = true;
  return printing::words_as_page(unknowns_report(Equations(scene, options), say), scene.content(), {Format::html, false, say});
}

/// The same with sections that are folded at first.
std::string closed(std::string sections) {
  const std::string open = "<details open>";
  for (std::size_t at = sections.find(open); at != std::string::npos; at = sections.find(open, at)) {
    sections.replace(at, open.size(), "<details>");
  }
  return sections;
}

std::string note(const std::string& sentence) { return fmt::format("<p class=\"note\">{}</p>\n", html_escaped(sentence)); }

std::string motion_note(const Motion& motion, const NaturalLanguage& say) {
  if (!motion.remark.empty()) return note(say("There is no motion: {}.", motion.remark));
  if (motion.recording.empty()) {
    if (motion.invented.empty()) return "";
    return note(say("The scene gives these parameters no value, and the motion here takes 1 for them until a slider says otherwise: {}.",
                    motion.invented));
  }
  return note(say("This motion is recorded: torsor moved the mechanism from event to event of its contacts when it wrote this page, "
                  "and the page plays that back. Parameters and start values cannot be changed here. The commands report and "
                  "simulate move the mechanism again."));
}

std::string script(std::string_view id, const std::string& text) {
  return fmt::format("<script id=\"{}\">\n{}</script>\n", id, inside_script(text));
}

}  // namespace

std::string module_as_object(const std::string& module) {
  std::string body, names;
  for (std::size_t begin = 0; begin < module.size();) {
    const std::size_t end = std::min(module.find('\n', begin), module.size());
    std::string line = module.substr(begin, end - begin);
    begin = end + 1;
    static constexpr std::string_view mark = "export ";
    if (line.starts_with(mark)) {
      line.erase(0, mark.size());
      const std::size_t name = line.find(' ') + 1;
      names += (names.empty() ? "" : ", ") + line.substr(name, line.find_first_of(" (", name) - name);
    }
    body += line + "\n";
  }
  return "(() => {\n\"use strict\";\n" + body + "return { " + names + " };\n})()";
}

std::string inside_script(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += text[i];
    // "</" and "<!" in strings and in patterns mean the same behind a backslash; elsewhere they do not occur.
    if (text[i] == '<' && i + 1 < text.size() && (text[i + 1] == '/' || text[i + 1] == '!')) result += '\\';
  }
  return result;
}

std::string inside_json(const std::string& text) {
  std::string result;
  for (const char c : text) c == '<' ? result += "\\u003c" : result += c;
  return result;
}

std::string report_html(const Scene& scene, const ReportOptions& options) {
  if (!(options.duration > 0 && std::isfinite(options.duration))) throw UsageError("--to must be a time above 0");
  const SceneContent& content = scene.content();
  const NaturalLanguage& say = options.language;
  const Motion motion = motion_of(scene, options);
  PrintOptions print;
  print.about = options.about;
  print.derivation = true;
  print.language = say;
  const bool about = !options.about.empty();
  const std::string equations =
      without_long_sections(markup([&] { return print_equations(scene, Format::html, print); }, about), "equations", say);
  std::string scripts;
  scripts += script("mechanism", "globalThis.torsorMechanism = " + motion.module + ";\n" +
                                     (motion.varies_in_time ? "torsorMechanism.variesInTime = true;\n" : "") +
                                     (content.frictions.empty() ? "" : "torsorMechanism.rubsAtRest = true;\n"));
  scripts += fmt::format("<script id=\"scene\" type=\"application/json\">{}</script>\n",
                         inside_json(report_data(scene, options.duration)));
  if (options.meshes) {
    scripts += fmt::format("<script id=\"meshes\" type=\"application/json\">{}</script>\n", report_meshes(content));
  }
  if (!motion.given.empty()) {
    scripts += fmt::format("<script id=\"given\" type=\"application/json\">{}</script>\n", inside_json(motion.given));
  }
  if (!motion.recording.empty()) {
    scripts += fmt::format("<script id=\"recording\" type=\"application/json\">{}</script>\n", inside_json(motion.recording));
  }
  if (!options.reference.empty()) {
    scripts += fmt::format("<script id=\"reference\" type=\"application/json\">{}</script>\n",
                           inside_json(report_reference(content, options.reference)));
  }
  for (const char* name : {"integrator", "projection", "motion", "playback", "modes", "vectors", "surfaces", "framing", "shapes",
                           "viewer", "plots", "formulas", "page"}) {
    scripts += script(fmt::format("script-{}", name), part(fmt::format("{}.js", name), say));
  }
  const bool with_katex = !katex_script().empty();
  const std::string title = content.title.empty() ? content.name : content.title;
  return fill_template(
      "report/report.html", say.said_in(embedded_template("report/report.html")),
      {{"title", html_escaped(title)},
       {"name", html_escaped(content.name)},
       {"version", TORSOR_VERSION},
       {"language", std::string(say.code())},
       {"style", part("style.css", say)},
       {"formula_style", formula_style()},
       {"structure_graph", picture(scene, "structure", say)},
       {"analysis_graph", picture(scene, "analysis", say)},
       {"structure_words", html_lines(words([&] { return structure_text(scene, {}, say); }))},
       {"equations", equations},
       {"further", closed(markup([&] { return unknowns_page(scene, say); }))},
       // A state to linearise about need not be a rest: its section then says so.
       {"statics", closed(without_long_sections(
                       markup([&] { return statics_text(scene, options.about, {}, {Format::html, false, say}); }), "statics", say))},
       {"formula_note",
        with_katex ? "" : note(say("Formulas are shown as text: KaTeX was not there when torsor was built."))},
       {"motion_note", motion_note(motion, say)},
       {"origin_of_motion",
        html_escaped(motion.recording.empty() ? say("The motion is integrated here by the kernels that torsor generates, with Dormand and "
                                                    "Prince's method of order 8.")
                                              : say("The motion was recorded when torsor wrote this page."))},
       {"katex", with_katex ? script("katex", std::string(katex_script()) + "\n") : ""},
       {"scripts", scripts}});
}

}  // namespace torsor
