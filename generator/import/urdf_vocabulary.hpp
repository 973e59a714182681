// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/import/reading_notes.hpp"
#include "torsor/generator/import/xml_element.hpp"

namespace torsor {

/// Looks at what an element of URDF holds: attributes, elements and text. What URDF does not know cannot act and is noted,
/// one note for each kind, under the name of the `part` (a link or a joint). Throws FileError
///  * for what looks like a misspelling of something that acts ("did you mean"),
///  * for what acts elsewhere and stands in the wrong place (<mass> outside <inertial>),
///  * for what xacro has not expanded.
void check_vocabulary(const XmlElement& element, const std::string& part, ReadingNotes& notes);

}  // namespace torsor
