// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/configuration_sample.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/program/test_symbols.hpp"
#include "tests/scenes/bodies.hpp"

namespace torsor::configuration_sample_test {
namespace {

using namespace testing_symbols;

using Columns = std::array<std::array<Real, 3>, 3>;

/// The axes of the last link in the ground's.
Columns axes_of(const Model& model, ConfigurationSample& sample) {
  const int link = static_cast<int>(model.links().size()) - 1;
  Columns columns;
  for (int j = 0; j < 3; ++j) {
    Vector unit;
    unit[j] = model.program().number(Number(1));
    const Vector axis = bound(model.program(), model.express(unit, link, 0));
    for (int i = 0; i < 3; ++i) columns[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = sample(axis[i]);
  }
  return columns;
}

// R' e_j = R (e_j + d x e_j) and terms of second order: d turns about the moving axes, whatever the attitude.
TEST(ConfigurationSample, TurnsAttitudesAboutTheirMovingAxes) {
  const WorkingDigits precision(50);
  const Scene scene = testing_mechanisms::torque_free_body();
  Program program(Model::resolver(scene, {}));
  const Model model(scene, program);
  ConfigurationSample sample(model);
  sample.scatter();
  const Columns before = axes_of(model, sample);
  const Real h = pow(Real(10), -15);
  const std::array<Real, 3> d{h * rational(1, 3), h * rational(-2, 7), h * rational(5, 9)};
  sample.displace({d[0], d[1], d[2]});
  const Columns after = axes_of(model, sample);
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;  // d x e_j = d_l e_k - d_k e_l
    for (std::size_t i = 0; i < 3; ++i) {
      const Real turned = before[j][i] + d[l] * before[k][i] - d[k] * before[l][i];
      // |d|^2 is below 1e-30: that much is left out, at most
      EXPECT_LT(abs(after[j][i] - turned).to_double(), 1e-30) << i << ' ' << j;
    }
  }
}

}  // namespace
}  // namespace torsor::configuration_sample_test
