// Example of two frames, from whole numbers, the same everywhere: a wavy sheet falls on a pyramid.

/** Vertices along a side of the sheet. */
const N = 14;

/** Positions at both ends of a step, and faces; sheet: `nSheet` vertices, then the pyramid. */
export function scene() {
  const [x0, x1, faces] = [[], [], []];
  for (let j = 0; j < N; j++) {
    for (let i = 0; i < N; i++) {
      const [x, z] = [(i - (N - 1) / 2) / 4, (j - (N - 1) / 2) / 4];
      const wave = ((i * 7 + j * 3) % 5) / 16;
      x0.push([x, 2 + wave, z]);
      x1.push([x * 0.75 + wave, wave * 3 - 0.25, z * 0.75 - wave]);
    }
  }
  for (let j = 0; j + 1 < N; j++) {
    for (let i = 0; i + 1 < N; i++) {
      const v = j * N + i;
      faces.push([v, v + N, v + 1], [v + 1, v + N, v + N + 1]);
    }
  }
  const base = x0.length;
  for (const p of [[0, 1.5, 0], [-1, 0, -1], [1, 0, -1.125], [1.25, 0, 1], [-1, 0, 1]]) {
    x0.push(p);
    x1.push(p);
  }
  for (let k = 0; k < 4; k++) faces.push([base, base + 1 + k, base + 1 + ((k + 1) % 4)]);
  return { x0: x0.flat(), x1: x1.flat(), faces: faces.flat(), nSheet: base };
}

/** A frame as an OBJ file. */
export function obj(x, faces) {
  const lines = [];
  for (let i = 0; i < x.length; i += 3) lines.push(`v ${x[i]} ${x[i + 1]} ${x[i + 2]}`);
  for (let i = 0; i < faces.length; i += 3) {
    lines.push(`f ${faces[i] + 1} ${faces[i + 1] + 1} ${faces[i + 2] + 1}`);
  }
  return `${lines.join("\n")}\n`;
}
