# SPDX-License-Identifier: GPL-3.0-or-later
# A project of someone else configures, builds and runs with what torsor gives it.
include("${CMAKE_CURRENT_LIST_DIR}/consumer.cmake")
prepare_consumer()
build_consumer()
step("${FOLDER}/build/consumer")
if(NOT output MATCHES "accelerations of double_pendulum")
  message(FATAL_ERROR "the consumer printed something else:\n${output}")
endif()
message(STATUS "${output}")
if(KIND STREQUAL "add_subdirectory")
  # A good guest brings no tests, examples or benchmarks of its own.
  foreach(folder tests examples benchmarks)
    if(EXISTS "${FOLDER}/build/torsor/${folder}")
      message(FATAL_ERROR "torsor configured its ${folder} inside the build of its host")
    endif()
  endforeach()
endif()
