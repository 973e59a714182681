# SPDX-License-Identifier: GPL-3.0-or-later
"""Every example once more in Python: the same bytes of header as the scene in C++, whose header is committed."""

import os
import pathlib
import runpy

import pytest

SOURCES = pathlib.Path(os.environ["TORSOR_SOURCE_DIR"])
KERNELS = dict(line.split(" ", 1) for line in pathlib.Path(os.environ["TORSOR_KERNELS"]).read_text().splitlines())


def name_of(path):
    return path.stem.replace("scene", path.parent.name, 1)


SCENES = {name_of(path): path for path in sorted(SOURCES.glob("examples/*/scene*.py"))}


def test_every_scene_in_cpp_is_there_in_python():
    in_cpp = {name_of(path) for path in SOURCES.glob("examples/*/scene*.cpp")}
    assert len(in_cpp) > 50
    assert set(SCENES) == in_cpp


@pytest.mark.parametrize("name", SCENES)
def test_header_is_the_committed_one(name, tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(SCENES[name].parent))
    scene = runpy.run_path(str(SCENES[name]))["scene"]
    assert scene.name == name
    made = tmp_path / f"{name}.hpp"
    scene.generate(made, kernels=KERNELS[name], support=tmp_path / "torsor_support.hpp")
    assert made.read_bytes() == (SOURCES / "generated" / f"{name}.hpp").read_bytes()
