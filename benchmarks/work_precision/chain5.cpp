// SPDX-License-Identifier: GPL-3.0-or-later
#include "work_precision_chain5.hpp"

#include "benchmarks/work_precision/ways.hpp"

namespace work_precision {

Problem chain5() {
  using State = std::array<double, 10>;
  const Case<work_precision_chain5::Mechanism<double>, 10> motion{
      {1.0, 1.2, 1.4, 1.6, 1.8, 0, 0, 0, 0, 0},
      5,
      {2.428906088052164758836717588356e-01, 3.601413974362733462716781134075e-01, 4.672577635391160225256600968515e-01,
       1.085497749276475491991736326539e+00, 8.670185194143396414809006530577e-01, -2.02868529492405861057274532047e+00,
       -6.49147349123702533727340555823e-01, -3.74802981914805006700822089735e+00, -1.71091819211506005839701626303e+00,
       4.796834959088740828264621142749e-01},
      [](const State& y) { return y; },
      2 * 15 * 9.81};
  return {"chain5", "five masses on rods from (1, 1.2, 1.4, 1.6, 1.8) at rest, 5 s", all_ways(motion)};
}

}  // namespace work_precision
