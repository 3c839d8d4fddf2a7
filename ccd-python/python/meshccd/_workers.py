"""Workers of a run: processes of this machine, actors of Ray, jobs of Slurm; each has a session."""

from __future__ import annotations

import importlib
import os
import subprocess
import warnings
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from multiprocessing import get_context
from typing import Any

from . import _shards
from ._frames import Digest, FrameError, Frames, digest_of_frames, positions
from ._native import Session
from ._shards import Job

DIED = (
    "the worker died before it was written: killed, perhaps for memory. What is written stays; run "
    "again for the rest"
)

@dataclass(frozen=True)
class Task:
    """The steps from one frame until another, with these frames and the one at the end."""

    begin: int
    end: int
    frames: Frames


@dataclass(frozen=True)
class Outcome:
    """What became of a shard: written now, there before, or why it is not."""

    begin: int
    end: int
    written: bool = False
    error: str | None = None


class Worker:
    """Makes shards by one session, on a device."""

    def __init__(self, job: Job, device: str | None) -> None:
        self._job = job
        self._device = device
        self._session: Session | None = None

    def run(self, task: Task) -> Outcome:
        """A shard, if it is not there; an error is a part of the outcome."""
        try:
            return Outcome(task.begin, task.end, written=self._write(task))
        except Exception as why:  # It costs this shard, and no other one.
            return _failed(task, why)

    def _write(self, task: Task) -> bool:
        job, begin, end = self._job, task.begin, task.end
        frames = _frames(job, task)
        if _shards.check(job, begin, end, frames):
            return False
        with _shards.alone(job.path(begin, end)):
            if _shards.check(job, begin, end, frames):
                return False
            if self._session is None:
                device = assigned_gpu() if self._device == "gpu:assigned" else self._device
                self._session = Session(job.mesh, job.options, device=device)
            stepped = Digest()
            x = stepped.of(positions(task.frames, begin, end + 1, job.mesh))
            reports = self._session.step_many(x)
            if stepped.text() != frames:
                raise FrameError(f"frames {begin} to {end} were changed while they were read")
            _shards.write(job, begin, end, frames, reports)
        return True


