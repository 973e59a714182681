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

# What users include, and what that includes in turn.
set(headers_of_generator torsor.hpp queries.hpp emission/header.hpp import/urdf.hpp kernels/kernel.hpp
  printing/print_equations.hpp)
set(headers_of_runtime abi.h abi/mechanism_library.hpp mechanism.hpp
  batch/batch.hpp batch/motion_ensemble.hpp batch/packed_motion_ensemble.hpp
  constraints/consistent_state.hpp constraints/constrained_motion.hpp constraints/partitioned_motion.hpp
  constraints/projection.hpp
  contacts/contact_exchange.hpp contacts/contact_solver.hpp contacts/impact_laws.hpp contacts/integrate_contacts.hpp
  contacts/mechanism_with_contacts.hpp contacts/moreau_jean.hpp
  grains/grain_motion.hpp mpi/ensemble_mpi.hpp numerics/decompositions.hpp numerics/linear_solve.hpp
  sundials/sundials.hpp)
file(GLOB documented RELATIVE "${PROJECT_SOURCE_DIR}/runtime" "runtime/events/*.hpp" "runtime/integration/*.hpp"
  "runtime/records/*.hpp" "runtime/small_motions/*.hpp")
list(APPEND headers_of_runtime ${documented})
foreach(folder generator runtime)
  list(TRANSFORM headers_of_${folder} PREPEND "${folder}/")
  install(CODE "set(SOURCE [==[${PROJECT_SOURCE_DIR}]==])
    set(HEADERS [==[${headers_of_${folder}}]==])
    set(FOLDER ${folder})
    set(DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/torsor\")
    include([==[${PROJECT_SOURCE_DIR}/cmake/install_public_headers.cmake]==])" COMPONENT ${folder}-dev)
endforeach()
# The user of a mechanism's library in Octave and MATLAB, who compiles it.
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
