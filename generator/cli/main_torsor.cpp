// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/torsor_program.hpp"

#ifdef TORSOR_WITH_MUJOCO
#include "torsor/generator/import/mujoco_reader.hpp"

int main(int argc, char** argv) { return torsor::run_torsor(argc, argv, torsor::read_with_mujoco); }
#else
int main(int argc, char** argv) { return torsor::run_torsor(argc, argv); }
#endif
