#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# commands_are_listed.sh TORSOR PAGE: each command of the program begins an item of a list of PAGE, and each that does is one of
# the program.
set -euo pipefail
offered="$("$1" --help | sed -n '/^Subcommands:/,$s/^  \([a-z-]*\) .*/\1/p' | sort)"
listed="$(sed -n '/^[*] `/s/`:.*//p' "$2" | grep -oE '`[a-z-]+' | tr -d '`' | sort)"
[ "$(wc -l <<< "$offered")" -ge 10 ] || { echo "$1 --help lists too few commands: $offered"; exit 1; }
if ! diff <(echo "$offered") <(echo "$listed"); then
  echo "< is missing in $2, > is no command of $1"
  exit 1
fi
# A robot's file may stand before the command.
robot="$(dirname "$0")/../python/cart_pole.urdf"
diff <("$1" list "$robot") <("$1" "$robot" list)
echo "$(wc -l <<< "$offered") commands"
