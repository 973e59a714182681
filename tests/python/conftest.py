# SPDX-License-Identifier: GPL-3.0-or-later
"""Mechanisms of the tests: built once, without much optimisation, in the cache of the build."""

import os
import subprocess

import pytest

import torsor

SOURCES = os.environ["TORSOR_SOURCE_DIR"]
PROGRAMS = os.environ["TORSOR_PROGRAM_DIR"]


def scene(name, *options):
    """An example, built by its own program."""
    command = [os.path.join(PROGRAMS, f"{name}_scene"), "build", "--flags=-O1", *options]
    return torsor.open(subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip())


@pytest.fixture(scope="session")
def panda():
    return torsor.load(os.path.join(SOURCES, "tests/reference/urdf/panda.urdf"), flags="-O1",
                       kernels=["mass_matrix", "bias", "inverse_dynamics", "forward_dynamics", "energy"])


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
