"""`python -m meshccd.distributed`: `map_frames` from a shell, or by a task of Slurm."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from ._native import Options, read_mesh
from .distributed import Progress, map_frames

_ABOUT = """Every contact of the steps from each frame to the next, in shards of some steps each.
Shards that are there are not made again. With all shards there, a run prints the digest of all."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the program; its exit status."""
    given = _parser().parse_args(arguments)
    try:
        part = part_of(given.part, os.environ)
        options = Options()
        if given.options is not None:
            options = Options.from_json(given.options.read_text(encoding="utf-8"))
        mesh, _ = read_mesh(given.mesh or given.frames[0])
        n_workers = given.workers
        # A task of Slurm has its cores for itself.
        if n_workers is None and part != (1, 1) and not given.device:
            n_workers = 1
        reports = map_frames(
            given.frames,
            mesh,
            given.out,
            options=options,
            runner=given.runner,
            n_workers=n_workers,
            devices=given.device,
            part=part,
            steps_per_shard=given.steps_per_shard,
            progress=_say,
        )
    except (ValueError, RuntimeError, OSError, ImportError) as why:
        print(f"meshccd.distributed: {why}", file=sys.stderr)
        return 1
    n = sum(map(len, reports))
    last = reports.first + len(reports)
    whose = "" if part == (1, 1) else f"part {part[0]}/{part[1]}: "
    print(f"{whose}steps {reports.first} to {last}: {n} contacts, digest {reports.digest()}")
    return 0


def part_of(text: str | None, environment: Mapping[str, str]) -> tuple[int, int]:
    """The share that `--part` names: i/n, or None: that of this task of Slurm, of all tasks of all
    jobs of an array; all of it outside of Slurm. A ValueError if it is none."""
    if text is not None:
        index, slash, of = text.partition("/")
        if not (slash and index.isdecimal() and of.isdecimal() and 1 <= int(index) <= int(of)):
            raise ValueError(f"--part {text}: expected i/n with i from 1 to n")
        return int(index), int(of)

    def number(name: str, default: int) -> int:
        word = environment.get(name, str(default))
        if not word.isdecimal():
            raise ValueError(f"{name} is {word!r}, no number; --part i/n says the share")
        return int(word)

    job, n_jobs = 0, 1
    if "SLURM_ARRAY_TASK_ID" in environment:
        task, least = number("SLURM_ARRAY_TASK_ID", 0), number("SLURM_ARRAY_TASK_MIN", 0)
        n_jobs, step = number("SLURM_ARRAY_TASK_COUNT", 0), number("SLURM_ARRAY_TASK_STEP", 1)
        job, left = divmod(task - least, max(step, 1))
        if left or not 0 <= job < n_jobs:
            raise ValueError(
                f"task {task} is none of {n_jobs} from {least} in steps of {step}; an array with "
                "gaps needs --part i/n"
            )
    rank, n_ranks = 0, 1
    # The script of a batch job is no task of srun's: it has a job, and no step.
    if "SLURM_STEP_ID" in environment or "SLURM_JOB_ID" not in environment:
        rank, n_ranks = number("SLURM_PROCID", 0), number("SLURM_NTASKS", 1)
        if rank >= n_ranks:
            raise ValueError(f"SLURM_PROCID is {rank}, of {n_ranks} tasks; --part i/n says more")
    return job * n_ranks + rank + 1, n_jobs * n_ranks


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser("python -m meshccd.distributed", description=_ABOUT)
    what = "an animation (NPY, NPZ, PC2, MDD), or a mesh a frame"
    parser.add_argument("frames", nargs="+", help=what)
    parser.add_argument("--out", required=True, type=Path, help="the folder of the shards")
    parser.add_argument("--mesh", help="the mesh of an animation; by default the first frame")
    parser.add_argument("--part", help="share i/n; by default that of this task of Slurm, or all")
    parser.add_argument("--options", type=Path, help="a file of Options.to_json()")
    parser.add_argument("--runner", choices=["processes", "ray"], default="processes")
    parser.add_argument("--workers", type=int, help="by default one a core, or a device")
    parser.add_argument("--device", action="append", help="of a worker; may be repeated")
    parser.add_argument("--steps-per-shard", type=int, default=16)
    return parser


def _say(progress: Progress) -> None:
    print(progress, file=sys.stderr, flush=True)
