// Readers of meshes: OBJ, and PLY in text or binary of either byte order; polygons become fans.

/** Names of files that are read. */
export const EXTENSIONS = [".obj", ".ply"];

/** Positions, faces, and the file's polygon of each face; an Error says what is wrong. */
export function readMesh(bytes, name) {
  const mesh = { x: [], faces: [], polygons: [], nPolygons: 0 };
  const isPly = new TextDecoder("latin1").decode(bytes.subarray(0, 3)) === "ply";
  try {
    if (isPly) readPly(bytes, mesh);
    else if (name.toLowerCase().endsWith(".obj")) readObj(new TextDecoder().decode(bytes), mesh);
    else throw new Error(`this page reads ${EXTENSIONS.join(" and ")} files`);
    if (mesh.x.length === 0) throw new Error("there are no vertices");
    const wrong = mesh.x.findIndex((value) => !Number.isFinite(value));
    if (wrong >= 0) throw new Error(`vertex ${Math.floor(wrong / 3)} is not finite`);
  } catch (why) {
    throw new Error(`${name}: ${why.message}`);
  }
  return {
    x: Float64Array.from(mesh.x),
    faces: Uint32Array.from(mesh.faces),
    polygons: Uint32Array.from(mesh.polygons),
  };
}

/** Appends a polygon as a fan of triangles. */
function pushPolygon(mesh, corners) {
  if (corners.length < 3) throw new Error(`face ${mesh.nPolygons} has ${corners.length} corners`);
  const n = mesh.x.length / 3;
  const wrong = corners.find((v) => !Number.isInteger(v) || v < 0 || v >= n);
  if (wrong !== undefined) {
    throw new Error(`face ${mesh.nPolygons} refers to vertex ${wrong}; there are ${n} vertices`);
  }
  for (let i = 1; i + 1 < corners.length; i++) {
    mesh.faces.push(corners[0], corners[i], corners[i + 1]);
    mesh.polygons.push(mesh.nPolygons);
  }
  mesh.nPolygons += 1;
}

function readObj(text, mesh) {
  const polygons = [];
  text.split("\n").forEach((line, at) => {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === "v") {
      const numbers = rest.slice(0, 3).map(Number);
      if (numbers.length < 3 || numbers.some(Number.isNaN)) {
        throw new Error(`line ${at + 1}: a vertex needs 3 numbers`);
      }
      mesh.x.push(...numbers);
    } else if (word === "f") {
      // A negative id counts back from the last vertex so far.
      const n = mesh.x.length / 3;
      const id = (corner) => Number.parseInt(corner, 10);
      polygons.push(rest.map((corner) => (id(corner) < 0 ? n + id(corner) : id(corner) - 1)));
    }
  });
  polygons.forEach((corners) => pushPolygon(mesh, corners));
}

/** Types of PLY: bytes, and the method of a DataView. */
const TYPES = {};
for (const [names, size, method] of [
  ["char int8", 1, "getInt8"], ["uchar uint8", 1, "getUint8"],
  ["short int16", 2, "getInt16"], ["ushort uint16", 2, "getUint16"],
  ["int int32", 4, "getInt32"], ["uint uint32", 4, "getUint32"],
  ["float float32", 4, "getFloat32"], ["double float64", 8, "getFloat64"],
]) {
  names.split(" ").forEach((name) => { TYPES[name] = { size, method }; });
}

/** The header, and where the data begins. */
function plyHeader(bytes) {
  const text = new TextDecoder("latin1").decode(bytes.subarray(0, 65536));
  const end = /end_header\r?\n/.exec(text);
  if (!end) throw new Error("header: it has no end_header");
  const [header, begin] = [{ format: "", elements: [] }, end.index + end[0].length];
  const known = (type) => {
    if (!TYPES[type]) throw new Error(`header: unknown type ${type}`);
    return TYPES[type];
  };
  for (const line of text.slice(0, end.index).split(/\r?\n/)) {
    const words = line.trim().split(/\s+/);
    if (words[0] === "format") [, header.format] = words;
    if (words[0] === "element") {
      header.elements.push({ name: words[1], count: Number(words[2]), properties: [] });
    }
    if (words[0] === "property") {
      const isList = words[1] === "list";
      header.elements.at(-1)?.properties.push({
        name: words.at(-1),
        length: isList ? known(words[2]) : null,
        type: known(words[isList ? 3 : 1]),
      });
    }
  }
  return { ...header, begin };
}

function readPly(bytes, mesh) {
  const { format, elements, begin } = plyHeader(bytes);
  const next = format === "ascii" ? words(bytes, begin) : binary(bytes, begin, format);
  for (const { name, count, properties } of elements) {
    for (let i = 0; i < count; i++) {
      const row = {};
      for (const property of properties) {
        if (property.length) {
          const n = next(property.length);
          row[property.name] = Array.from({ length: n }, () => next(property.type));
        } else {
          row[property.name] = next(property.type);
        }
      }
      if (name === "vertex") mesh.x.push(row.x, row.y, row.z);
      if (name === "face") pushPolygon(mesh, row.vertex_indices ?? row.vertex_index ?? []);
    }
  }
}

/** A function of a type that returns the next number of a text. */
function words(bytes, begin) {
  const all = new TextDecoder("latin1").decode(bytes.subarray(begin)).trim().split(/\s+/);
  let at = 0;
  return () => {
    if (at >= all.length) throw new Error("the file ends early");
    return Number(all[at++]);
  };
}

/** A function of a type that returns the next number of binary data. */
function binary(bytes, begin, format) {
  if (!format.startsWith("binary_")) throw new Error(`header: unknown format ${format}`);
  const little = format === "binary_little_endian";
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = begin;
  return ({ size, method }) => {
    if (at + size > data.byteLength) throw new Error("the file ends early");
    at += size;
    return data[method](at - size, little);
  };
}
