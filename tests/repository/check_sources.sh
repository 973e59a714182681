#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_sources.sh ROOT: the rules of the layout that a compiler does not check. Prints each violation and fails.
#  * a file of generator/ includes its own layer or a lower one, and so within the folders of generator/dynamics and
#    runtime; runtime/ and examples' mains never include generator/, and of generator/ only cli includes runtime/contacts and the
#    methods of runtime/integration by which they move;
#  * headers are "torsor/generator/..." and "torsor/runtime/...", which no folder of a user's project can be taken for;
#  * a generated header includes <array> and <cmath> only;
#  * the SPDX line near the top names the licence of the folder;
#  * no source is above 500 lines (what is generated may be).
set -euo pipefail
cd "$1"

find . \( -path ./build -o -path './.*' \) -prune -o -type f \
  \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' -o -name '*.cmake' -o -name '*.cmake.in' -o -name '*.sh' \
     -o -name CMakeLists.txt -o -path './templates/*' -o -path './scripts/*' \) -printf '%P\n' | LC_ALL=C sort |
awk '
  BEGIN {
    layers = "base 0 expression 1 program 2 listing 3 geometry 4 mechanics 5 dynamics 6 import 6 kernels 7 emission 8 printing 8 graphs 8 verification 9 cli 10 torsor.hpp 11 queries.hpp 11"  # the umbrella headers stand on all
    count = split(layers, word, " ")
    for (i = 1; i < count; i += 2) height[word[i]] = word[i + 1]
    rooms("generator/dynamics", "motion forces recursions structure equations derivatives theorems")
    rooms("runtime", "numerics records steps constraints events integration contacts small_motions sundials batch grains mpi abi")
    room_height["runtime"] = 0  # the contract between mechanisms and methods, in the folder itself
    split("runtime cmake examples", list, " ")
    for (i in list) licence_of[list[i]] = "MIT"
    licence_of["templates"] = licence_of["generated"] = "MIT-0"  # who embeds them owes nothing
  }
  # Folders within a folder, lowest first.
  function rooms(parent, names,   list, i) {
    split(names, list, " ")
    for (i in list) room_height[parent "/" list[i]] = i + 0
  }
  function room_of(path) { sub(/\/[^\/]*$/, "", path); return path }
  function parent_of(path) { return path ~ /^generator\/dynamics\// ? "generator/dynamics" : path ~ /^runtime\// ? "runtime" : "" }
  function violation(text) { print text; bad = 1 }
  function included(line,   path) {
    if (line !~ /^[ \t]*#[ \t]*include[ \t]*["<]/) return ""
    path = line
    sub(/^[^"<]*["<]/, "", path)
    sub(/[">].*$/, "", path)
    return path
  }
  function check(file,   part, folder, line, number, licence, spdx, path, piece, code, room, other) {
    split(file, part, "/")
    folder = file ~ /\// ? part[1] : ""
    licence = folder in licence_of ? licence_of[folder] : "GPL-3.0-or-later"
    code = file ~ /\.(cpp|hpp|h)$/
    number = 0
    spdx = ""
    while ((getline line < file) > 0) {
      ++number
      # REUSE-IgnoreStart
      if (number <= 3 && line ~ /SPDX-License-Identifier: /) {
        spdx = line
        sub(/^.*SPDX-License-Identifier: */, "", spdx)
        sub(/[ \t*\/#>-]*$/, "", spdx)
      }
      # REUSE-IgnoreEnd
      path = code ? included(line) : ""
      if (path ~ /^(runtime|generator)\//)
        violation(file ":" number ": write torsor/" path ", which no folder of a user is taken for")
      sub(/^torsor\//, "", path)
      if (path == "") continue
      split(path, piece, "/")
      if (folder == "generator" && piece[1] == "generator") {
        if (!(part[2] in height)) violation(file ": generator/" part[2] " is no layer; the layers are " layers)
        else if (!(piece[2] in height)) violation(file ":" number ": generator/" piece[2] " is no layer")
        else if (height[piece[2]] > height[part[2]])
          violation(file ":" number ": layer " part[2] " includes the higher layer " piece[2] " (" path ")")
      }
      if (parent_of(file) != "" && parent_of(file) == parent_of(path)) {
        room = room_of(file)
        other = room_of(path)
        if (!(room in room_height)) violation(file ": " room " is no folder of " parent_of(file))
        else if (!(other in room_height)) violation(file ":" number ": " other " is no folder of " parent_of(file))
        else if (room_height[other] > room_height[room] && file != "runtime/mechanism.hpp")  # it makes motions: on all of them
          violation(file ":" number ": " room " includes " other ", which stands higher (" path ")")
      }
      if (folder == "generator" && piece[1] == "runtime" && !(part[2] == "cli" && piece[2] ~ /^(contacts|integration)$/)) violation(file ":" number ": generator includes runtime (" path ")")
      if (folder == "runtime" && piece[1] == "generator") violation(file ":" number ": runtime includes generator (" path ")")
      if (file ~ /^examples\/[^\/]*\/main/ && piece[1] == "generator")
        violation(file ":" number ": a main includes generator (" path "); only its scene may")
      if (folder == "generated" && path != "array" && path != "cmath" && path != "torsor_support.hpp")
        violation(file ":" number ": a generated header includes <" path ">; only <array>, <cmath> and its support are allowed")
    }
    close(file)
    if (spdx != licence)
      violation(file ": the SPDX line of its first three lines must read " licence ", not \"" spdx "\"")
    if (number > 500 && folder != "generated") violation(file ": " number " lines; split it, 500 is the most")
  }
  { check($0); ++checked }
  END {
    print checked " files checked"
    if (checked < 10 && !bad) { print "that is too few to be this repository"; bad = 1 }
    exit bad
  }
'
