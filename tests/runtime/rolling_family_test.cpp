// SPDX-License-Identifier: GPL-3.0-or-later
// Rolling mechanisms by every way to hold constraints and every kind of method: all meet the committed reference, which
// has 40 digits of a derivation of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "generated/chaplygin_sleigh.hpp"
#include "generated/disk_in_a_circle.hpp"
#include "generated/four_wheel_vehicle.hpp"
#include "generated/friction_wheels.hpp"
#include "generated/graham_variator.hpp"
#include "generated/rolling_hoop.hpp"
#include "generated/rolling_hoop_contact_forces.hpp"
#include "generated/tumbler.hpp"
#include "torsor/runtime/constraints/constrained_motion.hpp"
#include "torsor/runtime/constraints/partitioned_motion.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/records/reference.hpp"

namespace rolling_family_test {
namespace {

using namespace torsor::runtime;

template <class M>
class Family {
 public:
  using State = StateVector<M>;
  static constexpr double tolerance = 1e-10;

  Family() : reference_(read_reference<double>(TORSOR_SOURCE_DIR "/generated/" + std::string(M::name) + ".reference.csv")) {
    truth_ = reference_.template state<std::tuple_size_v<State>>(0);
    end_ = reference_.times[0];
  }

  template <int freedoms>
  void expect_all() const {
    const DormandPrince853 explicit_method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
    const RadauIia5 radau{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
    const StabilisedRadauIia5 stabilised{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
    const GaussCollocation<4> gauss{.step = end_ / 200};
    const auto raw = unprojected_motion<M>();
    const auto held = equations_of_motion<M>();
    const auto by_factor = constrained_motion<M>();
    const auto with = [&](const char* name, const auto& method) {
      const std::string method_name = name;
      expect(method_name + ", raw", [&](State& y) { return integrate(raw, y, 0, end_, method); });
      expect(method_name + ", held by default", [&](State& y) { return integrate(held, y, 0, end_, method); }, true);
      expect(method_name + ", projected", [&](State& y) { return integrate(projected(raw), y, 0, end_, method); }, true);
      expect(method_name + ", partitioned", [&](State& y) {
        return integrate_partitioned<freedoms>(raw, y, 0, end_, method).integration;
      }, true);
      expect(method_name + ", constrained",
             [&](State& y) { return integrate(projected(by_factor), y, 0, end_, method); }, true);
    };
    with("8(5,3)", explicit_method);
    with("Radau", radau);
    with("Gauss", gauss);
    expect("stabilised", [&](State& y) { return integrate(raw, y, 0, end_, stabilised); }, true);
    if constexpr (HasJets<M>) {
      const Taylor taylor{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
      expect("Taylor, raw", [&](State& y) { return integrate(raw, y, 0, end_, taylor); });
      expect("Taylor, projected", [&](State& y) { return integrate(projected(raw), y, 0, end_, taylor); }, true);
    }
  }

 private:
  template <class Integrate>
  void expect(const std::string& name, const Integrate& integrated, bool closed = false) const {
    State y = equations_of_motion<M>().initial();
    const Result<double> result = integrated(y);
    ASSERT_TRUE(result) << M::name << ", " << name << ": " << describe(result);
    double worst = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      worst = std::max(worst, std::abs(y[i] - truth_[i]) / (1 + std::abs(truth_[i])));
    }
    // Each step errs by the tolerance at most, in motions that amplify by less than thirty.
    EXPECT_LT(worst, tolerance * 30 * static_cast<double>(result.statistics.accepted)) << M::name << ", " << name;
    if (!closed) return;
    const auto motion = equations_of_motion<M>();
    using Kinds = ConstraintKinds<M>;
    typename M::Constraints c{};
    M::constraints(motion.precomputed(), unpack<M>(end_, y), c);
    double speed = 0;
    for (std::size_t j = 0; j < Kinds::nv; ++j) speed = std::max(speed, std::abs(y[Kinds::nv + j]));
    for (std::size_t i = 0; i < c.value.size(); ++i) {
      double terms = 0, size = 0;
      for (std::size_t j = 0; j < Kinds::nv; ++j) {
        const double entry = std::abs(c.jacobian[j * Kinds::m + i]);
        size += entry;
        terms += entry * std::max(1.0, std::abs(y[j]));
      }
      // Some roundings of the terms that each is a sum of, none of which is larger than these.
      EXPECT_LE(std::abs(c.value[i]), 8 * 1.1e-16 * terms) << M::name << ", " << name;
      EXPECT_LE(std::abs(c.rate[i]), 8 * 1.1e-16 * size * speed) << M::name << ", " << name;
    }
  }

  Reference<double> reference_;
  State truth_{};
  double end_ = 0;
};

TEST(RollingFamily, MeetsItsReferenceByAllWaysAndMethods) {
  Family<rolling_hoop::Mechanism<double>>().expect_all<3>();
  Family<rolling_hoop_contact_forces::Mechanism<double>>().expect_all<3>();
  Family<chaplygin_sleigh::Mechanism<double>>().expect_all<2>();
  Family<disk_in_a_circle::Mechanism<double>>().expect_all<3>();
  Family<tumbler::Mechanism<double>>().expect_all<3>();
  Family<four_wheel_vehicle::Mechanism<double>>().expect_all<1>();
  Family<friction_wheels::Mechanism<double>>().expect_all<1>();
  Family<graham_variator::Mechanism<double>>().expect_all<1>();
}

}  // namespace
}  // namespace rolling_family_test
