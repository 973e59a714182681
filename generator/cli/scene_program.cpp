// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cli/command_line.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <new>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "generator/cli/commands.hpp"
#include "generator/cli/scene_program.hpp"
#include "generator/dynamics/unknowns_report.hpp"
#include "generator/dynamics/validation.hpp"
#include "generator/emission/kernel.hpp"
#include "generator/emission/output_file.hpp"
#include "generator/expression/decimal.hpp"
#include "generator/expression/error.hpp"
#include "generator/reading/force_function_text.hpp"
#include "generator/reading/print_equations.hpp"
#include "generator/reading/statics_text.hpp"
#include "generator/reading/theorem_text.hpp"
#include "generator/verification/reference_cache.hpp"

namespace torsor {
namespace {

constexpr int check_failed = 1;
constexpr int bad_usage = 2;
constexpr int bad_scene_or_file = 3;

/// What the command line asked for.
struct Request {
  std::string format = "text";
  std::string kernels = "all";
  std::string output = "-";
  std::string run_time;
  std::string forward = "cheapest";
  std::string without;
  std::vector<std::string> about;
  std::vector<std::string> times;
  std::vector<std::string> actions, bodies;
  std::string point;
  std::string axes = "ground";
  std::string observer = "ground";
  std::string direction = "x";
  std::string theorem = "resultant";
  std::vector<std::string> inputs_outputs;
  std::string graph = "structure";
  std::string graph_format = "dot";
  int digits = 50;
  int states = 20;
  int verify_states = 64;
  int climbs = 2;
  int range = double_states.large;
  std::uint64_t seed = 1;
  std::string scalar = "both";
  std::string exceptions;
  std::string cache;
  bool every_group = false;
  bool with_states = false;
  bool markdown = false;
  bool json = false;
  bool document = false;
};

void write(const std::string& output, const std::string& text) {
  if (output == "-") {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
      throw FileError("cannot write to the standard output: is the disk full or the reader gone?");
    }
    return;
  }
  write_file_if_changed(output, text);
}

ForwardMethod forward_method(const std::string& name) {
  if (name == "cheapest") return ForwardMethod::cheapest;
  if (name == "factorisation") return ForwardMethod::factorisation;
  if (name == "articulated_body") return ForwardMethod::articulated_body;
  throw UsageError(fmt::format("unknown method '{}' in --forward: use cheapest, factorisation or articulated_body", name));
}

/// Times are positive and increase; what is wrong is quoted as the user wrote it.
void check_times(const std::vector<std::string>& times) {
  Number before;
  for (const std::string& text : times) {
    Number time;
    try {
      time = parse_decimal(text);
    } catch (const Error& error) {
      throw UsageError(fmt::format("--times: {}", error.what()));
    }
    if (!(before < time)) {
      throw UsageError(fmt::format("--times: '{}' does not come after what is before it: times are positive and increase", text));
    }
    before = time;
  }
}

ModelOptions model_options(const Scene& scene, const Request& request) {
  ModelOptions options;
  options.forward = forward_method(request.forward);
  options.passes = passes_without(request.without);
  if (request.run_time == "all") {
    options.all_run_time = true;
    return options;
  }
  for (std::size_t begin = 0; begin < request.run_time.size();) {
    const std::size_t end = std::min(request.run_time.find(',', begin), request.run_time.size());
    const std::string name = request.run_time.substr(begin, end - begin);
    begin = end + 1;
    const auto& parameters = scene.content().parameters;
    if (std::none_of(parameters.begin(), parameters.end(), [&](const auto& p) { return p.symbol->name == name; })) {
      std::string known;
      for (const auto& p : parameters) known += (known.empty() ? "" : ", ") + p.symbol->name;
      throw UsageError(fmt::format("unknown parameter '{}' in --run-time: the scene '{}' has {}", name, scene.name(),
                                   known.empty() ? "none" : known));
    }
    options.run_time.insert(name);
  }
  return options;
}

/// "theta=0" -> {"theta", "0"}
std::pair<std::string, std::string> split_assignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    throw UsageError(fmt::format("--about takes NAME=VALUE, e.g. theta=0, and got '{}'", text));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

int equations(const Scene& scene, const Request& request) {
  PrintOptions options;
  const Format format = parse_format(request.format);
  options.document = request.document;
  for (const std::string& about : request.about) options.about.push_back(split_assignment(about));
  write(request.output, print_equations(scene, format, options));
  return 0;
}

int generate(const Scene& scene, const Request& request) {
  const GeneratedHeader header =
      generate_header(scene, parse_kernel_list(request.kernels), model_options(scene, request));
  write(request.output, header.text);
  if (request.kernels == "all") return 0;  // all that there are: what is absent was not asked for
  for (const auto& [name, why] : header.absent) {
    std::fprintf(stderr, "note: the kernel %s is absent: %s\n", name.c_str(), why.c_str());
  }
  return 0;
}

int counts(const Scene& scene, const Request& request) {
  const SceneCounts counted = count_scene(scene, parse_kernel_list(request.kernels), model_options(scene, request));
  write(request.output, request.json ? counts_json({counted}) : counts_table({counted}));
  return 0;
}

int passes(const Scene& scene, const Request& request) {
  const PassReport report = report_passes(scene, parse_kernel_list(request.kernels), model_options(scene, request),
                                          {request.digits, request.verify_states, request.seed});
  write(request.output, request.json ? passes_json(report) : passes_table(report));
  return report.equal() ? 0 : check_failed;
}

int check(const Scene& scene, const Request& request) {
  const CheckOptions options{request.digits, request.states, parse_kernel_list(request.kernels)};
  const std::vector<CheckResult> results = check_scene(scene, options);
  write(request.output, request.json ? check_json(scene.name(), results) : check_table(scene.name(), results));
  const bool passed = std::all_of(results.begin(), results.end(), [](const CheckResult& r) { return r.passed(); });
  return passed ? 0 : check_failed;
}

std::string file_text(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw FileError(fmt::format("cannot read '{}': does it exist, and may you read it?", path));
  return {std::istreambuf_iterator<char>(stream), {}};
}

int verify(const Scene& scene, const Request& request) {
  VerifyOptions options;
  options.model = model_options(scene, request);
  options.kernels = parse_kernel_list(request.kernels);
  options.digits = request.digits;
  options.states = request.verify_states;
  options.climbs = request.climbs;
  options.seed = request.seed;
  options.range = request.range;
  if (request.scalar == "double") options.precisions = {Precision::in_double};
  if (request.scalar == "float") options.precisions = {Precision::in_float};
  if (!request.exceptions.empty()) options.exceptions = parse_accuracy_exceptions(file_text(request.exceptions));
  const std::vector<VerifyRow> rows = verify_scene(scene, options);
  std::string text = verify_table(scene.name(), rows, {request.every_group, request.with_states});
  if (request.json) text = verify_json(scene.name(), rows);
  if (request.markdown) text = verify_markdown(scene.name(), rows);
  write(request.output, text);
  return std::all_of(rows.begin(), rows.end(), [](const VerifyRow& row) { return row.passed(); }) ? 0 : check_failed;
}

int reference(const Scene& scene, const Request& request) {
  check_times(request.times);
  const ReferenceOptions options{request.digits, request.times};
  write(request.output,
        request.cache.empty() ? reference_csv(scene, options) : cached_reference_csv(scene, options, request.cache));
  return 0;
}

int list(const Scene& scene, const Request& request) {
  write(request.output, request.json ? list_json(scene) : list_text(scene));
  return 0;
}

int force_function(const Scene& scene, const Request& request) {
  write(request.output, force_function_text(scene, {request.actions, request.bodies}));
  return 0;
}

int unknowns(const Scene& scene, const Request& request) {
  if (request.bodies.empty() != request.point.empty()) {
    throw UsageError("--isolate BODIES and --at POINT go together: the point at which moments are taken");
  }
  ModelOptions options;
  options.symbolic_parameters = true;
  const Equations equations(scene, options);
  std::string text = unknowns_report(equations);
  if (!request.bodies.empty()) text += isolation_report(equations, request.bodies, {request.point, request.axes}).text;
  write(request.output, text);
  return 0;
}

int theorem(const Scene& scene, const Request& request) {
  write(request.output, theorem_text(scene, {request.theorem, request.bodies, request.point, request.direction,
                                             request.axes, request.observer}));
  return 0;
}

int statics(const Scene& scene, const Request& request) {
  std::vector<std::pair<std::string, std::string>> about;
  for (const std::string& each : request.about) about.push_back(split_assignment(each));
  write(request.output, statics_text(scene, about));
  return 0;
}

int structure(const Scene& scene, const Request& request) {
  write(request.output, request.json ? structure_json(scene, request.inputs_outputs)
                                     : structure_text(scene, request.inputs_outputs));
  return 0;
}

int graph(const Scene& scene, const Request& request) {
  write(request.output, graph_text(scene, request.graph_format, request.graph, request.inputs_outputs));
  return 0;
}

using Command = int (*)(const Scene&, const Request&);

/// Declares the commands; the chosen one is left in `chosen`.
void declare(CLI::App& app, Request& request, Command& chosen, const SceneSource& source) {
  app.require_subcommand(1);
  const auto add = [&](const char* name, const char* text, Command command) {
    CLI::App* sub = app.add_subcommand(name, text);
    if (source.add_options) source.add_options(*sub);
    sub->callback([&chosen, command] { chosen = command; });
    sub->add_option("-o,--output", request.output, "file to write; the standard output when absent or -");
    return sub;
  };
  const auto with_kernel_list = [&](CLI::App* sub) {
    sub->add_option("--kernels", request.kernels,
                    fmt::format("comma-separated list of {}; or all (the default), which leaves out second derivatives "
                                "and sensitivities",
                                fmt::join(kernel_names(), ", ")));
    return sub;
  };
  const auto with_kernels = [&](CLI::App* sub) {
    with_kernel_list(sub);
    sub->add_option("--run-time", request.run_time, "parameters that stay symbols, comma-separated, or all");
    sub->add_option("--forward", request.forward,
                    "method of forward_dynamics: cheapest, factorisation or articulated_body")
        ->capture_default_str();
    std::string passes;
    for (const PassName& pass : pass_names()) passes += fmt::format("{}{}", passes.empty() ? "" : ", ", pass.name);
    sub->add_option("--without", request.without, "passes to leave out, comma-separated: " + passes);
    return sub;
  };
  const auto with_json = [&](CLI::App* sub) { sub->add_flag("--json", request.json, "print JSON"); };
  const auto with_states = [&](CLI::App* sub) {
    sub->add_option("--digits", request.digits, "digits of CLN, more where the error depends on them")
        ->capture_default_str()
        ->check(CLI::Range(20, 1000));
    sub->add_option("--states", request.verify_states, "number of states to begin with")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000));
    sub->add_option("--seed", request.seed, "of the first state")->capture_default_str();
    return sub;
  };

  CLI::App* sub = add("equations", "print T, U, Lagrange's equations, constraints, linearisation", equations);
  sub->add_option("--format", request.format, "text or latex")->capture_default_str();
  sub->add_option("--about", request.about, "state of the linearisation, NAME=VALUE, e.g. theta=0; repeatable");
  sub->add_flag("--document", request.document, "LaTeX: a whole document");
  sub = with_kernels(add("generate", "write the specialised C++17 header", generate));
  sub->get_option("--output")->required()->description("file to write; - for the standard output");
  with_json(with_kernels(add("counts", "count the operations of the emitted kernels", counts)));
  with_json(with_states(with_kernels(
      add("passes", "tell what each pass saves, that it changes no result, and what it does to errors", passes))));
  sub = with_kernel_list(add("check", "compare independent derivations at random states", check));
  sub->add_option("--digits", request.digits, "digits of the comparison")
      ->capture_default_str()
      ->check(CLI::Range(20, 1000));
  sub->add_option("--states", request.states, "number of states")->capture_default_str()->check(CLI::Range(1, 1000000));
  with_json(sub);
  sub = with_states(with_kernels(
      add("verify", "find the worst errors of the kernels in double and float, against CLN", verify)));
  sub->add_option("--climbs", request.climbs, "searches for a worse state, for each group of results")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  sub->add_option("--range", request.range, "sizes of states go up to 2^±RANGE, in float to 2^±10 at most")
      ->capture_default_str()
      ->check(CLI::Range(4, double_states.large));
  sub->add_option("--scalar", request.scalar, "double, float or both")
      ->capture_default_str()
      ->check(CLI::IsMember({"double", "float", "both"}));
  sub->add_option("--exceptions", request.exceptions,
                  "file of groups that may exceed the bar: scene | kernel | group | scalar | limit | reason");
  sub->add_flag("--all", request.every_group, "every group of results, not the worst of each kernel only");
  sub->add_flag("--markdown", request.markdown, "print one row of the table in docs/accuracy.md");
  sub->add_flag("--show-states", request.with_states, "print the state of each row");
  with_json(sub);
  sub = add("reference", "integrate the motion in high precision by an independent road", reference);
  sub->add_option("--digits", request.digits, "digits of the result")
      ->capture_default_str()
      ->check(CLI::Range(10, 1000));
  sub->add_option("--times", request.times, "comma-separated times in seconds, increasing")->required()->delimiter(',');
  sub->add_option("--cache", request.cache, "folder that keeps references, so that none is integrated twice");
  sub = add("force-function", "tell whether actions have a potential energy, a force function or neither", force_function);
  sub->add_option("--actions", request.actions, "names, comma-separated; gravity is the weight; all when absent")
      ->delimiter(',');
  sub->add_option("--bodies", request.bodies, "bodies on which they are counted; both ends of all when absent")
      ->delimiter(',');
  sub = add("unknowns", "count unknowns against equations, and tell which theorem gives which reaction", unknowns);
  sub->add_option("--isolate", request.bodies, "bodies to isolate, comma-separated")->delimiter(',');
  sub->add_option("--at", request.point, "point at which their moments are taken");
  sub->add_option("--axes", request.axes, "frame along whose axes the theorems are written")->capture_default_str();
  sub =
      add("theorem", "write Newton-Euler's theorem or the energy theorem for some bodies, reactions by name", theorem);
  sub->add_option("--kind", request.theorem, "resultant, moment or energy")->capture_default_str();
  sub->add_option("--bodies", request.bodies, "bodies to isolate, comma-separated; all when absent")->delimiter(',');
  sub->add_option("--at", request.point, "point at which moments are taken, or a frame for its origin");
  sub->add_option("--direction", request.direction, "x, y, z or components 0,1,0")->capture_default_str();
  sub->add_option("--axes", request.axes, "frame along whose axes the direction is given")->capture_default_str();
  sub->add_option("--observer", request.observer, "frame from which motion is seen")->capture_default_str();
  sub = add("statics", "equations of equilibrium; at a state also its stability by Lejeune-Dirichlet and Hurwitz",
            statics);
  sub->add_option("--about", request.about, "the state, NAME=VALUE, e.g. theta=0; repeatable");
  const auto with_inputs = [&](CLI::App* command) {
    command->add_option("--inputs-outputs", request.inputs_outputs,
                        "joints that count as those with the outside, comma-separated; those of the ground when absent")
        ->delimiter(',');
    return command;
  };
  with_json(with_inputs(add("structure", "count loops, mobility and redundancy; name what is internal or indeterminate",
                            structure)));
  sub = with_inputs(add("graph", "draw the graph of bodies and joints", graph));
  sub->add_option("--format", request.graph_format, "dot (for Graphviz) or svg")->capture_default_str();
  sub->add_option("--of", request.graph, "structure, analysis (with constraints and actions) or reduced")->capture_default_str();
  with_json(add("list", "print what the scene contains and the kernels it offers", list));
}

}  // namespace

