"""Many frames on many cores, GPUs or machines: the steps of an animation in shards, files of some
steps each.

`map_frames` shares the shards out among processes of this machine, actors of Ray, or jobs of Slurm
by submitit. A shard that is there is not made again, so a run that was ended goes on where it was.
Reports, their order and their digest are those of one process.

    python -m meshccd.distributed FRAME.. --out FOLDER [--part i/n]

does the same from a shell: `--part` takes one share, by default that of this task of Slurm.
"""

from __future__ import annotations

import hashlib
import json
import os
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Union, overload

from numpy.typing import ArrayLike

from . import _shards, _workers
from ._frames import FrameError, Paths, frames_of
from ._native import Mesh, Options, Report, read_mesh
from ._shards import Job, ShardError
from ._workers import Outcome, Task

__all__ = [
    "FrameError",
    "Progress",
    "Reports",
    "RunError",
    "ShardError",
    "digest",
    "map_frames",
]


@dataclass(frozen=True)
class Progress:
    """How far a run is: shards and steps that are done of all, how many of these shards were there
    before and how many failed, and seconds since it began."""

    n_done: int
    n_shards: int
    n_steps_done: int
    n_steps: int
    n_kept: int
    n_failed: int
    seconds: float

    def __str__(self) -> str:
        rate = self.n_steps_done / self.seconds if self.seconds > 0 else 0.0
        return (
            f"{self.n_done} of {self.n_shards} shards, {self.n_steps_done} of {self.n_steps} "
            f"steps, {rate:.1f} a second; {self.n_kept} shards were there, {self.n_failed} failed"
        )


class RunError(RuntimeError):
    """Shards that are missing at the end of a run: `failures`, (begin, end, reason) of each. All
    others are written; the next run makes these alone."""

    def __init__(self, failures: Sequence[tuple[int, int, str]], n_shards: int) -> None:
        self.failures: list[tuple[int, int, str]] = list(failures)
        self._n_shards = n_shards
        lines = [f"steps {begin} to {end}: {why}" for begin, end, why in self.failures[:5]]
        if len(self.failures) > 5:
            lines.append("..")
        n = len(self.failures)
        super().__init__("\n  ".join([f"{n} of {n_shards} shards are not written:", *lines]))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.failures, self._n_shards)


class Reports(Sequence[Report]):
    """Reports of the steps of a run in their order, read from shards when they are asked for; they
    have no times, nor figures of trees. `first` is the number of the first step."""

    def __init__(self, mesh: Mesh, shards: Sequence[tuple[int, int, Path]]) -> None:
        self._mesh = mesh
        self._shards = list(shards)
        self._read: tuple[int, list[Report]] = (-1, [])
        self.first: int = shards[0][0] if shards else 0

    def __len__(self) -> int:
        return self._shards[-1][1] - self.first if self._shards else 0

    @overload
    def __getitem__(self, at: int) -> Report: ...

    @overload
    def __getitem__(self, at: slice) -> list[Report]: ...

    def __getitem__(self, at: int | slice) -> Report | list[Report]:
        if isinstance(at, slice):
            return [self[i] for i in range(*at.indices(len(self)))]
        step = at + len(self) if at < 0 else at
        if not 0 <= step < len(self):
            raise IndexError(f"step {at} of {len(self)}")
        size = self._shards[0][1] - self._shards[0][0]
        shard = step // size
        if self._read[0] != shard:
            self._read = (shard, _shards.reports(self._shards[shard][2], self._mesh))
        return self._read[1][step - shard * size]

    def digest(self) -> str:
        """`digest` of all reports."""
        return digest(self)

    def __repr__(self) -> str:
        return f"<Reports of {len(self)} steps from {self.first} on>"


def digest(reports: Iterable[Report]) -> str:
    """SHA-256 of the contacts of reports in their order: equal for runs that found the same."""
    sha = hashlib.sha256()
    for report in reports:
        sha.update(len(report).to_bytes(8, "little"))
        sha.update(report.contacts.tobytes())
    return sha.hexdigest()


