#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# accuracy_exceptions.sh FILE MOST: every exception names one group, of a scene that there is, and a limit that is a
# number, once; at most MOST. Whether each is needed says `verify --every-exception-needed`.
set -euo pipefail
generated="$(dirname "$1")/../generated"
for scene in $(awk -F ' *[|] *' '/^#/ || /^ *$/ { next } { print $1 }' "$1" | sort -u); do
  [ -e "$generated/$scene.hpp" ] || { echo "no such scene: $scene"; exit 1; }
done
awk -F ' *[|] *' -v most="$2" '
  /^#/ || /^ *$/ { next }
  NF != 6 { print "not six fields: " $0; bad = 1; next }
  { for (i = 1; i <= 4; ++i) if ($i == "*") { print "names more than one group: " $0; bad = 1 } }
  $4 != "double" && $4 != "float" { print "neither double nor float: " $0; bad = 1 }
  $5 !~ /^[0-9]+([.][0-9]+)?(e[+]?[0-9]+)?$/ || $5 + 0 <= 8 { print "no limit above the bar: " $0; bad = 1 }
  seen[$1, $2, $3, $4]++ { print "twice: " $0; bad = 1 }
  { ++n }
  END {
    if (n > most) { print n " exceptions, " most " are allowed"; bad = 1 }
    if (!bad) print n " exceptions, each of one group and with a limit"
    exit bad
  }' "$1"
