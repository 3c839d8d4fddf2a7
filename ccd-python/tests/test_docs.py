"""The programs of docs/cluster.md, run as a reader would: each block that begins with its name."""

import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest
from test_mpi import ENVIRONMENT, MPIRUN

from meshccd import Options, Session, read_mesh
from meshccd.distributed import digest

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/cluster.md"
BLOCK = re.compile(r"```(?:python|sh)\n((?:#!/bin/sh\n)?# (\w+\.\w+)\n.*?)```", re.DOTALL)
# Runs a command as Slurm does in the two tasks of a job.
SRUN = """#!/bin/sh
export SLURM_STEP_ID=0 SLURM_NTASKS=2
for SLURM_PROCID in 0 1; do export SLURM_PROCID; "$@" || exit 1; done
"""


@pytest.fixture
def folder(tmp_path):
    """A folder with all programs, and the animation that they read."""
    for text, name in BLOCK.findall(PAGE.read_text(encoding="utf-8")):
        (tmp_path / name).write_text(text)
    run(tmp_path, [sys.executable, "sheets.py"])
    return tmp_path


def run(folder, command, **variables):
    """What a program printed."""
    env = {name: word for name, word in os.environ.items() if not name.startswith("SLURM_")}
    env["PYTHONPATH"] = os.pathsep.join(sys.path)
    # `python3` is this one, and `srun` a stand-in, if the folder has one.
    env["PATH"] = os.pathsep.join([str(folder), os.path.dirname(sys.executable), env["PATH"]])
    env.update(variables)
    done = subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def of_one_process(folder):
    mesh, _ = read_mesh(folder / "sheets.obj")
    frames = np.load(folder / "sheets.npy")
    return Session(mesh, Options(threads=1)).step_many(frames)


def test_every_program_is_found():
    names = [name for _, name in BLOCK.findall(PAGE.read_text(encoding="utf-8"))]
    assert names == ["sheets.py", "frames.py", "frames.sh", "scene.py"]


@pytest.mark.parametrize(
    "runner, package", [("processes", "numpy"), ("slurm", "submitit"), ("ray", "ray")]
)
def test_frames(folder, runner, package):
    pytest.importorskip(package, reason=f"there is no package {package}")
    want = of_one_process(folder)
    command = [sys.executable, "frames.py", runner]
    lines = run(folder, command).splitlines()
    assert lines[-1] == f"digest {digest(want)}" != f"digest {digest(want[1:])}"
    assert "4 of 4 shards, 32 of 32 steps" in lines[3] and "0 shards were there" in lines[3]
    said = [line for line in lines if line.startswith("step ")]
    assert len(said) == sum(len(report) > 0 for report in want) > 10
    # What is there is not made again.
    (folder / "contacts" / "steps-0000008-0000016.npz").unlink()
    again = run(folder, command).splitlines()
    assert "3 shards were there" in again[3] and again[4:] == lines[4:]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no sh")
def test_shares_of_slurm(folder):
    (folder / "srun").write_text(SRUN)
    (folder / "srun").chmod(0o755)
    array = {"SLURM_JOB_ID": "1", "SLURM_ARRAY_TASK_COUNT": "2", "SLURM_ARRAY_TASK_MIN": "0"}
    said = [run(folder, ["sh", "frames.sh"], **array, SLURM_ARRAY_TASK_ID=id) for id in "01"]
    lines = "".join(said).splitlines()
    assert [line.partition(":")[0] for line in lines] == [f"part {i}/4" for i in range(1, 5)]
    *_, command = (folder / "frames.sh").read_text().splitlines()
    last = run(folder, command.removeprefix("srun ").split())
    want = of_one_process(folder)
    assert last == f"steps 0 to 32: {sum(map(len, want))} contacts, digest {digest(want)}\n"


def test_a_scene_on_four_ranks(folder):
    pytest.importorskip("mpi4py", reason="there is no package mpi4py")
    if MPIRUN is None:
        pytest.skip("there is no mpirun (Debian: openmpi-bin)")
    said = run(folder, [MPIRUN, "-n", "4", sys.executable, "scene.py"], **ENVIRONMENT)
    want = of_one_process(folder)[15:18]
    assert sum(map(len, want)) > 0 and said.splitlines() == [
        f"step {step}: {len(of)} contacts, {of.earliest_toi if len(of) else 1:.6f} of it is free"
        for step, of in enumerate(want, 15)
    ]
