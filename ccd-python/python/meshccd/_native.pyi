from collections.abc import Callable, Iterable, Sequence
from os import PathLike
from typing import Final, Literal, Protocol, TypeAlias, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Bodies",
    "BroadPhase",
    "CancelToken",
    "CandidateSet",
    "Geometry",
    "Hit",
    "Mesh",
    "Options",
    "Report",
    "Session",
    "__version__",
    "distance",
    "distance_type",
    "edge_edge",
    "exact_edge_edge",
    "exact_vertex_edge",
    "exact_vertex_face",
    "exact_vertex_vertex",
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

__version__: Final[str]

class _OfDLPack(Protocol):
    """An array of another library, in the memory of the CPU."""

    def __dlpack__(self) -> object: ...
    def __dlpack_device__(self) -> tuple[int, int]: ...

_Array: TypeAlias = ArrayLike | _OfDLPack
_Ids: TypeAlias = NDArray[np.uint32]
_Flags: TypeAlias = Sequence[bool] | NDArray[np.bool_]
_Mode: TypeAlias = Literal["auto", "conservative", "exact"]
_PerKind: TypeAlias = tuple[int, int, int, int]

@final
class Mesh:
    """The connectivity of a triangle mesh; it stays the same while vertices move."""

    def __new__(
        cls,
        faces: _Array,
        edges: _Array | None = None,
        *,
        n_vertices: int | None = None,
    ) -> Mesh: ...
    @property
    def n_vertices(self) -> int:
        """Number of vertices, also those in no face."""
    @property
    def faces(self) -> _Ids:
        """Faces as given, (n, 3)."""
    @property
    def edges(self) -> _Ids:
        """Undirected edges (n, 2), sorted by the second vertex, then by the first."""
    def neighbours(self, rings: int) -> tuple[_Ids, _Ids]:
        """Pairs of vertex and face, and of edges, that at most so many edges join."""
    def near_at_rest(
        self, x: _Array, distance: float
    ) -> tuple[_Ids, _Ids]:
        """Pairs of vertex and face, and of edges, at most so far apart at the positions x."""
    @property
    def isolated_vertices(self) -> _Ids:
        """Vertices of no edge, the particles, (n,)."""
    def vertices_of(self, kind: int, pairs: _Array) -> _Ids:
        """The vertices of pairs of features of a Kind, (n, 4)."""
    def __getnewargs_ex__(self) -> tuple[tuple[_Ids, _Ids], dict[str, int]]: ...

@final
class Bodies:
    """Bodies of a mesh and the rules of their pairs."""

    def __new__(
        cls,
        of_vertex: _Array,
        *,
        fixed: _Flags | None = None,
        sleeping: _Flags | None = None,
        self_contact: bool | _Flags = True,
        memberships: _Array | None = None,
        filters: _Array | None = None,
        worlds: _Array | None = None,
        excluded_bodies: _Array | None = None,
        excluded_vertex_face: _Array | None = None,
        excluded_edge_edge: _Array | None = None,
        fixed_motion: bool = False,
    ) -> Bodies: ...
    @staticmethod
    def of_obstacles(is_static: _Flags) -> Bodies:
        """Static vertices are body 1, which is fixed; all others are body 0."""
    @staticmethod
    def of_patches(patches: _Array) -> Bodies:
        """Each patch of vertices is a body, without self-contact."""
    @staticmethod
    def of_components(mesh: Mesh, self_contact: bool = True) -> Bodies:
        """Each connected component of a mesh is a body."""
    @property
    def of_vertex(self) -> _Ids:
        """The body of each vertex, (n_vertices,)."""
    @property
    def fixed_motion(self) -> bool:
        """Whether bodies that are fixed or asleep may be moved by the caller."""
    def wants(self, v: int, w: int) -> bool:
        """Whether features of the bodies of these two vertices are looked at."""
    def excludes(self, kind: int, a: int, b: int) -> bool:
        """Whether a pair of features is excluded, by its Kind and the ids of both."""
    def is_fixed(self, v: int) -> bool:
        """Whether the body of a vertex is fixed."""
    def world(self, v: int) -> int:
        """The world of a vertex."""
    def to_json(self) -> str:
        """The body of each vertex and all rules, as text."""
    @staticmethod
    def from_json(text: str) -> Bodies:
        """Bodies from the text of to_json."""
    def __eq__(self, value: object, /) -> bool: ...
    def __reduce__(self) -> tuple[Callable[[str], Bodies], tuple[str]]: ...

