// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace torsor::fuzzing {

/// A reader that is fed with damaged input. It must take it, or refuse it by an error of its own family; anything else
/// that leaves `run` is a defect, and so is an input that takes longer or more memory than the program allows.
struct Target {
  std::string_view name;
  void (*run)(std::string_view input);
};

void read_robot(std::string_view input);       ///< a URDF file, and now and then the header of what it describes
void read_xacro(std::string_view input);       ///< a xacro file, expanded, and what comes out read as a robot
void read_expression(std::string_view input);  ///< what stands in ${...}
void read_yaml(std::string_view input);
void read_exceptions(std::string_view input);  ///< of accuracy
void read_decimal(std::string_view input);     ///< what is written comes back as it was read
void read_unit(std::string_view input);        ///< likewise
void read_formula(std::string_view input);     ///< of a command line, as a program's definitions
void name_everything(std::string_view input);  ///< names and texts of a scene, up to the header, the page and the graph
void read_record_file(std::string_view input);
void read_reference_file(std::string_view input);
void read_table_head(std::string_view input);  ///< the first line of comma-separated values
/// A word of a scene program's command line in each line.
void run_scene_command(std::string_view input);
/// The same for the tool torsor, then an empty line, then the file robot.urdf.
void run_robot_command(std::string_view input);
#ifdef TORSOR_WITH_MUJOCO
void read_mjcf(std::string_view input);
#endif

}  // namespace torsor::fuzzing
