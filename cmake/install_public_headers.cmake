# SPDX-License-Identifier: MIT
# Installs headers and what they include, and no others: what none of them includes is nobody's but ours, and may change.
# -DSOURCE=<folder with generator/ and runtime/> -DHEADERS=<list of them> -DFOLDER=<generator or runtime, of which headers
# are installed; those of the other come with another component> -DDESTINATION=<folder that gets generator/ or runtime/>.
cmake_policy(VERSION 3.25)
set(found "")
set(next ${HEADERS})
while(next)
  list(POP_FRONT next header)
  if(header IN_LIST found)
    continue()
  endif()
  list(APPEND found "${header}")
  file(STRINGS "${SOURCE}/${header}" lines REGEX "^ *# *include [<\"]torsor/${FOLDER}/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^.*[<\"]torsor/([^>\"]*)[>\"].*$" "\\1" included "${line}")
    list(APPEND next "${included}")
  endforeach()
endwhile()
foreach(header IN LISTS found)
  cmake_path(GET header PARENT_PATH folder)
  file(INSTALL "${SOURCE}/${header}" DESTINATION "${DESTINATION}/${folder}")
endforeach()
