#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_names.sh PROGRAM FOLDER few|all [ROLE...]: makes headers of hostile names by PROGRAM (hostile_headers) and
# compiles each with every compiler there is of the two; so does it as C99, and as a module of JavaScript where node is
# installed. `few`: names like those that headers have of their own.
set -euo pipefail
program="$1" folder="$2" which="$3"
shift 3
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
rm -rf "$folder"
mkdir -p "$folder"
if [ "$which" = all ]; then
  bash "$here/names.sh" "$here"/../../generated/{double_pendulum,heavy_top,whipple_bicycle,torque_free_body}.hpp > "$folder/names"
else
  tr ' ' '\n' <<< "q_x v_x p_x a_x u_x l_x s_x c_x q v p a u l s c z12 z n1 n0_5 n1_over_3 k3 x1 y0 y1 j0 t pi traits name
fingerprint coordinate_count State time parameters precomputed state inputs accelerations multipliers forces member i
constant formula select sincos sqrt sin angles sines status pivot Status scalar_traits zero jets mass_matrix M E J R_OK
async await var let NaN Infinity prototype arguments length default_parameters precompute RAND_MAX int restrict xor std" > "$folder/names"
fi
"$program" "$folder" 100 "$@" < "$folder/names" > "$folder/log"
failed=0 compiled=0 in_c=0
strict="-fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
check() {
  command -v "${1%% *}" > /dev/null || return 0
  compiled=$((compiled + 1))
  $1 "$folder/$2" || failed=$((failed + 1))
}
while read -r source; do
  case "$source" in
    *.cpp)
      check "g++ -std=gnu++20 $strict" "$source"
      check "clang++ -std=c++17 $strict" "$source"
      ;;
    *.c)
      in_c=$((in_c + 1))
      check "gcc -std=c99 $strict" "$source"
      check "gcc -std=c99 -DTORSOR_SINGLE $strict" "$source"
      if [ "$which" = all ]; then check "clang -std=c99 $strict" "$source"; fi
      ;;
    *.mjs) check "node --check" "$source" ;;
  esac
done < <(sed -n 's/^source //p' "$folder/log")
echo "$(wc -l < "$folder/names") names, $(grep -c '^refused' "$folder/log") refusals; of $compiled compilations $failed failed"
[ $in_c -gt 0 ] && [ $compiled -gt $in_c ] && [ $failed -eq 0 ]
