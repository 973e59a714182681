# SPDX-License-Identifier: MIT
# Compile through ccache when it is there, unless the caller chose a launcher. The sloppiness is what ccache asks for
# before it caches a compilation that uses a precompiled header.
find_program(TORSOR_CCACHE ccache)
mark_as_advanced(TORSOR_CCACHE)
if(TORSOR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros "${TORSOR_CCACHE}")
endif()
