# SPDX-License-Identifier: GPL-3.0-or-later
# Steps that the scripts beside it share. The launcher is a list: it travels through the environment, which CMake reads.
if(KIND STREQUAL "add_subdirectory" AND NOT DEFINED ENV{TORSOR_LONG_TESTS})
  list(PREPEND LAUNCHER bash "${CMAKE_CURRENT_LIST_DIR}/reuse_object.sh" "${TORSOR_BUILD}")
endif()
set(ENV{CMAKE_CXX_COMPILER_LAUNCHER} "${LAUNCHER}")

# Runs a command and stops the test, with its output, when it fails.
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${result}:\n${output}")
  endif()
endfunction()

# A fresh copy of the consumer project and of the scene, configured in its own folder.
macro(prepare_consumer)
  file(REMOVE_RECURSE "${FOLDER}")
  file(COPY "${SOURCE}/" DESTINATION "${FOLDER}/source")
  file(COPY "${TORSOR_SOURCE}/tests/consumer/main.cpp" DESTINATION "${FOLDER}/source")
  file(COPY_FILE "${SCENE}" "${FOLDER}/source/scene.cpp")
  file(COPY "${TORSOR_SOURCE}/tests/import/data/arm.urdf" DESTINATION "${FOLDER}/source")
  if(KIND STREQUAL "find_package")
    step("${CMAKE_COMMAND}" --install "${TORSOR_BUILD}" --prefix "${FOLDER}/prefix")
    set(where "-DCMAKE_PREFIX_PATH=${FOLDER}/prefix")
  elseif(KIND STREQUAL "export")
    set(where "-Dtorsor_DIR=${TORSOR_BUILD}")
  else()
    set(where "-DTORSOR_SOURCE=${TORSOR_SOURCE}")
  endif()
  configure_consumer()
endmacro()

macro(configure_consumer)
  step("${CMAKE_COMMAND}" -S "${FOLDER}/source" -B "${FOLDER}/build" -G "${GENERATOR}" "${where}" ${ARGN}
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
    "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_CXX_FLAGS_RELEASE=${RELEASE_FLAGS}"
    "-DTORSOR_UNITY_BUILD=${UNITY}")
endmacro()

macro(build_consumer)
  step("${CMAKE_COMMAND}" --build "${FOLDER}/build" --parallel 2)
endmacro()
