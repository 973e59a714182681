// SPDX-License-Identifier: MIT
#pragma once
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "torsor/runtime/records/csv.hpp"
#include "torsor/runtime/records/file.hpp"

namespace torsor::runtime {

/// gnuplot is missing or refused the script; the text says what it said and what to do.
class PlotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One curve: two columns of a CSV file, by name.
struct Curve {
  std::filesystem::path csv;
  std::string x;
  std::string y;
  std::string title{};          ///< in the key; empty: the name of y
  std::string style = "lines";  ///< lines, points, linespoints
};

/// A picture of a few curves, drawn by gnuplot.
struct Plot {
  std::string title{};
  std::string x_title{};  ///< with its unit
  std::string y_title{};
  std::vector<Curve> curves{};
  bool log_x = false;
  bool log_y = false;
};

namespace detail {

// Inside single quotes gnuplot and the shell differ only in how a quote itself is written.
inline std::string quoted(std::string_view text, std::string_view quote_inside) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += quote_inside;
    else if (c == '\n')
      result += ' ';
    else
      result += c;
  }
  return result += '\'';
}
inline std::string for_gnuplot(std::string_view text) { return quoted(text, "''"); }
inline std::string for_shell(std::string_view text) { return quoted(text, "'\\''"); }

inline std::size_t column_number(const std::vector<std::string>& header, const std::string& name,
                                 const std::filesystem::path& csv) {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found != header.end()) return static_cast<std::size_t>(found - header.begin()) + 1;
  std::string known;
  for (const std::string& column : header) known += (known.empty() ? "" : ", ") + column;
  throw FileError("'" + csv.string() + "' has no column '" + name + "' to plot; it has " + known);
}

inline std::string terminal_for(const std::filesystem::path& picture) {
  const std::string extension = picture.extension().string();
  if (extension == ".svg") return "svg size 900,600 dynamic background rgb 'white' noenhanced";
  if (extension == ".png") return "pngcairo size 1350,900 noenhanced";
  throw PlotError("cannot plot '" + picture.string() + "': the kind '" + extension +
                  "' is unknown; end the name in .svg or .png");
}

inline std::string script_of(const Plot& plot, const std::filesystem::path& picture) {
  if (plot.curves.empty()) throw PlotError("cannot plot '" + picture.string() + "': no curve; add at least one");
  std::string script = "# Draws " + picture.filename().string() + "; run it in its own folder.\n";
  script += "set terminal " + terminal_for(picture) + "\n";
  script += "if (!exists('picture')) picture = " + for_gnuplot(picture.filename().string()) + "\n";
  script += "set output picture\nset datafile separator ','\nset grid\n";
  script += "set title " + for_gnuplot(plot.title) + "\n";
  script += "set xlabel " + for_gnuplot(plot.x_title) + "\nset ylabel " + for_gnuplot(plot.y_title) + "\n";
  // A long key would hide the curves.
  if (plot.curves.size() > 6) script += "set key below\n";
  if (plot.log_x) script += "set logscale x\nset format x '%.0e'\n";
  if (plot.log_y) script += "set logscale y\nset format y '%.0e'\n";
  script += "plot ";
  const std::filesystem::path folder = std::filesystem::absolute(picture).parent_path();
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const Curve& curve = plot.curves[i];
    const auto header = read_header(curve.csv);
    const std::size_t x = column_number(header, curve.x, curve.csv);
    const std::size_t y = column_number(header, curve.y, curve.csv);
    if (i > 0) script += ", \\\n     ";
    script += for_gnuplot(std::filesystem::absolute(curve.csv).lexically_proximate(folder).string());
    // The header line holds no number, which gnuplot would otherwise count as a gap in the curve.
    script += " every ::1 using " + std::to_string(x) + ":" + std::to_string(y) + " with " + curve.style + " title " +
              for_gnuplot(curve.title.empty() ? curve.y : curve.title);
  }
  return script + "\n";
}

/// Runs a shell command; its exit status and what it said, both streams together.
inline std::pair<int, std::string> run(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {-1, "no process could be started"};
  std::string said;
  std::array<char, 512> buffer;
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) said += buffer.data();
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said};
}

}  // namespace detail

/// Draws `plot` to `picture` (.svg or .png) from the CSV files of its curves, and leaves the gnuplot script beside the
/// picture (`name.gnuplot`) to be changed and run by hand. Throws FileError (a CSV file, its columns, the script) and
/// PlotError (gnuplot missing, or its complaint); no half-drawn picture is left.
inline void write_plot(const Plot& plot, const std::filesystem::path& picture) {
  namespace fs = std::filesystem;
  fs::path script = picture;
  script.replace_extension(".gnuplot");
  write_file(script, detail::script_of(plot, picture));
  const fs::path folder = fs::absolute(picture).parent_path();
  fs::path partial = picture.filename();
  partial += ".partial";
  const std::string command = "cd " + detail::for_shell(folder.string()) + " && gnuplot -e " +
                              detail::for_shell("picture = " + detail::for_gnuplot(partial.string())) + " " +
                              detail::for_shell(script.filename().string()) + " 2>&1";
  const auto [status, said] = detail::run(command);
  std::error_code error;
  if (status == 0) fs::rename(folder / partial, picture, error);
  if (status == 0 && !error) return;
  fs::remove(folder / partial, error);
  constexpr int not_found = 127;  // by POSIX, what the shell answers for a program it cannot find
  if (status == not_found) {
    throw PlotError("cannot draw '" + picture.string() +
                    "': gnuplot is not installed; install the Debian package "
                    "gnuplot-nox (apt-get install gnuplot-nox); the script '" +
                    script.string() + "' is ready");
  }
  throw PlotError("cannot draw '" + picture.string() + "': gnuplot says: " + said + "; see '" + script.string() + "'");
}

}  // namespace torsor::runtime
