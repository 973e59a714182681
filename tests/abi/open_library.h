/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OPEN_LIBRARY_H
#define OPEN_LIBRARY_H
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

#include "torsor/runtime/abi.h"

typedef const torsor_abi* (*torsor_mechanism_entry)(void);

/* The one function of a library of `build`; NULL, with the reason on the standard output, where there is none. */
static torsor_mechanism_entry opened(const char* path) {
  torsor_mechanism_entry entry = NULL;
  void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  void* const symbol = library == NULL ? NULL : dlsym(library, "torsor_mechanism");
  if (symbol == NULL) printf("%s\n", dlerror());
  else memcpy(&entry, &symbol, sizeof(entry));
  return entry;
}

#endif
