"""Many frames by processes of this machine against one: reports, digests, files; what fails."""

import errno
import multiprocessing
import os
import pickle
import signal
import socket
import sys
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool

import numpy as np
import pytest
from crowds import N_STEPS, OPTIONS, Deadly, animation, check, write_frames

from meshccd import Bodies, Mesh, Options, Session, _shards, _workers, read_mesh
from meshccd._shards import alone
from meshccd.distributed import FrameError, RunError, ShardError, digest, map_frames


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
    for text, words in (
        (whole[: whole.rindex("f")], "frame 4 .*other faces"),
        ("v a b c", "frame 4 cannot be"),
    ):
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


needs_kill = pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="there is no SIGKILL")


@needs_kill
def test_a_worker_that_dies_costs_its_shard_alone(tmp_path, monkeypatch):
    """Both workers die, each with one of the two shards that need frame 4."""
    mesh, frames = animation()
    how = {"options": OPTIONS, "steps_per_shard": 2, "n_workers": 2}
    said = []
    with monkeypatch.context() as patch:
        patch.setattr("meshccd.distributed.frames_of", lambda frames: Deadly(frames, 4))
        with pytest.raises(RunError, match="the worker died before it was written") as why:
            map_frames(frames, mesh, tmp_path, progress=said.append, **how)
    assert [of[:2] for of in why.value.failures] == [(2, 4), (4, 6)]
    copy = pickle.loads(pickle.dumps(why.value))
    assert (copy.failures, str(copy)) == (why.value.failures, str(why.value))
    assert [of.n_done for of in said] == [1, 2, 3, 4, 5] and said[-1].n_failed == 2
    found = map_frames(frames, mesh, tmp_path, progress=said.append, **how)
    check(found, Session(mesh, OPTIONS).step_many(frames))
    assert (said[-1].n_kept, said[-1].n_failed) == (3, 0)


def die(job, device):
    (job.folder / f"begun-{os.getpid()}").touch()
    os.kill(os.getpid(), signal.SIGKILL)


@needs_kill
def test_workers_that_cannot_begin_are_not_begun_again(tmp_path, monkeypatch):
    mesh, frames = animation()
    monkeypatch.setattr(_workers, "_begin", die)
    with pytest.raises(RunError, match="10 of 10 shards are not written"):
        map_frames(frames, mesh, tmp_path, options=OPTIONS, steps_per_shard=1, n_workers=2)
    assert len(list(tmp_path.iterdir())) == 2


def test_a_worker_that_dies_between_two_shards_costs_none(tmp_path, monkeypatch):
    died = []

    class Pool(ProcessPoolExecutor):
        def submit(self, call, *args):
            if call is _workers._run and len(died) < 2:
                died.append(call)
                raise BrokenProcessPool
            return super().submit(call, *args)

    mesh, frames = animation()
    monkeypatch.setattr(_workers, "ProcessPoolExecutor", Pool)
    how = {"options": OPTIONS, "steps_per_shard": 2, "n_workers": 2}
    check(map_frames(frames, mesh, tmp_path, **how), Session(mesh, OPTIONS).step_many(frames))
    assert len(died) == 2


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


def no_locks(*_):
    raise OSError(errno.ENOLCK, "there are no locks")


@pytest.mark.parametrize("locks", ["", "none", "no module"])
def test_a_file_that_may_be_unfinished_stays_without_locks(tmp_path, monkeypatch, locks):
    """That of a process of this machine, which is dead if the lock is had."""
    if sys.platform == "win32" or locks == "no module":
        monkeypatch.setattr(_shards, "fcntl", None)
    elif locks:
        monkeypatch.setattr(_shards.fcntl, "flock", no_locks)
    other = tmp_path / f".a.npz.{socket.gethostname()}.1"
    other.touch()
    with alone(tmp_path / "a.npz"):
        assert other.exists() == (_shards.fcntl is None or locks == "none")


@pytest.mark.skipif(sys.platform == "win32", reason="there are no locks")
def test_a_lock_that_was_removed_is_made_again(tmp_path, monkeypatch):
    """By a run that ends between opening it and locking it."""
    path, flock = tmp_path / "a.npz", _shards.fcntl.flock

    def late(*args):
        monkeypatch.undo()
        (tmp_path / ".a.npz.lock").unlink()
        flock(*args)

    monkeypatch.setattr(_shards.fcntl, "flock", late)
    with alone(path), pytest.raises(ShardError, match="is being written by process"), alone(path):
        pass
    assert list(tmp_path.iterdir()) == []


def no_links(*_):
    raise PermissionError(errno.EPERM, "there are no hard links")


@pytest.mark.parametrize("link", [os.link, no_links])
def test_a_second_run_that_was_not_seen_may_not_differ(tmp_path, monkeypatch, link):
    """Without locks, as on some file systems, and without links: the same contacts are accepted,
    others are not."""
    mesh, frames = animation()
    how = {"options": OPTIONS, "n_workers": 1}
    monkeypatch.setattr("os.link", link)
    map_frames(frames, mesh, tmp_path, **how)
    before = bytes_of(tmp_path)
    monkeypatch.setattr("meshccd._shards.check", lambda *_: False)
    map_frames(frames, mesh, tmp_path, **how)
    with pytest.raises(RunError, match="another run has written other contacts meanwhile"):
        map_frames(frames, mesh, tmp_path, options=Options(min_distance=0.04), n_workers=1)
    assert bytes_of(tmp_path) == before


