// C API of ccd: continuous collision detection for triangle meshes.
//
// Given a mesh at the start and at the end of a time step, every vertex moving on a straight line,
// it finds every vertex-face and edge-edge contact in between, with its time of impact. No contact
// is missed and no time of impact is late, rounding included.
//
// Status. Functions that can fail return a CcdStatus; ccd_last_error() has the message. Outputs are
// NULL or 0 after a failure. No exception and no unwinding leaves a function.
//
// Pointers. NULL is refused with CCD_STATUS_INVALID_ARGUMENT where a comment does not allow it. Any
// other pointer must be valid for what its comment says. Arrays that a call is given are read
// during the call alone; nothing of them is kept.
//
// Ownership. What a `_create` function made is destroyed by the `_destroy` function of its type,
// once; NULL is no error there. A session holds on to its mesh, which may be destroyed before it.
// What a call of a session points to belongs to the session, until its next call or its end.
//
// Threads. A mesh may be used by many threads at once. Bodies and a session are used by one thread
// at a time, any one: a call that meets another one is refused with CCD_STATUS_BUSY.
// ccd_session_cancel is for other threads. No call may be running when its object is destroyed.
//
// Units. Coordinates and distances are in any unit, the same for all. Times of impact are parts of
// the step, from 0 (its start) to 1 (its end). Ids of vertices, edges and triangles count from 0.
//
// Written by cbindgen from ccd-c/src; changes belong there.

#ifndef MESHCCD_H
#define MESHCCD_H

#include <stddef.h>
#include <stdint.h>

/// Major version of this header.
#define CCD_VERSION_MAJOR 0

/// Minor version of this header.
#define CCD_VERSION_MINOR 1

/// Patch version of this header.
#define CCD_VERSION_PATCH 0

/// Outcome of a call. ccd_last_error() has the message of all but CCD_STATUS_OK.
enum CcdStatus
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /// The call did what was asked.
  CCD_STATUS_OK = 0,
  /// Misuse: a pointer is NULL, a value is none of its enumeration, a size is none of a struct.
  CCD_STATUS_INVALID_ARGUMENT = 1,
  /// Input is refused, and nothing was computed from it: an index out of range, a wrong number
  /// of vertices, a coordinate that is NaN, infinite or above 1e100, options out of their range.
  CCD_STATUS_INVALID_INPUT = 2,
  /// There is no GPU that fits, or of the given name, or the library was built without GPU.
  CCD_STATUS_NO_GPU = 3,
  /// The GPU failed: it was lost, or refused a command.
  CCD_STATUS_DEVICE_FAILED = 4,
  /// More memory would be needed than max_memory, or the GPU, allows. The object stays usable.
  CCD_STATUS_OUT_OF_MEMORY = 5,
  /// ccd_session_cancel ended the call.
  CCD_STATUS_CANCELLED = 6,
  /// Another call uses this object at the moment.
  CCD_STATUS_BUSY = 7,
  /// A defect of the library. The object refuses all further calls: destroy it.
  CCD_STATUS_PANICKED = 8,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum CcdStatus CcdStatus;
#else
typedef int32_t CcdStatus;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// Which features touch: `a` and `b` of a contact.
enum CcdKind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /// Vertex `a`, triangle `b`.
  CCD_KIND_VERTEX_FACE = 0,
  /// Edges `a < b`, by the ids of ccd_mesh_edges.
  CCD_KIND_EDGE_EDGE = 1,
  /// Vertex `a` of no edge, edge `b` of no triangle: a particle and a rod.
  CCD_KIND_VERTEX_EDGE = 2,
  /// Vertices `a < b` of no edge: two particles.
  CCD_KIND_VERTEX_VERTEX = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum CcdKind CcdKind;
#else
typedef uint32_t CcdKind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// How certain a contact is.
enum CcdState
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /// Certainly a contact; its time of impact is at most the tolerance early.
  CCD_STATE_HIT = 0,
  /// Neither certainly a contact nor certainly none, with a minimum distance: treat it as a
  /// contact. There is certainly none before its time of impact.
  CCD_STATE_UNDECIDED = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum CcdState CcdState;
