"""Many frames by tasks of Slurm, by jobs of submitit and by actors of Ray against one process."""

import os
import subprocess
import sys

import numpy as np
import pytest
from crowds import OPTIONS, Deadly, animation, check, write_frames

from meshccd import Options, Session, read_mesh
from meshccd._distributed_main import main, part_of
from meshccd._workers import assigned_gpu
from meshccd.distributed import RunError, digest, map_frames


def run_task(arguments, **variables):
    """The program in a process, as Slurm starts it."""
    outside = {name: word for name, word in os.environ.items() if not name.startswith("SLURM_")}
    command = [sys.executable, "-m", "meshccd.distributed", *map(str, arguments)]
    done = subprocess.run(command, env={**outside, **variables}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_tasks_of_slurm_take_their_share(tmp_path):
    mesh, frames = animation()
    paths = write_frames(tmp_path, mesh, frames)
    mesh, _ = read_mesh(paths[0])
    (tmp_path / "options.json").write_text(OPTIONS.to_json())
    arguments = [*paths, "--out", tmp_path / "out", "--options", tmp_path / "options.json"]
    arguments += ["--steps-per-shard", 2]
    # An array of two jobs, from 10 in steps of 5.
    array = {"SLURM_JOB_ID": "7", "SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "10",
             "SLURM_ARRAY_TASK_STEP": "5"}  # fmt: skip
    assert "part 2/2: steps 4 to 10" in run_task(arguments, **array, SLURM_ARRAY_TASK_ID="15")
    # Three tasks of srun, of which the last was done.
    step = {"SLURM_JOB_ID": "8", "SLURM_STEP_ID": "0", "SLURM_NTASKS": "3"}
    assert "part 1/3: steps 0 to 2" in run_task(arguments, **step, SLURM_PROCID="0")
    assert "part 2/3: steps 2 to 6" in run_task(arguments, **step, SLURM_PROCID="1")
    assert len(list((tmp_path / "out").iterdir())) == 5
    want = Session(mesh, OPTIONS).step_many(frames)
    n = sum(map(len, want))
    said = run_task([*arguments, "--workers", 1])
    assert said == f"steps 0 to 10: {n} contacts, digest {digest(want)}\n"


def test_shares_are_those_of_the_variables():
    assert part_of(None, {}) == (1, 1) and part_of("2/3", {"SLURM_PROCID": "9"}) == (2, 3)
    array = {"SLURM_ARRAY_TASK_ID": "3", "SLURM_ARRAY_TASK_COUNT": "4"}
    assert part_of(None, array) == (4, 4)
    ranks = {"SLURM_STEP_ID": "0", "SLURM_PROCID": "1", "SLURM_NTASKS": "2"}
    assert part_of(None, ranks) == (2, 2) and part_of(None, {**array, **ranks}) == (8, 8)
    # The script of a batch job, outside of srun.
    assert part_of(None, {"SLURM_JOB_ID": "1", "SLURM_PROCID": "0", "SLURM_NTASKS": "2"}) == (1, 1)
    for text, environment, words in (
        ("3/2", {}, "expected i/n"),
        ("1", {}, "expected i/n"),
        (None, {**array, "SLURM_ARRAY_TASK_ID": "4"}, "none of 4"),
        (None, {**array, "SLURM_ARRAY_TASK_STEP": "2"}, "gaps needs --part"),
        (None, {**array, "SLURM_ARRAY_TASK_ID": "x"}, "'x', no number"),
        (None, {**ranks, "SLURM_PROCID": "2"}, "SLURM_PROCID is 2, of 2"),
    ):
        with pytest.raises(ValueError, match=words):
            part_of(text, environment)


def test_the_program_says_what_is_wrong(tmp_path, capsys):
    assert main(["nothing.obj", "--out", str(tmp_path)]) == 1
    assert "meshccd.distributed: nothing.obj" in capsys.readouterr().err
    mesh, frames = animation()
    np.save(tmp_path / "x.npy", frames)
    (path, *_) = map(str, write_frames(tmp_path, mesh, frames[:1]))
    arguments = [str(tmp_path / "x.npy"), "--mesh", path, "--out", str(tmp_path / "out")]
    assert main([*arguments, "--workers", "0"]) == 1
    assert "n_workers is 0; it must be at least 1" in capsys.readouterr().err
    for wrong, words in (
        ({"runner": "rays"}, 'runner is \'rays\'; it must be "processes", "ray"'),
        ({"part": (3, 2)}, "part is 3 of 2"),
        ({"steps_per_shard": 0}, "steps_per_shard is 0"),
        ({"n_workers": 0}, "n_workers is 0"),
    ):
        with pytest.raises(ValueError, match=words):
            map_frames(frames, mesh, tmp_path / "out", **wrong)
    with pytest.raises(RunError, match='device is "abacus"'):
        map_frames(frames, mesh, tmp_path / "out", devices=["abacus"])


def test_an_assigned_gpu_is_named_by_its_pci_id(tmp_path, monkeypatch):
    monkeypatch.delenv("CUDA_VISIBLE_DEVICES", raising=False)
    with pytest.raises(RuntimeError, match="CUDA_VISIBLE_DEVICES names no GPU"):
        assigned_gpu()
    tool = tmp_path / "nvidia-smi"
    rows = "0, GPU-aa11, 00000000:3B:00.0\n1, GPU-bb22, 00000000:AF:00.0"
    tool.write_text(f"#!/bin/sh\necho '{rows}'\n")
    tool.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    for ids, want in (("1", "AF"), ("GPU-aa11", "3B"), ("1,0", "AF")):
        monkeypatch.setenv("CUDA_VISIBLE_DEVICES", ids)
        assert assigned_gpu() == f"gpu:00000000:{want}:00.0"
    monkeypatch.setenv("CUDA_VISIBLE_DEVICES", "7")
    with pytest.raises(RuntimeError, match="lists no GPU 7"):
        assigned_gpu()


def test_jobs_of_submitit(tmp_path):
    submitit = pytest.importorskip("submitit", reason="there is no package submitit")
    mesh, frames = animation()
    executor = submitit.LocalExecutor(tmp_path / "logs")
    how = {"runner": executor, "options": OPTIONS, "steps_per_shard": 2}
    found = map_frames(frames, mesh, tmp_path / "out", n_workers=2, **how)
    check(found, Session(mesh, OPTIONS).step_many(frames))
    with pytest.raises(ValueError, match="n_workers says how many jobs"):
        map_frames(frames, mesh, tmp_path / "out", **how)


class Killed:
    """An executor whose jobs are killed, some after they have written a shard."""

    job_id = 7

    def __init__(self, wrote):
        self.wrote = wrote

    def map_array(self, share, jobs, tasks, devices):
        for job, of in zip(jobs, tasks):
            share(job, of[: self.wrote], None)
        return [self] * len(tasks)

    def result(self):
        raise RuntimeError("out of memory")


def test_a_shard_of_a_killed_job_is_looked_at(tmp_path):
    mesh, frames = animation()
    died = r"the worker died before it was written.* \(job 7: out of memory\)"
    how = {"options": OPTIONS, "steps_per_shard": 2, "n_workers": 2}
    with pytest.raises(RunError, match=died) as why:
        map_frames(frames, mesh, tmp_path / "out", runner=Killed(wrote=1), **how)
    # Of two and three shards the first ones are written.
    assert [of[:2] for of in why.value.failures] == [(2, 4), (6, 8), (8, 10)]
    map_frames(frames, mesh, tmp_path / "out", **how)
    found = map_frames(frames, mesh, tmp_path / "out", runner=Killed(wrote=0), **how)
    check(found, Session(mesh, OPTIONS).step_many(frames))
    other, bad = {**how, "options": Options(min_distance=0.03)}, frames.copy()
    bad[4] = 0
    for x, call, words, n in (
        (frames, other, "other options: min_distance 0.02, not 0.03", 5),
        (bad, how, "with other frames", 2),
        (frames[:, :-1], how, r"frame 0 has positions of the shape \(129, 3\)", 5),
    ):
        with pytest.raises(RunError, match=words) as why:
            map_frames(x, mesh, tmp_path / "out", runner=Killed(wrote=0), **call)
        assert len(why.value.failures) == n
    path = tmp_path / "out" / "steps-0000004-0000006.npz"
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(RunError, match="is damaged, remove it") as why:
        map_frames(frames, mesh, tmp_path / "out", runner=Killed(wrote=0), **how)
    assert [of[:2] for of in why.value.failures] == [(4, 6)]


@pytest.mark.filterwarnings("default")
def test_two_actors_of_ray(tmp_path, monkeypatch):
    ray = pytest.importorskip("ray", reason="there is no package ray")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(sys.path))
    mesh, frames = animation()
    want = Session(mesh, OPTIONS).step_many(frames)
    how = {"runner": "ray", "options": OPTIONS, "steps_per_shard": 2}
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        with monkeypatch.context() as patch:
            patch.setattr("meshccd.distributed.frames_of", lambda frames: Deadly(frames, 4))
            with pytest.raises(RunError, match="the worker died before it was written") as why:
                map_frames(frames, mesh, tmp_path, n_workers=2, **how)
        # The two shards with that frame, each with an actor.
        assert [of[:2] for of in why.value.failures] == [(2, 4), (4, 6)]
        # Of three, one has no place in the cluster.
        check(map_frames(frames, mesh, tmp_path, n_workers=3, **how), want)
        check(map_frames(frames, mesh, tmp_path / "again", runner="ray", options=OPTIONS), want)
    finally:
        ray.shutdown()
