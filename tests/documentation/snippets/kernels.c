/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Snippets of the manual in C, in what they take for granted. */
#include "double_pendulum.h"

int run(void);
int run(void) {
  /* snippet: docs/languages.md 1 */
  return status != torsor_ok;
}
