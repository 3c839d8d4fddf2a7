"""A step of a cloth in the viewer of rerun: meshes frame by frame, contacts coloured by their time.

    python ccd-python/examples/rerun_log.py [FILE.rrd]
    rerun FILE.rrd

It needs the package rerun-sdk. Without a file it writes to a folder that is removed at the end.
"""

import pathlib
import sys
import tempfile

import numpy as np
import rerun as rr

import meshccd


def sheet(n, height):
    """Vertices and faces of a wavy sheet of n x n squares."""
    u, v = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1), indexing="ij")
    x = np.stack([u, height + 0.1 * np.sin(4 * u) * np.cos(3 * v), v], axis=-1).reshape(-1, 3)
    corner = np.arange(n * (n + 1)).reshape(n, n + 1)[:, :n].ravel()
    right, up = corner + 1, corner + n + 1
    squares = np.stack([corner, right, up, up, right, up + 1], axis=1)
    return x, squares.reshape(-1, 3)


def colours(toi):
    """From yellow at the start of a step to red at its end, (n, 3)."""
    green = np.round(255 * (1 - toi)).astype(np.uint8)
    return np.stack([np.full_like(green, 255), green, np.zeros_like(green)], axis=1)


def log(recording, mesh, n_low, frames, reports):
    """Logs frames, and to the frame that each step begins at its contacts; their number.

    The timeline `frame` counts frames. Faces below `n_low` are one entity, all others another.
    """
    low = np.asarray(mesh.faces < n_low).all(axis=1)
    n_points = 0
    for frame, x in enumerate(frames):
        recording.set_time("frame", sequence=frame)
        for name, faces in (("low", mesh.faces[low]), ("high", mesh.faces[~low])):
            recording.log(f"mesh/{name}", rr.Mesh3D(vertex_positions=x, triangle_indices=faces))
        if frame == len(reports):
            break
        report = reports[frame]
        toi = 1.0 if report.earliest_toi is None else report.earliest_toi
        recording.log("toi", rr.Scalars(toi))
        # Points are where features meet, at the time of each contact.
        points = report.geometry(x, frames[frame + 1]).point
        recording.log("contacts", rr.Points3D(points, colors=colours(report.toi), radii=0.01))
        n_points += len(points)
    return n_points


def main(path):
    (low, faces), (high, more) = sheet(24, 0.0), sheet(30, 0.5)
    mesh = meshccd.Mesh(np.concatenate([faces, more + len(low)]))
    t = np.linspace(0, 1, 25)[:, None, None]
    frames = np.concatenate([low + 0 * t, high - t * [0.1, 1.0, 0.1]], axis=1)
    reports = meshccd.Session(mesh).step_many(frames)
    with rr.RecordingStream("meshccd") as recording:
        recording.save(str(path))
        n_points = log(recording, mesh, len(low), frames, reports)
    print(f"{path}: {len(frames)} frames, {n_points} contacts")
    assert n_points == sum(map(len, reports)) > 100 and len(reports[0]) == 0
    assert pathlib.Path(path).stat().st_size > frames.nbytes // 4


if len(sys.argv) > 1:
    main(sys.argv[1])
else:
    with tempfile.TemporaryDirectory() as folder:
        main(pathlib.Path(folder) / "contacts.rrd")
