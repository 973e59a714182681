#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""batch.py [STATES]: panda's inverse dynamics from numpy beside the C++ batch, compiled alike, beside MuJoCo where it is
installed, and one call with bound arrays. Processor time of this thread, in turns, the best of each: other programs then hardly count.

TORSOR names the program torsor where it is not on the path; PYTHONPATH the package. Fails above 1.3 times the batch, or
2 us a call."""

import ctypes
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

import torsor
from torsor._load import tool

SOURCE = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
ROBOT = os.path.join(SOURCE, "tests/reference/urdf/panda.urdf")
EIGEN = os.environ.get("EIGEN", "/usr/include/eigen3")
TURNS = 40


def batch_of_cpp(folder, contract):
    library = os.path.join(folder, f"batch-{contract}.so")
    subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-O3", "-march=native", f"-ffp-contract={contract}", "-shared", "-fPIC",
                    "-I", os.path.join(SOURCE, "include"), "-I", folder, "-isystem", EIGEN, os.path.join(SOURCE, "benchmarks/python/batch.cpp"), "-o", library],
                   check=True)
    loaded = ctypes.CDLL(library)
    loaded.make_problem.restype = ctypes.c_void_p
    return loaded


def mujoco(folder, states):
    """Seconds for all states and the forces, or None where MuJoCo is not installed."""
    library = os.path.join(folder, "mujoco.so")
    done = subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-O3", "-march=native", "-shared", "-fPIC",
                           os.path.join(SOURCE, "benchmarks/python/mujoco.cpp"), "-o", library, "-lmujoco"], capture_output=True, check=False)
    if done.returncode != 0:
        return None
    loaded = ctypes.CDLL(library)
    loaded.make_mujoco.restype = ctypes.c_void_p
    made = ctypes.c_void_p(loaded.make_mujoco(ROBOT.encode()))
    if not made:
        return None
    forces = np.empty_like(states[0])
    pointers = [x.ctypes.data_as(ctypes.c_void_p) for x in (*states, forces)]
    count = ctypes.c_size_t(len(forces))
    return min(seconds(lambda: loaded.evaluate_mujoco(made, count, *pointers)) for _ in range(5)), forces


def seconds(function):
    begin = time.thread_time_ns()
    function()
    return (time.thread_time_ns() - begin) * 1e-9


def main():
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    q, v, a = np.random.default_rng(1).normal(size=(3, n, 7))
    out, expected = np.empty((n, 7)), np.empty((n, 7))
    good = True
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([tool(), "generate", ROBOT, "--name", "panda", "--kernels", "inverse_dynamics", "--quiet", "-o",
                        os.path.join(folder, "panda.hpp")], check=True)
        for contract in ("off", "fast"):
            cpp = batch_of_cpp(folder, contract)
            arm = torsor.load(ROBOT, kernels=["inverse_dynamics"], fused=contract == "fast")
            pointers = [x.ctypes.data_as(ctypes.c_void_p) for x in (q, v, a)]
            problem = ctypes.c_void_p(cpp.make_problem(ctypes.c_size_t(n), *pointers))
            best = {"C++ batch": np.inf, "Python, out=": np.inf, "Python": np.inf}
            for _ in range(TURNS):
                best["C++ batch"] = min(best["C++ batch"], seconds(lambda: cpp.evaluate_problem(problem)))
                best["Python, out="] = min(best["Python, out="], seconds(lambda: arm.inverse_dynamics(q, v, a, out=out)))
                best["Python"] = min(best["Python"], seconds(lambda: arm.inverse_dynamics(q, v, a)))
            cpp.read_problem(problem, expected.ctypes.data_as(ctypes.c_void_p))
            same = "the same bits" if np.array_equal(out, expected) else f"up to {np.abs(out - expected).max():.1e} apart"
            print(f"products {'fused' if contract == 'fast' else 'not fused'}, {n} states, {same}")
            for name, value in best.items():
                print(f"  {name:<14} {value / n * 1e9:7.1f} ns a state   {value / best['C++ batch']:.2f}")
            good = good and best["Python, out="] <= 1.3 * best["C++ batch"]
            call = arm.inverse_dynamics.bind(q[0], v[0], a[0])
            one = min(seconds(lambda: [call() for _ in range(1000)]) for _ in range(TURNS)) / 1000
            whole = min(seconds(lambda: [arm.inverse_dynamics(q[0], v[0], a[0]) for _ in range(100)]) for _ in range(TURNS)) / 100
            print(f"  one call       {one * 1e6:7.2f} us with bound arrays, {whole * 1e6:.1f} us with new ones")
            good = good and one <= 2e-6
        peer = mujoco(folder, (q, v, a))
        if peer is None:
            print("MuJoCo is not installed")
        else:
            print(f"MuJoCo in a loop of C++ {peer[0] / n * 1e9:7.1f} ns a state, forces up to {np.abs(peer[1] - out).max():.1e} N m apart")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
