# SPDX-License-Identifier: GPL-3.0-or-later
# torsor_add_mechanism refuses wrong arguments when a project is configured, and hands the right ones to `generate`.
# The programs are stand-ins: nothing is built, and no compiler is looked for.
file(REMOVE_RECURSE "${FOLDER}")

# Configures a project that makes one call; sets `result`, `output` and `arguments`, those of `generate`.
function(configure call)
  file(REMOVE_RECURSE "${FOLDER}")
  file(WRITE "${FOLDER}/source/scene.cpp" "int main() {}\n")
  file(WRITE "${FOLDER}/source/arm.urdf" "<robot/>\n")
  file(WRITE "${FOLDER}/source/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.25)
project(arguments LANGUAGES NONE)
set(CMAKE_CXX_COMPILER_ID_RUN 1)
add_library(torsor_generator INTERFACE)
add_library(torsor::generator ALIAS torsor_generator)
add_library(torsor::torsor ALIAS torsor_generator)
add_custom_target(stand_in)
function(add_executable)
  add_library(\${ARGV0} INTERFACE)
endfunction()
function(target_link_libraries)
endfunction()
function(target_compile_features)
endfunction()
include(\"${TORSOR_SOURCE}/cmake/torsor_add_mechanism.cmake\")
${call}
")
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${FOLDER}/source" -B "${FOLDER}/build" -G "${GENERATOR}"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")  # CMake breaks lines where it likes
  set(result "${result}" PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
  set(arguments "" PARENT_SCOPE)
  if(EXISTS "${FOLDER}/build/torsor/arm.arguments")
    file(READ "${FOLDER}/build/torsor/arm.arguments" arguments)
    set(arguments "${arguments}" PARENT_SCOPE)
  endif()
endfunction()

function(expect_refused call message)
  configure("${call}")
  string(FIND "${output}" "${message}" place)
  if(result EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "${call}\nended with ${result} and should say '${message}':\n${output}")
  endif()
endfunction()

function(expect_arguments call wanted)
  configure("${call}")
  string(FIND "${arguments}" "${wanted}" place)
  if(NOT result EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "${call}\nended with ${result}, its arguments are '${arguments}', not '${wanted}':\n${output}")
  endif()
endfunction()

expect_refused("torsor_add_mechanism(arm URDF nowhere.urdf KERNELS bias)" "there is no file '${FOLDER}/source/nowhere.urdf'")
expect_refused("torsor_add_mechanism(arm SCENE nowhere.cpp KERNELS bias)" "there is no file '${FOLDER}/source/nowhere.cpp'")
expect_refused("torsor_add_mechanism(arm URDF . KERNELS bias)" "is a folder; URDF takes a file")
expect_refused("torsor_add_mechanism(arm SCENE scene.cpp URDF arm.urdf KERNELS bias)" "give SCENE or URDF, not both")
foreach(keyword SUPPORT OUTPUT_NAME)
  expect_refused("torsor_add_mechanism(arm SCENE scene.cpp KERNELS bias ${keyword})" "nothing stands behind ${keyword}")
endforeach()
foreach(support arm.hpp ./arm.hpp)
  expect_refused("torsor_add_mechanism(arm SCENE scene.cpp KERNELS bias SUPPORT ${support})" "is the header itself")
endforeach()
foreach(option "--kernels bias" "--output=x.hpp" "-o x.hpp" "--language c99" "--run-time m" "--support s.hpp" "--name other")
  expect_refused("torsor_add_mechanism(arm URDF arm.urdf KERNELS bias OPTIONS ${option})" "is no option for OPTIONS; give ")
endforeach()
expect_arguments("torsor_add_mechanism(arm SCENE scene.cpp KERNELS bias RUN_TIME \${none} OPTIONS \${none})" "--kernels;bias")
expect_refused("torsor_add_mechanism(arm SCENE scene.cpp KERNELS SUPPORT shared.hpp)" "nothing stands behind KERNELS")
expect_arguments("torsor_add_mechanism(arm SCENE scene.cpp KERNELS bias OPTIONS --label \"one;word\" --other)"
  "--label;one\;word;--other")
expect_arguments("torsor_add_mechanism(arm SCENE scene.cpp KERNELS bias energy OPTIONS --forward factorisation)"
  "--kernels;bias,energy;--output;${FOLDER}/build/torsor/arm/arm.hpp;--forward;factorisation")
expect_arguments("torsor_add_mechanism(arm SCENE scene.cpp KERNELS bias SUPPORT shared.hpp)"
  "--output;${FOLDER}/build/torsor/arm/arm.hpp;--support;${FOLDER}/build/torsor/arm/shared.hpp")
expect_arguments("torsor_add_mechanism(arm URDF arm.urdf KERNELS bias OPTIONS --base floating)" "--base;floating")
# What another rule of the project writes need not be there yet.
expect_arguments("set_source_files_properties(\${CMAKE_CURRENT_SOURCE_DIR}/later.urdf PROPERTIES GENERATED ON)
torsor_add_mechanism(arm URDF later.urdf KERNELS bias)" "later.urdf;--name;arm")
message(STATUS "refused and taken as they should be")