def assigned_gpu() -> str:
    """The GPU that Ray or Slurm gave this process, by its PCI id: numbers of CUDA are others than
    those of `gpus()`."""
    ids: Sequence[str] = [id for id in os.environ.get("CUDA_VISIBLE_DEVICES", "").split(",") if id]
    if not ids:
        raise RuntimeError(
            "gpu:assigned: CUDA_VISIBLE_DEVICES names no GPU; Ray sets it, and Slurm for "
            "--gpus-per-task"
        )
    ask = ["nvidia-smi", "--query-gpu=index,uuid,pci.bus_id", "--format=csv,noheader"]
    try:
        listed = subprocess.run(ask, capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as why:
        raise RuntimeError(f"gpu:assigned: nvidia-smi does not tell PCI ids: {why}") from why
    for line in listed.splitlines():
        index, uuid, pci = (word.strip() for word in line.split(","))
        if ids[0] == index or uuid.startswith(ids[0]):
            return f"gpu:{pci}"
    raise RuntimeError(f"gpu:assigned: nvidia-smi lists no GPU {ids[0]}")


def here(job: Job, tasks: Iterable[Task], device: str | None) -> Iterator[Outcome]:
    """One after the other, in this process."""
    worker = Worker(job, device)
    return map(worker.run, tasks)


_worker: Worker | None = None


def _begin(job: Job, device: str | None) -> None:
    global _worker
    _worker = Worker(job, device)


def _ready() -> None:
    """What a process does first: no task is lost with one that cannot begin."""


def _run(task: Task) -> Outcome:
    assert _worker is not None
    return _worker.run(task)


def processes(job: Job, tasks: Iterable[Task], devices: Sequence[str | None]) -> Iterator[Outcome]:
    """By a process a device, begun by spawn, each in a pool of its own and with one task at a time:
    one that dies breaks its pool and costs the shard of its task. Another takes its place."""
    context = get_context("spawn")
    pools: dict[int, ProcessPoolExecutor] = {}
    busy: dict[Future[Any], tuple[int, Task | None]] = {}
    waiting = list(tasks)[::-1]

    def begin(at: int) -> None:
        pools[at] = ProcessPoolExecutor(
            1, mp_context=context, initializer=_begin, initargs=(job, devices[at])
        )
        busy[pools[at].submit(_ready)] = (at, None)

    def give(at: int, task: Task) -> None:
        try:
            busy[pools[at].submit(_run, task)] = (at, task)
        except BrokenProcessPool:  # It died between two tasks.
            waiting.append(task)
            pools.pop(at).shutdown()
            begin(at)

    try:
        for at in range(len(devices)):
            begin(at)
        while busy:
            done = next(iter(wait(busy, return_when=FIRST_COMPLETED).done))
            at, task = busy.pop(done)
            try:
                outcome = done.result()
            except BrokenProcessPool:
                pools.pop(at).shutdown()
                if task is not None:
                    if waiting:
                        begin(at)
                    yield Outcome(task.begin, task.end, error=DIED)
                continue
            if waiting:
                give(at, waiting.pop())
            if outcome is not None:
                yield outcome
    finally:
        for pool in pools.values():
            pool.shutdown(cancel_futures=True)
    # No process can begin for these.
    yield from (Outcome(task.begin, task.end, error=DIED) for task in waiting[::-1])


def actors(job: Job, tasks: Iterable[Task], devices: Sequence[str | None]) -> Iterator[Outcome]:
    """By an actor of Ray a device; one on a GPU has a GPU of Ray's."""
    ray = connected_ray()
    shared, threads = ray.put(job), job.options.threads or 1
    needed = {"CPU": threads, "GPU": int(any(_is_on_gpu(device) for device in devices))}
    if not any(_holds(node, needed) for node in ray.nodes()):
        warnings.warn(
            f"no node of the cluster has {needed['CPU']} processors and {needed['GPU']} GPUs for a "
            "worker; it waits until there is one",
            stacklevel=2,
        )
    busy: dict[Any, tuple[Any, str | None, Task | None]] = {}
    waiting = list(tasks)[::-1]

    def begin(device: str | None) -> None:
        # An actor gets its first task when the cluster has a place for it, if it ever has one.
        actor = _actor(ray, device, threads).remote(shared, device)
        busy[actor.__ray_ready__.remote()] = (actor, device, None)

    for device in devices:
        begin(device)
    while busy and (waiting or any(task is not None for _, _, task in busy.values())):
        (done, *_), _ = ray.wait(list(busy))
        actor, device, task = busy.pop(done)
        try:
            outcome = ray.get(done)
        except ray.exceptions.RayError as why:
            if task is not None:
                if waiting:
                    begin(device)
                yield Outcome(task.begin, task.end, error=f"{DIED} ({type(why).__name__})")
            continue
        if task is not None:
            yield outcome
        if waiting:
            task = waiting.pop()
            busy[actor.run.remote(task)] = (actor, device, task)
    # No actor can begin for these.
    yield from (Outcome(task.begin, task.end, error=DIED) for task in waiting[::-1])


def connected_ray() -> Any:
    """Ray, with the cluster that it was connected to, or else a new one of this machine."""
    ray: Any = importlib.import_module("ray")
    if not ray.is_initialized():
        ray.init(log_to_driver=False)
    return ray


def _is_on_gpu(device: str | None) -> bool:
    return device is not None and device.startswith("gpu")


def _holds(node: Any, needed: dict[str, int]) -> bool:
    has = node["Resources"] if node["Alive"] else {}
    return all(has.get(name, 0) >= n for name, n in needed.items())


def _actor(ray: Any, device: str | None, threads: int) -> Any:
    return ray.remote(num_cpus=threads, num_gpus=int(_is_on_gpu(device)))(Worker)


def jobs(
    job: Job, tasks: Iterable[Task], devices: Sequence[str | None], executor: Any
) -> Iterator[Outcome]:
    """By a job a device of an executor of submitit, an array of Slurm: neighbouring shards."""
    tasks = list(tasks)
    n = min(len(devices), len(tasks))
    shares = [tasks[i * len(tasks) // n : (i + 1) * len(tasks) // n] for i in range(n)]
    submitted = executor.map_array(_share, [job] * n, shares, devices[:n])
    for of, share in zip(submitted, shares):
        try:
            yield from of.result()
        except Exception as why:  # What a job of Slurm may end with is open.
            words = (str(why).strip().splitlines() or [type(why).__name__])[0]
            for task in share:
                yield _left(job, task, f"{DIED} (job {of.job_id}: {words})")


def _left(job: Job, task: Task, died: str) -> Outcome:
    """What a worker that died has left of a shard: one of this run counts as written."""
    begin, end = task.begin, task.end
    try:
        # Frames are read only for a shard that is there.
        if job.path(begin, end).exists() and _shards.check(job, begin, end, _frames(job, task)):
            return Outcome(begin, end, written=True)
    except Exception as why:
        return _failed(task, why)
    return Outcome(begin, end, error=died)


def _frames(job: Job, task: Task) -> str:
    return digest_of_frames(task.frames, task.begin, task.end + 1, job.mesh)


def _failed(task: Task, why: Exception) -> Outcome:
    return Outcome(task.begin, task.end, error=str(why) or type(why).__name__)


def _share(job: Job, tasks: Sequence[Task], device: str | None) -> list[Outcome]:
    return list(here(job, tasks, device))


