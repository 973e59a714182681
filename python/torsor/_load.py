# SPDX-License-Identifier: MIT
"""Files to mechanisms: the program torsor derives, $CXX compiles, a cache keeps both."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import tempfile
from typing import Iterable, Sequence

from ._mechanism import Mechanism

_SCENE_PROJECT = """cmake_minimum_required(VERSION 3.22)
project(scene CXX)
find_package(torsor REQUIRED COMPONENTS generator)
add_executable(scene "${SCENE}")
target_link_libraries(scene PRIVATE torsor::generator)
"""


class LoadError(RuntimeError):
    """The program torsor, or a compiler, refuses a file; its own words."""


def _run(command: Sequence[str]) -> str:
    done = subprocess.run(list(command), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise LoadError(done.stderr.strip() or done.stdout.strip() or f"{command[0]} fails: {done.returncode}")
    return done.stdout


def _cache() -> str:
    folder = os.environ.get("TORSOR_CACHE")
    if not folder:
        folder = os.path.join(os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"), "torsor")
    os.makedirs(folder, exist_ok=True)
    return folder


def tool() -> str:
    """The program torsor: $TORSOR, or that on the PATH. Raises FileNotFoundError where there is none."""
    named = os.environ.get("TORSOR")
    found = shutil.which(named or "torsor")
    if found is None:
        raise FileNotFoundError(f"no program {named or 'torsor'!r}: install the package torsor, or set TORSOR to its path")
    return found


def scene_program(path: str) -> str:
    """The program of a scene in C++: built by CMake against the installed package, or the one of $torsor_DIR, and kept in
    the cache by its text."""
    with open(path, "rb") as file:
        text = file.read()
    key = hashlib.sha256(text + os.environ.get("torsor_DIR", "").encode()
                         + os.environ.get("CXX", "").encode()).hexdigest()[:16]
    program = os.path.join(_cache(), f"scene-{key}")
    if os.path.exists(program):
        return program
    with tempfile.TemporaryDirectory(dir=_cache()) as folder:
        with open(os.path.join(folder, "CMakeLists.txt"), "w", encoding="utf-8") as file:
            file.write(_SCENE_PROJECT)
        build = os.path.join(folder, "build")
        _run(["cmake", "-S", folder, "-B", build, "-DSCENE:FILEPATH=" + os.path.abspath(path).replace("\\", "/")])
        _run(["cmake", "--build", build])
        os.replace(os.path.join(build, "scene"), program)
    return program


class Source:
    """A file and how its program is called."""

    def __init__(self, path: str, options: Sequence[str]):
        if not os.path.exists(path):
            raise FileNotFoundError(2, os.strerror(2), path)
        if path.endswith((".cpp", ".cc", ".cxx")):
            self._start, self._target = [scene_program(path)], list(options)
        else:
            self._start, self._target = [tool()], [os.path.abspath(path), *options]

    def run(self, command: str, *arguments: str) -> str:
        return _run([*self._start, command, *self._target, *arguments])


def load(path: str | os.PathLike[str], *, kernels: Iterable[str] | str = "all", run_time: Iterable[str] | str = (),
         fused: bool = False, flags: str | None = None, options: Sequence[str] = ()) -> Mechanism:
    """The mechanism of a URDF, xacro or MJCF file, or of a scene in C++.

    kernels: names, or "all". run_time: parameters that can be changed later, or "all". fused: let the compiler fuse
    products with sums, which is faster and changes last digits. flags: of the compiler, instead of "-O3 -march=native".
    options: further ones of `torsor build`, e.g. ("--base", "floating").

    The first call compiles, which takes from seconds to minutes; later ones find the library in the cache.
    Raises LoadError with what torsor or the compiler say, FileNotFoundError where file or program are missing.
    """
    source = Source(os.fspath(path), options)
    words = ["--kernels", kernels if isinstance(kernels, str) else ",".join(kernels)]
    names = run_time if isinstance(run_time, str) else ",".join(run_time)
    if names:
        words += ["--run-time", names]
    if fused:
        words.append("--fused")
    if flags is not None:
        words.append(f"--flags={flags}")
    return Mechanism(source.run("build", *words).strip(), source)
