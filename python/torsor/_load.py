# SPDX-License-Identifier: MIT
"""Files to mechanisms: the program torsor derives, $CXX compiles, a cache keeps both."""

from __future__ import annotations

import hashlib
import json
import os
import shlex
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
set_target_properties(scene PROPERTIES EXPORT_COMPILE_COMMANDS ON)
file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/library" CONTENT "$<TARGET_FILE:torsor::generator>")
"""


class LoadError(RuntimeError):
    """The program torsor, or a compiler, refuses a file; its own words."""


def _run(command: Sequence[str], folder: str | None = None) -> str:
    done = subprocess.run(list(command), cwd=folder, capture_output=True, text=True, check=False)
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


def _digest(files: Iterable[str]) -> str:
    """Of the bytes of files and of their names. Raises OSError where one is missing."""
    whole = hashlib.sha256()
    for name in files:
        with open(name, "rb") as file:
            own = hashlib.sha256(file.read()).hexdigest()
        whole.update(f"{name}\0{own}\0".encode())
    return whole.hexdigest()[:16]


def _read_files(build: str) -> list[str]:
    """What the scene's program was made of: its source, all that it includes, the library of the generator."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        command = shlex.split(json.load(file)[0]["command"])
    rule = os.path.join(build, "scene.d")
    command[command.index("-o") + 1] = rule
    _run([*command, "-M", "-MT", "scene"], build)
    with open(rule, encoding="utf-8") as file:
        words = shlex.split(file.read().split(":", 1)[1].replace("\\\n", " ").replace("$$", "$"))
    with open(os.path.join(build, "library"), encoding="utf-8") as file:
        return sorted({os.path.abspath(os.path.join(build, word)) for word in words}) + [file.read()]


def _write(path: str, text: str) -> None:
    with tempfile.NamedTemporaryFile("w", dir=os.path.dirname(path), delete=False, encoding="utf-8") as file:
        file.write(text)
    os.replace(file.name, path)


def scene_program(path: str) -> str:
    """The program of a scene in C++: built by CMake against the installed package, or the one of $torsor_DIR, and kept in
    the cache by what it was made of: its text, what it includes, the library."""
    path = os.path.abspath(path)
    chosen = [path, *(os.environ.get(name, "") for name in ("torsor_DIR", "CMAKE_PREFIX_PATH", "CXX", "CXXFLAGS"))]
    kept = os.path.join(_cache(), "scene-" + hashlib.sha256("\0".join(chosen).encode()).hexdigest()[:16])
    try:
        with open(kept + ".json", encoding="utf-8") as file:
            program = f"{kept}-{_digest(json.load(file))}"
        if os.path.exists(program):
            return program
    except (OSError, ValueError):
        pass  # never built, or what it was made of is gone
    with tempfile.TemporaryDirectory(dir=_cache()) as folder:
        with open(os.path.join(folder, "CMakeLists.txt"), "w", encoding="utf-8") as file:
            file.write(_SCENE_PROJECT)
        build = os.path.join(folder, "build")
        _run(["cmake", "-S", folder, "-B", build, "-DSCENE:FILEPATH=" + path.replace("\\", "/")])
        files = _read_files(build)
        program = f"{kept}-{_digest(files)}"  # of what is there before the compiler reads it
        _run(["cmake", "--build", build])
        os.replace(os.path.join(build, "scene"), program)
    _write(kept + ".json", json.dumps(files))
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
