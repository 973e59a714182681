# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/python.md shows runs as it stands there. Its section "Scenes in Python" is run by scenes/scene_test.py."""

import functools
import os
import pathlib
import re

import numpy as np
import pytest
import torsor
from conftest import scene
from scipy.integrate import solve_ivp

TEXT = (pathlib.Path(os.environ["TORSOR_SOURCE_DIR"]) / "docs/python.md").read_text(encoding="utf-8")
LOADED, MOVED, TOUCHED, _ = re.findall(r"```python\n(.*?)```", TEXT, re.S)  # a new block needs a test here


@pytest.fixture(scope="module")
def names(tmp_path_factory):
    """A robot of one hinge under the name of the page, and what the page takes for granted."""
    folder = tmp_path_factory.mktemp("manual")
    (folder / "panda.urdf").write_text("""<robot name="panda"><link name="ground"/><link name="rod"><inertial><origin xyz="0 0 -0.5"/>
      <mass value="2"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <joint name="hinge" type="revolute"><parent link="ground"/><child link="rod"/><axis xyz="0 1 0"/>
      <limit lower="-3" upper="3" effort="10" velocity="5"/></joint></robot>""")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setattr(torsor, "load", functools.partial(torsor.load, flags="-O0"))
        q, v, a, u = ([x] for x in (0.2, 0.1, 0.3, 0.4))
        names = {"q": q, "v": v, "a": a, "u": u, "many_q": [[0.2], [0.3]], "y0": [0.2, 0.0], "guess": [0.1], "solve_ivp": solve_ivp}
        exec(LOADED, names)
    return names


def test_a_mechanism_is_loaded(names, capsys):
    assert names["forces"].shape == (1,)
    assert np.allclose(names["a"], (0.4 - 2 * 9.81 * 0.5 * np.sin(0.2)) / 0.6, rtol=1e-14)  # J = 0.1 + 2 (1/2)^2


def test_motions(names):
    exec(MOVED, names)
    assert names["motion"].times[-1] == 1.0
    assert abs(names["found"].q[0]) < 1e-9  # the rod hangs


def test_contacts():
    names = {"ball": scene("billiard", "--kernels", "mass_matrix,bias,energy,contacts,contact_coefficients")}
    exec(TOUCHED, names)
    assert names["motion"].regimes.shape[0] == 2
