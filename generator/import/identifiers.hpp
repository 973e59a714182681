// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

namespace torsor {

/// A name with every run of characters that generated code could not carry replaced by one underscore. `kind` is put in
/// front of what is then empty, begins with a digit or is a reserved word: "7dof" of a joint becomes "joint_7dof".
std::string as_identifier(const std::string& name, const std::string& kind);

/// Hands out identifiers that differ from one another: a_b for "a-b", then a_b_2 for "a.b".
class Identifiers {
 public:
  explicit Identifiers(std::set<std::string> taken = {}) : taken_(std::move(taken)) {}

  /// The identifier for a name, such that none of it with each of the suffixes is taken; takes them.
  std::string take(const std::string& name, const std::string& kind, const std::vector<std::string>& suffixes = {""});

 private:
  std::set<std::string> taken_;
};

/// Identifiers of the scene that a file becomes, and which of them replace names of the file.
class FileIdentifiers {
 public:
  /// For names of the file: of a frame, and of any other thing.
  std::string frame(const std::string& name, const std::string& kind, const std::vector<std::string>& suffixes = {""});
  std::string symbol(const std::string& name, const std::string& kind, const std::vector<std::string>& suffixes = {""});
  void note(const std::string& kind, const std::string& name, const std::string& identifier);
  /// "link 'a-b' is a_b", each once.
  const std::vector<std::string>& renamed() const { return renamed_; }

  /// For names that are made here.
  Identifiers& frames() { return frames_; }
  Identifiers& symbols() { return symbols_; }

 private:
  Identifiers symbols_{{"t"}}, frames_{{"ground"}};
  std::vector<std::string> renamed_;
};

}  // namespace torsor
