# SPDX-License-Identifier: MIT
# Export sets of their own, so that who embeds a header with the runtime (MIT) needs neither the generator nor GiNaC,
# nor MPI, nor SUNDIALS.
if(NOT TORSOR_INSTALL)
  return()
endif()
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/torsor")

install(TARGETS torsor EXPORT torsorToolTargets RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT tool)
install(TARGETS torsor_generator EXPORT torsorGeneratorTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT generator-dev)
install(TARGETS torsor_runtime EXPORT torsorRuntimeTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime-dev)
set(parts Tool Generator Runtime)
set(package_of_Tool tool)
set(package_of_Generator generator-dev)
set(package_of_Runtime runtime-dev)
set(package_of_RuntimeMpi runtime-dev)
set(package_of_RuntimeSundials runtime-dev)
if(TARGET torsor_runtime_mpi)
  install(TARGETS torsor_runtime_mpi EXPORT torsorRuntimeMpiTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime-dev)
  list(APPEND parts RuntimeMpi)
endif()
if(TARGET torsor_runtime_sundials)
  install(TARGETS torsor_runtime_sundials EXPORT torsorRuntimeSundialsTargets)
  list(APPEND parts RuntimeSundials)
endif()
foreach(part IN LISTS parts)
  install(EXPORT torsor${part}Targets NAMESPACE torsor:: DESTINATION "${package_dir}" COMPONENT ${package_of_${part}})
  export(EXPORT torsor${part}Targets NAMESPACE torsor:: FILE "${PROJECT_BINARY_DIR}/torsor${part}Targets.cmake")
endforeach()

foreach(folder generator runtime)
  if(EXISTS "${PROJECT_SOURCE_DIR}/${folder}")
    install(DIRECTORY "${folder}" DESTINATION "${TORSOR_INCLUDE_DIR}" COMPONENT ${folder}-dev
      FILES_MATCHING PATTERN "*.hpp")
  endif()
endforeach()
# What is C: the table of a mechanism's library, and its user in Octave and MATLAB, who compiles it.
install(FILES runtime/abi.h DESTINATION "${TORSOR_INCLUDE_DIR}/runtime" COMPONENT runtime-dev)
install(FILES runtime/octave/torsor_call.c DESTINATION "${CMAKE_INSTALL_DATADIR}/torsor/octave" COMPONENT runtime-dev)

configure_package_config_file(cmake/torsorConfig.cmake.in "${PROJECT_BINARY_DIR}/torsorConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
# For any processor: what a cross build wants is the tool, which runs here, and headers. A library of another
# architecture is refused by the linker.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/torsorConfigVersion.cmake" COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)
# Beside the configuration in the build tree too, where find_package(torsor) with torsor_DIR finds it.
file(COPY_FILE "${PROJECT_SOURCE_DIR}/cmake/torsor_add_mechanism.cmake"
  "${PROJECT_BINARY_DIR}/torsor_add_mechanism.cmake" ONLY_IF_DIFFERENT)
install(FILES "${PROJECT_BINARY_DIR}/torsorConfig.cmake" "${PROJECT_BINARY_DIR}/torsorConfigVersion.cmake"
  cmake/torsor_add_mechanism.cmake DESTINATION "${package_dir}" COMPONENT tool)
install(DIRECTORY LICENSES/ DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/torsor/LICENSES" COMPONENT tool)

# For builds that ask pkg-config. The prefix is found from the place of the file.
set(pc_dir "${CMAKE_INSTALL_DATADIR}/pkgconfig")  # as libraries are in no folder of an architecture
file(RELATIVE_PATH pc_to_prefix "/prefix/${pc_dir}" "/prefix")
string(REGEX REPLACE "/$" "" pc_to_prefix "${pc_to_prefix}")
set(pc_libraries "")
foreach(library IN ITEMS "${TORSOR_ARB_LIBRARY}" "${TORSOR_FLINT_LIBRARY}" "${TORSOR_ASSIMP_LIBRARY}")
  if(library)
    cmake_path(GET library STEM library)
    string(REGEX REPLACE "^lib" " -l" library "${library}")
    string(APPEND pc_libraries "${library}")
  endif()
endforeach()
foreach(part generator runtime)
  configure_file("cmake/torsor-${part}.pc.in" "${PROJECT_BINARY_DIR}/torsor-${part}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/torsor-${part}.pc" DESTINATION "${pc_dir}" COMPONENT ${part}-dev)
endforeach()
