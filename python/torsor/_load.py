# SPDX-License-Identifier: MIT
"""Files to mechanisms: the program torsor derives, $CXX compiles, a cache keeps both."""

from __future__ import annotations

import os
import shutil
import subprocess
import warnings
from typing import Any, Iterable, Protocol, Sequence, cast

from ._mechanism import Mechanism


class LoadError(RuntimeError):
    """The program torsor, or a compiler, refuses a file; its own words."""


def _run(command: Sequence[str]) -> subprocess.CompletedProcess[str]:
    done = subprocess.run(list(command), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise LoadError(done.stderr.strip() or done.stdout.strip() or f"{command[0]} fails: {done.returncode}")
    return done


def tool() -> str:
    """The program torsor: $TORSOR, or that on the PATH. Raises FileNotFoundError where there is none."""
    named = os.environ.get("TORSOR")
    found = shutil.which(named or "torsor")
    if found is None:
        raise FileNotFoundError(f"no program {named or 'torsor'!r}: install the package torsor, or set TORSOR to its path")
    return found


class Source:
    """A file, and the program torsor called for it. A scene in C++ is compiled by that program, which keeps what it made
    until the scene, what it includes or torsor's library changes."""

    def __init__(self, path: str, options: Sequence[str]):
        if not os.path.exists(path):
            raise FileNotFoundError(2, os.strerror(2), path)
        self._start, self._target = tool(), [os.path.abspath(path), *options]

    def run(self, command: str, *arguments: str) -> str:
        return _run([self._start, command, *self._target, *arguments]).stdout

    def build(self, *arguments: str) -> tuple[str, list[str]]:
        """The path of the library, and the program's notes."""
        built = _run([self._start, "build", *self._target, *arguments])
        return built.stdout, [line.removeprefix("note: ") for line in built.stderr.splitlines() if line.startswith("note: ")]


class AnyScene(Protocol):
    """A torsor.scene.Scene, by what it can: its module need not be installed."""

    def equations(self) -> str: ...
    def outcome(self, command: str, *words: str, **options: Any) -> Any: ...


def load(path: str | os.PathLike[str] | AnyScene, *, kernels: Iterable[str] | str = "all", run_time: Iterable[str] | str = (),
         fused: bool = False, flags: str | None = None, options: Sequence[str] = ()) -> Mechanism:
    """The mechanism of a URDF, xacro or MJCF file, of a scene in C++, or of a torsor.scene.Scene.

    kernels: names, or "all". run_time: parameters that can be changed later, or "all". fused: let the compiler fuse
    products with sums, which is faster and changes last digits. flags: of the compiler, instead of "-O3 -march=native".
    options: further ones of `torsor build`, e.g. ("--base", "floating").

    The first call compiles, which takes from seconds to minutes; later ones find the library in the cache.
    Notes of the program become warnings. Raises LoadError with what torsor or the compiler say,
    FileNotFoundError where file or program are missing; for a Scene its own errors.
    """
    if isinstance(options, str):
        raise TypeError(f"options: give a sequence of words, as ({options!r},), not one text")
    source: AnyScene | Source
    if hasattr(path, "equations"):
        source = cast(AnyScene, path)
    else:
        source = Source(os.fspath(cast("str | os.PathLike[str]", path)), options)
    words = ["--kernels", kernels if isinstance(kernels, str) else ",".join(kernels)]
    names = run_time if isinstance(run_time, str) else ",".join(run_time)
    if names:
        words += ["--run-time", names]
    if fused:
        words.append("--fused")
    if flags is not None:
        words.append(f"--flags={flags}")
    if not isinstance(source, Source):
        outcome = source.outcome("build", *words, *options)
        library, notes = outcome.text, outcome.notes
    else:
        library, notes = source.build(*words)
    for note in notes:
        warnings.warn(note, stacklevel=2)
    return Mechanism(library.strip(), source)
