from collections.abc import Sequence
from typing import Final, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "BroadPhase",
    "Mesh",
    "Report",
    "Session",
    "__version__",
    "edge_edge",
    "vertex_face",
]

__version__: Final[str]

@final
class Mesh:
    def __new__(
        cls,
        faces: ArrayLike,
        edges: ArrayLike | None = None,
        *,
        n_vertices: int | None = None,
    ) -> Mesh: ...
    @property
    def n_vertices(self) -> int: ...
    @property
    def faces(self) -> NDArray[np.uint32]: ...
    @property
    def edges(self) -> NDArray[np.uint32]: ...

@final
class Session:
    def __new__(
        cls,
        mesh: Mesh,
        *,
        min_distance: float = 0.0,
        threads: int = 0,
        bodies: ArrayLike | None = None,
        fixed: Sequence[bool] | NDArray[np.bool_] | None = None,
        self_contact: bool | None = None,
        device: str | None = None,
        max_memory: int | None = None,
    ) -> Session: ...
    @property
    def mesh(self) -> Mesh: ...
    @property
    def place(self) -> str: ...
    def step(self, x0: ArrayLike, x1: ArrayLike) -> Report: ...
    def earliest_toi(self, x0: ArrayLike, x1: ArrayLike) -> float | None: ...
    def collision_free_stepsize(self, x0: ArrayLike, x1: ArrayLike) -> float: ...
    def is_step_collision_free(self, x0: ArrayLike, x1: ArrayLike) -> bool: ...
    def candidates(
        self, x0: ArrayLike, x1: ArrayLike
    ) -> tuple[
        NDArray[np.uint32], NDArray[np.uint32], NDArray[np.uint32], NDArray[np.uint32]
    ]: ...

@final
class Report:
    @property
    def kind(self) -> NDArray[np.uint8]: ...
    @property
    def a(self) -> NDArray[np.uint32]: ...
    @property
    def b(self) -> NDArray[np.uint32]: ...
    @property
    def toi(self) -> NDArray[np.float64]: ...
    @property
    def state(self) -> NDArray[np.uint8]: ...
    @property
    def vertices(self) -> NDArray[np.uint32]: ...
    @property
    def contacts(self) -> NDArray[np.void]: ...
    @property
    def earliest_toi(self) -> float | None: ...
    @property
    def n_candidates(self) -> tuple[int, int, int, int]: ...
    @property
    def n_undecided(self) -> int: ...
    @property
    def times(self) -> dict[str, float]: ...
    def __len__(self) -> int: ...

@final
class BroadPhase:
    def __new__(
        cls,
        *,
        threads: int = 0,
        method: str = "blocks",
        device: str | None = None,
    ) -> BroadPhase: ...
    def self_pairs(self, boxes: ArrayLike) -> NDArray[np.uint32]: ...
    def pairs(self, a: ArrayLike, b: ArrayLike) -> NDArray[np.uint32]: ...

def vertex_face(
    x0: ArrayLike, x1: ArrayLike, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]: ...
def edge_edge(
    x0: ArrayLike, x1: ArrayLike, min_distance: float = 0.0
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]: ...
