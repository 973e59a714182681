// SPDX-License-Identifier: GPL-3.0-or-later
// Stiff and constrained motions, where implicit methods are compared: the flyball governor, a pendulum on a stiff and
// on a stiffer spring, Andrews' squeezing mechanism.
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/work_precision/elastic_pendulum.hpp"
#include "benchmarks/work_precision/ways.hpp"
#include "generated/andrews_squeezer.hpp"
#include "generated/flyball_governor.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"
#include "torsor/runtime/integration/stoermer_verlet.hpp"

namespace work_precision {
namespace {

using namespace torsor::runtime;

// Where dampers or motors work, the energy itself tells nothing.
constexpr double no_energy = std::numeric_limits<double>::infinity();

template <class M, std::size_t count>
std::vector<Way> stiff_ways(const Case<M, count>& problem, double longest_step) {
  const auto shared = std::make_shared<const Case<M, count>>(problem);
  const std::vector<double> all = tolerances(1e-3, 1e-13);
  std::vector<Way> ways;
  ways.push_back(way(shared, "torsor", "Radau IIA 5", false, all, [](double s) { return of_tolerance<RadauIia5>(s); }));
  if constexpr (M::multiplier_count > 0) {
    ways.push_back(way(shared, "torsor", "Radau IIA 5 stabilised", false, all,
                       [](double s) { return of_tolerance<StabilisedRadauIia5>(s); }));
  }
  ways.push_back(way(shared, "torsor", "Gauss collocation 12, Newton", true, steps(longest_step, 6),
                     [](double s) { return GaussCollocation<6, StageSolver::newton>{.step = s}; }));
  ways.push_back(way(shared, "torsor", "Dormand-Prince 8(5,3)", false, all,
                     [](double s) { return of_tolerance<DormandPrince853>(s); }));
  ways.push_back(way(shared, "torsor", "Dormand-Prince 5(4)", false, all,
                     [](double s) { return of_tolerance<DormandPrince54>(s); }));
#ifdef BENCHMARK_ODEINT
  for (Way& each : odeint_ways(shared, tolerances(1e-3, 1e-11))) ways.push_back(std::move(each));
#endif
#ifdef BENCHMARK_SUNDIALS
  ways.push_back(way(shared, "SUNDIALS", "CVODE BDF", false, all, [](double s) { return of_tolerance<Cvode>(s); }));
  ways.push_back(way(shared, "SUNDIALS", "ARKODE implicit 5", false, tolerances(1e-3, 1e-11),
                     [](double s) { return of_tolerance<ArkodeImplicit>(s); }));
  if constexpr (HasResidual<EquationsOfMotion<M>>) {
    ways.push_back(
        way(shared, "SUNDIALS", "IDA", false, tolerances(1e-3, 1e-11), [](double s) { return of_tolerance<Ida>(s); }));
  }
#endif
  return ways;
}

}  // namespace

Problem governor() {
  using State = std::array<double, 8>;
  const Case<flyball_governor::Mechanism<double>, 8> motion{
      equations_of_motion<flyball_governor::Mechanism<double>>().initial(),
      10,
      {5.59354099091023787e+01, 6.19622917061365658e-01, 3.90073701844645080e-01, 3.90073701844645080e-01,
       5.54820362265492658, -7.4760335416433246e-01, 8.08467051345577400e-01, 8.08467051345577400e-01},
      [](const State& y) { return y; },
      no_energy};
  return {"governor", "stiff flyball governor (roots at -2e4 1/s), 10 s", stiff_ways(motion, 0.02)};
}

namespace {

// A constant mass and a force of the place alone are what Störmer-Verlet asks for; it is stable below 2 / frequency.
template <int frequency>
Problem elastic_pendulum(std::string name, std::string text, const std::array<double, 4>& end) {
  using State = std::array<double, 4>;
  using Motion = Case<ElasticPendulum<double, frequency>, 4>;
  const Motion motion{{1, 0, 0, 0}, 2, end, [](const State& y) { return y; }, 9.81};
  std::vector<Way> ways = stiff_ways(motion, 2.0 / frequency);
  ways.push_back(way(std::make_shared<const Motion>(motion), "torsor", "Stoermer-Verlet", true,
                     steps(1.0 / frequency, frequency > 1000 ? 8 : 12),
                     [](double s) { return StoermerVerlet{.step = s}; }));
  return {std::move(name), std::move(text), std::move(ways)};
}

}  // namespace

Problem elastic_pendulum() {
  return elastic_pendulum<100>("elastic_pendulum", "pendulum on a spring of 100 rad/s, 2 s",
                               {0.78716337934128783673767423, -0.61969057482201185317075261,
                                2.1477596957501236496262230, 2.7408659966747509639371353});
}

Problem stiffer_pendulum() {
  return elastic_pendulum<10000>("stiffer_pendulum", "pendulum on a spring of 1e4 rad/s, 2 s",
                                 {0.79356556126269921386207737, -0.60848505169155606162579651,
                                  2.1024423862766915008686121, 2.7419353602363155999197867});
}

Problem squeezer() {
  using State = std::array<double, 14>;
  const Case<andrews_squeezer::Mechanism<double>, 14> motion{
      equations_of_motion<andrews_squeezer::Mechanism<double>>().initial(),
      0.03,
      {15.8107711951537070971193873, -15.7563710584118394697277528, 0.0408222401196458048582823196,
       -0.534730116342079593770185031, 0.524409965879954069371655800, 0.534730116342079593770185031,
       1.04808074104193787306851547, 1139.92030225910606419809685, -1424.37929517754007319602644,
       11.0329119106185937453273113, 19.2933741050320408316275568, 0.573569914829502453817687862,
       -19.2933741050320408316275568, 0.323179149249130874990748391},
      [](const State& y) { return y; },
      no_energy};
  return {"squeezer", "Andrews' squeezing mechanism, six multipliers, 0.03 s", stiff_ways(motion, 1e-3)};
}

}  // namespace work_precision
