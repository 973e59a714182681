# SPDX-License-Identifier: GPL-3.0-or-later
# moving_object SOURCE COMPILER OPTION...: compiles what moves a unit with contacts; `moving_object` is the object then. It is
# the one of the call before where all files that this was made of have the same bytes: units of both versions have.
moving_object=""
moving_object() {
  local source="$1" file
  local folder="$(dirname "$source")"
  shift
  if [ -n "$moving_object" ]; then
    local before="$(dirname "$moving_object")" same=yes
    while read -r file; do
      cmp -s "$before/$file" "$folder/$file" || same=no
    done < "$before/made_of"
    if [ $same = yes ]; then return; fi
  fi
  "$@" "-I$folder" -MMD -MF "$folder/moving.d" -c "$source" -o "$folder/moving.o"
  tr -s ' \\\n' '\n' < "$folder/moving.d" | sed -n "s|^$folder/||p" | grep -v '^moving\.o' > "$folder/made_of"
  [ -s "$folder/made_of" ] || { echo "no source is listed in $folder/moving.d" >&2; exit 1; }
  moving_object="$folder/moving.o"
}