def test_a_gpu_finds_what_the_cpu_does(tmp_path):
    mesh, frames = animation()
    try:
        Session(mesh, device="gpu")
    except RuntimeError as why:
        if os.environ.get("CCD_GPU") == "require":
            raise
        pytest.skip(str(why))
    how = {"options": OPTIONS, "steps_per_shard": 5}
    found = map_frames(frames, mesh, tmp_path, devices=["gpu", None], **how)
    want = Session(mesh, OPTIONS).step_many(frames)
    assert digest(found) == digest(want) and found[0].n_candidates == want[0].n_candidates


def test_frames_of_stl_may_touch_in_a_later_one(tmp_path):
    """Vertices are merged as in the first frame."""
    mesh = Mesh([[0, 1, 2], [3, 4, 5]])
    paths = []
    for at, height in enumerate((1.0, 0.0, 1.0)):
        below = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)
        lines = ["solid"]
        for corners in (below, below + [0, 0, height]):
            lines += ["facet normal 0 0 1", "outer loop"]
            lines += ["vertex " + " ".join(map(str, corner)) for corner in corners]
            lines += ["endloop", "endfacet"]
        paths.append(tmp_path / f"f{at}.stl")
        paths[-1].write_text("\n".join([*lines, "endsolid", ""]))
    found = map_frames(paths, mesh, tmp_path / "out", n_workers=1)
    frames = [read_mesh(path, paths[0])[1] for path in paths]
    want = Session(mesh).step_many(frames)
    assert digest(found) == digest(want) and len(want[0]) > 0


def test_a_file_that_is_no_shard_costs_one_shard(tmp_path):
    mesh, frames = animation()
    how = {"options": OPTIONS, "steps_per_shard": 2, "n_workers": 1}
    map_frames(frames, mesh, tmp_path, **how)
    shard = sorted(tmp_path.glob("*.npz"))[1]
    with shard.open("wb") as file:
        np.save(file, np.zeros(3))
    sorted(tmp_path.glob("*.npz"))[2].unlink()
    with pytest.raises(RunError, match=r"(?s)1 of .* damaged, remove it") as why:
        map_frames(frames, mesh, tmp_path, **how)
    assert len(why.value.failures) == 1


def test_frames_that_change_while_they_are_read_make_no_shard(tmp_path, monkeypatch):
    mesh, frames = animation()
    frames = frames.copy()
    read = _workers.digest_of_frames

    def then_others(*args):
        digest = read(*args)
        frames[...] += 1.0
        return digest

    monkeypatch.setattr(_workers, "digest_of_frames", then_others)
    with pytest.raises(RunError, match="were changed while they were read"):
        map_frames(frames, mesh, tmp_path, options=OPTIONS, steps_per_shard=20, n_workers=1)
    assert list(tmp_path.glob("*.npz")) == []


def test_frames_of_other_rods_are_refused(tmp_path):
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 6 6 6\nf 1 2 3\n"
    (tmp_path / "a.obj").write_text(text + "l 4 5\n")
    (tmp_path / "b.obj").write_text(text)
    paths = [tmp_path / "a.obj", tmp_path / "b.obj"]
    with pytest.raises(RunError, match="edges that the mesh has not"):
        map_frames(paths, paths[1], tmp_path / "out", n_workers=1)
    # Of a format without rods they may be the mesh's alone.
    assert len(map_frames(paths, paths[0], tmp_path / "out", n_workers=1)) == 1


def test_an_archive_and_its_array_are_the_same_frames(tmp_path):
    mesh, frames = animation()
    np.savez(tmp_path / "x.npz", frames)
    how = {"options": OPTIONS, "steps_per_shard": 3, "n_workers": 1}
    found = map_frames(tmp_path / "x.npz", mesh, tmp_path / "a", **how)
    check(found, Session(mesh, OPTIONS).step_many(frames))
    with pytest.raises(TypeError, match="list of names"):
        map_frames(frames, mesh, tmp_path / "a", devices="gpu")
    frames = frames.copy()
    frames[4, 0, 0] = np.nan
    with pytest.raises(RunError, match="frame 4 has a coordinate that is not finite"):
        map_frames(frames, mesh, tmp_path / "b", **how)


def test_a_file_that_is_no_animation_is_named(tmp_path):
    mesh, frames = animation()
    with (tmp_path / "z.npy").open("wb") as file:
        np.savez(file, frames)
    (tmp_path / "e.npy").touch()
    np.save(tmp_path / "one.npy", frames[0])
    np.save(tmp_path / "none.npy", 3.0)
    for name, words in (
        ("z", "the magic string is not correct"),
        ("e", "EOF: reading magic string"),
        ("one", r"the shape is \(130, 3\), expected \(frames, n, 3\)"),
        ("none", r"the shape is \(\)"),
    ):
        with pytest.raises(ValueError, match=rf"{name}\.npy: .*{words}"):
            map_frames(tmp_path / f"{name}.npy", mesh, tmp_path / "out", n_workers=1)
