# SPDX-License-Identifier: MIT
# Packages by `cpack -G DEB` or `cpack -G TGZ` in a build folder: the tool, what programs link to, the package of Python.
# Who makes them is DEBFULLNAME and DEBEMAIL, as Debian's own tools read them.
if(NOT PROJECT_IS_TOP_LEVEL OR NOT TORSOR_INSTALL)
  return()
endif()
set(CPACK_PACKAGE_VENDOR "torsor")
set(TORSOR_PACKAGER "" CACHE STRING "who makes packages, Name <address>; DEBFULLNAME and DEBEMAIL when empty")
mark_as_advanced(TORSOR_PACKAGER)
set(CPACK_PACKAGE_CONTACT "${TORSOR_PACKAGER}")
if(NOT CPACK_PACKAGE_CONTACT AND NOT "$ENV{DEBEMAIL}" STREQUAL "")
  set(packager "$ENV{DEBFULLNAME}")
  if(packager STREQUAL "")
    set(packager "The packager of torsor")
  endif()
  set(CPACK_PACKAGE_CONTACT "${packager} <$ENV{DEBEMAIL}>")
endif()
if(NOT CPACK_PACKAGE_CONTACT)  # good on this machine only
  set(CPACK_PACKAGE_CONTACT "The developers of torsor <torsor@localhost>")
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_FILE_NAME "torsor-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSES/GPL-3.0-or-later.txt")
set(CPACK_STRIP_FILES ON)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # what was built is packed
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_COMPONENTS_ALL tool generator-dev runtime-dev python)
if(TARGET torsor_scene)
  list(APPEND CPACK_COMPONENTS_ALL python-scene)
endif()

set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION "science")
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME "torsor")
set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_TOOL_DESCRIPTION "Equations of motion of mechanisms, as code
Reads a robot's file (URDF, xacro, MJCF), derives its equations of motion and
writes them as one C++ or C header, or as one JavaScript module.")
set(CPACK_DEBIAN_GENERATOR-DEV_PACKAGE_NAME "libtorsor-generator-dev")
set(CPACK_DEBIAN_GENERATOR-DEV_PACKAGE_SECTION "libdevel")
set(generator_needs "torsor (= ${PROJECT_VERSION}), libginac-dev, libcln-dev, libfmt-dev, libtinyxml2-dev")
if(TORSOR_ARB_INCLUDE_DIR AND TORSOR_ARB_LIBRARY AND TORSOR_FLINT_LIBRARY)
  string(APPEND generator_needs ", libflint-arb-dev, libflint-dev")
endif()
if(TORSOR_ASSIMP_INCLUDE_DIR AND TORSOR_ASSIMP_LIBRARY)
  string(APPEND generator_needs ", libassimp-dev")
endif()
set(CPACK_DEBIAN_GENERATOR-DEV_PACKAGE_DEPENDS "${generator_needs}")
set(CPACK_COMPONENT_GENERATOR-DEV_DESCRIPTION "Mechanisms described in C++, for torsor
The library that a scene is written with, and that derives its equations.")
set(CPACK_DEBIAN_RUNTIME-DEV_PACKAGE_NAME "libtorsor-runtime-dev")
set(CPACK_DEBIAN_RUNTIME-DEV_PACKAGE_SECTION "libdevel")
set(CPACK_DEBIAN_RUNTIME-DEV_PACKAGE_DEPENDS "torsor (= ${PROJECT_VERSION}), libeigen3-dev")
set(CPACK_COMPONENT_RUNTIME-DEV_DESCRIPTION "Motions of the mechanisms that torsor generates
Integrators, events, equilibria and comparisons for generated headers (MIT).")
# In Debian's folder of modules, which belongs to no other prefix: a component of packages only.
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME "python3-torsor")
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE "all")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION "python")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.9), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "torsor (= ${PROJECT_VERSION}), g++")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Kernels of mechanisms on numpy arrays, from torsor
Opens the libraries of `torsor build`, or makes them from robots' files (MIT).")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA  # compile modules, and take them away again
  "${PROJECT_SOURCE_DIR}/cmake/python3-torsor/postinst" "${PROJECT_SOURCE_DIR}/cmake/python3-torsor/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
install(DIRECTORY python/torsor DESTINATION lib/python3/dist-packages COMPONENT python EXCLUDE_FROM_ALL
  FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
if(TARGET torsor_scene)
  set(CPACK_DEBIAN_PYTHON-SCENE_PACKAGE_NAME "python3-torsor-scene")
  set(CPACK_DEBIAN_PYTHON-SCENE_PACKAGE_SECTION "python")
  set(CPACK_DEBIAN_PYTHON-SCENE_PACKAGE_SHLIBDEPS ON)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON-SCENE_PACKAGE_DEPENDS
    "python3-torsor (= ${PROJECT_VERSION}), python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor})")
  set(CPACK_COMPONENT_PYTHON-SCENE_DESCRIPTION "Mechanisms described in Python, for torsor
The module under torsor.scene: frames, bodies, joints, actions and
constraints, with the equations and the generated code of scenes in C++.")
  install(TARGETS torsor_scene LIBRARY DESTINATION lib/python3/dist-packages COMPONENT python-scene EXCLUDE_FROM_ALL)
  install(DIRECTORY python/scene/_torsor_scene DESTINATION lib/python3/dist-packages COMPONENT python-scene EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN "*.pyi")
endif()

# Copyright and changelog, as Debian wants them in each package: those of debian/, which makes the same packages in a
# build of its own, with the address of who makes these.
find_program(TORSOR_GZIP gzip)
mark_as_advanced(TORSOR_GZIP)
set(package_texts "${PROJECT_SOURCE_DIR}/debian/copyright")
if(TORSOR_GZIP)
  file(READ "${PROJECT_SOURCE_DIR}/debian/changelog" changelog)
  string(REGEX REPLACE " -- [^>]*>" " -- ${CPACK_PACKAGE_CONTACT}" changelog "${changelog}")
  file(WRITE "${PROJECT_BINARY_DIR}/texts/changelog" "${changelog}")
  execute_process(COMMAND "${TORSOR_GZIP}" -9nkf "${PROJECT_BINARY_DIR}/texts/changelog" COMMAND_ERROR_IS_FATAL ANY)
  list(APPEND package_texts "${PROJECT_BINARY_DIR}/texts/changelog.gz")
endif()
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(only_packages "")
  if(component MATCHES "^python")
    set(only_packages EXCLUDE_FROM_ALL)
  endif()
  string(TOUPPER "${component}" upper)
  install(FILES ${package_texts} DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}"
    COMPONENT ${component} ${only_packages})
endforeach()
include(CPack)
