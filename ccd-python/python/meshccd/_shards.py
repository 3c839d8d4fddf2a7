"""Files of some steps each: what was found, and digests of what it was found for."""

from __future__ import annotations

import hashlib
import json
import os
import socket
import zipfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ._native import Mesh, Options, Report, __version__

try:
    import fcntl
except ImportError:  # Windows: two runs are told apart when the second one has finished.
    fcntl = None  # type: ignore[assignment]

_COLUMNS = ("kind", "a", "b", "toi", "state", "approach")


class ShardError(RuntimeError):
    """A shard that is not of this run, that is damaged, or that another run writes."""


@dataclass(frozen=True)
class Job:
    """What all shards of a run have in common."""

    mesh: Mesh
    options: Options
    folder: Path

    def identity(self) -> dict[str, Any]:
        """What answers depend on, frames apart."""
        options = json.loads(self.options.to_json())
        # No answer depends on these.
        for name in ("threads", "max_memory", "scheduling"):
            options.pop(name, None)
        sha = hashlib.sha256(str(self.mesh.n_vertices).encode())
        for ids in (self.mesh.faces, self.mesh.edges):
            sha.update(ids.astype("<u4").tobytes() + b"|")
        return {"version": __version__, "mesh": sha.hexdigest(), "options": options}

    def path(self, begin: int, end: int) -> Path:
        """The shard of the steps from one frame until another."""
        return self.folder / f"steps-{begin:07}-{end:07}.npz"


def write(job: Job, begin: int, end: int, frames: str, reports: Sequence[Report]) -> None:
    """Writes a shard, so that it is there whole or not at all. Where another run has written it
    meanwhile, with what this one found, nothing is done."""
    path = job.path(begin, end)
    columns = {name: np.concatenate([getattr(of, name) for of in reports]) for name in _COLUMNS}
    if reports[0].toi_of_worlds is not None:
        columns["toi_of_worlds"] = np.array([of.toi_of_worlds for of in reports])
    columns["n_contacts"] = np.array([len(of) for of in reports], np.int64)
    columns["n_candidates"] = np.array([of.n_candidates for of in reports], np.uint64)
    columns["n_filtered"] = np.array([of.n_filtered for of in reports], np.uint64)
    meta = {**job.identity(), "frames": frames}
    text = np.array(json.dumps(meta, sort_keys=True))
    own = path.with_name(f".{path.name}.{socket.gethostname()}.{os.getpid()}")
    try:
        with own.open("wb") as file:
            np.savez(file, meta=text, **columns)  # type: ignore[arg-type]
            file.flush()
            os.fsync(file.fileno())
        _publish(own, path)
    finally:
        own.unlink(missing_ok=True)


def _publish(own: Path, path: Path) -> None:
    """Gives a file its name, unless there is one of that name with other bytes."""
    try:
        os.link(own, path)
        return
    except FileExistsError:
        pass
    except OSError:
        # A file system without links: a file that comes between these two lines is lost.
        if not path.exists():
            os.replace(own, path)
            return
    if path.read_bytes() != own.read_bytes():
        raise ShardError(f"{path}: another run has written other contacts meanwhile")


def check(job: Job, begin: int, end: int, frames: str) -> bool:
    """Whether a shard is there; one of another run is a ShardError that says what differs."""
    path = job.path(begin, end)
    if not path.exists():
        return False
    shard = load(path)
    found, wanted = shard["meta"], {**job.identity(), "frames": frames}
    for name in wanted:
        if found.get(name) != wanted[name]:
            raise ShardError(
                f"{path} was made with {_what(name, found.get(name), wanted[name])}; write to "
                "another folder, or remove it"
            )
    return True


def _what(name: str, found: Any, wanted: Any) -> str:
    if name == "version":
        return f"version {found} of meshccd, this is {wanted}"
    if name == "options" and isinstance(found, dict):
        other = [key for key in wanted if found.get(key) != wanted[key]]
        return "other options: " + ", ".join(
            key if key == "bodies" else f"{key} {found.get(key)}, not {wanted[key]}"
            for key in other
        )
    return f"another {name}" if name == "mesh" else "other frames"


def load(path: Path) -> dict[str, Any]:
    """The arrays of a shard by their names, and `meta`."""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as arrays:
            shard: dict[str, Any] = {name: arrays[name] for name in arrays.files}
        shard["meta"] = json.loads(str(shard["meta"]))
        if shard["n_contacts"].sum() != len(shard["toi"]):
            raise ValueError("its columns do not fit together")
        # What `check` and `reports` take as given.
        shard["meta"].get("version")
        shard["toi"].shape[0]
    except (
        AttributeError,
        EOFError,
        IndexError,
        KeyError,
        OSError,
        TypeError,
        ValueError,
        zipfile.BadZipFile,
    ) as why:
        raise ShardError(f"{path} is damaged, remove it: {why}") from why
    return shard


def reports(path: Path, mesh: Mesh) -> list[Report]:
    """The reports of a shard, without times and figures of trees."""
    shard = load(path)
    ends = np.cumsum(shard["n_contacts"])
    made = []
    for step, (begin, end) in enumerate(zip(ends - shard["n_contacts"], ends)):
        parts: dict[str, Any] = {name: shard[name][begin:end].copy() for name in _COLUMNS}
        worlds = shard.get("toi_of_worlds")
        made.append(
            Report(
                **parts,
                vertices=_vertices(mesh, parts),
                earliest_toi=float(parts["toi"].min()) if end > begin else None,
                n_candidates=tuple(map(int, shard["n_candidates"][step])),
                n_filtered=tuple(map(int, shard["n_filtered"][step])),
                n_undecided=int((parts["state"] == 2).sum()),
                triangles=None,
                front=None,
                rebuilt=False,
                times={},
                toi_of_worlds=None if worlds is None else worlds[step].copy(),
                mesh=mesh,
            )
        )
    return made


def _vertices(mesh: Mesh, parts: dict[str, Any]) -> NDArray[np.uint32]:
    vertices = np.zeros((len(parts["kind"]), 4), np.uint32)
    pairs = np.stack([parts["a"], parts["b"]], axis=1)
    for kind in np.unique(parts["kind"]):
        of_kind = parts["kind"] == kind
        vertices[of_kind] = mesh.vertices_of(int(kind), pairs[of_kind])
    return vertices


@contextmanager
def alone(path: Path) -> Iterator[None]:
    """While no other process has this shard; a ShardError if one has. A process that dies leaves
    it at once."""
    lock = path.with_name(f".{path.name}.lock")
    file, locked = _open(lock, path)
    with file:
        file.truncate(0)
        file.write(f"process {os.getpid()} on {socket.gethostname()}\n")
        file.flush()
        # What a process of this machine left that died while it wrote; without locks it may live.
        if locked:
            for left in path.parent.glob(f".{path.name}.{socket.gethostname()}.*"):
                left.unlink(missing_ok=True)
        try:
            yield
        finally:
            with suppress(OSError):
                lock.unlink()


def _open(lock: Path, path: Path) -> tuple[IO[str], bool]:
    """The file of a lock, and whether it is locked."""
    while True:
        file = lock.open("a+")
        if fcntl is None:
            return file, False
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            with file:
                file.seek(0)
                who = file.read().strip() or "another process"
            raise ShardError(f"{path} is being written by {who}") from None
        except OSError:  # A file system without locks: `_publish` tells two runs apart.
            return file, False
        # The process that had it may have removed it meanwhile: then it locks nothing.
        with suppress(FileNotFoundError):
            if os.path.samestat(os.fstat(file.fileno()), lock.stat()):
                return file, True
        file.close()
