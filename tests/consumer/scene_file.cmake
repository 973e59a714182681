# SPDX-License-Identifier: GPL-3.0-or-later
# torsor SCENE.cpp COMMAND: a scene in C++ without a project. Its program is kept, and built again when what it is made of
# has changed; whatever is missing is named.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}/a folder")
set(scene "${FOLDER}/a folder/pendulum.cpp")
file(WRITE "${FOLDER}/a folder/length.hpp" "inline int length() { return 2; }\n")
file(WRITE "${scene}" "
#include \"torsor/generator/torsor.hpp\"
#include \"length.hpp\"
torsor::Scene pendulum() {
  using namespace torsor;
  Scene scene(\"pendulum\", \"A rod that swings\");
  const Expression m = scene.parameter(\"m\", \"kg\", 1), g = scene.parameter(\"g\", \"m/s^2\", 10);
  const Expression l = scene.parameter(\"l\", \"m\", length());
  const Expression theta = scene.coordinate(\"theta\", \"rad\");
  const FrameHandle rod = scene.revolute(\"rod\", scene.ground(), axis::y, theta);
  scene.body(\"rod\", rod, Inertia::rod(m, l, 2).at({0, 0, -l / 2}));
  scene.gravity({0, 0, -g});
  return scene;
}
TORSOR_SCENE(pendulum)
")
set(ENV{TORSOR_CACHE} "${FOLDER}/cache")
set(ENV{CXX} "${COMPILER}")

# torsor(<code> <words>...): runs the tool, which must end with this code; sets `output`.
macro(torsor code)
  execute_process(COMMAND "${TOOL}" ${ARGN} WORKING_DIRECTORY "${FOLDER}/a folder"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL "${code}")
    message(FATAL_ERROR "torsor ${ARGN} ends with ${result} and not with ${code}:\n${output}")
  endif()
endmacro()
macro(expect pattern)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "'${pattern}' does not occur in:\n${output}")
  endif()
endmacro()
function(programs variable)
  file(GLOB found "${FOLDER}/cache/scene-*")
  list(FILTER found EXCLUDE REGEX "\\.inputs$")
  list(LENGTH found count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "the cache holds ${found}")
  endif()
  file(TIMESTAMP "${found}" date "%s" UTC)
  file(SHA256 "${found}" digest)
  set(${variable} "${date} ${digest}" PARENT_SCOPE)
endfunction()

torsor(0 pendulum.cpp equations)
expect("l = 2 ")
programs(first)
torsor(0 equations "${scene}")  # another spelling of both orders
expect("l = 2 ")
foreach(included "${FOLDER}/a folder/length.hpp" length.hpp pendulum.cpp)
  torsor(2 pendulum.cpp equations --output "${included}")
  expect("would overwrite '[^']*', which the command reads")
endforeach()
programs(second)
if(NOT first STREQUAL second)
  message(FATAL_ERROR "a scene that has not changed was built again")
endif()
torsor(2 pendulum.cpp lost)
expect("pendulum.cpp: unknown command 'lost'.*did you mean 'list'")

file(WRITE "${FOLDER}/a folder/length.hpp" "inline int length() { return 3; }\n")
torsor(0 pendulum.cpp equations)
expect("l = 3 ")

file(WRITE "${FOLDER}/a folder/length.hpp" "inline int length() { return three; }\n")
torsor(3 pendulum.cpp list)
expect("the compiler refuses the scene '[^']*pendulum.cpp'.*length.hpp:1.*three")
file(WRITE "${FOLDER}/a folder/empty.cpp" "int nothing;\n")
torsor(3 empty.cpp list)
expect("empty.cpp' has no program: end it with TORSOR_SCENE")
torsor(3 missing.cpp list)
expect("there is no file 'missing.cpp'")
set(ENV{CXX} "${FOLDER}/no compiler")
torsor(3 pendulum.cpp list)
expect("no C.. compiler: CXX, which is '[^']*no compiler', does not run")
set(ENV{CXX} "${COMPILER}")
set(ENV{torsor_ROOT} "${FOLDER}")
set(ENV{CMAKE_PREFIX_PATH} "")
torsor(3 empty.cpp list)
expect("libraries are not found|has no program")  # found, where torsor is installed on this machine