#else
typedef uint32_t CcdState;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// Whether the features of a contact come nearer there.
enum CcdApproach
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /// Neither of the others, or not certain.
  CCD_APPROACH_UNKNOWN = 0,
  /// Certainly nearer.
  CCD_APPROACH_APPROACHING = 1,
  /// In contact at the start, and certainly apart from then on for a while.
  CCD_APPROACH_SEPARATING = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum CcdApproach CcdApproach;
#else
typedef uint32_t CcdApproach;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// Where steps run.
enum CcdBackend
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /// A GPU if there is one and the mesh has at least 20,000 edges, and for as long as it does not
  /// fail; else the CPU. With an `adapter` that one, however small the mesh is.
  CCD_BACKEND_AUTO = 0,
  /// Threads of this machine.
  CCD_BACKEND_CPU = 1,
  /// A GPU; an error if there is none, or if it fails.
  CCD_BACKEND_GPU = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum CcdBackend CcdBackend;
#else
typedef uint32_t CcdBackend;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// How times of impact are found. Which pairs touch is decided exactly in all modes.
enum CcdMode
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /// CCD_MODE_EXACT on the CPU, if there is no minimum distance; else, and in sessions on a GPU
  /// also for what they leave to the CPU, CCD_MODE_CONSERVATIVE.
  CCD_MODE_AUTO = 0,
  /// Never late, and early by the tolerance at most.
  CCD_MODE_CONSERVATIVE = 1,
  /// The true ones, rounded down. Takes no minimum distance.
  CCD_MODE_EXACT = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum CcdMode CcdMode;
#else
typedef uint32_t CcdMode;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// Type of coordinates.
enum CcdComponent
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  /// `float`
  CCD_COMPONENT_F32 = 0,
  /// `double`
  CCD_COMPONENT_F64 = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum CcdComponent CcdComponent;
#else
typedef uint32_t CcdComponent;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/// The body of each vertex, and rules of which pairs of bodies are looked at. A session copies
/// them.
typedef struct CcdBodies CcdBodies;

/// Topology of a triangle mesh, which stays the same while vertices move. Not changed once it is
/// made, so many threads and sessions may use it at once.
typedef struct CcdMesh CcdMesh;

/// Continuous collision detection of one mesh over many steps: keep it from frame to frame.
typedef struct CcdSession CcdSession;

/// Two ids.
typedef struct CcdPair {
  /// The first.
  uint32_t a;
  /// The second.
  uint32_t b;
} CcdPair;

/// An array of pairs.
typedef struct CcdPairs {
  /// The first pair; not to be read if there is none.
  const struct CcdPair *data;
  /// Number of pairs.
  size_t count;
} CcdPairs;

/// What a session looks for and how. Later versions may have more fields at the end:
/// ccd_options_default fills in all that there are.
typedef struct CcdOptions {
  /// Bytes of this struct as the program knows it.
  size_t size;
  /// Contact means a distance of at most this, in the unit of coordinates; 0 means touching.
  double min_distance;
  /// How early a certain time of impact may be, from 1e-12 to 1; 1e-6 by default.
  double tolerance;
  /// Bytes that the session may hold; 0: no limit.
  uint64_t max_memory;
  /// A part of the name of a GPU, its PCI id or its number, for CCD_BACKEND_AUTO and
  /// CCD_BACKEND_GPU; NULL or empty: the one that the system prefers. UTF-8.
  const char *adapter;
  /// A CcdBackend; CCD_BACKEND_AUTO by default.
  uint32_t backend;
  /// A CcdMode; CCD_MODE_AUTO by default.
  uint32_t mode;
  /// Threads of work on the CPU: 0 for all cores, shared by all sessions; 1 for the calling
  /// thread alone; more, up to 1024, for a pool of the session's own.
  uint32_t threads;
  /// Whether features that are in contact at the start of a step may leave it (1) or not (0).
  uint32_t leave_contact;
} CcdOptions;

