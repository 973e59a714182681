#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_bits.sh HOST-COMPILER HEADER FOLDER TARGET...: every kernel of a generated header gives the bits of this machine on
# each target, where no product is fused with a sum:
#   cortex-m4   in float, in which nothing calls for a double, and cortex-m7 in double with TORSOR_SMALL, under QEMU
#   aarch64, riscv64   in float and in double, numbers and packs of runtime/batch, under qemu-user
#   windows   the same, compiled by MinGW, under Wine; without Wine, numbers compiled in float only
# Targets whose tools are not installed are left out with a note. Ends with 77 (skipped) where all are.
set -euo pipefail
host="$1" header="$2" folder="$3"
shift 3
here="$(cd "$(dirname "$0")" && pwd)" repository="$(cd "$(dirname "$0")/../.." && pwd)"
mkdir -p "$folder"

mechanism="$(sed -nE 's/^(inline )?namespace ([A-Za-z_0-9:]+) *\{.*/\2/p' "$header" | grep -vx torsor | tail -n 1)"
flags=(-std=c++17 -O1 -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror
  "-DHEADER=\"$header\"" "-DMECHANISM=$mechanism")
bare=(-fno-exceptions -fno-rtti -fno-threadsafe-statics -DBARE -nostartfiles --specs=nano.specs
  -T "$repository/examples/cortex_m/board.ld")

# there COMPILER...: whether all of these programs are there, and the compiler finds <array>
there() {
  local program
  for program in "$@"; do
    command -v "$program" > /dev/null || { echo "$program is not installed"; return 1; }
  done
  echo '#include <array>' | "$1" -std=c++17 -xc++ -fsyntax-only - 2> /dev/null || { echo "$1 has no <array>"; return 1; }
}
# expected REAL: what this machine finds
expected() {
  [ -f "$folder/$1.txt" ] || {
    "$host" "${flags[@]}" -DREAL="$1" "$here/kernels.cpp" -o "$folder/$1"
    "$folder/$1" > "$folder/$1.new"
    [ -s "$folder/$1.new" ] || { echo "$header: nothing was computed"; exit 1; }
    mv "$folder/$1.new" "$folder/$1.txt"
  }
}
# compare TARGET REAL [WHAT]: packs print a state of each lane in turn, and the others kernel by kernel
compare() {
  expected "$2"
  diff <(sort "$folder/$2.txt") <(sort "$folder/$1.txt") || { echo "$header: other bits on $1 in $2${3:+ in $3}"; exit 1; }
  echo "$mechanism: $(wc -l < "$folder/$2.txt") results have the same bits on $1 in $2${3:+ in $3}"
}
# packs REAL: as many lanes as a register of 16 bytes holds, which these targets have
packs() { echo "-std=c++20 -I$repository/include -DLANES=$([ "$1" = float ] && echo 4 || echo 2)"; }
# board CORE FPU MACHINE REAL OPTION...
board() {
  local core=(-mcpu="$1" -mfpu="$2" -mthumb -mfloat-abi=hard "${@:5}")
  arm-none-eabi-gcc "${core[@]}" -O1 -c "$repository/examples/cortex_m/start.c" -o "$folder/start.o"
  arm-none-eabi-g++ "${core[@]}" "${flags[@]}" "${bare[@]}" -DREAL="$4" "$here/kernels.cpp" "$folder/start.o" -o "$folder/$1.elf"
  if [ "$4" = float ]; then
    if arm-none-eabi-nm "$folder/$1.elf" | grep -E '__aeabi_(d[a-z0-9]*|[a-z0-9]*2d)$|__(add|sub|mul|div)df3'; then
      echo "$header: the image in float calls for doubles"
      exit 1
    fi
  fi
  timeout 60 qemu-system-arm -M "$3" -nographic -semihosting -kernel "$folder/$1.elf" > "$folder/$1.txt" 2>&1 < /dev/null ||
    { tail -n 5 "$folder/$1.txt"; echo "$header: the program failed on $1"; exit 1; }
  compare "$1" "$4"
}

rm -f "$folder"/*.txt
ran=0
for target in "$@"; do
  case "$target" in
    cortex-m4)
      there arm-none-eabi-g++ qemu-system-arm || continue
      board cortex-m4 fpv4-sp-d16 mps2-an386 float ;;
    cortex-m7)
      there arm-none-eabi-g++ qemu-system-arm || continue
      board cortex-m7 fpv5-d16 mps2-an500 double -DTORSOR_SMALL ;;
    aarch64 | riscv64)
      there "$target-linux-gnu-g++" "qemu-$target" || continue
      for real in float double; do
        for lanes in "" "$(packs $real)"; do
          # shellcheck disable=SC2086
          "$target-linux-gnu-g++" "${flags[@]}" $lanes -static -DREAL=$real "$here/kernels.cpp" -o "$folder/$target"
          "qemu-$target" "$folder/$target" > "$folder/$target.txt"
          compare "$target" $real "${lanes:+packs of ${lanes##*=}}"
        done
      done ;;
    windows)
      there x86_64-w64-mingw32-g++ || continue
      for real in float double; do
        for lanes in "" "$(packs $real)"; do
          # shellcheck disable=SC2086
          x86_64-w64-mingw32-g++ "${flags[@]}" $lanes -static -DREAL=$real "$here/kernels.cpp" -o "$folder/windows.exe"
          command -v wine > /dev/null || { echo "wine is not installed: $mechanism is compiled only"; continue 3; }
          export WINEPREFIX="$(dirname "$folder")/wine" WINEDEBUG=-all
          # One at a time makes Wine's folder; its server, which stays, must not keep the lock.
          flock -o "$WINEPREFIX.lock" wineboot -i > /dev/null 2>&1
          timeout 120 wine "$folder/windows.exe" | tr -d '\r' > "$folder/windows.txt"
          compare windows $real "${lanes:+packs of ${lanes##*=}}"
        done
      done ;;
    *) echo "same_bits.sh: no target is $target; the targets are cortex-m4, cortex-m7, aarch64, riscv64 and windows"; exit 2 ;;
  esac
  ran=$((ran + 1))
done
[ $ran -gt 0 ] || exit 77
