#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# names.sh HEADER...: prints names, one a line, that generated code may not be able to carry: those that standard headers
# define or declare as either compiler sees them, words of languages, words of the given generated headers.
set -uo pipefail
includes='#include <array>
#include <cerrno>
#include <cfenv>
#include <climits>
#include <cmath>
#include <complex>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <string>
#include <thread>
#include <unistd.h>'
{
  for compiler in g++ clang++; do
    command -v "$compiler" > /dev/null || continue
    for standard in c++17 gnu++20; do
      "$compiler" "-std=$standard" -x c++ -dM -E - <<< "$includes" | sed -E 's/^#define ([A-Za-z_0-9]+).*/\1/'
      "$compiler" "-std=$standard" -x c++ -E - <<< "$includes" | grep -v '^#' | grep -oE '[A-Za-z_][A-Za-z_0-9]*'
    done
  done
  # What compilers know without a header.
  for program in cc1plus clang; do
    case $program in
      cc1plus) file="$(g++ -print-prog-name=cc1plus 2> /dev/null)" ;;
      clang) file="$(ls /usr/lib/llvm-*/lib/libclang-cpp.so* 2> /dev/null | tail -n 1)" ;;
    esac
    [ -f "$file" ] && strings -n 4 "$file" | sed -nE 's/^__builtin_([a-z][a-z0-9]*(_(r|l|unlocked))?)$/\1/p'
  done
  # Keywords and alternative tokens of C++, of C99 and after; of JavaScript, with its globals; of Python.
  tr ' ' '\n' <<< "alignas alignof and and_eq asm atomic_cancel atomic_commit auto bitand bitor bool break case catch char
char8_t char16_t char32_t class compl concept const consteval constexpr constinit const_cast continue co_await co_return
co_yield decltype default delete do double dynamic_cast else enum explicit export extern false float for friend goto if
import inline int long module mutable namespace new noexcept not not_eq nullptr operator or or_eq override final private
protected public reflexpr register reinterpret_cast requires restrict return short signed sizeof static static_assert
static_cast struct switch synchronized template this thread_local throw transaction_safe true try typedef typeid typename
typeof union unsigned using virtual void volatile wchar_t while xor xor_eq complex imaginary I
abstract arguments async await boolean byte debugger eval final finally function get implements in instanceof interface let
native of package set super synchronized throws transient undefined var with yield constructor prototype NaN Infinity Math
Object Array Float64Array Symbol Number globalThis window toString valueOf hasOwnProperty length name exports require
None True False def elif except from global is lambda nonlocal pass raise self"
  # Names like those that the emitter makes itself.
  for prefix in q p v a u l s c n k z y t x; do
    printf '%s\n' $prefix ${prefix}0 ${prefix}1 ${prefix}12 ${prefix}_0 ${prefix}_1 ${prefix}_x ${prefix}_1_2 ${prefix}0_5 ${prefix}1_over_3 ${prefix}_q_x
  done
  [ $# -eq 0 ] || cat "$@" | grep -oE '[A-Za-z_][A-Za-z_0-9]*'
} | grep -vE "^_[A-Za-z_]|__|_$" | sort -u
