// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {

template class Evaluator<double>;
template class Evaluator<Real>;

}  // namespace torsor
