"""One scene on many processes with MPI: each rank has a part of `meshccd.partition`.

Modelled on the distributed tree of ArborX: the boxes of all ranks are on every rank, swept elements
go to the ranks whose boxes they overlap, and of two ranks the lower one owns a pair. A step takes
one `allgather` of boxes, one `Alltoallv` of elements, and one reduction of the earliest time.

    mpirun -n 4 python scene.py    # scene.py: see docs/cluster.md

It needs the package mpi4py, and an MPI. All calls but `vertices` and `part` are collective: every
rank makes them, in one order. An error of one rank is one of every rank, so none waits for ever: a
ValueError if it is one, else a RuntimeError, with the number of that rank. Ranks of one host share
its cores: give a session `Options(threads=n)`.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._local import Rules, whole_numbers
from ._native import Mesh, Options, Session
from .partition import ELEMENT, Local, Part, merge, split

if TYPE_CHECKING:
    from mpi4py import MPI

__all__ = ["Scene"]

_Ids = NDArray[np.uint32]
_T = TypeVar("_T")
#: As of `Report.contacts`.
_CONTACT = np.dtype([("kind", "u1"), ("a", "u4"), ("b", "u4"), ("toi", "f8"), ("state", "u1")])


class Scene:
    """A scene of which each rank has the elements of one part.

    Parameters
    ----------
    part : Part
        The part of this rank: of as many as there are ranks, by its number.
    options : Options, optional
        Of all steps, the same on every rank; bodies are those of the whole mesh.
    comm : MPI.Intracomm, optional
        By default `MPI.COMM_WORLD`.
    device : str, optional
        As of a `Session`: one a rank, such as "gpu:0000:3b:00.0". Where some ranks have a GPU and
        others none, name the `mode` of the options: by default times are exact on a CPU alone.

    Raises
    ------
    ValueError
        If the part is that of another rank, on any rank.
    ImportError, RuntimeError
        If there is no mpi4py, or no MPI that it can load.
    """

    def __init__(
        self,
        part: Part,
        options: Options | None = None,
        *,
        comm: MPI.Intracomm | None = None,
        device: str | None = None,
    ) -> None:
        self.part: Part = part
        self._comm = _world() if comm is None else comm
        self._options = Options() if options is None else options
        self._device = device
        self._session: Session | None = None
        self._rules: Rules | None = _together(self._comm, self._checked)

    @classmethod
    def of_mesh(
        cls,
        mesh: Mesh,
        x: ArrayLike,
        options: Options | None = None,
        *,
        comm: MPI.Intracomm | None = None,
        device: str | None = None,
    ) -> Scene:
        """A scene of a mesh that every rank has read; x as for `partition.split`. Where one rank
        alone has it, it calls `split` and scatters the parts."""
        comm = _world() if comm is None else comm

        def mine() -> Part:
            bodies = None if options is None else options.bodies
            if bodies is not None and len(bodies.of_vertex) != mesh.n_vertices:
                n = len(bodies.of_vertex)
                raise ValueError(f"there are {n} bodies, the mesh has {mesh.n_vertices} vertices")
            return split(mesh, x, comm.size)[comm.rank]

        part = _together(comm, mine)
        return cls(part, options, comm=comm, device=device)

    @property
    def vertices(self) -> _Ids:
        """Ids of the vertices of this rank's elements, ascending, (n,): of whose positions steps
        are made. Some are on several ranks, with the same positions."""
        return self.part.vertices

    def step(self, x0: ArrayLike, x1: ArrayLike) -> NDArray[np.void]:
        """The contacts that this rank owns, as `Report.contacts`, with the numbers of the whole
        mesh: those of all ranks together are those of one process.

        Parameters
        ----------
        x0, x1 : (n, 3) arrays
            Positions of `vertices` at the start and at the end of the step.

        Raises
        ------
        ValueError
            If one rank refuses its positions or options, on every rank.
        """
        local = self._exchange(x0, x1)
        return _together(self._comm, lambda: self._contacts(local))

    def earliest_toi(self, x0: ArrayLike, x1: ArrayLike) -> float | None:
        """The earliest time of impact of the whole scene, on every rank; None if all is free."""
        local = self._exchange(x0, x1)
        toi = _together(self._comm, lambda: local.earliest_toi(self._on(local)))
        from mpi4py import MPI

        least: float = self._comm.allreduce(np.inf if toi is None else toi, MPI.MIN)
        return None if least == np.inf else least

    def collision_free_stepsize(self, x0: ArrayLike, x1: ArrayLike) -> float:
        """The part of the step that is free of contact in the whole scene, in [0, 1]."""
        toi = self.earliest_toi(x0, x1)
        return 1.0 if toi is None else toi

    def gather(self, contacts: NDArray[np.void], root: int = 0) -> NDArray[np.void] | None:
        """The contacts of all ranks on one, sorted as by one process; None on the others.

        Raises
        ------
        ValueError
            If one rank gives no contacts, or a root that is no rank, on every rank.
        """
        given = _together(self._comm, lambda: _sent(contacts, root, self._comm.size))
        parts = self._comm.gather(given, root)
        return _together(self._comm, lambda: None if parts is None else merge(parts))

    def _checked(self) -> Rules | None:
        """What steps need of the bodies of the whole mesh."""
        rank, size = self._comm.rank, self._comm.size
        if (self.part.index, self.part.n_parts) != (rank, size):
            raise ValueError(f"{self.part!r} is not that of rank {rank} of {size}")
        bodies = self._options.bodies
        return None if bodies is None else Rules(json.loads(bodies.to_json()))

    def _exchange(self, x0: ArrayLike, x1: ArrayLike) -> Local:
        """The mesh of this rank and its halo."""
        from mpi4py import MPI

        comm, part, options = self._comm, self.part, self._options
        boxes = comm.allgather(_together(comm, lambda: part.boxes(x0, x1, options.min_distance)))
        outgoing = _together(comm, lambda: part.outgoing(x0, x1, boxes, options.min_distance))
        n_sent = np.array([len(of) for of in outgoing])
        n_received = np.array(comm.alltoall(n_sent.tolist()))
        sent, received = _together(
            comm, lambda: (np.concatenate(outgoing), np.empty(n_received.sum(), ELEMENT))
        )
        # An element is one item, so that counts stay below 2^31.
        item = MPI.BYTE.Create_contiguous(ELEMENT.itemsize).Commit()
        try:
            comm.Alltoallv(
                [sent, (n_sent, _starts(n_sent)), item],
                [received, (n_received, _starts(n_received)), item],
            )
        finally:
            item.Free()
        return _together(comm, lambda: part.local(x0, x1, [received]))

    def _contacts(self, local: Local) -> NDArray[np.void]:
        session = self._on(local)
        with whole_numbers(local):
            return local.contacts(session.step(local.x0, local.x1))

    def _on(self, local: Local) -> Session:
        bodies = None if self._rules is None else self._rules.bodies(local)
        options, device = self._options, self._device
        with whole_numbers(local):
            if self._session is None:
                self._session = Session(local.mesh, options, bodies=bodies, device=device)
            else:
                self._session.set_mesh(local.mesh, bodies)
        return self._session


def _together(comm: MPI.Intracomm, call: Callable[[], _T]) -> _T:
    """The result of a call, once it has succeeded on every rank. An error between two collective
    calls that does not pass through here leaves the other ranks waiting."""
    try:
        result, why = call(), None
    except BaseException as error:  # Also an interrupt, which the others cannot know of.
        result, why = None, error
    # The words alone: not every error can be pickled.
    said = None if why is None else (isinstance(why, ValueError), str(why) or type(why).__name__)
    failed = [(rank, of) for rank, of in enumerate(comm.allgather(said)) if of is not None]
    if why is not None:
        raise why
    if failed:
        rank, (is_value, words) = failed[0]
        raise (ValueError if is_value else RuntimeError)(f"rank {rank}: {words}")
    return result  # type: ignore[return-value]


def _world() -> MPI.Intracomm:
    from mpi4py import MPI

    return MPI.COMM_WORLD


def _sent(contacts: object, root: int, n_ranks: int) -> NDArray[np.void]:
    """Contacts that can be sent to the root."""
    if not 0 <= root < n_ranks:
        raise ValueError(f"root is {root}; there are {n_ranks} ranks")
    array = np.asarray(contacts)
    if array.ndim != 1 or array.dtype != _CONTACT:
        raise ValueError(
            f"contacts are an array of {array.dtype} with the shape {array.shape}; they must be as "
            "`step` returns them"
        )
    return array


def _starts(counts: NDArray[np.int64]) -> NDArray[np.int64]:
    return np.concatenate([[0], np.cumsum(counts)[:-1]]).astype(np.int64)
