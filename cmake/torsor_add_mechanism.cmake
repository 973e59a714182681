# SPDX-License-Identifier: MIT
include_guard(GLOBAL)

# torsor_add_mechanism(<name> SCENE <file.cpp> KERNELS <kernel>... [OUTPUT_NAME <name>] [RUN_TIME <parameter>...|all]
#                      [SUPPORT <file name>] [OPTIONS <option>...])
# torsor_add_mechanism(<name> URDF <file.urdf> KERNELS <kernel>... [OUTPUT_NAME <name>] [RUN_TIME <parameter>...|all]
#                      [SUPPORT <file name>] [OPTIONS <option>...] [SHARED])
#
# Builds the program <name>_scene from the scene, or takes the tool torsor for a URDF, xacro or MJCF file, and runs it to write
# <output name>.hpp (<name>.hpp by default) and make the interface target <name>: what links to it can write #include
# "<name>.hpp". The target <name>_header stands for the writing alone, and the target property TORSOR_HEADER of <name>
# holds the path of the header. With SUPPORT, what all headers have in common goes to a file of that name beside the
# header, which includes it. The namespace of the header is the name of the scene; for a URDF file it is <name>.
# OPTIONS are further ones of `generate`: --forward factorisation, or for a URDF file --base floating. A file that does
# not exist, and that nothing in this project generates, is an error here and not only when it is built.
#
# With SHARED, <name> is a shared library too, with the interface of runtime/abi.h for C, Python and all that calls C,
# compiled by this project's compiler with its flags: what links to it can write #include "torsor/runtime/abi.h". Give
# CMAKE_CXX_FLAGS -march=native where it runs where it is built. A mechanism with constraints needs Eigen.
#
# The program runs again only when it, and so its scene or torsor, was built again, or the URDF file or one that it
# includes changed; it leaves a header alone whose bytes would not change, so that nothing is compiled again then. The stamp is what the build tool
# looks at: with the header itself as output, make would find an unchanged header old for ever.
function(torsor_add_mechanism name)
  cmake_parse_arguments(PARSE_ARGV 1 mechanism "SHARED" "SCENE;URDF;OUTPUT_NAME;SUPPORT" "KERNELS;RUN_TIME;OPTIONS")
  if(mechanism_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "torsor_add_mechanism(${name}): '${mechanism_UNPARSED_ARGUMENTS}' is no argument; "
                        "the arguments are SCENE or URDF, KERNELS, OUTPUT_NAME, RUN_TIME, SUPPORT, OPTIONS and SHARED")
  endif()
  # An empty list is no RUN_TIME parameter and no option: OPTIONS ${more}.
  list(REMOVE_ITEM mechanism_KEYWORDS_MISSING_VALUES RUN_TIME OPTIONS)
  if(mechanism_KEYWORDS_MISSING_VALUES)
    list(JOIN mechanism_KEYWORDS_MISSING_VALUES ", " missing)
    message(FATAL_ERROR "torsor_add_mechanism(${name}): nothing stands behind ${missing}; give a value, or leave the keyword out")
  endif()
  if((NOT mechanism_SCENE AND NOT mechanism_URDF) OR NOT mechanism_KERNELS)
    message(FATAL_ERROR "torsor_add_mechanism(${name}): give SCENE <file.cpp> or URDF <file.urdf>, and KERNELS <kernel>...")
  endif()
  if(mechanism_SCENE AND mechanism_URDF)
    message(FATAL_ERROR "torsor_add_mechanism(${name}): give SCENE or URDF, not both")
  endif()
  foreach(kind SCENE URDF)
    if(NOT mechanism_${kind})
      continue()
    endif()
    cmake_path(ABSOLUTE_PATH mechanism_${kind} BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
    get_source_file_property(generated "${mechanism_${kind}}" GENERATED)
    if(NOT EXISTS "${mechanism_${kind}}" AND NOT generated)
      message(FATAL_ERROR "torsor_add_mechanism(${name}): there is no file '${mechanism_${kind}}'; "
                          "${kind} takes a path, from ${CMAKE_CURRENT_SOURCE_DIR} when it is relative")
    elseif(IS_DIRECTORY "${mechanism_${kind}}")
      message(FATAL_ERROR "torsor_add_mechanism(${name}): '${mechanism_${kind}}' is a folder; ${kind} takes a file")
    endif()
  endforeach()
  set(needed torsor::generator)
  set(component generator)
  if(mechanism_URDF)
    set(needed torsor::torsor)
    set(component tool)
  endif()
  if(NOT TARGET ${needed})
    message(FATAL_ERROR "torsor_add_mechanism(${name}): there is no target ${needed}; "
                        "call find_package(torsor) with the component ${component}, or add_subdirectory, first")
  endif()
  if(NOT mechanism_OUTPUT_NAME)
    set(mechanism_OUTPUT_NAME "${name}")
  endif()

  if(mechanism_SUPPORT)
    cmake_path(SET support_name NORMALIZE "${mechanism_SUPPORT}")
    if(support_name STREQUAL "${mechanism_OUTPUT_NAME}.hpp")
      message(FATAL_ERROR "torsor_add_mechanism(${name}): SUPPORT ${mechanism_SUPPORT} is the header itself; "
                          "give what all headers have in common another name, as torsor_support.hpp")
    endif()
  endif()
  # What the function gives itself, and what would write no header or write it elsewhere.
  set(own_options "--kernels;KERNELS;--output;OUTPUT_NAME;-o;OUTPUT_NAME;--run-time;RUN_TIME;--support;SUPPORT")
  list(APPEND own_options "--name;the name of the mechanism;--depfile;no option, for the build tool follows files by itself"
                          "--language;no option, for the function writes a header of C++")
  foreach(option IN LISTS mechanism_OPTIONS)
    string(REGEX REPLACE "=.*" "" option "${option}")
    list(FIND own_options "${option}" place)
    math(EXPR even "${place} % 2")
    if(option MATCHES "^-" AND even EQUAL 0)
      math(EXPR place "${place} + 1")
      list(GET own_options ${place} instead)
      message(FATAL_ERROR "torsor_add_mechanism(${name}): ${option} is no option for OPTIONS; give ${instead}")
    endif()
  endforeach()

  if(mechanism_URDF)
    set(program torsor::torsor)
    set(inputs "${mechanism_URDF}")
    set(arguments "${mechanism_URDF}" --name "${name}")
  else()
    add_executable(${name}_scene "${mechanism_SCENE}")
    target_link_libraries(${name}_scene PRIVATE torsor::generator)
    set(program ${name}_scene)
    set(inputs "")
    set(arguments "")
  endif()

  set(folder "${CMAKE_CURRENT_BINARY_DIR}/torsor/${name}")
  set(header "${folder}/${mechanism_OUTPUT_NAME}.hpp")
  set(stamp "${CMAKE_CURRENT_BINARY_DIR}/torsor/${name}.stamp")
  list(JOIN mechanism_KERNELS "," kernels)
  list(APPEND arguments --kernels "${kernels}")
  if(mechanism_RUN_TIME)
    list(JOIN mechanism_RUN_TIME "," run_time)
    list(APPEND arguments --run-time "${run_time}")
  endif()
  # In quotes, so that an option with a semicolon stays one.
  set(options "")
  if(DEFINED mechanism_OPTIONS)
    set(options ";${mechanism_OPTIONS}")
  endif()
  set(library_arguments "${arguments}${options};--sources;${folder}/library")
  list(APPEND arguments --output "${header}")
  set(support "")
  if(mechanism_SUPPORT)
    set(support "${folder}/${mechanism_SUPPORT}")
    list(APPEND arguments --support "${support}")
  endif()
  string(APPEND arguments "${options}")
  file(MAKE_DIRECTORY "${folder}")
  # make does not notice that a command changed; this file changes with it.
  file(CONFIGURE OUTPUT "${folder}.arguments" CONTENT "${arguments}\n" @ONLY)
  set(found_inputs "")
  if(mechanism_URDF)
    # What the file includes is known when it has been read.
    list(APPEND arguments --depfile "${stamp}.d")
    set(found_inputs DEPFILE "${stamp}.d")
  endif()
  add_custom_command(OUTPUT "${stamp}" BYPRODUCTS "${header}" ${support}
    COMMAND ${program} generate ${arguments}
    COMMAND "${CMAKE_COMMAND}" -E touch "${stamp}"
    DEPENDS ${program} ${inputs} "${folder}.arguments" ${found_inputs}
    COMMENT "Generating ${mechanism_OUTPUT_NAME}.hpp" VERBATIM)
  add_custom_target(${name}_header DEPENDS "${stamp}")

  if(mechanism_SHARED)
    torsor_add_shared_library()
    set(scope PUBLIC)
  else()
    add_library(${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${name} ${scope} "${folder}")
  target_compile_features(${name} INTERFACE cxx_std_17)
  set_target_properties(${name} PROPERTIES TORSOR_HEADER "${header}")
  add_dependencies(${name} ${name}_header)
endfunction()

# The library of torsor_add_mechanism(... SHARED), from what `build --sources` writes; reads the variables of its caller.
macro(torsor_add_shared_library)
  set(library_stamp "${CMAKE_CURRENT_BINARY_DIR}/torsor/${name}.library.stamp")
  set(library_source "${folder}/library/library.cpp")
  file(MAKE_DIRECTORY "${folder}/library")
  add_custom_command(OUTPUT "${library_stamp}" BYPRODUCTS "${library_source}"
    COMMAND ${program} build ${library_arguments}
    COMMAND "${CMAKE_COMMAND}" -E touch "${library_stamp}"
    DEPENDS ${program} ${inputs} "${folder}.arguments" "${stamp}"
    COMMENT "Generating the library of ${mechanism_OUTPUT_NAME}" VERBATIM)
  add_custom_target(${name}_library DEPENDS "${library_stamp}")
  set_source_files_properties("${library_source}" PROPERTIES GENERATED ON)
  add_library(${name} SHARED "${library_source}")
  add_dependencies(${name} ${name}_library)
  target_include_directories(${name} PUBLIC "${folder}/library")
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-ffp-contract=off>)
  set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET hidden CXX_EXTENSIONS OFF)
  find_package(Threads REQUIRED)
  find_package(Eigen3 QUIET NO_MODULE)
  target_link_libraries(${name} PRIVATE Threads::Threads)
  if(TARGET Eigen3::Eigen)
    target_link_libraries(${name} PRIVATE Eigen3::Eigen)
  endif()
endmacro()
