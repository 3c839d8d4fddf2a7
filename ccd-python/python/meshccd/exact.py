"""Single queries decided exactly, one or many at once: of the coordinates as they are.

`vertex_face`, `edge_edge`, `vertex_edge`, `vertex_vertex`: as those of `meshccd`, but with a window
of time instead of a distance, and with times of impact rounded down and up.
"""

from ._native import exact_edge_edge as edge_edge
from ._native import exact_vertex_edge as vertex_edge
from ._native import exact_vertex_face as vertex_face
from ._native import exact_vertex_vertex as vertex_vertex

__all__ = ["edge_edge", "vertex_edge", "vertex_face", "vertex_vertex"]
