// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/forces/closure_wrench.hpp"

namespace torsor {

Vector frame_axis(const Model& model, const FramePlace& at, int i, int axes) {
  Program& program = model.program();
  Vector unit;
  for (int k = 0; k < 3; ++k) unit[k] = program.number(at.rotation(k, i));
  return bound(program, model.express(unit, at.link, axes));
}

ClosureWrench closure_wrench(const Model& model, const JointClosure& law, const std::string& user) {
  Program& program = model.program();
  const FramePlace& at_a = model.place(law.a, user);
  const FramePlace& at_b = model.place(law.b, user);
  const int axes = at_a.link;
  const Vector b = bound(program, model.locate(at_b.origin, at_b.link, axes));
  const Vector a_i = frame_axis(model, at_a, law.i, axes);
  ClosureWrench wrench{{{at_b.link, at_b.origin}, axes}, {}};
  switch (law.kind) {
    case JointClosure::Kind::offset:
      wrench.at_point.resultant = a_i;
      break;
    case JointClosure::Kind::alignment: {
      const Vector b_j = frame_axis(model, at_b, law.j, axes);
      const Vector couple = cross(b_j, a_i);
      wrench.at_point.moment = bound(program, law.sign > 0 ? couple : -couple);
      break;
    }
    case JointClosure::Kind::screw: {
      const Value pitch = program.lower(law.pitch);
      const Vector ab = bound(program, b - at_a.origin);
      const Value angle = program.bind(dot(ab, a_i) / pitch);
      const Value sine = program.sin(angle), cosine = program.cos(angle);
      const Vector a_y = frame_axis(model, at_a, 1, axes), a_z = frame_axis(model, at_a, 2, axes);
      const Vector b_y = frame_axis(model, at_b, 1, axes);
      const Value along_y = program.bind(dot(a_y, b_y)), along_z = program.bind(dot(a_z, b_y));
      const Value along = program.bind(cosine * along_y + sine * along_z);
      const Vector turned = bound(program, sine * a_y - cosine * a_z);
      wrench.at_point.resultant = bound(program, along * a_i);
      wrench.at_point.moment = bound(program, pitch * bound(program, cross(b_y, turned)));
      break;
    }
  }
  return wrench;
}

}  // namespace torsor
