#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A cached precompiled header must be a new one where its files changed in comments alone: g++ knows the files in there
# by their bytes, and would read the changed one a second time. Builds a project of one file, twice, in a cache of its own.
# usage: cached_headers.sh FOLDER_OF_SOURCES COMPILER
set -euo pipefail
sources=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"
export CCACHE_DIR=$place/cache
cat > CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(cached_headers LANGUAGES CXX)
include("$sources/cmake/ccache.cmake")
add_executable(program program.cpp)
target_precompile_headers(program PRIVATE outer.hpp)
END
printf '#pragma once\n#include "inner.hpp"\n' > outer.hpp
printf '#include "inner.hpp"\nint main() { return Inner{}.value; }\n' > program.cpp
for comment in "one comment" "another, longer comment"; do
  printf '#pragma once\n// %s\nstruct Inner { int value = 0; };\n' "$comment" > inner.hpp
  sleep 1  # ccache does not trust files as young as the compilation
  rm -rf build
  cmake -G Ninja -S . -B build -DCMAKE_CXX_COMPILER="$2" > configured.txt || { cat configured.txt; exit 1; }
  cmake --build build > built.txt || { cat built.txt; echo "the project does not build with $comment"; exit 1; }
  printf '// and the program itself\n' >> program.cpp
done
