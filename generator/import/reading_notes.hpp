// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "torsor/generator/import/xml_element.hpp"

namespace torsor {

/// "KIND: joint a, joint b, joint c, joint d and 10 more", or with `all` the name of each part.
std::string note_of_parts(const std::string& kind, const std::vector<std::string>& parts, bool all = false);

/// What a file states and a scene made of it leaves out, or takes otherwise than stated: one note for each kind, with the
/// parts of the robot that it concerns. Those who read strictly take the first one as an error.
class ReadingNotes {
 public:
  enum class Parts {
    few,   ///< names some of them, then their number
    each,  ///< names them all: what was done decides their motion
  };
  /// `kind` says what was noticed and what is done ("attribute D of <dynamics> is not read"); `part` is the link or joint
  /// concerned ("joint elbow"), empty for the robot as a whole.
  void add(const std::string& kind, const std::string& part, const XmlPlace& place, Parts named = Parts::few);

  /// "attribute D of <dynamics> is not read: joint a, joint b, joint c, joint d and 10 more", in the order of the file.
  std::vector<std::string> lines() const;
  /// Throws FileError with the place of the first note when there is one.
  void refuse() const;

 private:
  struct Kind {
    std::string text;
    XmlPlace place;  ///< of the first
    Parts named = Parts::few;
    std::vector<std::string> parts{};
  };

  std::vector<Kind> kinds_;
};

}  // namespace torsor
