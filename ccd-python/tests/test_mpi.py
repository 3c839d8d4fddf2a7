"""Scenes on four ranks, where there is an MPI: Debian's openmpi-bin, and the package mpi4py."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest
from conftest import named

MPIRUN = shutil.which("mpirun")
# As root and with more ranks than cores, as in a container; only within this host.
ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
    "OMPI_MCA_btl": "self,vader",
    "PYTHONDONTWRITEBYTECODE": "1",
}
SCRIPT = pathlib.Path(__file__).with_name("mpi_scene.py")


def run(scene, n=4):
    pytest.importorskip("mpi4py", reason="there is no package mpi4py")
    if MPIRUN is None:
        pytest.skip("there is no mpirun (Debian: openmpi-bin)")
    command = [MPIRUN, "-n", str(n), sys.executable, str(SCRIPT), scene]
    env = {**os.environ, **ENVIRONMENT}
    done = subprocess.run(command, env=env, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.count("as one process") == 2, done.stdout
    print(done.stdout)


def test_a_crowd_with_bodies_on_four_ranks():
    run("crowd")


def test_a_real_scene_on_four_ranks():
    named("cloth-funnel")
    run("cloth-funnel")
