// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cli/torsor_program.hpp"

int main(int argc, char** argv) { return torsor::run_torsor(argc, argv); }
