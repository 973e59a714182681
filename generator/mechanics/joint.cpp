// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/joint.hpp"

#include <array>

#include "torsor/generator/base/natural_language.hpp"

namespace torsor {
namespace {

struct Row {
  Phrase name;
  int freedoms;
};

constexpr std::array<Row, 12> table{{{"weld", 0},
                                     {"revolute", 1},
                                     {"prismatic", 1},
                                     {"helical", 1},
                                     {"cylindrical", 2},
                                     {"universal", 2},
                                     {"spherical", 3},
                                     {"planar", 3},
                                     {"line contact", 4},
                                     {"sphere in cylinder", 4},
                                     {"point contact", 5},
                                     {"free", 6}}};

const Row& row(JointType type) { return table[static_cast<std::size_t>(type)]; }

}  // namespace

int freedom_count(JointType type) { return row(type).freedoms; }
std::string_view to_string(JointType type) { return row(type).name.english; }
std::string name_of(JointType type, const NaturalLanguage& say) { return say(row(type).name); }

}  // namespace torsor
