/**
 * Continuous collision detection for triangle meshes: which vertices and faces, and which edges,
 * touch while every vertex moves on a straight line from its position at the start of a step to
 * that at its end, and when. No contact is missed, and no time of impact is late, rounding
 * included. On the CPU everything runs in the calling thread: call it from a worker. Steps that are
 * awaited may run on a GPU, by WebGPU: see `Session.open`.
 */

/// <reference lib="esnext.disposable" />

/** Positions: three numbers a vertex, x y z. If one array is f64, both are taken as f64. */
export type Positions = Float32Array | Float64Array;

/**
 * Ids, flat or as a list of lists: `[0, 1, 2]` or `[[0, 1, 2]]`. Inner lists of edges, faces and
 * pairs have as many ids as one of these: polygons have to be cut into triangles first.
 */
export type Ids = Uint32Array | readonly number[] | readonly (readonly number[])[];

/** `vf`: vertex and face; `ee`: two edges; `ve`: particle and rod; `vv`: two particles. */
export type Kind = "vf" | "ee" | "ve" | "vv";

/** `undecided`: rounding leaves it open, with a minimum distance, and of intersections beyond 2^200
 * and below 2^-200; to be treated as a contact. */
export type State = "hit" | "undecided";

/** A number for each kind. */
export type PerKind = Record<Kind, number>;

/** Where the WebAssembly module is: beside this file. */
export const wasmUrl: URL;
/** Where that with the kernels is, which is fetched when a session is opened on a GPU. */
export const gpuWasmUrl: URL;
/** Names of the numbers in the column `kind`. */
export const KINDS: readonly ["vf", "ee", "ve", "vv"];
/** Names of the numbers in the column `state`. */
export const STATES: readonly ["hit", "undecided"];

/**
 * Loads the module; call it once in each thread, before anything else. Later calls wait for the
 * first one. By default it loads `wasmUrl`, also under Node.
 *
 * @param source Address, bytes, a response, or a compiled module, such as one that another thread
 *   has sent by `postMessage`.
 */
export function init(
  source?: string | URL | Request | Response | BufferSource | WebAssembly.Module,
): Promise<void>;

/**
 * The same from bytes or a compiled module, without waiting.
 * @throws Error while a call of `init` is in flight.
 */
export function initSync(source: BufferSource | WebAssembly.Module): void;

/** Version of the package. */
export function version(): string;

/** Vertices, edges and faces. Positions are given to each step. */
export class Mesh {
  /**
   * @param nVertices Number of vertices.
   * @param edges Edges of no face (rods), two ids each; those of faces are added.
   * @param faces Triangles, three ids each; `[]` if there are none.
   * @throws Error if an id names no vertex, a row has another number of ids, or faces are missing.
   */
  constructor(nVertices: number, edges: Ids | null | undefined, faces: Ids);
  readonly nVertices: number;
  /** All edges, two vertices each, to which ids of edges refer. A copy. */
  get edges(): Uint32Array;
  /** All faces, three vertices each. A copy. */
  get faces(): Uint32Array;
  /**
   * Frees its memory now; otherwise the garbage collector does. Sessions keep what they need. Once
   * more it does nothing; all else is an error then.
   */
  free(): void;
  /** The same at the end of a block, by `using`; where the language has that. */
  [Symbol.dispose](): void;
}

export interface Bodies {
  /** Body of each vertex. */
  ofVertex: Ids;
  /** Bodies that stand still; a step that moves one is refused. */
  fixed?: Ids;
  /** Bodies whose features are not tested against each other. */
  noSelfContact?: Ids;
  /** Pairs of bodies that are not tested against each other, two each. */
  excluded?: Ids;
}

export interface Options {
  /** Contact means a distance of at most this; 0 by default. */
  minDistance?: number;
  /** How times of impact are found: `exact`, the true ones rounded down, without `minDistance`;
      `conservative`, early by the tolerance at most; `auto`, the default, is exact on the CPU if
      there is no `minDistance`, else conservative. Name one if `step` and `stepAsync` on a GPU are
      to agree: normals on sides and corners follow from the time, too. */
  mode?: "auto" | "conservative" | "exact";
  /** How early a time of impact may be, as a part of the step; 1e-6 by default. */
  tolerance?: number;
  /** Contacts at the start whose features separate do not count. */
  leaveContact?: boolean;
  /** Bytes that a step may take, 0 or more; one that would take more is refused. */
  maxMemory?: number;
  /** Without them all of the mesh is one body. */
  bodies?: Bodies;
}