/// Positions of vertices: x, y, z one behind the other, the next vertex a stride later. They are
/// read where they are if they are aligned and without gaps, else copied.
typedef struct CcdPositions {
  /// The first coordinate of the first vertex; any address. NULL if there are no vertices.
  const void *data;
  /// Bytes from one vertex to the next; 0 for those without a gap. No bytes are needed behind the
  /// last vertex.
  size_t stride;
  /// Number of vertices: that of the mesh.
  size_t count;
  /// A CcdComponent; the same at both ends of a step.
  uint32_t component;
} CcdPositions;

/// A contact between two features.
typedef struct CcdContact {
  /// Time of impact in [0, 1]; never later than the first contact of the two features.
  double toi;
  /// Which features touch.
  CcdKind kind;
  /// Whether it is certain that they do.
  CcdState state;
  /// Whether they come nearer there.
  CcdApproach approach;
  /// The vertex of a vertex-face or vertex-edge pair; else the lesser edge or vertex.
  uint32_t a;
  /// The triangle or edge that the vertex `a` touches; else the greater edge or vertex.
  uint32_t b;
  /// The vertices: `v f0 f1 f2` of a vertex and a triangle, `ea0 ea1 eb0 eb1` of two edges,
  /// `v e0 e1 e1` and `v w w w` of particles and rods.
  uint32_t vertices[4];
} CcdContact;

/// Numbers by kind of pair.
typedef struct CcdCounts {
  /// Vertex and triangle.
  uint64_t vertex_face;
  /// Two edges.
  uint64_t edge_edge;
  /// Vertex of no edge and edge of no triangle.
  uint64_t vertex_edge;
  /// Two vertices of no edge.
  uint64_t vertex_vertex;
} CcdCounts;

/// What a step found. The library makes it; later versions may have more fields at the end.
typedef struct CcdReport {
  /// All contacts, sorted by kind, then a, then b.
  const struct CcdContact *contacts;
  /// Number of contacts.
  size_t contact_count;
  /// Least time of impact; INFINITY without contact.
  double toi;
  /// Contacts in CCD_STATE_UNDECIDED.
  uint64_t undecided_count;
  /// Contacts by kind.
  struct CcdCounts contacts_by_kind;
  /// Pairs of features whose swept boxes overlap.
  struct CcdCounts candidates;
  /// Wall clock of the step in milliseconds.
  double milliseconds;
} CcdReport;

/// How two features meet at their time of impact.
typedef struct CcdGeometry {
  /// Halfway between the nearest points of the features.
  double point[3];
  /// Unit vector from the second feature towards the first: pushed along it, the first parts.
  double normal[3];
  /// Of each of the vertices, in the nearest point of its feature.
  double weights[4];
  /// Distance of the features.
  double distance;
} CcdGeometry;

/// The first contact of a step, and how its features meet. The library makes it; later versions may
/// have more fields at the end.
typedef struct CcdHit {
  /// The contact.
  struct CcdContact contact;
  /// Where its features meet at that time.
  struct CcdGeometry geometry;
  /// The bodies of its features; both 0 without bodies.
  uint32_t bodies[2];
} CcdHit;

/// Candidates of a step: pairs of features whose swept boxes overlap, without those that share a
/// vertex or that the bodies rule out. In no order. The library makes it.
typedef struct CcdCandidates {
  /// Vertex, triangle.
  struct CcdPairs vertex_face;
  /// Two edges, the lesser id first.
  struct CcdPairs edge_edge;
  /// A vertex of no edge, an edge of no triangle.
  struct CcdPairs vertex_edge;
  /// Two vertices of no edge, the lesser id first.
  struct CcdPairs vertex_vertex;
} CcdCandidates;

/// How one body moves in a step: positions of its vertices, in the order of their ids.
typedef struct CcdBodyMotion {
  /// The body.
  uint32_t body;
  /// Positions at the start of the step.
  struct CcdPositions x0;
  /// Positions at its end.
  struct CcdPositions x1;
} CcdBodyMotion;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/// Version of the library: `major << 16 | minor << 8 | patch`, which may differ from that of the
/// header that a program was compiled with. Versions of one major number, of 0 those of one minor
/// number, can be exchanged.
uint32_t ccd_version(void);

