# SPDX-License-Identifier: GPL-3.0-or-later
# Run as a script: cmake -DHEADERS=<header>;... -DOUTPUT=<file.cpp> -P comments.cmake
# The comment of each operation that the headers declare, as text for help(): one place says what an operation means.
cmake_minimum_required(VERSION 3.25)
set(entries "")
set(known "")
foreach(header IN LISTS HEADERS)
  file(READ "${header}" text)
  # Lines as a list: what CMake counts as its own is put aside.
  string(REPLACE ";" "<semicolon>" text "${text}")
  string(REPLACE "[" "<open>" text "${text}")
  string(REPLACE "]" "<close>" text "${text}")
  string(REPLACE "\\" "<backslash>" text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  set(comment "")
  foreach(line IN LISTS lines)
    if(line MATCHES "^ +/// ?(.*)$")
      string(APPEND comment "${CMAKE_MATCH_1}\n")
    elseif(line MATCHES "^  [A-Za-z][^(]* ([a-z_]+)\\(")
      set(name "${CMAKE_MATCH_1}")  # of several overloads the first
      if(NOT comment STREQUAL "" AND NOT name IN_LIST known)
        list(APPEND known "${name}")
        string(REPLACE "<semicolon>" ";" comment "${comment}")
        string(REPLACE "<open>" "[" comment "${comment}")
        string(REPLACE "<close>" "]" comment "${comment}")
        string(REPLACE "<backslash>" "\\" comment "${comment}")
        string(APPEND entries "    {\"${name}\", R\"torsor_comment(${comment})torsor_comment\"},\n")
      endif()
      set(comment "")
    else()
      set(comment "")
    endif()
  endforeach()
endforeach()
file(WRITE "${OUTPUT}.new" "// SPDX-License-Identifier: GPL-3.0-or-later
// Made by python/scene/comments.cmake from comments of the generator's headers; change those.
#include <stdexcept>
#include <string>
#include <utility>

namespace torsor::python {

const char* comment_of(const char* operation);

const char* comment_of(const char* operation) {
  static constexpr std::pair<const char*, const char*> comments[] = {
${entries}  };
  for (const auto& [name, text] : comments) {
    if (std::string(name) == operation) return text;
  }
  throw std::logic_error(std::string(\"no comment tells of \") + operation);
}

}  // namespace torsor::python
")
file(COPY_FILE "${OUTPUT}.new" "${OUTPUT}" ONLY_IF_DIFFERENT)
file(REMOVE "${OUTPUT}.new")
