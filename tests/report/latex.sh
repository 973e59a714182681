#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# latex.sh PDFLATEX FOLDER PROGRAM...: equations of scene programs as LaTeX documents become pages without an error and without a
# line that is wider than the page.
set -euo pipefail
pdflatex="$1" folder="$2"
shift 2
mkdir -p "$folder"
cd "$folder"
failed=0
for program in "$@"; do
  name="$(basename "$program")"
  "$program" equations --format latex --document --output "$name.tex"
  "$pdflatex" -interaction=batchmode "$name.tex" > /dev/null || true
  wrong="$(grep -E '^(Overfull|!)' "$name.log" || true)"
  if [ -n "$wrong" ] || [ ! -s "$name.pdf" ]; then
    echo "$name: $wrong" >&2
    failed=1
  else
    echo "$name: fits the page"
  fi
done
exit "$failed"
