#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# readme_scene.sh ROOT: the scene in README, its equations and its other lines of C++ are those of docs/tutorial.md, which is run;
# and README stays short.
set -euo pipefail
cd "$1"
block() { # LANGUAGE: the first code block of README in it
  awk -v open="\`\`\`$1" '!found && $0 == open { on = found = 1; next } on && /^```/ { exit } on' README.md
}
tutorial="$(cat docs/tutorial.md)"
scene="$(block cpp)"
[ "$(wc -l <<< "$scene")" -ge 10 ] || { echo "README has no scene"; exit 1; }
[[ "$tutorial" == *"$scene"* ]] || { echo "README's scene is not that of docs/tutorial.md, word by word"; exit 1; }
while read -r line; do
  grep -qF -- "$line" docs/tutorial.md || { echo "docs/tutorial.md does not print: $line"; exit 1; }
done < <(awk '$0 == "```" && !on { on = 1; next } /^```/ && on { exit } /^```[a-z]/ { getline; while ($0 != "```") getline; next } on' README.md)
while read -r line; do
  grep -qF -- "$line" docs/tutorial.md || { echo "docs/tutorial.md does not have: $line"; exit 1; }
done < <(awk '/^```cpp$/ { on = 1; next } /^```$/ { on = 0 } on' README.md)
lines="$(wc -l < README.md)"
[ "$lines" -lt 120 ] || { echo "README has $lines lines; fewer than 120 are read"; exit 1; }
echo "README: $lines lines, its scene is the tutorial's"
