// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/xml_element.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <tinyxml2.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/unclosed_element.hpp"

namespace torsor {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string tag(const tinyxml2::XMLElement& element) {
  const char* name = element.Attribute("name");
  return name == nullptr ? fmt::format("<{}>", element.Name()) : fmt::format("<{} name=\"{}\">", element.Name(), name);
}

/// Whether two elements say the same: attributes in any order, elements in the same order, each on its own, no text.
bool same(const tinyxml2::XMLElement& a, const tinyxml2::XMLElement& b) {
  const auto covers = [](const tinyxml2::XMLElement& all, const tinyxml2::XMLElement& some) {
    for (const auto* attribute = some.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
      const char* value = all.Attribute(attribute->Name());
      if (value == nullptr || std::string_view(value) != attribute->Value()) return false;
    }
    return true;
  };
  if (std::string_view(a.Name()) != b.Name() || !covers(a, b) || !covers(b, a)) return false;
  const auto* of_a = a.FirstChildElement();
  const auto* of_b = b.FirstChildElement();
  for (; of_a != nullptr && of_b != nullptr; of_a = of_a->NextSiblingElement(), of_b = of_b->NextSiblingElement()) {
    if (!same(*of_a, *of_b)) return false;
  }
  return of_a == of_b;
}

/// What a parser's complaint means for who wrote the file.
std::string explain(const tinyxml2::XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file is empty; it must hold a <robot> element";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an element is not closed by its own name; close the innermost open element with </name> first";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute cannot be read; write name=\"value\", with quotes, and separate attributes by spaces";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed; end it with -->";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "<? ... ?> stands behind an element, or is not closed; move it to the head of the file, or remove it";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply; close those that are open";
    default:
      return "an element cannot be read; write <name attribute=\"value\"/> or <name> ... </name>";
  }
}

}  // namespace

void XmlPlace::fail(const std::string& message) const {
  throw FileError(fmt::format("{}:{}: {}: {}", file, line, element, message));
}

XmlElement::XmlElement(std::string file, const tinyxml2::XMLElement& element, const std::vector<XmlLine>* lines)
    : file_(std::move(file)), element_(&element), lines_(lines) {}

std::string XmlElement::name() const { return element_->Name(); }

XmlPlace XmlElement::place() const {
  std::string label = tag(*element_);
  // The nearest element with a name, or the root, tells where in the robot it is.
  const auto* parent = element_->Parent() == nullptr ? nullptr : element_->Parent()->ToElement();
  while (element_->Attribute("name") == nullptr && parent != nullptr) {
    label += " of " + tag(*parent);
    if (parent->Attribute("name") != nullptr) break;
    parent = parent->Parent() == nullptr ? nullptr : parent->Parent()->ToElement();
  }
  const int line = element_->GetLineNum();
  if (lines_ == nullptr || line < 1 || line > static_cast<int>(lines_->size())) return {file_, line, label};
  const XmlLine& origin = (*lines_)[static_cast<std::size_t>(line - 1)];
  return {origin.file, origin.line, origin.within.empty() ? label : fmt::format("{} ({})", label, origin.within)};
}

bool XmlElement::has(const char* attribute) const { return element_->Attribute(attribute) != nullptr; }

std::string XmlElement::value(const char* attribute) const { return element_->Attribute(attribute); }

std::string XmlElement::text(const char* attribute) const {
  const char* value = element_->Attribute(attribute);
  if (value == nullptr) fail(fmt::format("has no attribute {}; add {}=\"...\"", attribute, attribute));
  if (std::string_view(value).find_first_not_of(blanks) == std::string_view::npos) {
    fail(fmt::format("has an empty attribute {}; give it a value", attribute));
  }
  return value;
}

XmlNumber XmlElement::parse(const char* attribute, std::string_view word) const {
  const auto refuse = [&](const std::string& reason) {
    fail(fmt::format("{}=\"{}\": '{}' {}", attribute, element_->Attribute(attribute), word, reason));
  };
  if (word.find("${") != std::string_view::npos) refuse("is a xacro expression; expand the file with xacro first");
  Number value;
  try {
    if (word.find('/') != std::string_view::npos) throw Error("a quotient");
    value = parse_decimal(word);
  } catch (const Error&) {
    refuse("is not a number; write a decimal such as 0.25 or -1.5e-3");
  }
  // Beyond these a double is infinite or nothing, and a generated header could not state the number.
  static const Number largest = Number(10).pow(300);
  if (value.abs() > largest || (!value.is_zero() && value.abs() * largest < Number(1))) {
    refuse("is beyond the range of a double; write 0 or a number between 1e-300 and 1e300");
  }
  return {value, std::string(word)};
}

Number XmlElement::number(const char* attribute) const {
  const std::string whole = text(attribute);
  const std::size_t begin = whole.find_first_not_of(blanks);
  const std::size_t end = whole.find_last_not_of(blanks);
  return parse(attribute, std::string_view(whole).substr(begin, end - begin + 1)).value;
}