/** Columns of contacts, sorted by kind, then ids. */
export interface Contacts {
  /** Number of contacts. */
  readonly length: number;
  /** Numbers of kinds, see `KINDS`. */
  readonly kind: Uint8Array;
  /** Numbers of states, see `STATES`. */
  readonly state: Uint8Array;
  /** Two a contact: vertex and face, or the lesser and the greater edge. */
  readonly ids: Uint32Array;
  /** Times of impact in [0, 1]; none is late. */
  readonly toi: Float64Array;
}

/** Columns that are there with `geometry: true`. */
export interface ContactsWithGeometry extends Contacts {
  /**
   * Four a contact: v f0 f1 f2, or ea0 ea1 eb0 eb1. Of `ve` only the first three count, v e0 e1, of
   * `vv` the first two; the others repeat the last one.
   */
  readonly vertices: Uint32Array;
  /** Three a contact: where both features meet, at the time of impact. */
  readonly point: Float64Array;
  /** Three a contact: unit vector from the second feature to the first. */
  readonly normal: Float64Array;
  /** Four a contact: of each vertex, in the point of its feature; 0 where `vertices` repeats. */
  readonly weights: Float64Array;
}

/**
 * Milliseconds of a step; parts of milliseconds are as exact as `performance.now()` is. On a GPU
 * stages are not timed apart: `build`, `traverse` and `narrow` are 0, `total` has them.
 */
export interface Milliseconds {
  /** Checking input, swept boxes. */
  readonly boxes: number;
  /** Building trees, or refitting them. */
  readonly build: number;
  /** Finding candidates. */
  readonly traverse: number;
  /** Deciding them. */
  readonly narrow: number;
  /** Positions into the module's memory, columns out of it. */
  readonly copy: number;
  /** All of the step. */
  readonly total: number;
}

export interface Report<C extends Contacts = Contacts> {
  readonly contacts: C;
  /** The earliest time of impact; null without contact. */
  readonly toi: number | null;
  /** Contacts whose state is undecided. */
  readonly undecided: number;
  /** Whether trees were built anew rather than refitted. */
  readonly rebuilt: boolean;
  readonly counts: {
    readonly contacts: PerKind;
    /** Pairs whose swept boxes overlap. */
    readonly candidates: PerKind;
    /** Candidates that the filters could not reject. */
    readonly filtered: PerKind;
  };
  readonly ms: Milliseconds;
  /** Where the step ran. */
  readonly backend: Backend;
}

export type Backend = "cpu" | "gpu";

export interface OpenOptions extends Options {
  /**
   * `gpu`: WebGPU, or an error. `auto`, the default: WebGPU where there is a GPU and the mesh has
   * 20,000 edges or more, else the CPU, which also takes over if the GPU fails later; not for input
   * that the CPU refuses as well.
   */
  device?: "auto" | Backend;
}

export interface StepOptions {
  /** Only contacts that exist at some time in it; [0, 1] by default. */
  window?: readonly [number, number];
  /** Vertices, points, normals and weights too. */
  geometry?: boolean;
  /**
   * Columns are views of the module's memory instead of copies: valid until the next call of
   * anything in this package.
   */
  views?: boolean;
}

/** Columns of an awaited step are always copies. */
export type AsyncStepOptions = Omit<StepOptions, "views">;

/** The first contact of a step. */
export interface FirstContact {
  readonly toi: number;
  readonly kind: Kind;
  readonly state: State;
  /** Vertex and face, or the lesser and the greater edge. */
  readonly features: [number, number];
  /** Bodies of the features; 0 where the options have none. */
  readonly bodies: [number, number];
  /** As in `ContactsWithGeometry`, with the last one repeated. */
  readonly vertices: [number, number, number, number];
  readonly point: [number, number, number];
  /** Unit vector from the second feature to the first. */
  readonly normal: [number, number, number];
  readonly weights: [number, number, number, number];
  /** How far both are apart at that time. */
  readonly distance: number;
}

