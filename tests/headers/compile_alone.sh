#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# compile_alone.sh COMPILER HEADER FOLDER: compiles every kernel of the header, in double and in float and with nothing
# else, under the flags of its contract, at the levels of levels.sh; then looks at what the object asks of the outside and
# whether it holds state. Ends with 77 (skipped) when the compiler is not installed.
set -euo pipefail
compiler="$1" header="$2" folder="$3"
command -v "$compiler" > /dev/null || { echo "$compiler is not installed"; exit 77; }
mkdir -p "$folder"
# shellcheck source=tests/headers/levels.sh
source "$(dirname "$0")/levels.sh"

# What is included in quotes lies beside it, and keeps the contract too.
check_includes() {
  local included
  while read -r included; do
    case "$included" in
      array | cmath) ;;
      *)
        [ -f "$(dirname "$1")/$included" ] || { echo "$1 includes $included; only array and cmath are allowed"; exit 1; }
        check_includes "$(dirname "$1")/$included" ;;
    esac
  done < <(sed -nE 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*["<]([^">]*)[">].*/\1/p' "$1")
}
check_includes "$header"

mechanism="$(sed -nE 's/^(inline )?namespace ([A-Za-z_0-9:]+) *\{.*/\2/p' "$header" | grep -vx torsor | tail -n 1)"
[ -n "$mechanism" ] || { echo "$header: found no namespace but torsor"; exit 1; }

read -ra levels < <(levels_of "$compiler" "$header")
in_float=""
for level in "${levels[@]}"; do
  object="$folder/$compiler$level.o" source="$folder/$compiler$level.cpp"
  printf '#include "%s"\ntemplate struct %s::Mechanism<double>;\n' "$header" "$mechanism" > "$source"
  if [ "$level" = -O0 ] || ! is_large "$header"; then
    in_float=yes
    printf 'template struct %s::Mechanism<float>;\n' "$mechanism" >> "$source"
  fi
  "$compiler" -std=c++17 "$level" -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fno-exceptions -fno-rtti \
    -c "$source" -o "$object"

  # No more than the functions of <cmath> and copying may be asked of the outside: no allocation, no throwing function.
  while read -r symbol; do
    case "$symbol" in
      sin | cos | tan | asin | acos | atan | atan2 | sincos | sqrt | exp | log | pow | fabs | hypot | fma | fmin | fmax) ;;
      sinf | cosf | tanf | asinf | acosf | atanf | atan2f | sincosf | sqrtf | expf | logf | powf | fabsf | hypotf | fmaf) ;;
      fminf | fmaxf | frexp | frexpf | ldexp | memcpy | memmove | memset | _GLOBAL_OFFSET_TABLE_) ;;
      *) echo "$header: its $compiler $level object refers to $symbol ($(c++filt "$symbol"))"; exit 1 ;;
    esac
  done < <(nm --undefined-only "$object" | awk '{ print $NF }')

  # B, D and their weak or unique forms: data that a kernel could write to. The guard of a local static is one.
  state="$(nm --defined-only "$object" | awk '$2 ~ /^[bBdDuVv]$/ && $3 !~ /^DW\.ref/ { print $3 }')"
  constants="$(objdump -t "$object" | awk '/\.rodata|\.data\.rel\.ro/ { print $NF }')"
  for symbol in $state; do
    grep -qxF -- "$symbol" <<< "$constants" && continue
    echo "$header: its $compiler $level object holds writable state: $(c++filt "$symbol")"
    exit 1
  done
done
# What was asked for must be there, or nothing was looked at.
nm -C --defined-only "$object" | grep -c 'Mechanism<double>::' > /dev/null || { echo "$header: no kernel was compiled"; exit 1; }
[ -z "$in_float" ] || nm -C --defined-only "$object" | grep -c 'Mechanism<float>::' > /dev/null ||
  { echo "$header: no float kernel was compiled"; exit 1; }
echo "$(nm -C --defined-only "$object" | grep -c 'Mechanism<') functions of $mechanism compiled alone with $compiler"
