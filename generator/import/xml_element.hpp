// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "torsor/generator/base/number.hpp"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace torsor {

/// A place of a file, for messages about what stands there.
struct XmlPlace {
  std::string file;
  int line = 0;
  std::string element;  ///< "<joint name="elbow">", "<axis> of <joint name="elbow">"

  /// Throws FileError "file:line: <element>: message".
  [[noreturn]] void fail(const std::string& message) const;
};

/// Where a line of a text comes from that was made of other files.
struct XmlLine {
  std::string file;
  int line = 0;
  std::string within;  ///< "in the macro 'arm', called at robot.xacro:7"; may be empty
};

/// Numbers separated by spaces, with the text they were read from.
struct XmlNumber {
  Number value;
  std::string text;
};

/// An element of an XML file that is read strictly: whatever is wrong is a FileError with file, line and element.
class XmlElement {
 public:
  /// `lines` says where each line of the text comes from; null for a text that is the file's own. It must outlive this.
  XmlElement(std::string file, const tinyxml2::XMLElement& element, const std::vector<XmlLine>* lines = nullptr);

  std::string name() const;
  XmlPlace place() const;
  [[noreturn]] void fail(const std::string& message) const { place().fail(message); }

  bool has(const char* attribute) const;
  /// The value of an attribute that is there, whatever it holds.
  std::string value(const char* attribute) const;
  /// The value of an attribute that must be there and hold something.
  std::string text(const char* attribute) const;
  /// A decimal; the attribute must be there.
  Number number(const char* attribute) const;
  std::optional<Number> optional_number(const char* attribute) const;
  /// A decimal that bounds something: none where it is missing, infinite, or beyond 10³⁰⁰.
  std::optional<Number> optional_bound(const char* attribute) const;
  /// That many decimals; the attribute must be there.
  template <std::size_t count>
  std::array<XmlNumber, count> numbers(const char* attribute) const {
    std::array<XmlNumber, count> result;
    std::vector<XmlNumber> read = numbers(attribute, count);
    std::move(read.begin(), read.end(), result.begin());
    return result;
  }
  /// Names of all attributes, in the order of the file.
  std::vector<std::string> attributes() const;
  /// Whether text that is no blank stands directly inside.
  bool holds_text() const;
  /// Name of the element around it; empty for the root.
  std::string parent_name() const;

  /// The child of that name, none when there is none; two are refused unless they say the same.
  std::optional<XmlElement> child(const char* name) const;
  /// The child of that name; `remedy` is what to write when it is missing.
  XmlElement required_child(const char* name, const std::string& remedy) const;
  std::vector<XmlElement> children(const char* name) const;
  /// All children, in the order of the file.
  std::vector<XmlElement> elements() const;

 private:
  XmlNumber parse(const char* attribute, std::string_view word) const;
  std::vector<XmlNumber> numbers(const char* attribute, std::size_t count) const;

  std::string file_;
  const tinyxml2::XMLElement* element_;
  const std::vector<XmlLine>* lines_;
};

/// A parsed file.
class XmlFile {
 public:
  /// Throws FileError with file, line and remedy when the text is no well-formed XML with one root element.
  /// `lines` says where each line of the text comes from, where it was made of other files.
  XmlFile(std::string_view text, std::string file, std::vector<XmlLine> lines = {});
  ~XmlFile();

  XmlElement root() const;
  const tinyxml2::XMLElement& element() const;

 private:
  const std::vector<XmlLine>* lines() const { return lines_.empty() ? nullptr : &lines_; }

  std::string file_;
  std::vector<XmlLine> lines_;
  std::unique_ptr<tinyxml2::XMLDocument> document_;
};

}  // namespace torsor
