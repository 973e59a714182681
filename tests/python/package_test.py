# SPDX-License-Identifier: GPL-3.0-or-later
"""The package as others get it: a wheel, and a notebook."""

import ast
import importlib.util
import inspect
import json
import os
import re
import shutil
import subprocess
import sys
import typing
import zipfile

import pytest

import torsor

from conftest import SOURCES


def test_every_end_of_a_motion_has_words():
    from torsor._mechanism import MOTION_STATUSES

    with open(os.path.join(SOURCES, "runtime", "abi.h"), encoding="utf-8") as header:
        numbers = [int(number) for number in re.findall(r"^  torsor_motion_[a-z_]+ = (\d+)", header.read(), re.MULTILINE)]
    assert numbers == list(range(len(MOTION_STATUSES)))


@pytest.mark.parametrize("call", ["torsor.load", "torsor.open('libarm.so')"])
def test_a_python_without_numpy_is_told_what_to_install(call):
    said = subprocess.run([sys.executable, "-c", f"import sys; sys.modules['numpy'] = None; import torsor; {call}"],
                          capture_output=True, text=True, check=False)
    assert said.returncode != 0 and "python3-numpy" in said.stderr.splitlines()[-1]


def test_a_wheel_holds_all_that_the_package_needs(tmp_path):
    """Built without the network from a copy of the sources, unpacked into an empty folder, imported from there."""
    for module in ("pip", "setuptools", "wheel"):
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"no {module} (Debian: python3-{module})")
    shutil.copytree(os.path.join(SOURCES, "python"), tmp_path / "source")
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--no-cache-dir"]
    subprocess.run([*pip, "wheel", "--quiet", "--no-build-isolation", "--no-deps", "--no-index", "--wheel-dir", tmp_path / "wheels",
                    tmp_path / "source"], check=True)
    wheel, = (tmp_path / "wheels").iterdir()
    assert wheel.name.endswith("-py3-none-any.whl")
    inside = {name for name in zipfile.ZipFile(wheel).namelist() if name.startswith("torsor/")}
    folder = os.path.join(SOURCES, "python", "torsor")
    assert inside == {f"torsor/{name}" for name in os.listdir(folder) if name.endswith((".py", ".typed"))}
    subprocess.run([*pip, "install", "--quiet", "--no-deps", "--no-index", "--target", tmp_path / "target", wheel], check=True)
    said = subprocess.run([sys.executable, "-c", "import torsor; print(torsor.__file__, torsor.__version__)"], check=True, text=True,
                          capture_output=True, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(tmp_path / "target")}).stdout
    assert said.startswith(str(tmp_path / "target"))
    tool = subprocess.run([os.environ["TORSOR"], "--version"], check=True, text=True, capture_output=True).stdout
    assert said.split()[1] == wheel.name.split("-")[1] == tool.split()[1]


def test_a_notebook_runs_from_its_first_to_its_last_cell(tmp_path):
    pytest.importorskip("nbconvert", reason="no nbconvert (Debian: python3-nbconvert)")
    pytest.importorskip("ipykernel", reason="no kernel of Jupyter (Debian: python3-ipykernel)")
    shutil.copy(os.path.join(SOURCES, "python", "notebooks", "pendulum.ipynb"), tmp_path)
    subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--inplace", "pendulum.ipynb"],
                   cwd=tmp_path, check=True, env={**os.environ, "HOME": str(tmp_path)})
    cells = json.loads((tmp_path / "pendulum.ipynb").read_text())["cells"]
    shown = {kind for cell in cells for output in cell.get("outputs", ()) for kind in output.get("data", ())}
    assert {"text/latex", "text/html", "text/plain"} <= shown


def test_all_that_is_public_is_annotated_and_described():
    for name in torsor.__all__:
        public = getattr(torsor, name)
        assert public.__doc__, name
        functions = [public]
        if inspect.isclass(public):
            functions = [f for key, f in vars(public).items()
                         if inspect.isfunction(f) and (key == "__call__" or not key.startswith("_"))]
        for function in functions:
            assert function.__doc__, function
            hints = typing.get_type_hints(function)
            assert {*inspect.signature(function).parameters} - {"self"} <= set(hints), function
            assert "return" in hints, function


def test_type_checkers_know_every_kernel():
    """They are attributes at run time only; the annotations are those of a class that no interpreter sees."""
    folder = os.path.join(SOURCES, "python", "torsor")
    with open(os.path.join(folder, "_mechanism.py"), encoding="utf-8") as file:
        annotated = {node.target.id for node in ast.walk(ast.parse(file.read()))
                     if isinstance(node, ast.AnnAssign) and isinstance(node.annotation, ast.Name) and node.annotation.id == "Kernel"}
    said = subprocess.run([os.environ["TORSOR"], "build", "--help"], check=True, text=True, capture_output=True).stdout
    listed = said.split("comma-separated list of ")[1].split("; or all")[0].replace(" ", "").replace("\n", "").split(",")
    assert {*listed, "coordinate_rates", "state_derivative"} == annotated