def map_frames(
    frames: Union[ArrayLike, Paths, str, os.PathLike[str]],
    mesh: Union[Mesh, str, os.PathLike[str]],
    folder: Union[str, os.PathLike[str]],
    *,
    options: Options | None = None,
    runner: Any = "processes",
    n_workers: int | None = None,
    devices: Sequence[str | None] | None = None,
    part: tuple[int, int] = (1, 1),
    steps_per_shard: int = 16,
    progress: Callable[[Progress], object] | None = None,
) -> Reports:
    """A report of each step of an animation: from each frame to the next.

    Parameters
    ----------
    frames : array (n_frames, n_vertices, 3), path, or list of paths or of arrays
        Positions; an animation in one file as of `read_positions`, or a mesh file a frame. Workers
        read files themselves, so these must be where every worker finds them.
    mesh : Mesh, or path of a mesh file
    folder : path
        Where shards are written, `steps-BEGIN-END.npz`; made if it is not there. A shard has the
        columns of reports, and digests of mesh, options and positions.
    options : Options, optional
        Its `threads`: of each worker; 0 for an equal share of the cores. Its `mode` "auto": exact
        if no worker has a GPU and there is no minimum distance, else conservative.
    runner : str or executor
        "processes" of this machine, begun by spawn: a script that calls this needs
        `if __name__ == "__main__":`. "ray": actors. Or an executor of submitit, which has the
        parameters of Slurm: an array of jobs.
    n_workers : int, optional
        By default one a device if there are devices, else one a core. "processes" with one worker
        work in this process. An executor gets so many jobs.
    devices : sequence of str, optional
        As of a `Session`, in turn for each worker: ["gpu:0000:3b:00.0", "gpu:0000:af:00.0"] is a
        worker on each of two GPUs. "gpu:assigned" is the one that Ray or Slurm gave the worker.
    part : (int, int)
        Share i of n, counted from 1, of the shards: neighbours, and as many as in the others, or
        one more or less.
    steps_per_shard : int
        Also of later runs that are to find the shards.
    progress : callable, optional
        Called with a `Progress` after each shard.

    Returns
    -------
    reports : Reports
        Those of the part.

    Raises
    ------
    ValueError
        If arguments are refused.
    RunError
        If shards are missing at the end: a frame cannot be read, a worker died, a shard there is
        of another mesh, of other options or frames, or another run is writing it. All other shards
        are written.
    """
    begun = time.monotonic()
    is_executor = hasattr(runner, "map_array")
    if not is_executor and runner not in ("processes", "ray"):
        raise ValueError(
            f'runner is {runner!r}; it must be "processes", "ray", or an executor of submitit'
        )
    source = frames_of(frames)
    if not isinstance(mesh, Mesh):
        mesh, _ = read_mesh(mesh)
    index, of = part
    if not 1 <= index <= of:
        raise ValueError(f"part is {index} of {of}; the first is 1 of {of}")
    if steps_per_shard < 1:
        raise ValueError(f"steps_per_shard is {steps_per_shard}; it must be at least 1")
    if isinstance(devices, str):
        raise TypeError(f"devices is {devices!r}; it must be a list of names")
    if n_workers is None:
        n_workers = len(devices) if devices else _cores(runner)[0]
    if n_workers < 1:
        raise ValueError(f"n_workers is {n_workers}; it must be at least 1")
    devices = list(devices or [None])
    options = options or Options()
    # A worker that has its machine for itself counts the cores there.
    if not is_executor and n_workers > 1:
        options = _of_one_worker(options, runner, n_workers)
    options = _in_one_mode(options, devices)
    job = Job(mesh, options, Path(os.path.abspath(folder)))
    job.folder.mkdir(parents=True, exist_ok=True)
    ranges = _ranges(len(source), steps_per_shard, index, of)
    tasks = (Task(begin, end, source.part(begin, end + 1)) for begin, end in ranges)
    of_workers = [devices[i % len(devices)] for i in range(min(n_workers, len(ranges)))]
    done: list[Outcome] = []
    for outcome in _outcomes(runner, job, tasks, of_workers):
        done.append(outcome)
        if progress is not None:
            progress(_progress(done, ranges, time.monotonic() - begun))
    failures = sorted((of.begin, of.end, of.error) for of in done if of.error is not None)
    if failures:
        raise RunError(failures, len(ranges))
    return Reports(mesh, [(begin, end, job.path(begin, end)) for begin, end in ranges])


def _outcomes(
    runner: Any, job: Job, tasks: Iterable[Task], devices: Sequence[str | None]
) -> Iterator[Outcome]:
    if not devices:
        return iter(())
    if runner == "processes":
        if len(devices) == 1:
            return _workers.here(job, tasks, devices[0])
        return _workers.processes(job, tasks, devices)
    if runner == "ray":
        return _workers.actors(job, tasks, devices)
    return _workers.jobs(job, tasks, devices, runner)


def _ranges(n_frames: int, size: int, index: int, of: int) -> list[tuple[int, int]]:
    """First step of each shard of a part, and the step behind the last one."""
    n_steps = max(n_frames - 1, 0)
    ranges = [(at, min(at + size, n_steps)) for at in range(0, n_steps, size)]
    n = len(ranges)
    return ranges[(index - 1) * n // of : index * n // of]


def _progress(done: list[Outcome], ranges: list[tuple[int, int]], seconds: float) -> Progress:
    steps = sum(of.end - of.begin for of in done)
    kept = sum(not of.written and of.error is None for of in done)
    all_steps = sum(end - begin for begin, end in ranges)
    failed = sum(of.error is not None for of in done)
    return Progress(len(done), len(ranges), steps, all_steps, kept, failed, seconds)


def _cores(runner: Any) -> tuple[int, int]:
    """The number of cores that workers share, and that of the largest machine among theirs."""
    if hasattr(runner, "map_array"):
        raise ValueError("n_workers says how many jobs an executor gets")
    if runner == "ray":
        nodes = [node for node in _workers.connected_ray().nodes() if node["Alive"]]
        cores = [int(node["Resources"].get("CPU", 0)) for node in nodes]
        return max(sum(cores), 1), max(cores, default=1)
    if hasattr(os, "sched_getaffinity"):
        n = len(os.sched_getaffinity(0))
    else:
        n = os.cpu_count() or 1
    return n, n


def _of_one_worker(options: Options, runner: Any, n_workers: int) -> Options:
    """Options with an equal share of the cores, unless they name the threads of a worker."""
    if options.threads:
        return options
    cores, most = _cores(runner)
    return _with(options, threads=max(min(cores // n_workers, most), 1))


def _in_one_mode(options: Options, devices: Sequence[str | None]) -> Options:
    """Options whose mode does not depend on where a worker runs: all shards are of one."""
    if options.mode != "auto":
        return options
    on_cpu = all(device in (None, "cpu") for device in devices)
    return _with(options, mode="exact" if on_cpu and not options.min_distance else "conservative")


def _with(options: Options, **given: Any) -> Options:
    return Options.from_json(json.dumps({**json.loads(options.to_json()), **given}))


if __name__ == "__main__":
    from ._distributed_main import main

    raise SystemExit(main())