/// Message of the last call on this thread that failed, in English and UTF-8, with element, place
/// and value; "" if none failed. Valid until another call fails on this thread, or the thread ends.
const char *ccd_last_error(void);

/// Name of a status, such as "invalid input"; "unknown status" of any other number. Static.
const char *ccd_status_name(int32_t status);

/// Makes a mesh.
///
/// `triangles`: three indices of vertices a triangle, `triangle_stride` bytes from one triangle to
/// the next (0: 12). Edges are derived. A triangle that names a vertex twice is kept.
///
/// Fails with CCD_STATUS_INVALID_INPUT for an index out of range and for more than 2^31 - 1
/// elements.
CcdStatus ccd_mesh_create(size_t vertex_count,
                          const uint32_t *triangles,
                          size_t triangle_count,
                          size_t triangle_stride,
                          struct CcdMesh **mesh);

/// Makes a mesh with edges that no triangle has (rods, wires) besides those of the triangles: two
/// indices of vertices an edge, `edge_stride` bytes from one edge to the next (0: 8). Repeated
/// edges count once. All else as ccd_mesh_create.
CcdStatus ccd_mesh_create_with_edges(size_t vertex_count,
                                     const uint32_t *triangles,
                                     size_t triangle_count,
                                     size_t triangle_stride,
                                     const uint32_t *edges,
                                     size_t edge_count,
                                     size_t edge_stride,
                                     struct CcdMesh **mesh);

/// Destroys a mesh; NULL is ignored. Sessions that have it go on.
void ccd_mesh_destroy(struct CcdMesh *mesh);

/// Number of vertices, those of no triangle too; 0 of NULL.
size_t ccd_mesh_vertex_count(const struct CcdMesh *mesh);

/// Number of triangles; 0 of NULL.
size_t ccd_mesh_triangle_count(const struct CcdMesh *mesh);

/// Edges: vertices `a < b`, sorted by `b`, then by `a`; the index is the id of the edge. Valid
/// until the mesh is destroyed; empty of NULL.
struct CcdPairs ccd_mesh_edges(const struct CcdMesh *mesh);

/// Makes bodies: `body_of_vertex` has the body of each vertex, by any number. They move, and touch
/// themselves and each other. A session refuses another number of vertices than its mesh has, a
/// triangle or an edge that joins two bodies, and a rule for a body without a vertex, with
/// CCD_STATUS_INVALID_INPUT.
CcdStatus ccd_bodies_create(const uint32_t *body_of_vertex,
                            size_t vertex_count,
                            struct CcdBodies **bodies);

/// Destroys bodies; NULL is ignored. Sessions that were given them go on.
void ccd_bodies_destroy(struct CcdBodies *bodies);

/// Sets whether a body is fixed: 1 or 0. Two bodies that stand still are no pair, and a step in
/// which a fixed one moves is refused.
CcdStatus ccd_bodies_set_fixed(struct CcdBodies *bodies, uint32_t body, uint32_t fixed);

/// Sets whether a body sleeps: 1 or 0. While it sleeps it is as one that is fixed.
CcdStatus ccd_bodies_set_sleeping(struct CcdBodies *bodies, uint32_t body, uint32_t sleeping);

/// Sets whether a step in which a fixed or sleeping body moves is accepted: 1 or 0, at first 0.
CcdStatus ccd_bodies_set_fixed_motion(struct CcdBodies *bodies, uint32_t may_move);

/// Sets whether pairs of features within a body are looked at, for all bodies: 1 or 0, at first 1.
CcdStatus ccd_bodies_set_self_contacts(struct CcdBodies *bodies, uint32_t self_contact);

/// Sets whether pairs of features within one body are looked at: 1 or 0, at first 1.
CcdStatus ccd_bodies_set_self_contact(struct CcdBodies *bodies,
                                      uint32_t body,
                                      uint32_t self_contact);

/// Sets the groups of a body, a bit a group: those that it belongs to, and those whose members it
/// may touch. Two bodies are looked at if each belongs to a group that the other may touch. At
/// first all bits are set.
CcdStatus ccd_bodies_set_groups(struct CcdBodies *bodies,
                                uint32_t body,
                                uint32_t memberships,
                                uint32_t filter);

