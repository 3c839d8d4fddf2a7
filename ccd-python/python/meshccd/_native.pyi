from collections.abc import Callable, Sequence
from os import PathLike
from typing import Final, Literal, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Bodies",
    "BroadPhase",
    "CandidateSet",
    "Geometry",
    "Hit",
    "Mesh",
    "Report",
    "Session",
    "__version__",
    "distance",
    "distance_type",
    "edge_edge",
    "read_mesh",
    "read_positions",
    "squared_distance",
    "squared_distance_gradient",
    "squared_distance_hessian",
    "vertex_edge",
    "vertex_face",
    "vertex_vertex",
]

__version__: Final[str]

@final
class Mesh:
    """The connectivity of a triangle mesh; it stays the same while vertices move."""

    def __new__(
        cls,
        faces: ArrayLike,
        edges: ArrayLike | None = None,
        *,
        n_vertices: int | None = None,
    ) -> Mesh: ...
    @property
    def n_vertices(self) -> int:
        """Number of vertices, also those in no face."""
    @property
    def faces(self) -> NDArray[np.uint32]:
        """Faces as given, (n, 3)."""
    @property
    def edges(self) -> NDArray[np.uint32]:
        """Undirected edges (n, 2), sorted by the second vertex, then by the first."""
    def neighbours(self, rings: int) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Pairs of vertex and face, and of edges, that at most so many edges join."""
    def near_at_rest(
        self, x: ArrayLike, distance: float
    ) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Pairs of vertex and face, and of edges, at most so far apart at the positions x."""
    def __getnewargs_ex__(
        self,
    ) -> tuple[tuple[NDArray[np.uint32], NDArray[np.uint32]], dict[str, int]]: ...

@final
class Bodies:
    """Bodies of a mesh and the rules of their pairs."""

    def __new__(
        cls,
        of_vertex: ArrayLike,
        *,
        fixed: Sequence[bool] | NDArray[np.bool_] | None = None,
        sleeping: Sequence[bool] | NDArray[np.bool_] | None = None,
        self_contact: bool | Sequence[bool] | NDArray[np.bool_] = True,
        memberships: ArrayLike | None = None,
        filters: ArrayLike | None = None,
        worlds: ArrayLike | None = None,
        excluded_bodies: ArrayLike | None = None,
        excluded_vertex_face: ArrayLike | None = None,
        excluded_edge_edge: ArrayLike | None = None,
        fixed_motion: bool = False,
    ) -> Bodies: ...
    @staticmethod
    def of_obstacles(is_static: Sequence[bool] | NDArray[np.bool_]) -> Bodies:
        """Static vertices are body 1, which is fixed; all others are body 0."""
    @staticmethod
    def of_patches(patches: ArrayLike) -> Bodies:
        """Each patch of vertices is a body, without self-contact."""
    @staticmethod
    def of_components(mesh: Mesh, self_contact: bool = True) -> Bodies:
        """Each connected component of a mesh is a body."""
    @property
    def of_vertex(self) -> NDArray[np.uint32]:
        """The body of each vertex, (n_vertices,)."""
    def __getnewargs_ex__(self) -> tuple[tuple[ArrayLike], dict[str, object]]: ...

