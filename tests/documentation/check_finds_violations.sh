#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_finds_violations.sh SCRIPT: pages_are_linked.sh passes a small manual, and fails for each thing that is wrong in one.
set -euo pipefail
script="$1"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
manual() {
  rm -rf "$folder/m"
  mkdir -p "$folder/m/docs"
  cd "$folder/m"
  printf 'site_name: m\nnav:\n  - First: a.md\n  - Second:\n      - Third: b.md\n      - Fourth: c.md\n' > mkdocs.yml
  printf '# A\n[b](b.md#one-two) [site](https://example.org)\n```\n[x](nowhere.md)\n```\n' > docs/a.md
  printf '# B\n## One `two`\n' > docs/b.md
  printf '# C\n[up](../README.md)\n' > docs/c.md
  printf '# M\n[a](docs/a.md)\n' > README.md
  printf '# H\n' > CONTRIBUTING.md
}
manual
bash "$script" "$folder/m" > /dev/null || { echo "a manual without fault was refused"; bash "$script" "$folder/m"; exit 1; }
refused() { # WHAT EXPECTED-TEXT
  if text="$(bash "$script" "$folder/m")"; then echo "not noticed: $1"; exit 1; fi
  grep -q -- "$2" <<< "$text" || { echo "$1: the message does not say '$2': $text"; exit 1; }
}
manual; printf '# D\n' > docs/d.md; refused "a page outside the navigation" "docs/d.md is not in the navigation"
manual; rm docs/c.md; refused "an entry without its page" "there is no docs/c.md"
manual; printf '  - Again: a.md\n' >> mkdocs.yml; refused "a page that stands twice" "a.md stands twice"
manual; printf '[d](d.md)\n' >> docs/c.md; refused "a link to no file" "d.md leads nowhere"
manual; printf '[b](b.md#three)\n' >> docs/c.md; refused "a link to no heading" "no heading 'three'"
manual; printf '[b](docs/b.md#three)\n' >> README.md; refused "a link of README to no heading" "no heading 'three'"
echo "all six are noticed"
