# SPDX-License-Identifier: GPL-3.0-or-later
# The header is made again only when its inputs changed, and what includes it is compiled again only when its bytes did.
include("${CMAKE_CURRENT_LIST_DIR}/consumer.cmake")

# Content and time of the files that tell what ran. The folders are searched, as the generators name objects alike.
function(observe prefix)
  set(build "${FOLDER}/build")
  file(GLOB_RECURSE main_object "${build}/CMakeFiles/consumer.dir/main.cpp.o")
  file(GLOB_RECURSE scene_object "${build}/CMakeFiles/double_pendulum_scene.dir/scene.cpp.o")
  set(header "${build}/torsor/double_pendulum/double_pendulum.hpp")
  set(stamp "${build}/torsor/double_pendulum.stamp")
  set(included_arm "${build}/torsor/included_arm/included_arm.hpp")
  foreach(file main_object scene_object header stamp included_arm)
    if(NOT EXISTS "${${file}}")
      message(FATAL_ERROR "${file} '${${file}}' was not made")
    endif()
    execute_process(COMMAND stat -c %.Y "${${file}}" OUTPUT_VARIABLE time OUTPUT_STRIP_TRAILING_WHITESPACE)
    set(${prefix}_${file} "${time}" PARENT_SCOPE)
  endforeach()
endfunction()

# expect(<before> <after> SAME|NEWER <file>): compares the two observations of a file.
function(expect before after relation file)
  if("${${before}_${file}}" STREQUAL "${${after}_${file}}")
    set(found SAME)
  else()
    set(found NEWER)
  endif()
  if(NOT found STREQUAL relation)
    message(FATAL_ERROR "${after}: ${file} should be ${relation}, is ${found} than ${before}; the build printed:\n${output}")
  endif()
endfunction()

prepare_consumer()
build_consumer()
observe(first)

build_consumer()
observe(nothing_changed)
foreach(file main_object scene_object header stamp included_arm)
  expect(first nothing_changed SAME ${file})
endforeach()

# A comment more: the scene is compiled and run again, and gives the same bytes.
execute_process(COMMAND "${CMAKE_COMMAND}" -E sleep 1.1)
file(APPEND "${FOLDER}/source/scene.cpp" "// one remark more\n")
build_consumer()
observe(remark_added)
expect(nothing_changed remark_added NEWER scene_object)
expect(nothing_changed remark_added NEWER stamp)
expect(nothing_changed remark_added SAME header)
expect(nothing_changed remark_added SAME main_object)

# And that was the end of it: the unchanged, now older header is not made again and again.
build_consumer()
observe(after_the_remark)
foreach(file main_object scene_object header stamp)
  expect(remark_added after_the_remark SAME ${file})
endforeach()

# Another list of kernels is another header.
execute_process(COMMAND "${CMAKE_COMMAND}" -E sleep 1.1)
configure_consumer(-DMORE_KERNELS=energy)
build_consumer()
observe(kernel_added)
expect(after_the_remark kernel_added SAME scene_object)
expect(after_the_remark kernel_added NEWER header)
expect(after_the_remark kernel_added NEWER main_object)

# A longer rod in a file that another one includes is another header of that arm.
execute_process(COMMAND "${CMAKE_COMMAND}" -E sleep 1.1)
file(READ "${FOLDER}/source/included_rod.xacro" rod)
string(REPLACE "length:=0.5" "length:=0.75" rod "${rod}")
file(WRITE "${FOLDER}/source/included_rod.xacro" "${rod}")
build_consumer()
observe(rod_grown)
expect(kernel_added rod_grown NEWER included_arm)
expect(kernel_added rod_grown SAME header)
build_consumer()
observe(after_the_rod)
expect(rod_grown after_the_rod SAME included_arm)
