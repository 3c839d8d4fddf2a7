"""Frames of an animation as workers read them: of an array, of one file, of a file a frame."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, Union

import numpy as np
from numpy.typing import NDArray

from ._native import Mesh, read_mesh, read_positions

Paths = Sequence[Union[str, "os.PathLike[str]"]]


class FrameError(ValueError):
    """A frame that cannot be read, or that is one of another mesh."""


class Frames(Protocol):
    """Frames by their numbers; what a worker gets is the part that it reads."""

    def __len__(self) -> int: ...

    def part(self, begin: int, end: int) -> Frames:
        """The frames from one number until before another, counted as before."""
        ...

    def read(self, at: int, mesh: Mesh) -> NDArray[Any]:
        """Positions of a frame, (n_vertices, 3)."""
        ...


def frames_of(frames: object) -> Frames:
    """Frames of what a caller has: an array or arrays, a file or files."""
    if isinstance(frames, (str, os.PathLike)):
        path = os.path.abspath(frames)
        if path.lower().endswith(".npz"):
            # Its frames are packed together: to read one would unpack all.
            return _InArray(read_positions(path), 0)
        return _InOneFile(path, _n_frames(path))
    if isinstance(frames, np.ndarray):
        return _InArray(frames, 0)
    listed = list(frames)  # type: ignore[call-overload]
    if all(isinstance(of, (str, os.PathLike)) for of in listed):
        if len(listed) == 1:
            return frames_of(listed[0])
        paths = [os.path.abspath(path) for path in listed]
        return _InFiles(paths, 0, paths[0]) if paths else _InArray(np.zeros((0, 0, 3)), 0)
    return _InArray(np.stack([np.asarray(x) for x in listed]), 0)


def positions(frames: Frames, begin: int, end: int, mesh: Mesh) -> Iterator[NDArray[Any]]:
    """Frames of a mesh in order; a FrameError names the one that is not."""
    for at in range(begin, end):
        x = frames.read(at, mesh)
        if x.shape != (mesh.n_vertices, 3):
            raise FrameError(
                f"frame {at} has positions of the shape {x.shape}; the mesh has "
                f"{mesh.n_vertices} vertices"
            )
        if not np.isfinite(x).all():
            raise FrameError(f"frame {at} has a coordinate that is not finite")
        yield x


class Digest:
    """SHA-256 of positions that go by."""

    def __init__(self) -> None:
        self._sha = hashlib.sha256()

    def of(self, frames: Iterator[NDArray[Any]]) -> Iterator[NDArray[Any]]:
        """The same frames."""
        for x in frames:
            # As numbers, so that the digest does not depend on type or order in memory.
            self._sha.update(np.ascontiguousarray(x, "<f8").tobytes())
            yield x

    def text(self) -> str:
        return self._sha.hexdigest()


def digest_of_frames(frames: Frames, begin: int, end: int, mesh: Mesh) -> str:
    """That of some frames."""
    digest = Digest()
    for _ in digest.of(positions(frames, begin, end, mesh)):
        pass
    return digest.text()


@dataclass
class _InArray:
    array: NDArray[Any]
    first: int

    def __len__(self) -> int:
        return len(self.array)

    def part(self, begin: int, end: int) -> Frames:
        return _InArray(self.array[begin - self.first : end - self.first], begin)

    def read(self, at: int, mesh: Mesh) -> NDArray[Any]:
        return np.asarray(self.array[at - self.first])


@dataclass
class _InOneFile:
    path: str
    n: int

    def __len__(self) -> int:
        return self.n

    def part(self, begin: int, end: int) -> Frames:
        return self

    def read(self, at: int, mesh: Mesh) -> NDArray[Any]:
        try:
            frames = read_positions(self.path, (at, at + 1))
        except (ValueError, OSError) as why:
            raise FrameError(f"frame {at} cannot be read: {why}") from why
        x: NDArray[Any] = frames[0]
        return x


@dataclass
class _InFiles:
    paths: list[str]
    first: int
    #: The first file of all, whose vertices are merged as those of the others are.
    start: str

    def __len__(self) -> int:
        return len(self.paths)

    def part(self, begin: int, end: int) -> Frames:
        paths = self.paths[begin - self.first : end - self.first]
        return _InFiles(paths, begin, self.start)

    def read(self, at: int, mesh: Mesh) -> NDArray[Any]:
        path = self.paths[at - self.first]
        try:
            # Other formats merge no vertices, and need not read the first file again.
            merges = path.lower().removesuffix(".gz").endswith((".stl", ".gltf", ".glb"))
            other, x = read_mesh(path, self.start if merges else None)
        except (ValueError, OSError) as why:
            raise FrameError(f"frame {at} cannot be read: {why}") from why
        if not np.array_equal(other.faces, mesh.faces):
            raise FrameError(f"frame {at} ({path}) has other faces than the mesh")
        # Not every format has rods, so the mesh may have more of them.
        if not np.isin(_keys(other.edges), _keys(mesh.edges)).all():
            raise FrameError(f"frame {at} ({path}) has edges that the mesh has not")
        return x


def _keys(edges: NDArray[np.uint32]) -> NDArray[np.uint64]:
    """A number for each edge."""
    keys: NDArray[np.uint64] = edges[:, 0].astype(np.uint64) << np.uint64(32) | edges[:, 1]
    return keys


def _n_frames(path: str) -> int:
    if path.lower().endswith(".npy"):
        try:
            shape: tuple[int, ...] = np.lib.format.open_memmap(path, mode="r").shape
        except ValueError as why:
            raise ValueError(f"{path}: {why}") from why
        if len(shape) != 3:
            raise ValueError(f"{path}: the shape is {shape}, expected (frames, n, 3)")
        return shape[0]
    return len(read_positions(path))
