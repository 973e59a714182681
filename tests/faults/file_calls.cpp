// SPDX-License-Identifier: GPL-3.0-or-later
// The C library's calls, replaced in this program: each does what it did, and then says so or says that it could not.
#include "tests/faults/file_calls.hpp"

#include <cerrno>
#include <cstdio>

#include <dlfcn.h>
#include <unistd.h>

namespace torsor::testing_files {

FileCalls& file_calls() {
  static FileCalls calls;
  return calls;
}

namespace {

/// Whether the call of this name, made just now, is to fail.
bool refused(const char* name, int reason) {
  file_calls().made.emplace_back(name);
  if (file_calls().fails != name) return false;
  errno = reason;
  return true;
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace
}  // namespace torsor::testing_files

using torsor::testing_files::real;
using torsor::testing_files::refused;

extern "C" int fsync(int descriptor) {
  const int result = real<int(int)>("fsync")(descriptor);
  return refused("fsync", EIO) ? -1 : result;
}
extern "C" int close(int descriptor) {
  const int result = real<int(int)>("close")(descriptor);
  return refused("close", ENOSPC) ? -1 : result;
}
extern "C" int fclose(FILE* file) {
  const int result = real<int(FILE*)>("fclose")(file);
  return refused("fclose", ENOSPC) ? EOF : result;
}
// The one that does nothing when it fails.
extern "C" int rename(const char* from, const char* to) noexcept {
  return refused("rename", EXDEV) ? -1 : real<int(const char*, const char*)>("rename")(from, to);
}
