# SPDX-License-Identifier: MIT
include_guard(GLOBAL)

# torsor_add_mechanism(<name> SCENE <file.cpp> KERNELS <kernel>... [OUTPUT_NAME <name>] [RUN_TIME <parameter>...|all])
#
# Builds the program <name>_scene from the scene, runs it to write <output name>.hpp (<name>.hpp by default) and makes
# the interface target <name>: what links to it can write #include "<name>.hpp". The target <name>_header stands for
# the writing alone, and the target property TORSOR_HEADER of <name> holds the path of the header.
#
# The program runs again only when it, and so its scene or torsor, was built again; it leaves a header alone whose
# bytes would not change, so that nothing is compiled again then. The stamp is what the build tool looks at: with the
# header itself as output, make would find an unchanged header old for ever.
function(torsor_add_mechanism name)
  cmake_parse_arguments(PARSE_ARGV 1 mechanism "" "SCENE;OUTPUT_NAME" "KERNELS;RUN_TIME")
  if(mechanism_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "torsor_add_mechanism(${name}): '${mechanism_UNPARSED_ARGUMENTS}' is no argument; "
                        "the arguments are SCENE, KERNELS, OUTPUT_NAME and RUN_TIME")
  endif()
  if(NOT mechanism_SCENE OR NOT mechanism_KERNELS)
    message(FATAL_ERROR "torsor_add_mechanism(${name}): give SCENE <file.cpp> and KERNELS <kernel>...")
  endif()
  if(NOT TARGET torsor::generator)
    message(FATAL_ERROR "torsor_add_mechanism(${name}): there is no target torsor::generator; "
                        "call find_package(torsor) with the component generator, or add_subdirectory, first")
  endif()
  if(NOT mechanism_OUTPUT_NAME)
    set(mechanism_OUTPUT_NAME "${name}")
  endif()

  add_executable(${name}_scene "${mechanism_SCENE}")
  target_link_libraries(${name}_scene PRIVATE torsor::generator)

  set(folder "${CMAKE_CURRENT_BINARY_DIR}/torsor/${name}")
  set(header "${folder}/${mechanism_OUTPUT_NAME}.hpp")
  set(stamp "${CMAKE_CURRENT_BINARY_DIR}/torsor/${name}.stamp")
  list(JOIN mechanism_KERNELS "," kernels)
  set(arguments --kernels "${kernels}" --output "${header}")
  if(mechanism_RUN_TIME)
    list(JOIN mechanism_RUN_TIME "," run_time)
    list(APPEND arguments --run-time "${run_time}")
  endif()
  file(MAKE_DIRECTORY "${folder}")
  # make does not notice that a command changed; this file changes with it.
  file(CONFIGURE OUTPUT "${folder}.arguments" CONTENT "${arguments}\n" @ONLY)
  add_custom_command(OUTPUT "${stamp}" BYPRODUCTS "${header}"
    COMMAND ${name}_scene generate ${arguments}
    COMMAND "${CMAKE_COMMAND}" -E touch "${stamp}"
    DEPENDS ${name}_scene "${folder}.arguments"
    COMMENT "Generating ${mechanism_OUTPUT_NAME}.hpp" VERBATIM)
  add_custom_target(${name}_header DEPENDS "${stamp}")

  add_library(${name} INTERFACE)
  target_include_directories(${name} INTERFACE "${folder}")
  target_compile_features(${name} INTERFACE cxx_std_17)
  set_target_properties(${name} PROPERTIES TORSOR_HEADER "${header}")
  add_dependencies(${name} ${name}_header)
endfunction()
