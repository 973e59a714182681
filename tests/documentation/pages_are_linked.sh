#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# pages_are_linked.sh ROOT: each page of docs/ stands once in the navigation of mkdocs.yml, each entry is a page, and each
# relative link of docs/, README.md and CONTRIBUTING.md leads to a file, and to a heading of it where it names one.
set -euo pipefail
cd "$1"
bad=0
say() { echo "$1"; bad=1; }

entries="$(sed -n '/^nav:/,/^[a-z]/s/^ *- .*: *\([A-Za-z0-9_./-]*\.md\)$/\1/p' mkdocs.yml)"
[ -n "$entries" ] || say "mkdocs.yml: no page in the navigation"
for repeated in $(sort <<< "$entries" | uniq -d); do say "mkdocs.yml: $repeated stands twice in the navigation"; done
for entry in $entries; do
  # scripts/docs puts these beside the pages.
  case "$entry" in CONTRIBUTING.md | CHANGELOG.md) file="$entry" ;; *) file="docs/$entry" ;; esac
  [ -f "$file" ] || say "mkdocs.yml: there is no $file"
done
pages=0
for page in docs/*.md; do
  grep -qx "$(basename "$page")" <<< "$entries" || say "$page is not in the navigation of mkdocs.yml"
  pages=$((pages + 1))
done

# The anchors of a page, as GitHub and MkDocs make them of headings.
anchors() {
  awk '/^```/ { code = !code } !code && /^#+ /' "$1" | sed -e 's/^#* *//' -e 's/`//g' | tr '[:upper:]' '[:lower:]' |
    sed -e 's/[^[:alnum:] _-]//g' -e 's/ /-/g'
}
links=0
for page in README.md CONTRIBUTING.md docs/*.md; do
  folder="$(dirname "$page")"
  while read -r target; do
    [ -n "$target" ] || continue
    links=$((links + 1))
    file="${target%%#*}"
    path="$folder/$file"
    [ -n "$file" ] || path="$page"
    if [ ! -e "$path" ]; then
      say "$page: the link to $target leads nowhere"
    elif [[ "$target" == *#* ]] && ! grep -qx -- "${target#*#}" <<< "$(anchors "$path")"; then
      say "$page: $path has no heading '${target#*#}'"
    fi
  done < <(awk '/^```/ { code = !code } !code' "$page" | sed 's/`[^`]*`//g' | grep -oE '\]\([^) ]+\)' | sed -e 's/^](//' -e 's/)$//' |
    grep -vE '^(https?|mailto):' || true)
done
echo "$pages pages, $links links"
[ "$pages" -ge 3 ] || say "that is too few to be the manual"
exit "$bad"