@final
class Session:
    """Continuous collision detection of one mesh over many steps."""

    def __new__(
        cls,
        mesh: Mesh,
        *,
        min_distance: float = 0.0,
        threads: int = 0,
        bodies: Bodies | ArrayLike | None = None,
        fixed: Sequence[bool] | NDArray[np.bool_] | None = None,
        self_contact: bool | None = None,
        device: str | None = None,
        max_memory: int | None = None,
        tolerance: float = 1e-06,
        mode: Literal["conservative", "exact"] = "conservative",
        leave_contact: bool = False,
        method: str | None = None,
        builder: str | None = None,
        traversal: str | None = None,
        volume: str | None = None,
        pipeline: str | None = None,
        scheduler: str | None = None,
        front: str | None = None,
    ) -> Session: ...
    @property
    def mesh(self) -> Mesh:
        """The mesh of the next step."""
    @property
    def place(self) -> str:
        """Where steps run: "2 threads", or the name of the GPU."""
    def step(
        self, x0: ArrayLike, x1: ArrayLike, window: tuple[float, float] | None = None
    ) -> Report:
        """Every contact of the step that exists in a window of time."""
    def earliest_toi(self, x0: ArrayLike, x1: ArrayLike) -> float | None:
        """The earliest time of impact; None if all of the step is free."""
    def first_contact(self, x0: ArrayLike, x1: ArrayLike) -> Hit | None:
        """The first contact with its point and normal; None if all of the step is free."""
    def collision_free_stepsize(self, x0: ArrayLike, x1: ArrayLike) -> float:
        """The part of the step that is free of contact, in [0, 1]."""
    def is_step_collision_free(self, x0: ArrayLike, x1: ArrayLike) -> bool:
        """Whether nothing touches during the step, both ends included."""
    def set_positions(self, x: ArrayLike) -> None:
        """From now on all vertices stand there, until step_bodies moves some."""
    def step_bodies(self, motions: Sequence[tuple[int, ArrayLike, ArrayLike]]) -> Report:
        """Every contact of a step in which these bodies move: (body, x0, x1) of each."""
    def earliest_toi_of_bodies(
        self, motions: Sequence[tuple[int, ArrayLike, ArrayLike]]
    ) -> float | None:
        """The earliest time of impact of a step in which these bodies move."""
    def first_contact_of_bodies(
        self, motions: Sequence[tuple[int, ArrayLike, ArrayLike]]
    ) -> Hit | None:
        """The first contact of a step in which these bodies move."""
    def candidates(
        self, x0: ArrayLike, x1: ArrayLike
    ) -> tuple[
        NDArray[np.uint32], NDArray[np.uint32], NDArray[np.uint32], NDArray[np.uint32]
    ]:
        """Pairs whose swept boxes overlap, an array (n, 2) for each Kind."""
    def intersections(self, x: ArrayLike) -> NDArray[np.uint32]:
        """Edges and faces that have a point in common at the positions x, (n, 2)."""
    def has_intersections(self, x: ArrayLike) -> bool:
        """Whether there are any at the positions x; the search ends with the first."""
    def candidate_set(
        self, x0: ArrayLike, x1: ArrayLike, inflation: float = 0.0
    ) -> CandidateSet:
        """Candidates for all steps of vertices at most inflation outside of this one."""
    def set_mesh(self, mesh: Mesh, bodies: Bodies | ArrayLike | None = None) -> None:
        """From now on steps of another mesh, with other bodies if some are given."""
    def set_bodies(self, bodies: Bodies | ArrayLike | None = None) -> None:
        """From now on these bodies, or none."""
    def set_min_distance(self, min_distance: float) -> None:
        """From now on another min_distance."""
    def set_sleeping(self, body: int, sleeping: bool) -> None:
        """From now on a body sleeps, or is awake."""
    def set_fixed(self, body: int, fixed: bool) -> None:
        """From now on a body is fixed, or moves."""
    def set_filter(
        self, filter: Callable[[int, NDArray[np.uint32]], NDArray[np.bool_]] | None = None
    ) -> None:
        """From now on filter(kind, pairs) says which candidates count."""

@final
class CandidateSet:
    """Candidates of a step, for all steps near it: those of a line search."""

    @property
    def vf(self) -> NDArray[np.uint32]:
        """Vertex and face, (n, 2)."""
    @property
    def ee(self) -> NDArray[np.uint32]:
        """Two edges, the lesser id first, (n, 2)."""
    @property
    def ve(self) -> NDArray[np.uint32]:
        """Particle and rod, (n, 2)."""
    @property
    def vv(self) -> NDArray[np.uint32]:
        """Two particles, the lesser id first, (n, 2)."""
    @property
    def inflation(self) -> float:
        """How far vertices may be outside of the step that it was made for."""
    def earliest_toi(self, x0: ArrayLike, x1: ArrayLike) -> float | None:
        """The earliest time of impact; None if all of the step is free."""
    def collision_free_stepsize(self, x0: ArrayLike, x1: ArrayLike) -> float:
        """The part of the step that is free of contact, in [0, 1]."""
    def is_step_collision_free(self, x0: ArrayLike, x1: ArrayLike) -> bool:
        """Whether nothing touches during the step, both ends included."""

@final
class Report:
    """What a step found: arrays with an entry for each contact."""

    def __new__(
        cls,
        kind: NDArray[np.uint8],
        a: NDArray[np.uint32],
        b: NDArray[np.uint32],
        toi: NDArray[np.float64],
        state: NDArray[np.uint8],
        vertices: NDArray[np.uint32],
        earliest_toi: float | None,
        n_candidates: tuple[int, int, int, int],
        n_undecided: int,
        times: dict[str, float],
        toi_of_worlds: NDArray[np.float64] | None,
        mesh: Mesh,
    ) -> Report: ...
    @property
    def kind(self) -> NDArray[np.uint8]:
        """Kind of each contact."""
    @property
    def a(self) -> NDArray[np.uint32]:
        """Vertex id, or the lesser edge id."""
    @property
    def b(self) -> NDArray[np.uint32]:
        """Face id, or the greater edge id."""
    @property
    def toi(self) -> NDArray[np.float64]:
        """Time of impact in [0, 1]; never late."""
    @property
    def state(self) -> NDArray[np.uint8]:
        """How certain: State.HIT or State.UNDECIDED."""
    @property
    def vertices(self) -> NDArray[np.uint32]:
        """v f0 f1 f2, or ea0 ea1 eb0 eb1: (n, 4)."""
    @property
    def contacts(self) -> NDArray[np.void]:
        """All columns but vertices in one structured array."""
    @property
    def earliest_toi(self) -> float | None:
        """Least time of impact; None without contact."""
    @property
    def n_candidates(self) -> tuple[int, int, int, int]:
        """Numbers of candidates in the order of Kind."""
    @property
    def n_undecided(self) -> int:
        """Number of contacts that are undecided."""
    @property
    def times(self) -> dict[str, float]:
        """Where the time went, in milliseconds."""
    @property
    def toi_of_worlds(self) -> NDArray[np.float64] | None:
        """Least time of impact of each world, infinity where there is none."""
    @property
    def mesh(self) -> Mesh:
        """The mesh of the step."""
    def geometry(self, x0: ArrayLike, x1: ArrayLike) -> Geometry:
        """Points, normals and weights, from the positions of the step."""
    def __len__(self) -> int: ...
    def __getnewargs__(self) -> tuple[object, ...]: ...

