# SPDX-License-Identifier: GPL-3.0-or-later
"""Mechanisms of the tests: built once, without much optimisation, in the cache of the build."""

import os
import subprocess

import pytest

import torsor

SOURCES = os.environ["TORSOR_SOURCE_DIR"]
PROGRAMS = os.environ["TORSOR_PROGRAM_DIR"]


FILES = {"bennett": ["tests/python/bennett.cpp"],
         "lamp": ["tests/python/lamp.cpp"],
         "ring": ["tests/python/ring.cpp"],
         "rising": ["tests/report/rising_scene.cpp"],
         "unvalued": ["tests/python/unvalued.cpp"],
         "odd_names": ["tests/python/odd_names.cpp"],
         "worn_floor": ["tests/python/worn_floor.cpp"],
         "rubbing_parts": ["tests/python/rubbing_parts.cpp"],
         "cart_pole": ["tests/python/cart_pole.urdf", "--initial", "hinge=0.3"],
         "quadruped": ["examples/quadruped/quadruped.urdf", "--base", "floating"],
         "quadruped_on_its_feet": [
             "examples/quadruped/quadruped.urdf", "--base", "floating", "--name", "quadruped_on_its_feet", "--ground",
             ",".join(f"{end}_{side}_foot" for end in ("front", "rear") for side in ("left", "right")), "--ground-friction", "0.6",
             "--initial", ",".join(["trunk_z=0.45", "trunk_x'=0.5"] + [
                 f"{end}_{side}_{joint}" for end in ("front", "rear") for side in ("left", "right")
                 for joint in ("thigh=0.7", "knee=-1.4")])]}


def command(name, what, *options):
    """The words that do something with an example: by its own program, or with a robot's file."""
    if name not in FILES:
        return [os.path.join(PROGRAMS, f"{name}_scene"), what, *options]
    file, *rest = FILES[name]
    quiet = [] if file.endswith(".cpp") else ["--quiet"]
    return [os.environ["TORSOR"], what, os.path.join(SOURCES, file), *rest, *quiet, *options]


def scene(name, *options):
    words = command(name, "build", "--flags=-O0", *options)
    return torsor.open(subprocess.run(words, capture_output=True, text=True, check=True).stdout.strip())


@pytest.fixture(scope="session")
def panda():
    return torsor.load(os.path.join(SOURCES, "tests/reference/urdf/panda.urdf"), flags="-O1",
                       kernels=["mass_matrix", "bias", "inverse_dynamics", "forward_dynamics", "energy"])


@pytest.fixture(scope="session")
def rod(tmp_path_factory):
    """2 kg on a hinge, the centre of mass 0.5 m below it."""
    source = tmp_path_factory.mktemp("rod") / "rod.urdf"
    source.write_text("""<robot name="rod"><link name="ground"/><link name="rod"><inertial><origin xyz="0 0 -0.5"/>
      <mass value="2"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <joint name="hinge" type="continuous"><parent link="ground"/><child link="rod"/><axis xyz="0 1 0"/></joint></robot>""")
    return torsor.load(source, flags="-O0")


@pytest.fixture(scope="session")
def pendulum():
    """Two masses on rods; all parameters can be changed."""
    return scene("double_pendulum", "--run-time", "all")


@pytest.fixture(scope="session")
def hoop():
    return scene("rolling_hoop", "--run-time", "all", "--kernels", "mass_matrix,inverse_dynamics,forward_dynamics,energy,constraints")


@pytest.fixture(scope="session")
def top():
    """Singular where its second angle stands at a right angle."""
    return scene("heavy_top", "--kernels", "mass_matrix,forward_dynamics,energy")


@pytest.fixture(scope="session")
def body():
    """Free of torque, its attitude by a quaternion."""
    return scene("torque_free_body", "--run-time", "all")


@pytest.fixture(scope="session")
def cart():
    """A motor pushes a cart with a pole."""
    return scene("cart_pole", "--run-time", "all", "--kernels", "forward_dynamics,energy")


@pytest.fixture(scope="session")
def quadruped():
    """Twelve joints on a body that floats."""
    return scene("quadruped", "--kernels", "forward_dynamics,energy")


def fmi_unit(request, tmp_path_factory, name, *options):
    """Of the version that is the fixture's parameter, for all files that ask for it."""
    import fmi_importer  # which takes `command` from here
    return getattr(fmi_importer, f"Unit{request.param}")(name, tmp_path_factory.mktemp(name), "--flags=-O0", *options)


@pytest.fixture(scope="session", params=("2", "3"))
def fmi_billiard(request, tmp_path_factory):
    """A ball on a cloth, all of whose parameters can be changed."""
    return fmi_unit(request, tmp_path_factory, "billiard", "--run-time", "all", "--frames", "ball")


@pytest.fixture(scope="session", params=("2", "3"))
def fmi_cart_with_stops(request, tmp_path_factory):
    """A cart that a motor pushes, with stops at 10 m on either side, and a pole."""
    return fmi_unit(request, tmp_path_factory, "cart_pole", "--limits")
