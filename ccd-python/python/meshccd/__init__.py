"""Continuous collision detection for triangle meshes.

Which vertices and faces, and which edges, touch while every vertex moves on a straight line from
its position at the start of a step to that at its end, and when. No contact is missed, and no time
of impact is late, rounding included.

- `Mesh`: faces and edges; `Session`: a mesh stepped frame by frame; `Report`: what a step found,
  with its `Geometry`; `Hit`: the first contact of a step.
- `Bodies`: which vertices belong together, and which pairs of bodies are looked at.
- `BroadPhase`: boxes in, overlapping pairs out.
- `vertex_face`, `edge_edge`, `vertex_edge`, `vertex_vertex`: queries, one or many; `distance`.
- `read_mesh`, `read_positions`: files.
- `Kind`, `State`: what the numbers in the columns of a report mean.

What is refused is a ValueError that says what, where and the value.
"""

import enum

from ._native import (
    Bodies,
    BroadPhase,
    Geometry,
    Hit,
    Mesh,
    Report,
    Session,
    __version__,
    distance,
    edge_edge,
    read_mesh,
    read_positions,
    vertex_edge,
    vertex_face,
    vertex_vertex,
)

__all__ = [
    "Bodies",
    "BroadPhase",
    "Geometry",
    "Hit",
    "Kind",
    "Mesh",
    "Report",
    "Session",
    "State",
    "__version__",
    "distance",
    "edge_edge",
    "read_mesh",
    "read_positions",
    "vertex_edge",
    "vertex_face",
    "vertex_vertex",
]


class Kind(enum.IntEnum):
    """Which features touch."""

    VERTEX_FACE = 0
    EDGE_EDGE = 1
    VERTEX_EDGE = 2
    """A vertex of no edge and an edge of no face."""
    VERTEX_VERTEX = 3
    """Two vertices of no edge."""


class State(enum.IntEnum):
    """How certain an answer is."""

    MISS = 0
    """Certainly no contact."""
    HIT = 1
    """Certainly a contact; its time of impact is at most 1e-6 of the step early."""
    UNDECIDED = 2
    """Neither is certain: to be treated as a contact. There is none before its time of impact."""
