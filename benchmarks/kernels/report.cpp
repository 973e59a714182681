// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/kernels/report.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "torsor/runtime/records/plot.hpp"

namespace kernels {
namespace {

std::string text_of(const Spread& spread, int digits) {
  return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", spread.median, digits, spread.lower, digits, spread.upper, digits);
}

std::string all_columns(const std::vector<Row>& rows) {
  std::string text =
      "model,joints,quantity,competitor,without,build,scalar,functions,ns,ns_lower_quartile,ns_upper_quartile,"
      "ratio,ratio_lower_quartile,ratio_upper_quartile,difference,operations,header_bytes\n";
  for (const Row& row : rows) {
    std::string functions = row.way.functions;  // a cell holds no comma
    functions.erase(std::remove(functions.begin(), functions.end(), ','), functions.end());
    const auto& [ns, ratio] = row.timing;
    text += fmt::format("{},{},{},{},{},{},{},{},{:.2f},{:.2f},{:.2f},{:.3f},{:.3f},{:.3f},{:.1e},{},{}\n", row.model,
                        row.joints, name_of(row.quantity), row.way.competitor, row.way.without, row.way.build,
                        row.way.scalar, functions, ns.median, ns.lower, ns.upper, ratio.median, ratio.lower,
                        ratio.upper, row.difference, row.operations, row.header_bytes);
  }
  return text;
}

/// One line for each number of joints, one column for each way.
void write_picture(const std::vector<Row>& rows, Quantity quantity, const std::filesystem::path& folder) {
  std::vector<std::string> labels;
  std::map<std::size_t, std::map<std::string, double>> lines;
  for (const Row& row : rows) {
    if (row.quantity != quantity || !row.way.without.empty()) continue;
    const std::string label = row.way.label();
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
    lines[row.joints][label] = row.timing.nanoseconds.median;
  }
  if (lines.empty()) return;
  std::string text = "joints";
  for (const std::string& label : labels) text += "," + label;
  for (const auto& [joints, line] : lines) {
    text += fmt::format("\n{}", joints);
    for (const std::string& label : labels) text += line.contains(label) ? fmt::format(",{:.2f}", line.at(label)) : ",";
  }
  const std::string name = fmt::format("nanoseconds_{}", name_of(quantity));
  const std::filesystem::path csv = folder / (name + ".csv");
  torsor::runtime::write_file(csv, text + "\n");
  torsor::runtime::Plot plot{fmt::format("{}: one state", name_of(quantity)), "joints", "nanoseconds", {}, true, true};
  for (const std::string& label : labels) plot.curves.push_back({csv, "joints", label, label, "linespoints"});
  torsor::runtime::write_plot(plot, folder / (name + ".svg"));
}

}  // namespace

std::string operations_in(const std::filesystem::path& header, Quantity quantity) {
  std::ifstream file(header);
  for (std::string line; std::getline(file, line) && line.starts_with("//");) {
    std::istringstream words(line);
    std::vector<std::string> cells;
    for (std::string word; words >> word;) cells.push_back(word);
    // "//", the kernel, additions and so on, their total, the total before
    if (cells.size() > 4 && cells[1] == name_of(quantity) &&
        cells[2].find_first_not_of("0123456789") == std::string::npos)
      return cells[cells.size() - 2];
  }
  return {};
}

void print_heading() {
  fmt::print("{:<8}{:<18}{:<22}{:<26}{:<7}{:>30}{:>26}{:>9}{:>12}\n", "model", "quantity", "", "build", "scalar",
             "ns for one state (quartiles)", "ratio to the first", "differs", "operations");
}

void print(const Row& row) {
  fmt::print("{:<8}{:<18}{:<22}{:<26}{:<7}{:>30}{:>26}{:>9.0e}{:>12}\n", row.model, name_of(row.quantity),
             row.way.without.empty() ? row.way.competitor : "without " + row.way.without, row.way.build, row.way.scalar,
             text_of(row.timing.nanoseconds, 1), text_of(row.timing.ratio, 2), row.difference, row.operations);
}

void write_files(const std::vector<Row>& rows, const std::filesystem::path& folder) {
  torsor::runtime::write_file(folder / "kernels.csv", all_columns(rows));
  for (const Quantity quantity : quantities) write_picture(rows, quantity, folder);
}

}  // namespace kernels
