// OBJ: the statements `v`, `f` and `l`, as the command reads them; other statements of the format
// are passed over, all else is refused.

/** Statements that hold neither vertices nor what joins them. */
const PASSED_OVER = new Set((
  "vn vt vp o g s mtllib usemtl p cstype deg parm trim hole scrv sp end con mg bevel c_interp "
  + "d_interp lod shadow_obj trace_obj ctech stech bmat step usemap maplib"
).split(" "));
const FREE_FORM = ["curv", "curv2", "surf"];
/** Control characters that no text has. */
const CONTROL = /[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]/;
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const INTEGER = /^[+-]?\d+$/;
/** The greatest coordinate that the library takes. */
const LIMIT = 1e100;

/** Adds what the file holds to the mesh. */
export function readObj(bytes, mesh) {
  for (const [text, line] of statements(new TextDecoder().decode(bytes))) {
    try {
      statement(text, mesh);
    } catch (why) {
      throw new Error(`line ${line}: ${why.message}`);
    }
  }
}

/**
 * Statements with the numbers of their lines. A line that ends with `\` goes on in the next; `#`
 * starts a comment, which ends with its line.
 */
function statements(text) {
  const all = [];
  let [begun, first] = ["", 0];
  text.split(/\r\n|\r|\n/).forEach((line, at) => {
    if (!begun) first = at + 1;
    if (line.endsWith("\\") && !line.includes("#")) {
      begun += `${line.slice(0, -1)} `;
      return;
    }
    all.push([begun + line, first]);
    begun = "";
  });
  if (begun) throw new Error(`line ${first}: goes on (\`\\\`), but the file ends`);
  return all;
}

function statement(text, mesh) {
  if (CONTROL.test(text)) throw new Error("is not text");
  const [keyword, ...words] = text.split("#")[0].trim().split(/\s+/);
  if (keyword === "v") {
    mesh.x.push(...vertex(words));
  } else if (keyword === "f") {
    mesh.pushPolygon(corners(words, 3, mesh));
  } else if (keyword === "l") {
    const chain = corners(words, 2, mesh);
    for (let i = 0; i + 1 < chain.length; i++) mesh.edges.push(chain[i], chain[i + 1]);
  } else if (FREE_FORM.includes(keyword)) {
    throw new Error(`\`${keyword}\`: free-form curves and surfaces are not read`);
  } else if (keyword && !PASSED_OVER.has(keyword)) {
    throw new Error(`\`${keyword}\` is no statement of OBJ`);
  }
}

/** The position of a vertex, which may have a weight, a colour, or a colour with alpha. */
function vertex(words) {
  if (words.length < 3) throw new Error("a vertex needs 3 numbers");
  if (![3, 4, 6, 7].includes(words.length)) {
    throw new Error(`a vertex has 3, 4, 6 or 7 numbers, not ${words.length}`);
  }
  const all = words.map((word) => {
    if (!NUMBER.test(word)) throw new Error(`\`${word}\` is not a number`);
    const value = Number(word);
    if (!Number.isFinite(value)) throw new Error(`\`${word}\` is not a finite number`);
    return value;
  });
  const beyond = all.slice(0, 3).findIndex((value) => Math.abs(value) > LIMIT);
  if (beyond >= 0) throw new Error(`\`${words[beyond]}\` is beyond 1e100`);
  if (words.length === 4 && all[3] !== 1) {
    throw new Error(`the weight of a vertex is ${all[3]}; only 1 is read`);
  }
  return all.slice(0, 3);
}

/** The vertices of a face or of a line, `least` or more, counted from 0. */
function corners(words, least, mesh) {
  if (words.length < least) throw new Error(`has ${words.length} vertices, fewer than ${least}`);
  return words.map((word) => corner(word, mesh.x.length / 3));
}

/** The vertex of `7`, `7/1`, `7//2`, `7/1/2` or `-1`, which counts back from the last so far. */
function corner(word, nVertices) {
  const [first, ...unused] = word.split("/");
  const fine = (part) => part === "" || (INTEGER.test(part) && Number(part) !== 0);
  if (!INTEGER.test(first) || unused.length > 2 || !unused.every(fine)) {
    throw new Error(`\`${word}\` is not a vertex index`);
  }
  const i = Number(first);
  if (i === 0) throw new Error("vertex index 0 names no vertex: OBJ counts from 1");
  const at = i < 0 ? nVertices + i : i - 1;
  if (at < 0) throw new Error(`vertex index ${i} names no vertex (${nVertices} so far)`);
  return at;
}
