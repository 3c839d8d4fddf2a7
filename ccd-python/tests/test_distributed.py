"""Many frames by several workers against one process: reports, digests, files; and what fails."""

import multiprocessing
import os
import signal
import subprocess
import sys

import numpy as np
import pytest
from test_partition import crowd

from meshccd import Bodies, Mesh, Options, Session, read_mesh
from meshccd._distributed_main import main, part_of
from meshccd._shards import alone
from meshccd._workers import assigned_gpu
from meshccd.distributed import FrameError, RunError, ShardError, digest, map_frames

N_STEPS = 10
OPTIONS = Options(min_distance=0.02, threads=1)


def animation(seed=3):
    """A mesh, and frames of an animation that goes there and back."""
    mesh, x0, x1 = crowd(30, seed, particles=10)
    t = np.abs(np.linspace(-1, 1, N_STEPS + 1))[:, None, None]
    return mesh, x0 + t * (x1 - x0)


def write_frames(folder, mesh, frames):
    faces = "".join("f {} {} {}\n".format(*face) for face in mesh.faces + 1)
    paths = []
    for at, x in enumerate(frames):
        path = folder / f"frame{at:03}.obj"
        path.write_text("".join("v {!r} {!r} {!r}\n".format(*p) for p in x.tolist()) + faces)
        paths.append(path)
    return paths


def check(found, want):
    """Reports are those of one process, in their order."""
    assert len(found) == len(want) == N_STEPS and digest(found) == digest(want)
    for one, other in zip(found, want):
        assert np.array_equal(one.contacts, other.contacts)
        assert np.array_equal(one.vertices, other.vertices)
        assert np.array_equal(one.approach, other.approach)
        assert one.earliest_toi == other.earliest_toi and one.n_undecided == other.n_undecided
        assert one.n_candidates == other.n_candidates and one.n_filtered == other.n_filtered
    assert sum(map(len, want)) > 100 and digest(list(found)[::-1]) != digest(want)


def bytes_of(folder):
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def test_processes_find_what_one_does(tmp_path):
    mesh, frames = animation()
    want = Session(mesh, OPTIONS).step_many(frames)
    said = []
    how = {"options": OPTIONS, "steps_per_shard": 3}
    found = map_frames(frames, mesh, tmp_path / "two", n_workers=2, progress=said.append, **how)
    check(found, want)
    assert [(of.n_done, of.n_kept, of.n_failed) for of in said] == [(i, 0, 0) for i in range(1, 5)]
    assert (said[-1].n_steps_done, said[-1].n_steps) == (N_STEPS, N_STEPS)
    assert "4 of 4 shards, 10 of 10 steps" in str(said[-1]) and "10 steps from 0" in repr(found)
    assert found[-1].earliest_toi == want[-1].earliest_toi and len(found[2:5]) == 3
    # In this process, by one file a frame: the same files to the last bit, resumed or not.
    (tmp_path / "frames").mkdir()
    paths = write_frames(tmp_path / "frames", mesh, frames)
    mesh, _ = read_mesh(paths[0])
    map_frames(frames, mesh, tmp_path / "one", n_workers=1, **how)
    files = bytes_of(tmp_path / "one")
    assert len(files) == 4 and "steps-0000009-0000010.npz" in files
    (tmp_path / "one" / "steps-0000003-0000006.npz").unlink()
    said.clear()
    found = map_frames(paths, mesh, tmp_path / "one", n_workers=1, progress=said.append, **how)
    check(found, want)
    assert bytes_of(tmp_path / "one") == files and said[-1].n_kept == 3
    # One file for all.
    np.save(tmp_path / "x.npy", frames)
    check(map_frames(tmp_path / "x.npy", paths[0], tmp_path / "npy", n_workers=1, **how), want)
    assert bytes_of(tmp_path / "npy") == files


def test_parts_are_all_of_it_and_nothing_twice(tmp_path):
    mesh, frames = animation()
    bodies = Bodies.of_components(mesh, self_contact=False)
    how = {"options": Options(bodies=bodies, threads=1), "steps_per_shard": 2, "n_workers": 1}
    want = Session(mesh, how["options"]).step_many(frames)
    parts = [map_frames(frames, mesh, tmp_path, part=(i, 3), **how) for i in (3, 1, 2)]
    assert sorted((of.first, len(of)) for of in parts) == [(0, 2), (2, 4), (6, 4)]
    check(map_frames(frames, mesh, tmp_path, **how), want)
    assert np.array_equal(parts[1][0].toi_of_worlds, want[0].toi_of_worlds)
    assert len(map_frames(frames[:1], mesh, tmp_path, **how)) == 0


@pytest.mark.parametrize(
    "change, words",
    [
        ({"mesh": True}, "with another mesh; write to another folder, or remove it"),
        ({"options": Options(min_distance=0.03)}, "other options: min_distance 0.02, not 0.03"),
        ({"options": Options(min_distance=0.02, mode="conservative", tolerance=1e-4)}, "tolerance"),
        ({"frames": True}, "with other frames"),
    ],
)
def test_shards_of_another_run_are_refused(tmp_path, change, words):
    mesh, frames = animation()
    how = {"options": OPTIONS, "n_workers": 1}
    map_frames(frames, mesh, tmp_path, **how)
    before = bytes_of(tmp_path)
    if change.pop("frames", False):
        frames = frames + 1e-9
    if change.pop("mesh", False):
        mesh = Mesh(mesh.faces[:, [1, 2, 0]], n_vertices=mesh.n_vertices)
    with pytest.raises(RunError, match=words) as why:
        map_frames(frames, mesh, tmp_path, **{**how, **change})
    assert why.value.failures[0][:2] == (0, N_STEPS) and bytes_of(tmp_path) == before
    # What no answer depends on is no other run.
    map_frames(*animation()[::-1], tmp_path, options=Options(min_distance=0.02, threads=2))


