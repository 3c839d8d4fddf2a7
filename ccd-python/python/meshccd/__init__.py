"""Continuous collision detection for triangle meshes.

Which vertices and faces, and which edges, touch while every vertex moves on a straight line from
its position at the start of a step to that at its end, and when. No contact is missed, and no time
of impact is late, rounding included.

- `Mesh`: faces and edges; `Session`: a mesh stepped frame by frame; `Report`: what a step found,
  with its `Geometry`; `Hit`: the first contact of a step.
- `Options`: what a session looks for, and how; `methods`: the choices; `CancelToken` ends calls.
- `Bodies`: which vertices belong together, and which pairs of bodies are looked at.
- `CandidateSet`: candidates for many steps, of a line search.
- `BroadPhase`: boxes in, overlapping pairs out.
- `vertex_face`, `edge_edge`, `vertex_edge`, `vertex_vertex`: queries, one or many; `distance`;
  `exact` has the same queries, decided exactly.
- `squared_distance`, with `_gradient` and `_hessian`, and `distance_type`: what barriers are made
  of.
- `read_mesh`, `read_positions`, `read_queries`: files.
- `scaled_toi`, `toi_to_f32`: times as an application uses them, never later.
- `gpus`, `instruction_set`: what this machine has.
- `meshccd.distributed`, `meshccd.mpi`, `meshccd.partition`: many frames, many hosts.
- `Kind`, `State`, `Approach`, `VertexFaceType`, `EdgeEdgeType`: what numbers in arrays mean.

What is refused is a ValueError that says what, where and the value; a negative number where there
is none, an OverflowError.
"""

import enum

from . import exact
from ._native import (
    Bodies,
    BroadPhase,
    CancelToken,
    CandidateSet,
    Geometry,
    Hit,
    Mesh,
    Options,
    Report,
    Session,
    __version__,
    distance,
    distance_type,
    edge_edge,
    gpus,
    instruction_set,
    methods,
    read_mesh,
    read_positions,
    read_queries,
    scaled_toi,
    toi_to_f32,
    squared_distance,
    squared_distance_gradient,
    squared_distance_hessian,
    vertex_edge,
    vertex_face,
    vertex_vertex,
)

__all__ = [
    "Approach",
    "Bodies",
    "BroadPhase",
    "CancelToken",
    "CandidateSet",
    "EdgeEdgeType",
    "Geometry",
    "Hit",
    "Kind",
    "Mesh",
    "Options",
    "Report",
    "Session",
    "State",
    "VertexFaceType",
    "__version__",
    "distance",
    "distance_type",
    "edge_edge",
    "exact",
    "gpus",
    "instruction_set",
    "methods",
    "read_mesh",
    "read_positions",
    "read_queries",
    "scaled_toi",
    "toi_to_f32",
    "squared_distance",
    "squared_distance_gradient",
    "squared_distance_hessian",
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
    """Certainly a contact; its time of impact is at most `tolerance` of the step early."""
    UNDECIDED = 2
    """Neither is certain: to be treated as a contact. There is none before its time of impact."""


class Approach(enum.IntEnum):
    """Whether features come nearer at the time of impact."""

    UNKNOWN = 0
    """Certainly neither, or not certain."""
    APPROACHING = 1
    """Certainly nearer."""
    SEPARATING = 2
    """Certainly apart: a contact at the start whose distance grows from then on for a while."""


class VertexFaceType(enum.IntEnum):
    """Which part of a face is nearest to a vertex; the numbers are those of ipctk."""

    F0 = 0
    F1 = 1
    F2 = 2
    F0F1 = 3
    """The inside of the side from f0 to f1."""
    F1F2 = 4
    F2F0 = 5
    FACE = 6
    """The inside of the face."""


class EdgeEdgeType(enum.IntEnum):
    """Which parts of two edges are nearest to each other; the numbers are those of ipctk."""

    A0B0 = 0
    """The first ends of both."""
    A0B1 = 1
    A1B0 = 2
    A1B1 = 3
    AB0 = 4
    """The inside of the first edge, and the first end of the second."""
    AB1 = 5
    A0B = 6
    A1B = 7
    AB = 8
    """The insides of both."""
