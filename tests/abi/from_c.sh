#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# from_c.sh CC CXX SCENE_PROGRAM KERNELS SOURCE FOLDER [USER]...: builds a library of the scene twice, the second time
# without a compiler's work; without a compiler it is one error. load.c opens it, and so does each USER.c. What moves the
# contacts of every mechanism takes a minute to compile: it is left in the folder LAYERS for the tests of Python. FLAGS are
# the compiler's.
set -euo pipefail
cc="$1" cxx="$2" program="$3" kernels="$4" source="$5" folder="$6"
rm -rf "$folder"
mkdir -p "$folder"
export TORSOR_CACHE="$folder/cache" CXX="$cxx"
build() { "$program" build --kernels "$kernels" --flags="${FLAGS:--O1}" "$@"; }

mkdir -p "$TORSOR_CACHE" "${LAYERS:=$folder/layers}"
cp -np "$LAYERS"/contact_layer-*.o "$TORSOR_CACHE" 2> /dev/null || true
build --output "$folder/lib.so"
cp -np "$TORSOR_CACHE"/contact_layer-*.o "$LAYERS" 2> /dev/null || true
cached="$(build)"
[ -f "$cached" ] || { echo "no library in the cache: $cached"; exit 1; }
before="$(stat -c %Y.%i "$cached" "$folder/lib.so")"
build --output "$folder/lib.so"
[ "$before" = "$(stat -c %Y.%i "$cached" "$folder/lib.so")" ] || { echo "what was there was compiled or written again"; exit 1; }
# And, where there are contacts, the object that moves those of every mechanism.
left="$(find "$TORSOR_CACHE" -mindepth 1 ! -name 'contact_layer-*.o')"
[ "$left" = "$cached" ] || { echo "more than a library is left:"; find "$TORSOR_CACHE"; exit 1; }

# One contact has room for two, not for as many as there can be.
if [[ " ${*:7} " == *" contacts "* ]]; then
  room="$(nm -C "$folder/lib.so" | grep -o 'library_has_room_for_contacts<[0-9]*>' | sort -u)" || true
  [ "$room" = "library_has_room_for_contacts<2>" ] || { echo "the library has another room: $room"; exit 1; }
fi

code=0
said="$(CXX="$folder/no_such_compiler" "$program" build --kernels energy 2>&1)" || code=$?
[ $code = 3 ] && [[ "$said" == *"no C++ compiler"*"no_such_compiler"* ]] || { echo "without a compiler, $code: $said"; exit 1; }
[ "$(nm -D --defined-only "$folder/lib.so" | awk '$2 == "T"' | wc -l)" = 1 ] || { echo "more than one symbol"; nm -D --defined-only "$folder/lib.so"; exit 1; }
# Later states of an array are fetched before they are read: a compiler may drop a function that does nothing else.
if [ "$(uname -m)" = x86_64 ] && ! objdump -d "$folder/lib.so" | grep -c prefetch > /dev/null; then
  echo "the library fetches nothing ahead"
  exit 1
fi

shift 6
for user in load "$@"; do
  "$cc" -std=c99 -pedantic -Wall -Wextra -Wconversion -Werror -D_GNU_SOURCE -O1 -I"$source" -I"$source/include" "$source/tests/abi/$user.c" \
    -o "$folder/$user" -ldl -lm
  "$folder/$user" "$folder/lib.so"
done
