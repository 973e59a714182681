# SPDX-License-Identifier: MIT
# Everything comes from the system (Debian packages, see scripts/install-dependencies).
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
if(NOT TARGET PkgConfig::cln)
  pkg_check_modules(cln REQUIRED IMPORTED_TARGET GLOBAL cln)
endif()
if(NOT TARGET PkgConfig::ginac)
  pkg_check_modules(ginac REQUIRED IMPORTED_TARGET GLOBAL ginac)
endif()
