"""One scene in several parts, each pair of features found by exactly one: plain arrays, without a
transport. `meshccd.mpi` steps such parts with MPI.

An element is a face, an edge of no face, or a vertex of no edge. `split` gives each element to one
part: neighbours on a Morton curve. A vertex or an edge belongs to the lowest part that has an
element with it, a face to the part that has it: every feature has one owner. A step of a part is
made of its elements and of a halo, and then

1. `part.boxes(..)`: some boxes around the swept elements of a part; all parts get those of all.
2. `part.outgoing(..)`: a part sends to each lower one the elements that overlap its boxes.
3. `part.local(..)`: a mesh of what a part has and what it received, for a `Session`.
4. `local.contacts(report)`: what this part owns, by the numbers of the whole mesh. A pair is owned
   by the lower of the owners of its two features. `merge` joins the arrays of all parts. The least
   `local.earliest_toi(session)` is the earliest time of the whole.

Why every pair of the whole mesh is found once, and no other. Let the features a and b be a pair
with owners p <= q. *Not twice:* parts keep a pair only if they are p, and a report lists it once.
*Found:* p has an element A with the feature a, since it owns a; q has an element B with b. If
q = p, then p has both. Otherwise B goes to p: features in contact are at most `min_distance` d
apart at one time, so in each axis the gap of their swept boxes is at most d; boxes of elements
hold those of their features, are grown by more than d / 2 each and rounded outward, and the
comparison is closed, so B overlaps the box of A and the boxes of p around it. *Nothing else:* whole
elements are sent, with all their vertices and edges. So a rod of a local mesh is one of the whole
mesh, and a vertex with an edge has one there. But p may take a vertex v for a particle of which it
has a face [v, v, v] alone, while elements with its edges are elsewhere. None of these is in a
higher part, since all elements with v overlap where that face does, and would have come with it. So
one is in a lower part, which owns v, and p keeps no pair of v as a particle. `local.earliest_toi`
leaves these pairs out, too.

Why it has the same time and state. A verdict depends on the positions of the pair alone and on the
order of its features and of their vertices. Local numbers of vertices, edges and faces ascend as
those of the whole mesh do, so both orders are the same; and arrays stay sorted.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._local import SIDES, Local, edge_keys
from ._native import BroadPhase, Mesh

__all__ = ["ELEMENT", "Local", "Part", "merge", "split"]

_Ids = NDArray[np.uint32]
_Reals = NDArray[np.float64]
_Records = NDArray[np.void]

#: An element on its way to another part: its number of corners (3 for a face, 2 for an edge of no
#: face, 1 for a vertex of no edge), ids in the whole mesh and the parts that own them, positions at
#: both ends of the step. An element with fewer corners repeats the last one.
ELEMENT: np.dtype[np.void] = np.dtype(
    [
        ("corners", "u4"),
        ("face", "u4"),
        ("face_owner", "u4"),
        ("vertices", "u4", 3),
        ("vertex_owners", "u4", 3),
        ("edges", "u4", 3),
        ("edge_owners", "u4", 3),
        ("x0", "f8", (3, 3)),
        ("x1", "f8", (3, 3)),
    ]
)
# Boxes grow by this part of their coordinates besides: far above the rounding of their bounds and
# of a verdict in float64, far below what would make a halo larger.
_SLACK = 2.0**-40
_TINY = float(np.finfo(np.float64).tiny)


def split(mesh: Mesh, x: ArrayLike, n_parts: int) -> list[Part]:
    """A mesh as so many parts with as many elements each, or one more or less.

    Parameters
    ----------
    mesh : Mesh
    x : (n_vertices, 3) array
        Positions that tell which elements are neighbours; those of any frame serve.
    n_parts : int
        At least 1. There may be more parts than elements: some are empty then.

    Raises
    ------
    ValueError
        If there is no part, or positions are not finite or of another shape.
    """
    if n_parts < 1:
        raise ValueError(f"n_parts is {n_parts}; it must be at least 1")
    x = _positions("x", x, mesh.n_vertices)
    records = _records(mesh)
    order = np.argsort(_morton(x[records["vertices"]].mean(axis=1)), kind="stable")
    records = records[order]
    ends = [i * len(records) // n_parts for i in range(n_parts + 1)]
    owner = np.repeat(np.arange(n_parts, dtype=np.uint32), np.diff(ends))
    records["face_owner"] = owner
    for ids, owners, n in (
        ("vertices", "vertex_owners", mesh.n_vertices),
        ("edges", "edge_owners", len(mesh.edges)),
    ):
        # One more, for the id that stands for no edge.
        lowest = np.full(n + 1, n_parts, np.uint32)
        np.minimum.at(lowest, records[ids], owner[:, None])
        records[owners] = lowest[records[ids]]
    return [Part(i, n_parts, records[a:b]) for i, (a, b) in enumerate(zip(ends, ends[1:]))]


class Part:
    """The elements of one part; it can be pickled, and does not refer to the whole mesh.

    `index` of `n_parts`, counted from 0; `vertices`: ids of the vertices of its elements in the
    whole mesh, ascending, (n,). Calls take the positions of these vertices, (n, 3) in any unit; a
    vertex that several parts have must have the same ones in each.
    """

    def __init__(self, index: int, n_parts: int, records: _Records) -> None:
        self.index: int = index
        self.n_parts: int = n_parts
        self.vertices: _Ids
        self._records = records
        self.vertices, self._corners = np.unique(records["vertices"], return_inverse=True)
        self._corners = self._corners.reshape(-1, 3)

    def __len__(self) -> int:
        """Number of elements."""
        return len(self._records)

    def __repr__(self) -> str:
        return f"<Part {self.index} of {self.n_parts}: {len(self)} elements>"

    def boxes(
        self, x0: ArrayLike, x1: ArrayLike, min_distance: float = 0.0, at_most: int = 64
    ) -> _Reals:
        """Boxes around the swept elements, least and greatest corner: (n, 2, 3).

        At most so many, of neighbours on the curve; none of an empty part.

        Raises
        ------
        ValueError
            If positions are not finite or of another shape, the distance is negative, or no box is
            allowed.
        """
        if at_most < 1:
            raise ValueError(f"at_most is {at_most}; it must be at least 1")
        boxes = self._swept(*self._ends(x0, x1), min_distance)
        starts = np.unique(np.arange(at_most) * len(boxes) // at_most)
        if len(boxes) == 0:
            return boxes
        low = np.minimum.reduceat(boxes[:, 0], starts)
        return np.stack([low, np.maximum.reduceat(boxes[:, 1], starts)], axis=1)

    def outgoing(
        self,
        x0: ArrayLike,
        x1: ArrayLike,
        boxes: Sequence[_Reals],
        min_distance: float = 0.0,
    ) -> list[_Records]:
        """The elements that each part needs of this one: an array of `ELEMENT` a part, empty from
        this part on.

        Parameters
        ----------
        x0, x1 : (n, 3) arrays
        boxes : sequence of arrays
            What `boxes` of each part returned, for the same distance.
        """
        x0, x1 = self._ends(x0, x1)
        mine = self._swept(x0, x1, min_distance)
        lower = [np.asarray(of, np.float64).reshape(-1, 2, 3) for of in boxes[: self.index]]
        owner = np.repeat(np.arange(len(lower)), [len(of) for of in lower])
        sent = [np.zeros(0, ELEMENT) for _ in range(self.n_parts)]
        if len(owner) == 0 or len(mine) == 0:
            return sent
        element, box = BroadPhase(threads=1).pairs(mine, np.concatenate(lower)).T
        for part in range(len(lower)):
            which = np.unique(element[owner[box] == part])
            records = self._records[which].copy()
            records["x0"], records["x1"] = x0[self._corners[which]], x1[self._corners[which]]
            sent[part] = records
        return sent

    def local(self, x0: ArrayLike, x1: ArrayLike, received: Iterable[_Records]) -> Local:
        """The mesh of a step of this part: its elements, and those that other parts sent.

        Raises
        ------
        ValueError
            If a vertex has other positions in another part.
        """
        x0, x1 = self._ends(x0, x1)
        mine = self._records.copy()
        mine["x0"], mine["x1"] = x0[self._corners], x1[self._corners]
        return Local(self.index, np.concatenate([mine, *received]))

    def _ends(self, x0: ArrayLike, x1: ArrayLike) -> tuple[_Reals, _Reals]:
        n = len(self.vertices)
        return _positions("x0", x0, n), _positions("x1", x1, n)

    def _swept(self, x0: _Reals, x1: _Reals, min_distance: float) -> _Reals:
        """Boxes of elements over the step, grown by more than half of the distance."""
        if not 0 <= min_distance < np.inf:
            raise ValueError(f"min_distance is {min_distance}; it must be finite, at least 0")
        x = np.concatenate([x0[self._corners], x1[self._corners]], axis=1)
        if len(x) == 0:
            return np.zeros((0, 2, 3))
        low, high = x.min(axis=1), x.max(axis=1)
        by = 0.5 * min_distance + _SLACK * (np.abs(x).max(axis=(1, 2)) + min_distance) + _TINY
        low = np.nextafter(low - by[:, None], -np.inf)
        return np.stack([low, np.nextafter(high + by[:, None], np.inf)], axis=1)


def merge(contacts: Iterable[NDArray[np.void]]) -> NDArray[np.void]:
    """The contacts of all parts, sorted by kind, `a` and `b` as one process lists them."""
    joined = np.concatenate(list(contacts))
    return joined[np.lexsort((joined["b"], joined["a"], joined["kind"]))]


def _records(mesh: Mesh) -> _Records:
    """All elements of a mesh, without owners and positions."""
    faces, edges, particles = mesh.faces, mesh.edges, mesh.isolated_vertices
    known = edge_keys(edges)
    ends = faces[:, np.array(SIDES)]
    sides = np.searchsorted(known, edge_keys(ends)).reshape(-1, 3)
    # A side with equal corners is no edge; `is_rod` has one more, for that id.
    sides[ends[:, :, 0] == ends[:, :, 1]] = len(edges)
    is_rod = np.ones(len(edges) + 1, bool)
    is_rod[sides.ravel()] = False
    rods = np.flatnonzero(is_rod[:-1])
    n, m = len(faces), len(faces) + len(rods)
    records = np.zeros(m + len(particles), ELEMENT)
    records["corners"][:n], records["corners"][n:m], records["corners"][m:] = 3, 2, 1
    records["face"][:n] = np.arange(n)
    records["vertices"][:n] = faces
    records["vertices"][n:m] = edges[rods][:, [0, 1, 1]]
    records["vertices"][m:] = particles[:, None]
    records["edges"] = len(edges)
    records["edges"][:n] = sides
    records["edges"][n:m, 0] = rods
    return records


def _positions(name: str, x: ArrayLike, n: int) -> _Reals:
    given = np.asarray(x)
    if given.shape != (n, 3):
        raise ValueError(f"{name} has the shape {given.shape}; there are {n} vertices: ({n}, 3)")
    # As of a `Session`: only numbers that have a place in float64.
    if not np.can_cast(given.dtype, np.float64, "safe"):
        raise ValueError(f"{name} is an array of {given.dtype}, which float64 does not hold")
    if given.dtype.kind in "iu" and n and max(-int(given.min()), int(given.max())) > 2**53:
        raise ValueError(f"{name} has integers beyond 2**53, which float64 rounds")
    array = given.astype(np.float64, copy=False)
    bad = ~np.isfinite(array).all(axis=1)
    if bad.any():
        at = int(np.argmax(bad))
        raise ValueError(f"{name}[{at}] is {array[at].tolist()}; positions must be finite")
    return array


def _morton(points: _Reals) -> NDArray[np.uint64]:
    """Codes of 63 bits along a Morton curve through the box of the points (n, 3)."""
    if len(points) == 0:
        return np.zeros(0, np.uint64)
    low = points.min(axis=0)
    # Halves, so that the extent of the largest coordinates is finite.
    extent = (0.5 * points.max(axis=0) - 0.5 * low).max()
    unit = (0.5 * points - 0.5 * low) / extent if extent > 0 else np.zeros_like(points)
    cells = np.minimum(unit * 2.0**21, 2.0**21 - 1).astype(np.uint64)
    for shift, mask in (
        (32, 0x001F00000000FFFF),
        (16, 0x001F0000FF0000FF),
        (8, 0x100F00F00F00F00F),
        (4, 0x10C30C30C30C30C3),
        (2, 0x1249249249249249),
    ):
        cells = (cells | cells << np.uint64(shift)) & np.uint64(mask)
    x, y, z = cells.T
    code: NDArray[np.uint64] = x | y << np.uint64(1) | z << np.uint64(2)
    return code
