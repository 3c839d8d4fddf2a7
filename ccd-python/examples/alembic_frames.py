"""Contacts of an Alembic archive: all of its polygon meshes, in one space, from sample to sample.

    python ccd-python/examples/alembic_frames.py [ARCHIVE.abc]

Without an archive it writes a small one: a sheet that falls onto a plate. It needs the package
alembic3d, whose types mypy and pyright do not know.
"""

import pathlib
import sys
import tempfile
from typing import Any

import imath  # type: ignore[import-not-found]
import numpy as np
from alembic3d import Abc, AbcCoreAbstract, AbcGeom  # type: ignore[import-not-found]

import meshccd


def polygon_meshes(parent, transforms=()):
    """Each polygon mesh below an object with the transforms above it, the outermost first."""
    for child in parent.children:
        if AbcGeom.IPolyMesh.matches(child.getHeader()):
            yield AbcGeom.IPolyMesh(parent, child.getName()).getSchema(), transforms
        elif AbcGeom.IXform.matches(child.getHeader()):
            xform = AbcGeom.IXform(parent, child.getName()).getSchema()
            yield from polygon_meshes(child, (*transforms, xform))
            continue
        yield from polygon_meshes(child, transforms)


def array(of_alembic: Any):
    """A copy, which outlives the sample that the array belongs to."""
    return np.array(memoryview(of_alembic))


def triangles(sample):
    """Triangles of polygons, each of which is a fan from its first corner."""
    corners, counts = array(sample.getFaceIndices()), array(sample.getFaceCounts())
    first = np.cumsum(counts) - counts
    n = np.maximum(counts - 2, 0)
    polygon = np.repeat(np.arange(len(counts)), n)
    nth = np.arange(n.sum()) - np.repeat(np.cumsum(n) - n, n)
    at = first[polygon]
    return np.stack([corners[at], corners[at + nth + 1], corners[at + nth + 2]], axis=1)


def positions(schema, transforms, selector):
    """Positions at a time in the space of the archive, float64: transforms are."""
    x = array(schema.getValue(selector).getPositions()).astype(np.float64)
    # Alembic's points are rows: p' = p M.
    for xform in reversed(transforms):
        sample = xform.getValue(selector)
        m = np.array([[sample.getMatrix()[i][k] for k in range(4)] for i in range(4)])
        x = x @ m[:3, :3] + m[3, :3]
        if not sample.getInheritsXforms():
            break
    return x


def read(path):
    """The mesh of an archive, the times of its samples, and a generator of their positions."""
    archive = Abc.IArchive(str(path))
    found = list(polygon_meshes(archive.getTop()))
    if not found:
        raise SystemExit(f"{path} has no polygon mesh")
    faces, n_vertices = [], 0
    for schema, _ in found:
        if schema.getTopologyVariance() == AbcGeom.MeshTopologyVariance.kHeterogenousTopology:
            raise SystemExit(f"{path} has a mesh whose faces change from sample to sample")
        sample = schema.getValue()
        faces.append(triangles(sample) + n_vertices)
        n_vertices += len(sample.getPositions())
    # The times of whatever has most samples, a mesh or a transform.
    animated = [of for schema, transforms in found for of in (schema, *transforms)]
    longest = max(animated, key=lambda of: of.getNumSamples())
    sampling = longest.getTimeSampling()
    times = [sampling.getSampleTime(at) for at in range(longest.getNumSamples())]
    selectors = (Abc.ISampleSelector(time) for time in times)
    frames = (np.concatenate([positions(a, b, at) for a, b in found]) for at in selectors)
    return meshccd.Mesh(np.concatenate(faces), n_vertices=n_vertices), times, frames


def write(path, n=12, n_frames=24):
    """An archive of a plate of one quad, and of a wavy sheet of n x n quads below a transform, by
    which it falls onto the plate and through it."""
    archive = Abc.OArchive(str(path))
    corner = np.arange(n * (n + 1)).reshape(n, n + 1)[:, :n].ravel()
    quads = np.stack([corner, corner + 1, corner + n + 2, corner + n + 1], axis=1)
    u, v = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1), indexing="ij")
    sheet = np.stack([u, 0.1 * np.sin(4 * u) * np.sin(3 * v), v], axis=-1).reshape(-1, 3)
    plate = np.array([[-1.5, 0, -1.5], [1.5, 0, -1.5], [1.5, 0, 1.5], [-1.5, 0, 1.5]])

    def add(parent, name, x, faces):
        x = np.ascontiguousarray(x, np.float32)
        counts = np.full(len(faces), faces.shape[1], np.int32)
        sample = AbcGeom.OPolyMeshSchemaSample(
            imath.V3fArrayFromBuffer(x),
            imath.IntArrayFromBuffer(faces.astype(np.int32).ravel()),
            imath.IntArrayFromBuffer(counts),
        )
        AbcGeom.OPolyMesh(parent, name).getSchema().set(sample)

    fall = AbcGeom.OXform(archive.getTop(), "fall")
    fall.getSchema().setTimeSampling(AbcCoreAbstract.TimeSampling(1 / 24, 0.0))
    for frame in range(n_frames):
        sample = AbcGeom.XformSample()
        sample.setTranslation(imath.V3d(0.01 * frame, 0.5 - 0.04 * frame, 0))
        fall.getSchema().set(sample)
    add(fall, "sheet", sheet, quads)
    add(archive.getTop(), "plate", plate, np.arange(4).reshape(1, 4))


def main(path):
    mesh, times, frames = read(path)
    print(f"{path}: {mesh.n_vertices} vertices, {len(mesh.faces)} triangles, {len(times)} samples")
    reports = meshccd.Session(mesh).step_many(frames)
    for at, report in enumerate(reports):
        if report.earliest_toi is not None:
            time = times[at] + report.earliest_toi * (times[at + 1] - times[at])
            print(f"step {at}: {len(report)} contacts, the first one at {time:.6f} s")
    return reports


if len(sys.argv) > 1:
    main(sys.argv[1])
else:
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "sheet.abc"
        write(path)
        reports = main(path)
    # The wave of the sheet is from -0.1 to 0.1 around its middle, which is at the height of the
    # plate after 12.5 steps of 0.04.
    assert [at for at, report in enumerate(reports) if len(report)] == [10, 11, 12, 13, 14]