int run_commands(int argc, const char* const* argv, const SceneSource& source) {
  const auto fail = [argv](const std::string& message, int code) {
    std::fprintf(stderr, "%s: %s\n", argv[0], message.c_str());
    return code;
  };
  CLI::App app{source.description};
  Request request;
  Command chosen = nullptr;
  try {
    declare(app, request, chosen, source);
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    const auto is_first_word = [argv](const CLI::App* command) { return command->get_name() == argv[1]; };
    if (argc > 1 && argv[1][0] != '-' && std::none_of(commands.begin(), commands.end(), is_first_word)) {
      return fail(
          fmt::format("unknown command '{}': use equations, generate, counts, passes, check, verify, reference, "
                      "force-function, unknowns, theorem, statics, structure, graph or list; see --help",
                      argv[1]),
          bad_usage);
    }
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    const int code = app.exit(help, text, text);
    try {
      write("-", text.str());
    } catch (const Error& error) {
      return fail(error.what(), bad_scene_or_file);
    }
    return code;
  } catch (const CLI::ParseError& error) {
    return fail(fmt::format("{}; see --help", error.what()), bad_usage);
  }
  try {
    if (request.kernels != "all") parse_kernel_list(request.kernels);  // before the scene is even built
    const Scene scene = source.make();
    validate(scene);
    return chosen(scene, request);
  } catch (const UsageError& error) {
    return fail(error.what(), bad_usage);
  } catch (const Error& error) {
    return fail(error.what(), bad_scene_or_file);
  } catch (const std::exception& error) {
    return fail(fmt::format("unexpected failure: {}", error.what()), bad_scene_or_file);
  }
}

int run_scene_program(int argc, const char* const* argv, Scene (*make_scene)()) {
  return run_commands(argc, argv, {"Equations of motion and specialised kernels of one mechanism.", {}, make_scene});
}

}  // namespace torsor
