// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace torsor {

/// Base of every error the generator throws: one clear line that names the object, the value and the remedy. What it
/// quotes may come from anywhere: the message is made printable (generator/base/printable.hpp).
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message);
};

/// A description of a mechanism that cannot stand: duplicate name, unknown frame, inconsistent initial state.
class SceneError : public Error {
 public:
  using Error::Error;
};

/// Units that do not match, or a unit that cannot be read.
class UnitError : public Error {
 public:
  using Error::Error;
};

/// A request that is not understood: unknown kernel, wrong option, arguments that contradict one another.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// A file or folder that cannot be read or written.
class FileError : public Error {
 public:
  using Error::Error;
};

}  // namespace torsor
