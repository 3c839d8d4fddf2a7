// A cloth on the GPU in three kernels around a step of `ccd`: where its vertices would go, where
// contacts stop them, and what Bevy draws. Vertices of the cloth come first, row by row; those
// behind them stand still.

struct Vertex { position: vec4f, velocity: vec4f }
struct Path { t0: vec4f, t1: vec4f }
struct Touch { kind: u32, state: u32, a: u32, b: u32, toi: array<u32, 2>, approach: u32 }
struct Contacts { n: u32, unused: array<u32, 3>, touches: array<Touch> }
struct Geometry { point: vec4f, normal: vec4f, weights: vec4f, vertices: vec4u }

@group(0) @binding(0) var<storage, read_write> vertices: array<Vertex>;
// The buffer of `Engine::paths`.
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;
// By vertex, the bits of its earliest time of impact.
@group(0) @binding(2) var<storage, read_write> earliest: array<atomic<u32>>;
// Those of `Engine::record_geometry`.
@group(0) @binding(3) var<storage, read> contacts: Contacts;
@group(0) @binding(4) var<storage, read> geometry: array<Geometry>;
// Position and normal of the cloth's vertices, as in its Bevy mesh; in `predict`, scratch.
@group(0) @binding(5) var<storage, read_write> drawn: array<f32>;

override SIDE: u32; // vertices
override SPACING: f32; // metres, of neighbours in a row
const DT = 1.0 / 120.0; // seconds a frame: slow motion at 60 frames a second
const GRAVITY = vec3f(0.0, -9.81, 0.0);
const ITERATIONS = 24u; // more: a cloth that stretches less
const MARGIN = 0.01; // metres, between a vertex that stops and what it would touch
const NEVER = 2.0; // later than any time of impact

// Where every vertex would go without contacts, as a path. One workgroup, because an iteration
// reads what its neighbours wrote in the one before.
@compute @workgroup_size(256)
fn predict(@builtin(local_invocation_index) first: u32) {
    for (var v = first; v < arrayLength(&vertices); v += 256u) {
        let p = vertices[v].position.xyz;
        var goal = p;
        if v < SIDE * SIDE {
            goal += DT * (vertices[v].velocity.xyz + DT * GRAVITY);
        }
        paths[v] = Path(vec4f(p, 0.0), vec4f(goal, 0.0));
        atomicStore(&earliest[v], bitcast<u32>(NEVER));
    }
    for (var i = 0u; i < ITERATIONS; i += 1u) {
        storageBarrier();
        for (var v = first; v < SIDE * SIDE; v += 256u) {
            write_drawn(6u * v, relaxed(v));
        }
        storageBarrier();
        for (var v = first; v < SIDE * SIDE; v += 256u) {
            paths[v].t1 = vec4f(drawn[6u * v], drawn[6u * v + 1u], drawn[6u * v + 2u], 0.0);
        }
    }
}

// A vertex moved so that its distances to its neighbours are more like at rest: those beside it
// resist stretching and shearing, those two further resist bending.
fn relaxed(v: u32) -> vec3f {
    let p = paths[v].t1.xyz;
    var sum = vec3f();
    var n = 0.0;
    for (var y = -2; y <= 2; y += 1) {
        for (var x = -2; x <= 2; x += 1) {
            let d = vec2i(x, y);
            let near = max(abs(x), abs(y)) == 1 || (min(abs(x), abs(y)) == 0 && (x + y) != 0);
            let at = vec2i(i32(v % SIDE), i32(v / SIDE)) + d;
            if near && all(at >= vec2i(0)) && all(at < vec2i(i32(SIDE))) {
                let to = paths[at.y * i32(SIDE) + at.x].t1.xyz - p;
                sum += 0.5 * (1.0 - SPACING * length(vec2f(d)) / max(length(to), 1e-9)) * to;
                n += 1.0;
            }
        }
    }
    return p + 1.2 * sum / n;
}

// The earliest time of impact of every vertex.
@compute @workgroup_size(64)
fn respond(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let n = min(contacts.n, arrayLength(&contacts.touches));
    for (var i = id.x; i < n; i += 64u * groups.x) {
        let toi = bitcast<u32>(rounded_down(contacts.touches[i].toi));
        for (var k = 0u; k < 4u; k += 1u) {
            atomicMin(&earliest[geometry[i].vertices[k]], toi);
        }
    }
}

// The bits of an `f64` from 0 to 1, low word first, as an `f32`.
fn rounded_down(bits: array<u32, 2>) -> f32 {
    let exponent = bits[1] >> 20u;
    let word = ((exponent - 896u) << 23u) | ((bits[1] & 0xfffffu) << 3u) | (bits[0] >> 29u);
    return select(0.0, bitcast<f32>(word), exponent > 896u);
}

// The simplest response: a vertex with a contact stops before it, and sticks. That changes paths,
// so other pairs may touch now; an engine would look for contacts again.
@compute @workgroup_size(256)
fn settle(@builtin(local_invocation_index) first: u32) {
    for (var v = first; v < SIDE * SIDE; v += 256u) {
        let path = paths[v].t1.xyz - paths[v].t0.xyz;
        let toi = bitcast<f32>(atomicLoad(&earliest[v]));
        let stopped = max(toi - MARGIN / max(length(path), 1e-9), 0.0);
        let moved = select(path, stopped * path, toi <= 1.0);
        vertices[v].position += vec4f(moved, 0.0);
        vertices[v].velocity = vec4f(0.99 * moved / DT, 0.0);
    }
    storageBarrier();
    for (var v = first; v < SIDE * SIDE; v += 256u) {
        let x = v % SIDE;
        let y = v / SIDE;
        let along = at(min(x + 1u, SIDE - 1u), y) - at(max(x, 1u) - 1u, y);
        let across = at(x, min(y + 1u, SIDE - 1u)) - at(x, max(y, 1u) - 1u);
        write_drawn(6u * v, vertices[v].position.xyz);
        write_drawn(6u * v + 3u, normalize(cross(across, along)));
    }
}

fn at(x: u32, y: u32) -> vec3f {
    return vertices[y * SIDE + x].position.xyz;
}

fn write_drawn(i: u32, p: vec3f) {
    drawn[i] = p.x;
    drawn[i + 1u] = p.y;
    drawn[i + 2u] = p.z;
}
