// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo's inverse dynamics of many states, by a loop in C++: batch.py compiles it where libmujoco-dev is installed.
#include <algorithm>
#include <cstddef>
#include <cstdio>

#include <mujoco/mujoco.h>

namespace {
struct Problem {
  mjModel* model;
  mjData* data;
};
}  // namespace

extern "C" {
void* make_mujoco(const char* path) {
  char error[1000] = "";
  mjModel* const model = mj_loadXML(path, nullptr, error, sizeof error);
  if (model == nullptr) return std::fprintf(stderr, "MuJoCo: %s\n", error), nullptr;
  return new Problem{model, mj_makeData(model)};
}

/// Only what inverse dynamics needs, without the tests for contacts and limits that mj_inverse makes.
void evaluate_mujoco(void* made, std::size_t n, const double* q, const double* v, const double* a, double* forces) {
  const auto& p = *static_cast<Problem*>(made);
  const auto size = static_cast<std::size_t>(p.model->nv);
  for (std::size_t i = 0; i < n; ++i) {
    std::copy_n(q + i * size, size, p.data->qpos);
    std::copy_n(v + i * size, size, p.data->qvel);
    std::copy_n(a + i * size, size, p.data->qacc);
    mj_kinematics(p.model, p.data);
    mj_comPos(p.model, p.data);
    mj_comVel(p.model, p.data);
    mj_rne(p.model, p.data, 1, forces + i * size);
  }
}
}
