# SPDX-License-Identifier: MIT
# Compile through ccache when it is there, unless the caller chose a launcher. The sloppiness is what ccache asks for
# before it caches a compilation that uses a precompiled header. By CCACHE_DEPEND an object is found by the bytes of all
# files it is made of, never by its preprocessed text: where comments alone changed, that text would give back the old
# precompiled header, and g++ knows the files in there by their bytes, so it would read the changed one a second time.
find_program(TORSOR_CCACHE ccache)
mark_as_advanced(TORSOR_CCACHE)
if(TORSOR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
      CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros "${TORSOR_CCACHE}")
endif()
