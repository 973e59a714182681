// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/records/plot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/runtime/temporary_folder.hpp"

namespace plot_test {
namespace {

using namespace torsor::runtime;

class PlotFile : public TemporaryFolder {
 protected:
  PlotFile() : csv(put("run.csv", "# a comment, with a comma\ntime,theta_1,theta_1'\n0.1,1,2\n1,3,4\n2,5,1\n")) {}

  Plot plot() const {
    return {.title = "It's a_b",
            .x_title = "t [s]",
            .y_title = "θ [rad]",
            .curves = {{.csv = csv, .x = "time", .y = "theta_1"},
                       {.csv = csv, .x = "time", .y = "theta_1'", .title = "rate", .style = "linespoints"}}};
  }

  static bool gnuplot_is_installed() { return detail::run("gnuplot --version 2>&1").first == 0; }

  const std::filesystem::path csv;
};

TEST_F(PlotFile, IsAScalableVectorGraphicWithTitlesAndCurves) {
  if (!gnuplot_is_installed()) GTEST_SKIP() << "gnuplot is not installed";
  write_plot(plot(), folder / "run.svg");
  const std::string svg = contents(folder / "run.svg");
  EXPECT_TRUE(mentions(svg, {"<svg", "It's a_b", "t [s]", "θ [rad]", "theta_1", "rate", "</svg>"}));
  EXPECT_EQ(files(), 3U) << "data, script and picture, no partial file";
}

TEST_F(PlotFile, IsAPortableNetworkGraphic) {
  if (!gnuplot_is_installed()) GTEST_SKIP() << "gnuplot is not installed";
  write_plot(plot(), folder / "run.png");
  EXPECT_EQ(contents(folder / "run.png").substr(0, 4), "\x89PNG");
}

TEST_F(PlotFile, HasAScriptThatRunsByHandWithLogarithmicAxes) {
  if (!gnuplot_is_installed()) GTEST_SKIP() << "gnuplot is not installed";
  Plot logarithmic = plot();
  logarithmic.log_x = logarithmic.log_y = true;
  write_plot(logarithmic, folder / "run.svg");
  EXPECT_TRUE(mentions(contents(folder / "run.gnuplot"), {"set logscale x", "set logscale y", "'run.csv'"}));
  std::filesystem::remove(folder / "run.svg");
  const auto [status, said] = detail::run("cd " + detail::for_shell(folder.string()) + " && gnuplot run.gnuplot 2>&1");
  EXPECT_EQ(status, 0) << said;
  EXPECT_TRUE(std::filesystem::exists(folder / "run.svg"));
}

TEST_F(PlotFile, NamesThePackageWhenGnuplotIsMissing) {
  const char* before = std::getenv("PATH");
  const std::string path = before != nullptr ? before : "";
  setenv("PATH", "/nonexistent", 1);
  const std::string error = error_of<PlotError>([&] { write_plot(plot(), folder / "run.svg"); });
  setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(mentions(error, {"run.svg", "gnuplot is not installed", "gnuplot-nox", "run.gnuplot' is ready"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "run.svg"));
}

TEST_F(PlotFile, PassesOnWhatGnuplotComplainsOf) {
  if (!gnuplot_is_installed()) GTEST_SKIP() << "gnuplot is not installed";
  Plot wrong = plot();
  wrong.curves.front().style = "no_such_style";
  const std::string error = error_of<PlotError>([&] { write_plot(wrong, folder / "run.svg"); });
  EXPECT_TRUE(mentions(error, {"gnuplot says", "run.gnuplot"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "run.svg"));
}

TEST_F(PlotFile, NamesColumnsThatDoNotExist) {
  Plot wrong = plot();
  wrong.curves.front().y = "theta_2";
  const std::string error = error_of<FileError>([&] { write_plot(wrong, folder / "run.svg"); });
  EXPECT_TRUE(mentions(error, {"run.csv", "no column 'theta_2'", "time, theta_1, theta_1'"}));
}

TEST_F(PlotFile, RefusesAnUnknownKindOfPictureAndAnEmptyPlot) {
  EXPECT_TRUE(
      mentions(error_of<PlotError>([&] { write_plot(plot(), folder / "run.bmp"); }), {"run.bmp", ".svg or .png"}));
  EXPECT_TRUE(mentions(error_of<PlotError>([&] { write_plot(Plot{}, folder / "run.svg"); }), {"no curve"}));
}

}  // namespace
}  // namespace plot_test
