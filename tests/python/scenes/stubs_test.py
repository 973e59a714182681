# SPDX-License-Identifier: GPL-3.0-or-later
"""The stubs say what the compiled module takes, and every operation has the comment of C++."""

import ast
import os
import pathlib
import re

import _torsor_scene
import pytest

STUBS = pathlib.Path(os.environ["TORSOR_SOURCE_DIR"]) / "python/scene/_torsor_scene"


def of_stub(body):
    """Names of functions, each with the arguments of its overloads."""
    found = {}
    for node in body:
        if isinstance(node, ast.FunctionDef) and not any(getattr(d, "id", "") == "property" for d in node.decorator_list):
            arguments = [a.arg for a in node.args.args + node.args.kwonlyargs if a.arg != "self"]
            found.setdefault(node.name, []).append(arguments)
    return found


def of_module(holder):
    """The same of what pybind11 wrote at the front of each docstring."""
    found = {}
    for name, function in vars(holder).items():
        function = getattr(function, "__func__", function)
        text = getattr(function, "__doc__", None) or ""
        signatures = re.findall(rf"^(?:\d+\. )?{name}\((.*)\) ->", text, re.M)
        if callable(function) and not isinstance(function, type) and signatures:
            found[name] = [[a for a in re.findall(r"(\w+): ", re.sub(r"\[[^\]]*\]|\([^)]*\)", "", s)) if a != "self"]
                           for s in signatures if "*args, **kwargs" not in s]
    return found


def stub(name="__init__"):
    return ast.parse((STUBS / f"{name}.pyi").read_text()).body


CLASSES = {node.name: node.body for node in stub() if isinstance(node, ast.ClassDef)}


@pytest.mark.parametrize("name", ["Scene", "Inertia", "Rotation"])
def test_classes(name):
    told, made = of_stub(CLASSES[name]), of_module(getattr(_torsor_scene, name))
    told.pop("__init__", None), made.pop("__init__", None)
    told.pop("__mul__", None), made.pop("__mul__", None)
    assert len(made) > 2
    assert told == made


@pytest.mark.parametrize("name", ["__init__", "shape", "form"])
def test_functions(name):
    assert of_stub(stub(name)) == of_module(_torsor_scene if name == "__init__" else getattr(_torsor_scene, name))


def test_every_name_is_told():
    told = {n.name for n in stub() if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
    told |= {n.target.id for n in stub() if isinstance(n, ast.AnnAssign)} | {"shape", "form"}
    has = {name for name in dir(_torsor_scene) if not name.startswith("_") or name == "__version__"}
    assert has == told


def test_operations_have_the_comments_of_cpp():
    assert "Ω(child/parent) = d(angle)/dt axis" in _torsor_scene.Scene.revolute.__doc__.replace("\n", " ")
    for name, operation in vars(_torsor_scene.Scene).items():
        if not name.startswith("_") and name not in ("name", "title"):
            comment = re.sub(r"(?m)^.*\) ->.*$|Overloaded function.", "", operation.__doc__)
            assert len(comment.strip()) > 10, name
