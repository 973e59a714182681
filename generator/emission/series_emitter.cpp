// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/series_emitter.hpp"

#include "generator/emission/series_text.hpp"

namespace torsor {

void write_series(FunctionEmitter& emitter, const Program& program, const SeriesResult& series, const Block& block) {
  SeriesText(emitter, program, series, block).write();
}

std::vector<Polynomial> coefficients_read(Program& program, const SeriesResult& series) {
  FunctionEmitter nowhere(program, "");
  SeriesText text(nowhere, program, series, {});
  text.write();
  return text.read();
}

}  // namespace torsor
