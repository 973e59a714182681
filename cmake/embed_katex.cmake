# SPDX-License-Identifier: MIT
# Run as a script: cmake -DKATEX=<folder of katex.js, or nothing> -DOUTPUT=<file.cpp> -P embed_katex.cmake
# Writes KaTeX's script, style sheet and the fonts that equations of motion need into one source file, fonts as
# hexadecimal digits, so that a report needs neither a path nor a network. Without KaTeX all are empty.
set(script "")
set(style "")
set(fonts "")
set(count 0)
if(KATEX)
  foreach(name katex.min.js katex.js)
    if(NOT script AND EXISTS "${KATEX}/${name}")
      file(READ "${KATEX}/${name}" script)
    endif()
  endforeach()
  file(READ "${KATEX}/katex.min.css" style)
  foreach(name Main-Regular Main-Bold Main-Italic Math-Italic AMS-Regular Size1-Regular Size2-Regular Size3-Regular
          Size4-Regular)
    file(READ "${KATEX}/fonts/KaTeX_${name}.woff2" digits HEX)
    string(APPEND fonts "    KatexFont{\"${name}\", \"${digits}\"},\n")
    math(EXPR count "${count} + 1")
  endforeach()
  if("${script}${style}" MATCHES "\\)torsor_katex\"")
    message(FATAL_ERROR "KaTeX holds the text )torsor_katex\", which ends the string it is embedded in")
  endif()
endif()

file(WRITE "${OUTPUT}.new" "// SPDX-License-Identifier: GPL-3.0-or-later
// Made by cmake/embed_katex.cmake from the files of KaTeX (MIT, Khan Academy and contributors).
#include \"torsor/generator/cli/katex.hpp\"

#include <array>

namespace torsor {
namespace {

constexpr std::array<KatexFont, ${count}> fonts{
${fonts}};

}  // namespace

std::string_view katex_script() { return R\"torsor_katex(${script})torsor_katex\"; }
std::string_view katex_style() { return R\"torsor_katex(${style})torsor_katex\"; }
std::vector<KatexFont> katex_fonts() { return {fonts.begin(), fonts.end()}; }

}  // namespace torsor
")
file(COPY_FILE "${OUTPUT}.new" "${OUTPUT}" ONLY_IF_DIFFERENT)
file(REMOVE "${OUTPUT}.new")