export interface Intersection {
  readonly edge: number;
  readonly face: number;
  readonly state: State;
}

/**
 * One mesh over many steps: keep it for the next frames. Calls throw an `Error` with the library's
 * message for input that is refused, and the session stays usable.
 */
export class Session {
  /** @throws Error if the options do not fit the mesh. */
  constructor(mesh: Mesh, options?: Options);

  /**
   * A session whose awaited calls run on a device. Loads the modules that it needs.
   * @throws Error as the constructor; with `device: "gpu"`, why there is none.
   */
  static open(mesh: Mesh, options?: OpenOptions): Promise<Session>;

  readonly mesh: Mesh;
  /** Where awaited calls run; all others run on the CPU. */
  readonly backend: Backend;
  /** Name of the GPU, which a browser may keep to itself; null on the CPU. */
  readonly adapter: string | null;
  /** Why `device: "auto"` runs on the CPU; null if it does not. */
  readonly whyCpu: string | null;

  /**
   * The session's own buffers for positions at the start and at the end of a step. Written there
   * and given to a call as `x0` and `x1`, or `x0` to one that takes one array, positions are not
   * copied. No call changes what they show: from this call on, those that are given other arrays of
   * this type, or these in other places as in `step(x1, x0)`, put back what was here, which costs
   * copies. They are views of the module's memory: ask for them again before each use, which costs
   * nothing, because a view has length 0 after that memory has grown.
   */
  positions(type: Float32ArrayConstructor): { x0: Float32Array; x1: Float32Array };
  positions(type: Float64ArrayConstructor): { x0: Float64Array; x1: Float64Array };

  /** Every contact of the step from `x0` to `x1`. */
  step(
    x0: Positions, x1: Positions, options: StepOptions & { geometry: true },
  ): Report<ContactsWithGeometry>;
  step(x0: Positions, x1: Positions, options?: StepOptions): Report;

  /**
   * The same on the session's device, without blocking where that is a GPU. Positions are read
   * before the call returns its promise, and may be overwritten then. One call of a session at a
   * time; changes have to wait for it, too.
   */
  stepAsync(
    x0: Positions, x1: Positions, options: AsyncStepOptions & { geometry: true },
  ): Promise<Report<ContactsWithGeometry>>;
  stepAsync(x0: Positions, x1: Positions, options?: AsyncStepOptions): Promise<Report>;

  /** `earliestToi` on the session's device, as `stepAsync`; a GPU rounds it down to an f32. */
  earliestToiAsync(x0: Positions, x1: Positions): Promise<number | null>;

  /** The earliest time of impact, never late; null if all of the step is free. */
  earliestToi(x0: Positions, x1: Positions): number | null;

  /** The part of the step that is free, in [0, 1]: the earliest time of impact, or 1. */
  collisionFreeStepsize(x0: Positions, x1: Positions): number;

  /** Whether nothing touches during the step. False if that could not be certified. */
  isStepCollisionFree(x0: Positions, x1: Positions): boolean;

  /** The first contact; null if all of the step is free. */
  firstContact(x0: Positions, x1: Positions): FirstContact | null;

  /** Pairs of ids whose swept boxes overlap, two ids a pair, in no particular order. */
  candidates(
    x0: Positions, x1: Positions, options?: { views?: boolean },
  ): Record<Kind, Uint32Array>;

  /** Edges and faces without a common vertex that have a point in common: where it goes through. */
  intersections(x: Positions): Intersection[];

  /** Whether there is any; the search ends with the first. */
  hasIntersections(x: Positions): boolean;

  /** From now on another distance. */
  setMinDistance(distance: number): void;
  /**
   * From now on a body is fixed, or moves.
   * @throws Error if there is no such body.
   */
  setFixed(body: number, fixed: boolean): void;
  /** From now on a body sleeps, or is awake. */
  setSleeping(body: number, sleeping: boolean): void;
  /**
   * Frees its memory now; otherwise the garbage collector does. Once more it does nothing; all else
   * is an error then.
   */
  free(): void;
  /** The same at the end of a block, by `using`; where the language has that. */
  [Symbol.dispose](): void;
}
