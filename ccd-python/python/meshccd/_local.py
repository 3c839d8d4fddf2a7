"""The mesh of one part and its halo, and the way back to the numbers of the whole mesh."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._native import Bodies, Mesh, Options, Report, Session

_Ids = NDArray[np.uint32]

#: Which corners of a face a side joins; the edges of an `ELEMENT` are in this order.
SIDES = ((0, 1), (1, 2), (2, 0))
_KINDS = {"vertex-face": 0, "edge-edge": 1, "vertex-edge": 2, "vertex-vertex": 3}
#: How errors of a session begin that name a feature.
_NAMED = re.compile(r"(vertex|edge|face) (\d+)\b")


class Local:
    """A step of one part, for a `Session`: `mesh`, and positions `x0`, `x1` of its vertices, (n, 3)
    float64. `vertices`, `edges`, `faces`: ids in the whole mesh of those of `mesh`, ascending.
    `Part.local` makes it.
    """

    def __init__(self, index: int, records: NDArray[np.void]) -> None:
        self.index: int = index
        corners = records["corners"]
        self.vertices: _Ids
        self.vertices, at = np.unique(records["vertices"], return_inverse=True)
        at = at.reshape(-1, 3)
        n = len(self.vertices)
        self.x0: NDArray[np.float64] = np.zeros((n, 3))
        self.x1: NDArray[np.float64] = np.zeros((n, 3))
        vertex_owner = np.zeros(n, np.uint32)
        vertex_owner[at] = records["vertex_owners"]
        for name, x in (("x0", self.x0), ("x1", self.x1)):
            x[at] = records[name]
            other = (x[at] != records[name]).any(axis=2)
            if other.any():
                vertex = records["vertices"][other][0]
                raise ValueError(f"vertex {vertex} has two positions {name}, in two parts")
        faces = np.flatnonzero(corners == 3)
        faces = faces[np.argsort(records["face"][faces])]
        self.faces: _Ids = records["face"][faces]
        self.mesh: Mesh = Mesh(at[faces], at[corners == 2, :2], n_vertices=n)
        known = edge_keys(self.mesh.edges)
        self.edges: _Ids = np.zeros(len(known), np.uint32)
        edge_owner = np.zeros(len(known), np.uint32)
        for side, (a, b) in enumerate(SIDES):
            # A side with equal corners is no edge.
            has = (corners == 3 if side else corners >= 2) & (at[:, a] != at[:, b])
            row = np.searchsorted(known, edge_keys(at[has][:, [a, b]]))
            self.edges[row] = records["edges"][has, side]
            edge_owner[row] = records["edge_owners"][has, side]
        face = (self.faces, records["face_owner"][faces])
        edge, vertex = (self.edges, edge_owner), (self.vertices, vertex_owner)
        # In the order of Kind: ids and owners of both features.
        self._features = ((vertex, face), (edge, edge), (vertex, edge), (vertex, vertex))
        # A particle here that may be none in the whole mesh: see `partition`.
        self._doubtful = bool((vertex_owner[self.mesh.isolated_vertices] < index).any())

    def options(self, options: Options) -> Options:
        """Options for the vertices of `mesh`: bodies and excluded features of the whole mesh, by
        their numbers here."""
        if options.bodies is None:
            return options
        whole = json.loads(options.to_json())
        whole["bodies"] = Rules(whole["bodies"]).values(self)
        return Options.from_json(json.dumps(whole))

    def bodies(self, bodies: Bodies) -> Bodies:
        """Bodies of the whole mesh, of the vertices of `mesh`."""
        return Rules(json.loads(bodies.to_json())).bodies(self)

    def owned(self, kind: int, pairs: ArrayLike) -> _Ids:
        """Of pairs of features (n, 2) of one `Kind`, by their numbers in `mesh`, those that this
        part owns, by their numbers in the whole mesh."""
        rows = np.asarray(pairs, np.int64).reshape(-1, 2)
        (a, owner_a), (b, owner_b) = self._features[kind]
        rows = rows[np.minimum(owner_a[rows[:, 0]], owner_b[rows[:, 1]]) == self.index]
        return np.stack([a[rows[:, 0]], b[rows[:, 1]]], axis=1)

    def earliest_toi(self, session: Session) -> float | None:
        """The earliest time of impact by a session of `mesh`; None if all is free. Of all parts
        the least is that of the whole mesh; that of the session itself may be of a pair which the
        whole mesh has not, where a part has a face [v, v, v]."""
        with whole_numbers(self):
            if not self._doubtful:
                return session.earliest_toi(self.x0, self.x1)
            toi = self.contacts(session.step(self.x0, self.x1))["toi"]
        return float(toi.min()) if len(toi) else None

    def contacts(self, report: Report) -> NDArray[np.void]:
        """The contacts of a step of `mesh` that this part owns, as `Report.contacts`: sorted, with
        the numbers of the whole mesh."""
        contacts = report.contacts
        keep = np.zeros(len(contacts), bool)
        for kind, ((a, owner_a), (b, owner_b)) in enumerate(self._features):
            of_kind = np.flatnonzero(contacts["kind"] == kind)
            i, j = contacts["a"][of_kind], contacts["b"][of_kind]
            keep[of_kind] = np.minimum(owner_a[i], owner_b[j]) == self.index
            contacts["a"][of_kind], contacts["b"][of_kind] = a[i], b[j]
        return contacts[keep]


class Rules:
    """Bodies of the whole mesh, of what `Bodies.to_json` says: read once, for the local meshes of
    many steps."""

    def __init__(self, values: dict[str, Any]) -> None:
        self._values = {**values, "body_of_vertex": [], "excluded_features": []}
        self._of_all = np.array(values["body_of_vertex"], np.uint32)
        self._pairs = np.array(values["excluded_bodies"], np.uint32).reshape(-1, 2)
        listed: dict[str, list[list[int]]] = {}
        for kind, pair in values["excluded_features"]:
            listed.setdefault(kind, []).append(pair)
        self._excluded = {kind: np.array(pairs, np.uint32) for kind, pairs in listed.items()}
        self._last: tuple[tuple[_Ids, _Ids, _Ids], Bodies] | None = None

    def bodies(self, local: Local) -> Bodies:
        """Those of the vertices of a local mesh: the last ones while halos have the same features.
        """
        ids = (local.vertices, local.edges, local.faces)
        if self._last is None or not all(map(np.array_equal, ids, self._last[0])):
            self._last = ids, Bodies.from_json(json.dumps(self.values(local)))
        return self._last[1]

    def values(self, local: Local) -> dict[str, Any]:
        """What `to_json` says of them."""
        ids = local.vertices
        if len(ids) and ids[-1] >= len(self._of_all):
            raise ValueError(f"vertex {ids[-1]} has no body: there are {len(self._of_all)}")
        of_vertex = self._of_all[ids]
        there = set(of_vertex.tolist())
        excluded: list[list[Any]] = []
        for kind, pairs in self._excluded.items():
            (a, _), (b, _) = local._features[_KINDS[kind]]
            i, j = pairs[np.isin(pairs[:, 0], a) & np.isin(pairs[:, 1], b)].T
            here = np.stack([np.searchsorted(a, i), np.searchsorted(b, j)], axis=1)
            excluded += [[kind, pair] for pair in here.tolist()]
        return {
            **self._values,
            "body_of_vertex": of_vertex.tolist(),
            "bodies": [rule for rule in self._values["bodies"] if rule["body"] in there],
            "excluded_bodies": self._pairs[np.isin(self._pairs, of_vertex).all(axis=1)].tolist(),
            "excluded_features": excluded,
        }


@contextmanager
def whole_numbers(local: Local) -> Iterator[None]:
    """Errors of a session of a local mesh name features by their numbers in the whole mesh."""
    try:
        yield
    except ValueError as why:
        text = str(why)
        named = _NAMED.match(text)
        if named is None:
            raise
        ids = {"vertex": local.vertices, "edge": local.edges, "face": local.faces}[named[1]]
        raise ValueError(f"{named[1]} {ids[int(named[2])]}{text[named.end() :]}") from why


def edge_keys(edges: NDArray[Any]) -> NDArray[np.int64]:
    """A number for each edge (n, 2), in the order of the edges of a mesh."""
    ends = np.sort(edges.astype(np.int64).reshape(-1, 2), axis=1)
    return ends[:, 1] << 32 | ends[:, 0]
