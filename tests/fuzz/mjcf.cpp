// SPDX-License-Identifier: GPL-3.0-or-later
// MJCF files, which MuJoCo reads.
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/mjcf.hpp"
#include "torsor/generator/import/mujoco_reader.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/fuzz/text_rules.hpp"

namespace torsor::fuzzing {

void read_mjcf(std::string_view input) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("torsor_fuzz_" + std::to_string(::getpid()) + ".xml")).string();
  std::ofstream(path, std::ios::binary).write(input.data(), static_cast<std::streamsize>(input.size()));
  try {
    const ImportedMjcf read = mjcf_scene(read_with_mujoco(path), {});
    for (const std::string& note : read.scene.content().origin.notes) expect_clean_text(note);
  } catch (const Error& refusal) {
    expect_message(refusal.what());
  }
  std::filesystem::remove(path);
}

}  // namespace torsor::fuzzing
