"""Writes a small corpus for every target below the folder that is named, by default `corpus`."""

import base64
import io
import json
import struct
import sys
import zipfile
from pathlib import Path

root = Path(sys.argv[1] if len(sys.argv) > 1 else "corpus")
points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.25), (2, 0, 0.1)]
faces = [(0, 1, 2), (0, 2, 3), (1, 4, 2)]
floats = [float(x) for p in points for x in p]


def seed(target, name, data):
    folder = root / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(data.encode() if isinstance(data, str) else data)


def lines(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


one = lambda rows: [[i + 1 for i in row] for row in rows]
seed("obj", "plain", "".join("v " + l for l in lines(points).splitlines(True))
     + "".join("f " + l for l in lines(one(faces)).splitlines(True)) + "l 1 2 5\n")
seed("obj", "words", "\ufeff# a\rv 0 0 0 1\r\nv 1 0 0 .1 .2 .3\nvn 0 0 1\nv 0 1 0 1 1 1 1\n"
     "f -3/1/1 -2//1 \\\n-1/1\ng a\nusemtl b\nl 1/2 3\n")
counts = f"{len(points)} {len(faces)} 0\n"
body = lines(points) + lines([3, *f] for f in faces)
seed("off", "plain", "OFF\n" + counts + body)
seed("off", "colours", "COFF # x\n3 1\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 1\n3 0 1 2 9 9\n")
solid = "solid a\n"
binary = b"x" * 80 + struct.pack("<I", len(faces))
for face in faces:
    corners = [points[i] for i in face]
    solid += "facet normal 0 0 1\nouter loop\n" + lines(["vertex", *p] for p in corners)
    solid += "endloop\nendfacet\n"
    binary += struct.pack("<12fH", 0, 0, 1, *[x for p in corners for x in p], 0)
seed("stl", "text", solid + "endsolid a\n")
seed("stl", "binary", binary)
for kind in ["ascii", "binary_little_endian", "binary_big_endian"]:
    head = (f"ply\nformat {kind} 1.0\ncomment a\nelement vertex 5\nproperty float x\n"
            "property float y\nproperty double z\nproperty uchar red\nelement other 1\n"
            "property list uchar short a\nelement face 3\n"
            "property list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\n"
            "property uint vertex2\nend_header\n")
    if kind == "ascii":
        rest = (lines([*p, 7] for p in points) + "2 5 6\n" + body.split("\n", 5)[5]
                + "0 4\n").encode()
    else:
        end = "<" if "little" in kind else ">"
        rest = b"".join(struct.pack(end + "ffdB", *p, 7) for p in points)
        rest += struct.pack(end + "Bhh", 2, 5, 6)
        rest += b"".join(struct.pack(end + "B3i", 3, *f) for f in faces)
        rest += struct.pack(end + "iI", 0, 4)
    seed("ply", kind, head.encode() + rest)
data = struct.pack(f"<{len(floats)}f", *floats) + struct.pack("<9H", *sum(faces, ()))


def scene(uri, mode=4, sparse=False, node={"mesh": 0}):
    views = [{"buffer": 0, "byteLength": 60}, {"buffer": 0, "byteOffset": 60, "byteLength": 18}]
    ends = {"type": "VEC3", "componentType": 5126, "min": [0, 0, 0], "max": [2, 1, 1]}
    positions = {"bufferView": 0, "count": 5, **ends}
    if sparse:
        views[0]["byteStride"] = 12
        positions["sparse"] = {"count": 2, "values": {"bufferView": 0}, "indices":
                               {"bufferView": 1, "byteOffset": 2, "componentType": 5123}}
    indices = {"bufferView": 1, "componentType": 5123, "count": 9, "type": "SCALAR"}
    primitive = {"attributes": {"POSITION": 0}, "indices": 1, "mode": mode}
    buffer = {"byteLength": 78, **({"uri": uri} if uri else {})}
    return json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                       "nodes": [node, {"mesh": 0, "scale": [2, 2, 2]}],
                       "meshes": [{"primitives": [primitive]}], "accessors": [positions, indices],
                       "bufferViews": views, "buffers": [buffer]}, separators=(",", ":"))


uri = "data:a;base64," + base64.b64encode(data).decode()
for mode in range(7):
    seed("gltf", f"mode{mode}", scene(uri, mode))
seed("gltf", "sparse", scene(uri, sparse=True))
seed("gltf", "nodes", scene(uri, node={"children": [1], "rotation": [0, 0, 0, 1]}))
text = scene(None).encode()
text += b" " * (-len(text) % 4)
data += b"\0" * (-len(data) % 4)
chunks = struct.pack("<I4s", len(text), b"JSON") + text
chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
seed("glb", "plain", b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks)


def npy(kind, version=1):
    head = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': (2, 5, 3), }}\n".encode()
    size = struct.pack("<H" if version == 1 else "<I", len(head))
    end, letter = kind[0], "f" if kind[2] == "4" else "d"
    return (b"\x93NUMPY" + bytes([version, 0]) + size + head
            + struct.pack(f"{end}30{letter}", *floats, *floats))


for at, kind in enumerate(["<f4", "<f8", ">f4", ">f8"]):
    seed("npy", f"kind{at}", npy(kind, 1 + at % 3))
for how in [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED]:
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", how) as z:
        z.writestr("times.npy", b"\x93NUMPY")
        z.writestr("x.npy", npy("<f4"))
    seed("npz", f"how{how}", archive.getvalue())
numbers = floats + floats
seed("pc2", "plain", b"POINTCACHE2\0" + struct.pack("<IIffI30f", 1, 5, 0, 1, 2, *numbers))
seed("mdd", "plain", struct.pack(">II2f30f", 2, 5, 0, 1, *numbers))
row = "-3,4,5,1,1,1024"
seed("csv", "answers", "".join(f"{row},{q}\n" for q in [0, 1] for _ in range(8)))
seed("csv", "plain", f'"1", 2 ,0,1,0,-1\r\n{row}\r\n' * 4)
seed("bodies", "lines", "0\n0\n1\n2\n")
seed("bodies", "commas", "\ufeff0, 7,\t16777215\r\n3\n")
part = lambda i, n: json.dumps({"steps": 1, "contacts": 2, "undecided": 0, "at_start": 0,
                                "free_steps": 0, "rebuilt": 1, "median_ms": 0.5, "total_ms": 0.5,
                                "mesh": {"vertices": 5, "edges": 7, "faces": 3},
                                "part": {"index": i, "of": n, "all_steps": n}}) + "\n"
times = {name: 0.1 for name in ["load", "boxes", "build", "traverse", "narrow", "total"]}
step = lambda at: json.dumps({"frame": at, "file": "a.ply", "candidates": {"vf": 3, "ee": 4},
                              "contacts": {"vf": 1, "ee": 1, "ve": 0}, "undecided": 0,
                              "at_start": 0, "toi": 0.5, "rebuilt": True,
                              "times_ms": times}) + "\n"
seed("merge", "one", step(0) + part(1, 1))
seed("merge", "two", step(1) + part(2, 2) + "\0" + step(0) + part(1, 2))
seed("merge", "object", '{"summary":{}}')
rows = "frame,kind,a,b\n0,vf,1,2\n1,ee,3,4\n"
seed("merge", "rows", rows + "\0" + rows.replace("\n0", "\n2").replace("\n1", "\n3"))
