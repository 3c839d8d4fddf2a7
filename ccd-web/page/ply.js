// PLY in text or binary of either byte order: the elements `vertex`, `face` and `edge`, as the
// command reads them.

/** Types: bytes, the method of a DataView, and the range of whole numbers. */
const TYPES = new Map();
for (const [names, size, method, range] of [
  ["char int8", 1, "getInt8", [-128, 127]], ["uchar uint8", 1, "getUint8", [0, 255]],
  ["short int16", 2, "getInt16", [-32768, 32767]], ["ushort uint16", 2, "getUint16", [0, 65535]],
  ["int int32", 4, "getInt32", [-(2 ** 31), 2 ** 31 - 1]],
  ["uint uint32", 4, "getUint32", [0, 2 ** 32 - 1]],
  ["float float32", 4, "getFloat32"], ["double float64", 8, "getFloat64"],
]) {
  names.split(" ").forEach((name) => TYPES.set(name, { size, method, range }));
}
const ENCODINGS = ["ascii", "binary_little_endian", "binary_big_endian"];
/** Names of the list of a face's vertices. */
const LISTS = ["vertex_indices", "vertex_index"];
/** Bytes of a header. */
const LONGEST_HEADER = 1 << 20;
/** The most elements that the library takes. */
const LIMIT = 2 ** 31 - 1;
const WHOLE = /^[+-]?\d+$/;
const NUMBER = /^[+-]?((\d+\.?\d*|\.\d+)(e[+-]?\d+)?|inf|infinity|nan)$/i;

/** Adds what the file holds to the mesh. */
export function readPly(bytes, mesh) {
  const { encoding, elements, begin } = header(bytes);
  if (!elements.some(({ name }) => name === "vertex")) {
    throw new Error("header: there is no element named vertex");
  }
  const isText = encoding === "ascii";
  const rows = isText ? lines(bytes, begin) : binary(bytes, begin, encoding);
  for (const element of elements) {
    const { name, count, properties } = element;
    const read = READERS[name];
    if (!read && properties.some((property) => LISTS.includes(property.name))) {
      throw new Error(`header: element \`${name}\` has lists of vertices; polygons are read from `
        + "an element named face");
    }
    if (count > LIMIT) {
      throw new Error(`header: ${count} of ${name}: at most ${LIMIT} are possible`);
    }
    // What has no properties takes no bytes, however many there are.
    if (!read && !properties.length && !isText) continue;
    for (let at = 0; at < count; at++) {
      if (rows.atEnd()) {
        throw new Error(`${name} ${at}: the file ends early; the header promises ${count}`);
      }
      try {
        const row = rows.next(element);
        read?.(row, mesh);
      } catch (why) {
        throw new Error(`${name} ${at}: ${why.message}`);
      }
    }
  }
  rows.nothingLeft();
}

/** What an element adds to the mesh. */
const READERS = Object.assign(Object.create(null), {
  vertex({ x, y, z }, mesh) {
    if (![x, y, z].every((value) => typeof value?.number === "number")) {
      throw new Error("x, y or z is missing");
    }
    mesh.x.push(x.number, y.number, z.number);
  },
  face(row, mesh) {
    const { list, whole } = row.vertex_indices ?? row.vertex_index ?? {};
    if (!list || !whole) throw new Error("has no list vertex_indices of integers");
    if (list.length < 3) throw new Error(`has ${list.length} vertices, fewer than 3`);
    mesh.pushPolygon(list);
  },
  edge({ vertex1, vertex2 }, mesh) {
    if (![vertex1, vertex2].every((end) => end?.whole && !end.list)) {
      throw new Error("has no integers vertex1 and vertex2");
    }
    mesh.edges.push(vertex1.number, vertex2.number);
  },
});