std::optional<Number> XmlElement::optional_number(const char* attribute) const {
  if (!has(attribute)) return std::nullopt;
  return number(attribute);
}

std::optional<Number> XmlElement::optional_bound(const char* attribute) const {
  if (!has(attribute)) return std::nullopt;
  std::string word = text(attribute);
  word.erase(0, word.find_first_not_of(blanks));
  word.erase(word.find_last_not_of(blanks) + 1);
  std::string letters = word;
  std::transform(letters.begin(), letters.end(), letters.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (letters.starts_with('-') || letters.starts_with('+')) letters.erase(0, 1);
  if (letters == "inf" || letters == "infinity" || letters == ".inf") return std::nullopt;
  try {
    if (letters.find('/') == std::string::npos && parse_decimal(word).abs() > Number(10).pow(300)) return std::nullopt;
  } catch (const Error&) {
    return number(attribute);  // says what is wrong
  }
  return number(attribute);
}

std::vector<XmlNumber> XmlElement::numbers(const char* attribute, std::size_t count) const {
  const std::string whole = text(attribute);
  std::vector<XmlNumber> numbers;
  for (std::size_t begin = whole.find_first_not_of(blanks); begin != std::string::npos;) {
    const std::size_t end = std::min(whole.find_first_of(blanks, begin), whole.size());
    numbers.push_back(parse(attribute, std::string_view(whole).substr(begin, end - begin)));
    begin = whole.find_first_not_of(blanks, end);
  }
  if (numbers.size() != count) {
    fail(fmt::format("{}=\"{}\" holds {} number{} and must hold {}, separated by spaces", attribute, whole,
                     numbers.size(), numbers.size() == 1 ? "" : "s", count));
  }
  return numbers;
}

std::vector<std::string> XmlElement::attributes() const {
  std::vector<std::string> names;
  for (const auto* attribute = element_->FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
    names.emplace_back(attribute->Name());
  }
  return names;
}

bool XmlElement::holds_text() const {
  for (const auto* node = element_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    const auto* text = node->ToText();
    if (text != nullptr && std::string_view(text->Value()).find_first_not_of(blanks) != std::string_view::npos) return true;
  }
  return false;
}

std::string XmlElement::parent_name() const {
  const auto* parent = element_->Parent() == nullptr ? nullptr : element_->Parent()->ToElement();
  return parent == nullptr ? "" : parent->Name();
}

std::vector<XmlElement> XmlElement::elements() const {
  std::vector<XmlElement> all;
  for (const auto* child = element_->FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    all.emplace_back(file_, *child, lines_);
  }
  return all;
}

std::vector<XmlElement> XmlElement::children(const char* name) const {
  std::vector<XmlElement> all;
  for (const auto* child = element_->FirstChildElement(name); child != nullptr;
       child = child->NextSiblingElement(name)) {
    all.emplace_back(file_, *child, lines_);
  }
  return all;
}

std::optional<XmlElement> XmlElement::child(const char* name) const {
  const std::vector<XmlElement> all = children(name);
  if (all.empty()) return std::nullopt;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (same(*all[0].element_, *all[i].element_)) continue;
    all[i].fail(fmt::format("there is another <{}> at line {}; keep one", name, all[0].place().line));
  }
  return all.front();
}

XmlElement XmlElement::required_child(const char* name, const std::string& remedy) const {
  const std::optional<XmlElement> found = child(name);
  if (!found) fail(fmt::format("has no <{}>; add {} inside it", name, remedy));
  return *found;
}

XmlFile::XmlFile(std::string_view text, std::string file, std::vector<XmlLine> lines)
    : file_(std::move(file)), lines_(std::move(lines)), document_(std::make_unique<tinyxml2::XMLDocument>()) {
  if (text.find('\0') != std::string_view::npos) throw FileError(file_ + ":1: the file is binary and no XML");
  document_->Parse(text.data(), text.size());
  if (document_->Error()) {
    if (const std::optional<UnclosedElement> open = unclosed_element(text)) {
      const XmlLine at = open->line <= static_cast<int>(lines_.size()) ? lines_[static_cast<std::size_t>(open->line - 1)]
                                                                       : XmlLine{file_, open->line, {}};
      throw FileError(fmt::format("{}:{}: malformed XML: {}", at.file, at.line, open->message));
    }
    throw FileError(
        fmt::format("{}:{}: malformed XML: {}", file_, std::max(1, document_->ErrorLineNum()), explain(*document_)));
  }
  if (document_->RootElement() == nullptr) {
    throw FileError(fmt::format("{}:1: the file holds no element; it must hold a <robot> element", file_));
  }
  if (const auto* second = document_->RootElement()->NextSiblingElement(); second != nullptr) {
    XmlElement(file_, *second, this->lines()).fail("stands beside the root element; an XML file has one root, which holds all others");
  }
}

XmlFile::~XmlFile() = default;

XmlElement XmlFile::root() const { return {file_, *document_->RootElement(), lines()}; }

const tinyxml2::XMLElement& XmlFile::element() const { return *document_->RootElement(); }

}  // namespace torsor