@final
class Options:
    """What a session looks for, and how."""

    def __new__(
        cls,
        *,
        min_distance: float | None = None,
        threads: int | None = None,
        bodies: Bodies | _Array | None = None,
        fixed: _Flags | None = None,
        self_contact: bool | None = None,
        max_memory: int | None = None,
        tolerance: float | None = None,
        mode: _Mode | None = None,
        leave_contact: bool | None = None,
        method: str | None = None,
        builder: str | None = None,
        traversal: str | None = None,
        volume: str | None = None,
        pipeline: str | None = None,
        scheduler: str | None = None,
        front: str | None = None,
    ) -> Options: ...
    @property
    def min_distance(self) -> float:
        """Contact means a distance of at most this."""
    @property
    def threads(self) -> int:
        """Threads on the CPU, 0 for all cores."""
    @property
    def bodies(self) -> Bodies | None:
        """Bodies and the rules of their pairs, if there are any."""
    @property
    def max_memory(self) -> int | None:
        """Bytes that a session may hold."""
    @property
    def tolerance(self) -> float:
        """How early a certain time of impact may be."""
    @property
    def mode(self) -> _Mode:
        """Auto, conservative or exact."""
    @property
    def leave_contact(self) -> bool:
        """Whether features that are in contact at the start may separate."""
    @property
    def method(self) -> str:
        """The broad phase; of a tree with its builder, its traversal and its volume."""
    @property
    def pipeline(self) -> str:
        """What is looked for in boxes: pairs of features, or of triangles."""
    @property
    def scheduler(self) -> str | None:
        """How work is shared out; None: as the method does by itself."""
    @property
    def front(self) -> str:
        """Whether descents begin where the last ones ended."""
    def to_json(self) -> str:
        """All options as text, bodies with their rules too."""
    @staticmethod
    def from_json(text: str) -> Options:
        """Options from the text of to_json."""
    def __eq__(self, value: object, /) -> bool: ...
    def __reduce__(self) -> tuple[Callable[[str], Options], tuple[str]]: ...

@final
class CancelToken:
    """Ends the calls of sessions that have it, from any thread."""

    def __new__(cls) -> CancelToken: ...
    def cancel(self) -> None:
        """Ends the calls that run, and all later ones."""
    @property
    def is_cancelled(self) -> bool:
        """Whether it is cancelled."""

