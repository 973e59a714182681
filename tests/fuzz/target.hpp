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

void read_robot(std::string_view input);      ///< a URDF file, and now and then the header of what it describes
void read_decimal(std::string_view input);    ///< what is written comes back as it was read
void read_unit(std::string_view input);       ///< likewise
void name_everything(std::string_view input); ///< names and texts of a scene, up to the header, the page and the graph
void read_record_file(std::string_view input);
void read_reference_file(std::string_view input);

}  // namespace torsor::fuzzing
