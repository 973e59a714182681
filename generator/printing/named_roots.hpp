// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "torsor/generator/printing/page.hpp"

namespace torsor::printing {

/// The same page with a name, root_1, root_2 and so on, for every root of more than a few letters that occurs twice, or once
/// beside its radicand as a denominator, root_1^2; a last section tells what they are.
std::unique_ptr<Page> with_named_roots(std::unique_ptr<Page> page);

}  // namespace torsor::printing