@final
class Session:
    """Continuous collision detection of one mesh over many steps."""

    def __new__(
        cls,
        mesh: Mesh,
        options: Options | None = None,
        *,
        device: str | None = None,
        min_distance: float | None = None,
        threads: int | None = None,
        bodies: Bodies | _Array | None = None,
        fixed: _Flags | None = None,
        self_contact: bool | None = None,
        max_memory: int | None = None,
        tolerance: float | None = None,
        mode: _Mode | None = None,
        leave_contact: bool | None = None,
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
    def options(self) -> Options:
        """The options of the next step."""
    @property
    def place(self) -> str:
        """Where steps run: "2 threads", or the name of the GPU."""
    @property
    def last_place(self) -> str:
        """Where the last step ran: `place`, or the CPU for one on a GPU in which little moved."""
    def step(
        self, x0: _Array, x1: _Array, window: Sequence[float] | None = None
    ) -> Report:
        """Every contact of the step that exists in a window of time."""
    def step_many(self, frames: _Array | Iterable[_Array]) -> list[Report]:
        """A report of each step of an animation: from each of these positions to the next."""
    def earliest_toi(self, x0: _Array, x1: _Array) -> float | None:
        """The earliest time of impact; None if all of the step is free."""
    def first_contact(self, x0: _Array, x1: _Array) -> Hit | None:
        """The first contact with its point and normal; None if all of the step is free."""
    def collision_free_stepsize(self, x0: _Array, x1: _Array) -> float:
        """The part of the step that is free of contact, in [0, 1]."""
    def is_step_collision_free(self, x0: _Array, x1: _Array) -> bool:
        """Whether nothing touches during the step, both ends included."""
    def set_positions(self, x: _Array) -> None:
        """From now on all vertices stand there, until step_bodies moves some."""
    def step_bodies(self, motions: Sequence[tuple[int, _Array, _Array]]) -> Report:
        """Every contact of a step in which these bodies move: (body, x0, x1) of each, positions
        of its vertices, or poses (4, 4) that move them from those of set_positions."""
    def earliest_toi_of_bodies(
        self, motions: Sequence[tuple[int, _Array, _Array]]
    ) -> float | None:
        """The earliest time of impact of a step in which these bodies move."""
    def first_contact_of_bodies(
        self, motions: Sequence[tuple[int, _Array, _Array]]
    ) -> Hit | None:
        """The first contact of a step in which these bodies move."""
    def candidates(
        self, x0: _Array, x1: _Array
    ) -> tuple[
        _Ids, _Ids, _Ids, _Ids
    ]:
        """Pairs whose swept boxes overlap, an array (n, 2) for each Kind."""
    def intersections(self, x: _Array) -> _Ids:
        """Edges and faces that have a point in common at the positions x, (n, 2)."""
    def has_intersections(self, x: _Array) -> bool:
        """Whether there are any at the positions x; the search ends with the first."""
    def candidate_set(
        self, x0: _Array, x1: _Array, inflation: float = 0.0
    ) -> CandidateSet:
        """Candidates for all steps of vertices at most inflation outside of this one."""
    def set_mesh(self, mesh: Mesh, bodies: Bodies | _Array | None = None) -> None:
        """From now on steps of another mesh, with other bodies if some are given."""
    def set_bodies(self, bodies: Bodies | _Array | None = None) -> None:
        """From now on these bodies, or none."""
    def set_min_distance(self, min_distance: float) -> None:
        """From now on another min_distance."""
    def set_sleeping(self, body: int, sleeping: bool) -> None:
        """From now on a body sleeps, or is awake."""
    def set_fixed(self, body: int, fixed: bool) -> None:
        """From now on a body is fixed, or moves."""
    def set_fixed_motion(self, may_move: bool) -> None:
        """From now on bodies that are fixed or asleep may be moved by the caller, or not."""
    def set_options(
        self,
        options: Options | None = None,
        *,
        min_distance: float | None = None,
        threads: int | None = None,
        bodies: Bodies | _Array | None = None,
        fixed: _Flags | None = None,
        self_contact: bool | None = None,
        max_memory: int | None = None,
        tolerance: float | None = None,
        mode: _Mode | None = None,
        leave_contact: bool | None = None,
        method: str | None = None,
        builder: str | None = None,
        traversal: str | None = None,
        volume: str | None = None,
        pipeline: str | None = None,
        scheduler: str | None = None,
        front: str | None = None,
    ) -> None:
        """From now on these options, or those of before, with each that is named changed."""
    def set_cancel_token(self, token: CancelToken | None = None) -> None:
        """From now on calls end with a RuntimeError once this token is cancelled."""
    def set_filter(
        self, filter: Callable[[int, _Ids], _Flags] | None = None
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
    def earliest_toi(self, x0: _Array, x1: _Array) -> float | None:
        """The earliest time of impact; None if all of the step is free."""
    def collision_free_stepsize(self, x0: _Array, x1: _Array) -> float:
        """The part of the step that is free of contact, in [0, 1]."""
    def is_step_collision_free(self, x0: _Array, x1: _Array) -> bool:
        """Whether nothing touches during the step, both ends included."""

@final
class Report:
    """What a step found: arrays with an entry for each contact."""

    def __new__(cls, **parts: object) -> Report: ...
    @property
    def kind(self) -> NDArray[np.uint8]:
        """Kind of each contact."""
    @property
    def a(self) -> _Ids:
        """The vertex of a vertex-face or vertex-edge pair; else the lesser edge or vertex."""
    @property
    def b(self) -> _Ids:
        """The face or edge that the vertex `a` touches; else the greater edge or vertex."""
    @property
    def toi(self) -> NDArray[np.float64]:
        """Time of impact in [0, 1]; never late."""
    @property
    def state(self) -> NDArray[np.uint8]:
        """How certain: State.HIT or State.UNDECIDED."""
    @property
    def approach(self) -> NDArray[np.uint8]:
        """Whether features come nearer at the time of impact: an Approach."""
    @property
    def vertices(self) -> _Ids:
        """v f0 f1 f2, or ea0 ea1 eb0 eb1: (n, 4)."""
    @property
    def contacts(self) -> NDArray[np.void]:
        """All columns but approach and vertices in one structured array."""
    @property
    def earliest_toi(self) -> float | None:
        """Least time of impact; None without contact."""
    @property
    def n_candidates(self) -> _PerKind:
        """Numbers of candidates in the order of Kind."""
    @property
    def n_filtered(self) -> _PerKind:
        """Numbers of candidates that the filters left open, in the order of Kind."""
    @property
    def n_contacts(self) -> _PerKind:
        """Numbers of contacts in the order of Kind."""
    @property
    def n_undecided(self) -> int:
        """Number of contacts that are undecided."""
    @property
    def triangles(self) -> dict[str, int] | None:
        """Figures of pairs of triangles; None but with the pipeline "triangles"."""
    @property
    def front(self) -> dict[str, int] | None:
        """Figures of the front; None without one."""
    @property
    def rebuilt(self) -> bool:
        """Whether trees were built anew rather than refitted."""
    @property
    def times(self) -> dict[str, float]:
        """Where the time went, in milliseconds."""
    @property
    def toi_of_worlds(self) -> NDArray[np.float64] | None:
        """Least time of impact of each world, infinity where there is none."""
    @property
    def mesh(self) -> Mesh:
        """The mesh of the step."""
    def geometry(self, x0: _Array, x1: _Array) -> Geometry:
        """Points, normals and weights, from the positions of the step."""
    def __len__(self) -> int: ...
    def __getnewargs_ex__(self) -> tuple[tuple[()], dict[str, object]]: ...

@final
class Geometry:
    """How features meet at the times of impact: arrays with an entry for each contact."""

    def __new__(cls, **parts: object) -> Geometry: ...
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
    def __getnewargs_ex__(self) -> tuple[tuple[()], dict[str, object]]: ...

@final
class Hit:
    """The first contact of a step."""

    def __new__(cls, **parts: object) -> Hit: ...
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
    def features(self) -> tuple[int, int]:
        """Vertex and face, or the lesser and the greater edge."""
    @property
    def bodies(self) -> tuple[int, int]:
        """The bodies of the features."""
    @property
    def vertices(self) -> _Ids:
        """v f0 f1 f2, or ea0 ea1 eb0 eb1: (4,)."""
    @property
    def point(self) -> NDArray[np.float64]:
        """Where they meet, (3,)."""
    @property
    def normal(self) -> NDArray[np.float64]:
        """Unit vector from the second feature towards the first, (3,)."""
    @property
    def weights(self) -> NDArray[np.float64]:
        """Of each of the vertices, in the point of its feature, (4,)."""
    @property
    def distance(self) -> float:
        """How far the features are apart at that time."""
    def normal_towards(self, body: int) -> NDArray[np.float64]:
        """The normal that points towards body, away from what it touches."""
    def __getnewargs_ex__(self) -> tuple[tuple[()], dict[str, object]]: ...

@final
class BroadPhase:
    """Finds overlapping boxes; keeps its buffers between calls."""

    def __new__(
        cls,
        *,
        threads: int = 0,
        device: str | None = None,
        method: str | None = None,
        builder: str | None = None,
        traversal: str | None = None,
        volume: str | None = None,
        scheduler: str | None = None,
        front: str | None = None,
    ) -> BroadPhase: ...
    @property
    def place(self) -> str:
        """Where it runs: "2 threads", or the name of the GPU."""
    @property
    def times(self) -> dict[str, float] | None:
        """Where the time of the last call went, in milliseconds; None on a GPU."""
    @property
    def visits(self) -> int | None:
        """How many nodes of a tree, or pairs of nodes, the last call visited."""
    @property
    def tree_statistics(self) -> dict[str, float] | None:
        """Figures of the binary tree of the last call, by name."""
    def self_pairs(self, boxes: _Array) -> _Ids:
        """Pairs within one set of boxes (n, 2, 3), each once, the lesser index first."""
    def pairs(self, a: _Array, b: _Array) -> _Ids:
        """Pairs of a box of a with a box of b."""

def vertex_face(
    x0: _Array, x1: _Array, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times of vertex-face queries, positions (..., 4, 3)."""

def edge_edge(
    x0: _Array, x1: _Array, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times of edge-edge queries, positions (..., 4, 3)."""

def vertex_edge(
    x0: _Array, x1: _Array, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times of vertex-edge queries, positions (..., 3, 3)."""

def vertex_vertex(
    x0: _Array, x1: _Array, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times of vertex-vertex queries, positions (..., 2, 3)."""

def distance(kind: int, x: _Array) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Least and greatest distance of features at one moment, positions (..., n, 3)."""

def exact_vertex_face(
    x0: _Array, x1: _Array, window: Sequence[float] = (0.0, 1.0)
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times (.., 2) of vertex-face queries decided exactly, positions (..., 4, 3)."""

def exact_edge_edge(
    x0: _Array, x1: _Array, window: Sequence[float] = (0.0, 1.0)
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times (.., 2) of edge-edge queries decided exactly, positions (..., 4, 3)."""

def exact_vertex_edge(
    x0: _Array, x1: _Array, window: Sequence[float] = (0.0, 1.0)
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times (.., 2) of vertex-edge queries decided exactly, positions (..., 3, 3)."""

def exact_vertex_vertex(
    x0: _Array, x1: _Array, window: Sequence[float] = (0.0, 1.0)
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """States and times (.., 2) of vertex-vertex queries decided exactly, positions (..., 2, 3)."""

def distance_type(kind: int, x: _Array) -> NDArray[np.uint8]:
    """Which parts of features are nearest, positions (..., 4, 3)."""

def squared_distance(
    kind: int, x: _Array, types: _Array | None = None
) -> NDArray[np.float64]:
    """Squared distances at one moment, positions (..., 4, 3)."""

def squared_distance_gradient(
    kind: int, x: _Array, types: _Array | None = None
) -> NDArray[np.float64]:
    """Their gradients, (..., 12)."""

def squared_distance_hessian(
    kind: int, x: _Array, types: _Array | None = None
) -> NDArray[np.float64]:
    """Their Hessians, (..., 12, 12)."""

def scaled_toi(toi: float, factor: float) -> float:
    """A time of impact times a factor in [0, 1], rounded down."""

def toi_to_f32(toi: float) -> float:
    """The greatest number that a float32 holds and that is not above a time of impact."""

def instruction_set() -> str:
    """The vector instructions that the CPU's path uses here."""

def gpus() -> list[str]:
    """Names of the GPUs of this machine."""

def methods() -> list[dict[str, object]]:
    """The choices of methods: what, name, about, source, backends, catalogue."""

def read_mesh(
    path: str | PathLike[str], first: str | PathLike[str] | None = None
) -> tuple[Mesh, NDArray[np.float64]]:
    """A mesh and its positions: OBJ, PLY, STL, OFF, glTF or GLB."""

def read_positions(
    path: str | PathLike[str], frames: Sequence[int] | None = None
) -> NDArray[np.float64]:
    """Positions over time (n_frames, n_vertices, 3): NPY, NPZ, PC2 or MDD."""

def read_queries(
    path: str | PathLike[str], kind: int | None = None
) -> tuple[
    NDArray[np.uint8], NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_] | None
]:
    """Kinds, positions at both ends (n, 4, 3) and answers of a file of queries."""
