"""The real scenes with their published answers; without the data a test is skipped, with the
reason."""

import functools
import json
import os
import pathlib
import re

import numpy as np
import pytest

import meshccd

SCENES = {
    "cloth-ball": ("cloth_ball92.ply", "cloth_ball93.ply", 92),
    "cloth-funnel": ("227.ply", "228.ply", 227),
    "rod-twist": ("3036.ply", "3037.ply", 3036),
}


class Scene:
    """Two frames of a mesh, in the precision of their files, and what is known of the step."""

    def __init__(self, folder, name):
        first, last, self.number = SCENES[name]
        self.name, self.folder = name, folder
        frames = folder / "scenes" / name / "frames"
        self.x0, self.faces = read_ply(frames / first)
        self.x1, _ = read_ply(frames / last)
        self.mesh = meshccd.Mesh(self.faces, n_vertices=len(self.x0))
        assert len(self.mesh.faces) == len(self.faces)

    def truth(self, kind):
        """All contacts of a kind, "vf" or "ee", as rows a, b, and their exact times."""
        of_scene = self.folder / "scenes" / self.name
        pairs = json.loads((of_scene / f"boxes/{self.number}{kind}.json").read_text())
        table = self.folder / f"toi/{self.name}_queries_{self.number}{kind}.csv"
        rows = [line.split(",") for line in table.read_text().splitlines()[1:]]
        assert len(rows) == len(pairs)
        hit = np.array([row[2] == "1" for row in rows])
        toi = np.array([float(row[3]) for row in rows if row[2] == "1"])
        # Ids count vertices, then edges, then faces.
        first = np.array([0, len(self.x0) + len(self.mesh.edges)])
        first = first if kind == "vf" else len(self.x0)
        return np.sort(np.array(pairs), axis=1)[hit] - first, toi


def read_ply(path):
    """Vertices, in the precision of the file, and faces of a binary PLY file."""
    header, body = path.read_bytes().split(b"end_header\n", 1)
    header = header.decode("ascii")
    order = ">" if "binary_big_endian" in header else "<"
    n, m = (int(re.search(f"element {what} (\\d+)", header)[1]) for what in ("vertex", "face"))
    real = "f4" if "property float x" in header else "f8"
    x = np.frombuffer(body, order + real, 3 * n).reshape(n, 3)
    faces = np.frombuffer(body, [("n", "u1"), ("v", order + "i4", 3)], m, x.nbytes)
    assert (faces["n"] == 3).all()
    return x.astype(real), faces["v"].astype(np.uint32)


@functools.cache
def load(folder, name):
    return Scene(folder, name)


def named(name):
    here = pathlib.Path(__file__).resolve().parents[2]
    folder = pathlib.Path(os.environ.get("CCD_DATA", here.parent / "shared/data"))
    if not (folder / "scenes").is_dir():
        pytest.skip(f"no data at {folder} (set CCD_DATA)")
    return load(folder, name)


@pytest.fixture(params=SCENES)
def scene(request):
    return named(request.param)


@pytest.fixture
def catalogue():
    """Methods of the feature `catalogue`, without which a module may have been built: then a test
    is skipped, with the reason."""
    try:
        meshccd.BroadPhase(method="brute-force").self_pairs(np.zeros((1, 2, 3)))
    except ValueError as why:
        assert "build with the feature `catalogue`" in str(why)
        if os.environ.get("CCD_CATALOGUE") == "require":
            raise
        pytest.skip(str(why))


@pytest.fixture
def cloth_ball():
    return named("cloth-ball")
