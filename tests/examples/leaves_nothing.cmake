# SPDX-License-Identifier: GPL-3.0-or-later
# A program of an example prints, and leaves no file where it ran unless it is asked for plots.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
execute_process(COMMAND "${PROGRAM}" --reference "${REFERENCE}" WORKING_DIRECTORY "${FOLDER}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${result}:\n${output}")
endif()
file(GLOB_RECURSE left LIST_DIRECTORIES true "${FOLDER}/*")
if(left)
  message(FATAL_ERROR "${PROGRAM} left ${left}")
endif()