/// Sets the world of a body, below 65536, at first 0: bodies of two worlds are never looked at.
CcdStatus ccd_bodies_set_world(struct CcdBodies *bodies, uint32_t body, uint32_t world);

/// Excludes pairs of bodies, besides those before; a body with itself: its self-contact.
CcdStatus ccd_bodies_exclude_bodies(struct CcdBodies *bodies,
                                    const struct CcdPair *pairs,
                                    size_t count);

/// Excludes pairs of features by their ids in the mesh, besides those before. `kind`: a CcdKind.
CcdStatus ccd_bodies_exclude_features(struct CcdBodies *bodies,
                                      uint32_t kind,
                                      const struct CcdPair *pairs,
                                      size_t count);

/// Fills in the defaults. `size`: sizeof(CcdOptions).
CcdStatus ccd_options_default(struct CcdOptions *options, size_t size);

/// Makes a session for a mesh. `bodies`: NULL if all pairs of features are looked at. `options`:
/// NULL for the defaults.
///
/// Fails with CCD_STATUS_NO_GPU for CCD_BACKEND_GPU where there is none, and for an `adapter` that
/// is not there; with CCD_STATUS_INVALID_INPUT for options and bodies that do not fit.
CcdStatus ccd_session_create(const struct CcdMesh *mesh,
                             const struct CcdBodies *bodies,
                             const struct CcdOptions *options,
                             struct CcdSession **session);

/// Destroys a session; NULL is ignored.
void ccd_session_destroy(struct CcdSession *session);

/// Every contact while vertices move on straight lines from `x0` to `x1`. `report` belongs to the
/// session, until its next call; NULL if it is not wanted.
///
/// Fails with CCD_STATUS_INVALID_INPUT for another number of positions than the mesh has vertices,
/// for a coordinate that is NaN, infinite or above 1e100, and for a fixed body that moves. The
/// session stays usable after every failure but CCD_STATUS_PANICKED.
CcdStatus ccd_session_step(struct CcdSession *session,
                           struct CcdPositions x0,
                           struct CcdPositions x1,
                           const struct CcdReport **report);

/// Every contact that exists at some time from `t0` to `t1`, with `0 <= t0 <= t1 <= 1`; times of
/// impact are parts of the whole step. All else as ccd_session_step.
CcdStatus ccd_session_step_window(struct CcdSession *session,
                                  struct CcdPositions x0,
                                  struct CcdPositions x1,
                                  double t0,
                                  double t1,
                                  const struct CcdReport **report);

/// The earliest time of impact of the step, without the list of contacts: cheaper than
/// ccd_session_step. INFINITY if the whole step is free. Not later than the earliest contact.
CcdStatus ccd_session_earliest_toi(struct CcdSession *session,
                                   struct CcdPositions x0,
                                   struct CcdPositions x1,
                                   double *toi);

/// How much of the step is certainly free of contact: 1 if all of it is, else the earliest time of
/// impact, which may be 0. At that time itself there may be contact.
CcdStatus ccd_session_collision_free_stepsize(struct CcdSession *session,
                                              struct CcdPositions x0,
                                              struct CcdPositions x1,
                                              double *stepsize);

/// The first contact of the step with point, normal and weights; NULL if the whole step is free.
/// `hit` belongs to the session, until its next call. Of contacts with the same time it is the
/// first by kind and ids. Its `approach` is CCD_APPROACH_UNKNOWN.
CcdStatus ccd_session_first_contact(struct CcdSession *session,
                                    struct CcdPositions x0,
                                    struct CcdPositions x1,
                                    const struct CcdHit **hit);

/// Point, normal and weights of every contact of the session's last report, in its order: those of
/// a step. After ccd_session_earliest_toi there are none; after ccd_session_first_contact none on a
/// CPU, those that it looked at on a GPU. `x0`, `x1`: the positions of that step, which are not
/// checked again. Does not end the life of the report.
///
/// `geometry` belongs to the session, until its next call; `count`: number of contacts.
CcdStatus ccd_session_contact_geometry(struct CcdSession *session,
                                       struct CcdPositions x0,
                                       struct CcdPositions x1,
                                       const struct CcdGeometry **geometry,
                                       size_t *count);