/** The elements, and where the data begins. */
function header(bytes) {
  const text = new TextDecoder("latin1").decode(bytes.subarray(0, LONGEST_HEADER));
  const found = { encoding: null, elements: [], begin: 0 };
  // Of elements, and of properties with their elements.
  const names = new Set();
  let nNames = 0;
  for (let line = 1; ; line++) {
    const end = text.indexOf("\n", found.begin);
    if (end < 0) {
      const isLonger = bytes.length > LONGEST_HEADER;
      throw new Error(`header: it ${isLonger ? "is longer than 1 MiB" : "has no end_header"}`);
    }
    const words = text.slice(found.begin, end).trimEnd().split(/[ \t]+/);
    found.begin = end + 1;
    if (words[0] === "end_header") break;
    if (line === 1 ? words.join(" ") !== "ply" : !headerLine(words, found)) {
      throw new Error(`header: line ${line} is \`${words.join(" ").slice(0, 100)}\``);
    }
    const isElement = words[0] === "element";
    if (!isElement && words[0] !== "property") continue;
    const name = words.at(isElement ? 1 : -1);
    names.add(isElement ? name : `${found.elements.at(-1).name} ${name}`);
    nNames += 1;
    if (names.size < nNames) {
      const kind = isElement ? "elements" : "properties";
      throw new Error(`header: line ${line}: \`${name}\` is the name of two ${kind}`);
    }
  }
  if (!found.encoding) throw new Error("header: it has no format");
  return found;
}

/** Whether a line of the header is one that PLY has. */
function headerLine([word, ...rest], found) {
  const last = found.elements.at(-1);
  switch (word) {
    case "comment":
    case "obj_info":
      return true;
    case "format":
      if (rest.length !== 2 || !ENCODINGS.includes(rest[0])) return false;
      if (found.encoding && found.encoding !== rest[0]) return false;
      [found.encoding] = rest;
      return /^\d+\.\d+$/.test(rest[1]);
    case "element":
      found.elements.push({ name: rest[0], count: Number(rest[1]), properties: [] });
      return rest.length === 2 && /^\d+$/.test(rest[1]);
    case "property": {
      const isList = rest[0] === "list";
      const types = rest.slice(isList ? 1 : 0, -1).map((name) => TYPES.get(name));
      if (!last || types.length !== (isList ? 2 : 1) || types.includes(undefined)) return false;
      // The length of a list is a whole number.
      if (isList && !types[0].range) return false;
      last.properties.push({ name: rest.at(-1), type: types.at(-1), length: isList && types[0] });
      return true;
    }
    default:
      return false;
  }
}

/** An element's properties, by a function that returns the next number of a type. */
function properties(element, next) {
  const row = Object.create(null);
  for (const { name, type, length } of element.properties) {
    const whole = Boolean(type.range);
    if (!length) {
      row[name] = { number: next(type), whole };
      continue;
    }
    const n = next(length);
    if (n < 0) throw new Error("the length of a list is negative");
    const list = [];
    while (list.length < n) list.push(next(type));
    row[name] = { list, whole };
  }
  return row;
}

/** Elements of a text, one a line. */
function lines(bytes, begin) {
  const text = new TextDecoder("latin1").decode(bytes.subarray(begin));
  let at = 0;
  return {
    atEnd: () => at >= text.length,
    next(element) {
      const end = text.indexOf("\n", at);
      const line = text.slice(at, end < 0 ? undefined : end).trim();
      at = end < 0 ? text.length : end + 1;
      const words = line === "" ? [] : line.split(/\s+/);
      let used = 0;
      const row = properties(element, (type) => {
        if (used === words.length) throw new Error(`\`${line}\` has fewer numbers than it needs`);
        return word(words[used++], type);
      });
      if (used < words.length) throw new Error(`\`${line}\` has more numbers than the header says`);
      return row;
    },
    nothingLeft() {
      if (text.slice(at).trim()) throw new Error("there is more than the header promises");
    },
  };
}

/** The number of a word, of a type. */
function word(text, { size, range }) {
  if (!(range ? WHOLE : NUMBER).test(text)) {
    throw new Error(`\`${text}\` is no ${range ? "whole " : ""}number`);
  }
  const value = Number(text.replace(/inf\w*/i, "Infinity"));
  if (range && (value < range[0] || value > range[1])) {
    throw new Error(`\`${text}\` does not fit its type`);
  }
  return size === 4 && !range ? Math.fround(value) : value;
}

/** Elements of binary data. */
function binary(bytes, begin, encoding) {
  const little = encoding === "binary_little_endian";
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = begin;
  const number = ({ size, method }) => {
    if (at + size > data.byteLength) throw new Error("the file ends early");
    at += size;
    return data[method](at - size, little);
  };
  return {
    atEnd: () => at >= data.byteLength,
    next: (element) => properties(element, number),
    nothingLeft() {
      const rest = bytes.subarray(at);
      if (rest.some((byte) => byte !== 0x20 && (byte < 0x09 || byte > 0x0d || byte === 0x0b))) {
        throw new Error("there is more than the header promises");
      }
    },
  };
}
