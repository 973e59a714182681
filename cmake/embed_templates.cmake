# SPDX-License-Identifier: MIT
# Run as a script: cmake -DTEMPLATES=<folder> -DOUTPUT=<file.cpp> -P embed_templates.cmake
# Writes the text of every file of the folder into one source file, so that an installed generator needs no path.
# A template is named by its path below the folder. -DFUNCTION=<name>: of the function that finds a text, declared by
# generator/emission/<name>s.hpp; embedded_template by default. -DWITHOUT=<regular expression>: files left out.
if(NOT FUNCTION)
  set(FUNCTION embedded_template)
endif()
file(GLOB_RECURSE names RELATIVE "${TEMPLATES}" "${TEMPLATES}/*")
if(WITHOUT)
  list(FILTER names EXCLUDE REGEX "${WITHOUT}")
endif()
list(SORT names)

set(entries "")
set(count 0)
foreach(name IN LISTS names)
  file(READ "${TEMPLATES}/${name}" text)
  if(text MATCHES "\\)torsor_template\"")
    message(FATAL_ERROR "${TEMPLATES}/${name}: the text )torsor_template\" ends the string it is embedded in; reword it")
  endif()
  string(APPEND entries "    Entry{\"${name}\", whole(R\"torsor_template(${text})torsor_template\")},\n")
  math(EXPR count "${count} + 1")
endforeach()

file(WRITE "${OUTPUT}.new" "// SPDX-License-Identifier: GPL-3.0-or-later
// Made by cmake/embed_templates.cmake from files of the sources; change those.
#include \"torsor/generator/emission/${FUNCTION}s.hpp\"

#include <array>
#include <cstddef>
#include <string>

#include \"torsor/generator/base/error.hpp\"

namespace torsor {
namespace {

struct Entry {
  std::string_view name;
  std::string_view text;
};

// Its size is known: a compiler that counted the characters would give up.
template <std::size_t size>
constexpr std::string_view whole(const char (&text)[size]) {
  return {text, size - 1};
}

constexpr std::array<Entry, ${count}> entries{
${entries}};

}  // namespace

std::vector<std::string_view> ${FUNCTION}_names() {
  std::vector<std::string_view> names;
  names.reserve(entries.size());
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

std::string_view ${FUNCTION}(std::string_view name) {
  std::string known;
  for (const Entry& entry : entries) {
    if (entry.name == name) return entry.text;
    known += known.empty() ? \"\" : \", \";
    known += entry.name;
  }
  throw Error(\"no text is named '\" + std::string(name) + \"'; the texts are: \" + known);
}

}  // namespace torsor
")
file(COPY_FILE "${OUTPUT}.new" "${OUTPUT}" ONLY_IF_DIFFERENT)
file(REMOVE "${OUTPUT}.new")