def test_a_damaged_shard_is_told(tmp_path):
    mesh, frames = animation()
    map_frames(frames, mesh, tmp_path, n_workers=1)
    (path,) = tmp_path.iterdir()
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(RunError, match="is damaged, remove it"):
        map_frames(frames, mesh, tmp_path, n_workers=1)


def test_a_frame_that_cannot_be_read_costs_its_shards_alone(tmp_path):
    mesh, frames = animation()
    paths = write_frames(tmp_path, mesh, frames)
    mesh, _ = read_mesh(paths[0])
    whole = paths[4].read_text()
    how = {"n_workers": 1, "steps_per_shard": 2}
    for text, words in ((whole[: whole.rindex("f")], "frame 4 .*other faces"), ("v a b c", "frame 4 cannot be")):
        paths[4].write_text(text)
        with pytest.raises(RunError, match=words) as why:
            map_frames(paths, mesh, tmp_path / "out", **how)
        # Of the two steps that need it, the last of one shard and the first of the next.
        assert [(a, b) for a, b, _ in why.value.failures] == [(2, 4), (4, 6)]
        assert "2 of 5 shards are not written" in str(why.value)
    paths[4].write_text(whole)
    said = []
    assert len(map_frames(paths, mesh, tmp_path / "out", progress=said.append, **how)) == N_STEPS
    assert said[-1].n_kept == 3
    wrong = np.zeros((3, 5, 3))
    with pytest.raises(RunError, match=r"frame 0 has positions of the shape \(5, 3\)"):
        map_frames(wrong, mesh, tmp_path / "wrong", n_workers=1)
    assert issubclass(FrameError, ValueError) and issubclass(ShardError, RuntimeError)


class Deadly:
    """Frames of which one kills the worker that unpickles it, as the system does for memory."""

    def __init__(self, frames, at):
        self.frames, self.at = frames, at

    def __len__(self):
        return len(self.frames)

    def part(self, begin, end):
        return Deadly(self.frames, self.at if begin <= self.at < end else -1)

    def read(self, at, mesh):
        if at == self.at:
            os.kill(os.getpid(), signal.SIGKILL)
        return self.frames[at]


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="there is no SIGKILL")
def test_a_worker_that_dies_is_told(tmp_path, monkeypatch):
    mesh, frames = animation()
    how = {"options": OPTIONS, "steps_per_shard": 2, "n_workers": 2}
    with monkeypatch.context() as patch:
        patch.setattr("meshccd.distributed.frames_of", lambda frames: Deadly(frames, 9))
        with pytest.raises(RunError, match="the worker died before it was written.* run again"):
            map_frames(frames, mesh, tmp_path, **how)
    said = []
    found = map_frames(frames, mesh, tmp_path, progress=said.append, **how)
    check(found, Session(mesh, OPTIONS).step_many(frames))
    assert said[-1].n_failed == 0


def hold(path, ready, done):
    with alone(path):
        ready.set()
        done.wait(60)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows tells two runs apart at their ends")
def test_two_runs_do_not_write_one_shard(tmp_path):
    mesh, frames = animation()
    context = multiprocessing.get_context("spawn")
    ready, done = context.Event(), context.Event()
    path = tmp_path / "steps-0000000-0000010.npz"
    other = context.Process(target=hold, args=(path, ready, done))
    other.start()
    assert ready.wait(60)
    with pytest.raises(RunError, match=f"is being written by process {other.pid} on "):
        map_frames(frames, mesh, tmp_path, n_workers=1)
    # A process that dies leaves its shard.
    other.kill()
    other.join()
    assert len(map_frames(frames, mesh, tmp_path, n_workers=1)) == N_STEPS
    assert list(tmp_path.iterdir()) == [path]


def test_a_second_run_that_was_not_seen_may_not_differ(tmp_path, monkeypatch):
    """Without locks, as on some file systems: the same contacts are accepted, others are not."""
    mesh, frames = animation()
    how = {"options": OPTIONS, "n_workers": 1}
    map_frames(frames, mesh, tmp_path, **how)
    before = bytes_of(tmp_path)
    monkeypatch.setattr("meshccd._shards.check", lambda *_: False)
    map_frames(frames, mesh, tmp_path, **how)
    with pytest.raises(RunError, match="another run has written other contacts meanwhile"):
        map_frames(frames, mesh, tmp_path, options=Options(min_distance=0.04), n_workers=1)
    assert bytes_of(tmp_path) == before


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
            patch.setattr("meshccd.distributed.frames_of", lambda frames: Deadly(frames, 9))
            with pytest.raises(RunError, match="the worker died before it was written") as why:
                map_frames(frames, mesh, tmp_path, n_workers=2, **how)
        # Both of the shards with that frame, or whatever else no actor was left for.
        assert {of[:2] for of in why.value.failures} >= {(8, 10)}
        check(map_frames(frames, mesh, tmp_path, **how), want)
    finally:
        ray.shutdown()
