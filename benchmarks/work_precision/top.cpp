// SPDX-License-Identifier: GPL-3.0-or-later
#include "work_precision_top.hpp"

#include "benchmarks/work_precision/ways.hpp"

namespace work_precision {

Problem top() {
  using State = std::array<double, 6>;
  const Case<work_precision_top::Mechanism<double>, 6> motion{
      {0, 0.5, 0, 0, 0, 24},
      20,
      {3.793810884914525621687350693649e+01, 7.357482475581846787198325020808e-01, 4.512030912771534084738916309643e+02,
       2.903961860301357099111870416440e+00, 6.919473781420158643078299803087e-01,
       2.184720949524797180285342147738e+01},
      [](const State& y) { return y; },
      2 * 4.905};
  return {"top", "heavy symmetric top from theta = 0.5, spin 24 rad/s, 20 s", all_ways(motion)};
}

}  // namespace work_precision
