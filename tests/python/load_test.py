# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes in C++ as mechanisms."""

import os

import numpy as np
import pytest

import torsor

SCENE = """#include "torsor/generator/torsor.hpp"
#include "length.hpp"
torsor::Scene rod() {
  using namespace torsor;
  Scene scene("rod", "A rod that swings");
  const Expression m = scene.parameter("m", "kg", 3), g = scene.parameter("g", "m/s^2", 10);
  const Expression l = scene.parameter("l", "m", length());
  const Expression theta = scene.coordinate("theta", "rad");
  const FrameHandle frame = scene.revolute("rod", scene.ground(), axis::y, theta);
  scene.body("rod", frame, Inertia::rod(m, l, 2).at({0, 0, -l / 2}));
  scene.gravity({0, 0, -g});
  return scene;
}
TORSOR_SCENE(rod)
"""


def test_a_scene_is_built_again_when_what_it_includes_changes(tmp_path, monkeypatch):
    """Neither its own text nor its path changes; what it includes does, and comes back."""
    monkeypatch.setenv("TORSOR_CACHE", str(tmp_path / "cache"))
    (tmp_path / "rod.cpp").write_text(SCENE)

    def inertia_of(length):
        (tmp_path / "length.hpp").write_text(f"inline int length() {{ return {length}; }}\n")
        rod = torsor.load(tmp_path / "rod.cpp", kernels=["mass_matrix"], flags="-O0")
        return rod.mass_matrix(np.zeros(1)).item(), rod

    # m l^2/3 about an end
    assert inertia_of(2)[0] == 4.0
    inertia, rod = inertia_of(4)
    assert inertia == 16.0
    assert "theta" in rod._repr_latex_()
    assert inertia_of(2)[0] == 4.0


def test_says_what_the_compiler_says(tmp_path, monkeypatch):
    monkeypatch.setenv("TORSOR_CACHE", str(tmp_path / "cache"))
    (tmp_path / "rod.cpp").write_text(SCENE)
    with pytest.raises(torsor.LoadError, match="length.hpp"):
        torsor.load(tmp_path / "rod.cpp")
    with pytest.raises(FileNotFoundError):
        torsor.load(os.path.join(tmp_path, "nothing.cpp"))


def test_warns_of_what_a_file_says_in_vain(tmp_path):
    """What the program notes on its standard error reaches who calls from Python, at the call's own line."""
    (tmp_path / "rod.urdf").write_text("""<robot name="rod"><link name="base"/><link name="rod"><inertial><origin xyz="0 0 1"/>
      <mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <joint name="hinge" type="continuous"><parent link="base"/><child link="rod"/><axis xyz="1 0 0"/></joint><thing/></robot>""")
    with pytest.warns(UserWarning, match="<thing> in <robot> is not read") as told:
        torsor.load(tmp_path / "rod.urdf", kernels=["energy"], flags="-O0")
    assert told[0].filename == __file__
