// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsor {

/// Appends a title and the lines below it to what the head of a generated header says; nothing where there is no line.
/// Lines quote the file that was read: they are made printable.
void append_notes(std::vector<std::string>& notes, const std::string& title, const std::vector<std::string>& lines);

}  // namespace torsor