@final
class Geometry:
    """How features meet at the times of impact: arrays with an entry for each contact."""

    @property
    def point(self) -> NDArray[np.float64]:
        """Halfway between the nearest points, (n, 3)."""
    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit vector from b towards a, (n, 3)."""
    @property
    def weights(self) -> NDArray[np.float64]:
        """Of the vertices, in the nearest point of their feature, (n, 4)."""
    @property
    def on_a(self) -> NDArray[np.float64]:
        """The nearest point of a, (n, 3)."""
    @property
    def on_b(self) -> NDArray[np.float64]:
        """The nearest point of b, (n, 3)."""
    @property
    def distance(self) -> NDArray[np.float64]:
        """Between the nearest points, (n,)."""

@final
class Hit:
    """The first contact of a step."""

    @property
    def toi(self) -> float:
        """Time of impact in [0, 1]; never late."""
    @property
    def kind(self) -> int:
        """Which features touch: a Kind."""
    @property
    def state(self) -> int:
        """State.HIT or State.UNDECIDED."""
    @property
    def features(self) -> list[int]:
        """Vertex and face, or the lesser and the greater edge."""
    @property
    def bodies(self) -> list[int]:
        """The bodies of the features."""
    @property
    def vertices(self) -> list[int]:
        """v f0 f1 f2, or ea0 ea1 eb0 eb1."""
    @property
    def point(self) -> list[float]:
        """Where they meet."""
    @property
    def normal(self) -> list[float]:
        """Unit vector from the second feature towards the first."""
    @property
    def weights(self) -> list[float]:
        """Of each of the vertices, in the point of its feature."""
    @property
    def distance(self) -> float:
        """How far the features are apart at that time."""
    def normal_towards(self, body: int) -> list[float]:
        """The normal that points towards body, away from what it touches."""

@final
class BroadPhase:
    """Finds overlapping boxes; keeps its buffers between calls."""

    def __new__(
        cls,
        *,
        threads: int = 0,
        method: str = "blocks",
        device: str | None = None,
    ) -> BroadPhase: ...
    def self_pairs(self, boxes: ArrayLike) -> NDArray[np.uint32]:
        """Pairs within one set of boxes (n, 2, 3), each once, the lesser index first."""
    def pairs(self, a: ArrayLike, b: ArrayLike) -> NDArray[np.uint32]:
        """Pairs of a box of a with a box of b."""

def vertex_face(
    x0: ArrayLike, x1: ArrayLike, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times of vertex-face queries, positions (..., 4, 3)."""

def edge_edge(
    x0: ArrayLike, x1: ArrayLike, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times of edge-edge queries, positions (..., 4, 3)."""

def vertex_edge(
    x0: ArrayLike, x1: ArrayLike, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times of vertex-edge queries, positions (..., 3, 3)."""

def vertex_vertex(
    x0: ArrayLike, x1: ArrayLike, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times of vertex-vertex queries, positions (..., 2, 3)."""

def distance(kind: int, x: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Least and greatest distance of features at one moment, positions (..., n, 3)."""

def distance_type(kind: int, x: ArrayLike) -> NDArray[np.uint8]:
    """Which parts of features are nearest, positions (..., 4, 3)."""

def squared_distance(
    kind: int, x: ArrayLike, types: ArrayLike | None = None
) -> NDArray[np.float64]:
    """Squared distances at one moment, positions (..., 4, 3)."""

def squared_distance_gradient(
    kind: int, x: ArrayLike, types: ArrayLike | None = None
) -> NDArray[np.float64]:
    """Their gradients, (..., 12)."""

def squared_distance_hessian(
    kind: int, x: ArrayLike, types: ArrayLike | None = None
) -> NDArray[np.float64]:
    """Their Hessians, (..., 12, 12)."""

def read_mesh(path: str | PathLike[str]) -> tuple[Mesh, NDArray[np.float64]]:
    """A mesh and its positions: OBJ, PLY, STL, OFF, glTF or GLB."""

def read_positions(path: str | PathLike[str]) -> NDArray[np.float64]:
    """Positions over time (n_frames, n_vertices, 3): NPY, NPZ, PC2 or MDD."""