/// All candidates of the step. `candidates` belongs to the session, until its next call. A step
/// does not need this.
CcdStatus ccd_session_candidates(struct CcdSession *session,
                                 struct CcdPositions x0,
                                 struct CcdPositions x1,
                                 const struct CcdCandidates **candidates);

/// Edges (a) and triangles (b) that have a point in common at positions `x`, but no vertex: where
/// the mesh goes through itself. Exact, on the CPU, where coordinates are zero or from 2^-200 to
/// 2^200; beyond, all that are not certainly apart. `pairs` belong to the session, until its next
/// call.
CcdStatus ccd_session_intersections(struct CcdSession *session,
                                    struct CcdPositions x,
                                    struct CcdPairs *pairs);

/// Sets the mesh of the next steps, with these bodies, or none (NULL): ids of features are new.
CcdStatus ccd_session_set_mesh(struct CcdSession *session,
                               const struct CcdMesh *mesh,
                               const struct CcdBodies *bodies);

/// Sets the bodies of the next steps, or none (NULL).
CcdStatus ccd_session_set_bodies(struct CcdSession *session, const struct CcdBodies *bodies);

/// Sets the minimum distance of the next steps.
CcdStatus ccd_session_set_min_distance(struct CcdSession *session, double min_distance);

/// Where steps run: "2 threads", or the name of the GPU. `place` belongs to the session, until its
/// next call.
CcdStatus ccd_session_place(struct CcdSession *session, const char **place);

/// Ends the step, search or list that runs, and all later ones, with CCD_STATUS_CANCELLED, until
/// ccd_session_resume. For any thread, at any time before the session is destroyed.
CcdStatus ccd_session_cancel(struct CcdSession *session);

/// Undoes ccd_session_cancel: later calls run to their ends.
CcdStatus ccd_session_resume(struct CcdSession *session);

/// From now on all vertices stand at `x`, until the calls below move bodies. Positions are copied.
CcdStatus ccd_session_set_positions(struct CcdSession *session, struct CcdPositions x);

/// Every contact of a step in which these bodies move and all others stand where the last such call
/// left them, or ccd_session_set_positions: what ccd_session_step finds for the same positions. On
/// a CPU it costs what the bodies cost that are not fixed and do not sleep. `report`: as there.
///
/// Fails with CCD_STATUS_INVALID_INPUT before ccd_session_set_positions, for a body without a
/// vertex or with two motions, and for another number of positions than the body has vertices; then
/// all stand where they stood.
CcdStatus ccd_session_step_bodies(struct CcdSession *session,
                                  const struct CcdBodyMotion *motions,
                                  size_t motion_count,
                                  const struct CcdReport **report);

/// The earliest time of impact of a step in which these bodies move: what ccd_session_earliest_toi
/// is to ccd_session_step. The bodies stand at their `x1` afterwards.
CcdStatus ccd_session_earliest_toi_of_bodies(struct CcdSession *session,
                                             const struct CcdBodyMotion *motions,
                                             size_t motion_count,
                                             double *toi);

/// The first contact of a step in which these bodies move; NULL if the whole step is free. All else
/// as ccd_session_first_contact and ccd_session_step_bodies.
CcdStatus ccd_session_first_contact_of_bodies(struct CcdSession *session,
                                              const struct CcdBodyMotion *motions,
                                              size_t motion_count,
                                              const struct CcdHit **hit);

/// Sets whether a body is fixed from now on: 1 or 0. The session must have bodies.
CcdStatus ccd_session_set_fixed(struct CcdSession *session, uint32_t body, uint32_t fixed);

/// Sets whether a body sleeps from now on: 1 or 0. The session must have bodies.
CcdStatus ccd_session_set_sleeping(struct CcdSession *session, uint32_t body, uint32_t sleeping);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* MESHCCD_H */
