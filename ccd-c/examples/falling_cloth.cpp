// A cloth that falls on a sphere, in C++17 over the C API: every frame is stepped, vertices that
// would touch stay where they are, and each frame is shown to be free before it is taken.
//
// The scene needs only additions, products and square roots, so that contacts are the same on every
// machine; the program fails if their number is another one. `falling_cloth N` expects N instead.

#include <ccd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::size_t kFrames = 40;
constexpr std::size_t kExpectedContacts = 59553;
constexpr double kRadius = 0.3;
constexpr double kDt = 1.0 / 60.0;

// Objects of the library, destroyed by their functions.
struct Destroy {
  void operator()(CcdMesh* mesh) const { ccd_mesh_destroy(mesh); }
  void operator()(CcdBodies* bodies) const { ccd_bodies_destroy(bodies); }
  void operator()(CcdSession* session) const { ccd_session_destroy(session); }
};
template <class T>
using Handle = std::unique_ptr<T, Destroy>;

void check(CcdStatus status) {
  if (status != CCD_STATUS_OK) {
    throw std::runtime_error(std::string(ccd_status_name(status)) + ": " + ccd_last_error());
  }
}

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

CcdPositions positions(const std::vector<Point>& x) {
  return {x.data(), sizeof(Point), x.size(), CCD_COMPONENT_F64};
}

struct Scene {
  std::vector<Point> x;
  std::vector<Triangle> triangles;
  std::size_t cloth_count = 0;
};

// A square of n x n vertices, a little beside the middle, so that no two features meet exactly.
void add_cloth(Scene& scene, std::uint32_t n) {
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const double u = double(i % n) / (n - 1), w = double(i / n) / (n - 1);
    scene.x.push_back({u - 0.513, kRadius + 0.1, w - 0.507});
  }
  for (std::uint32_t r = 0; r + 1 < n; ++r) {
    for (std::uint32_t c = 0; c + 1 < n; ++c) {
      const std::uint32_t v = r * n + c;
      scene.triangles.push_back({v, v + n, v + 1});
      scene.triangles.push_back({v + 1, v + n, v + n + 1});
    }
  }
  scene.cloth_count = scene.x.size();
}

// The surface of a grid of n x n x n cells, each vertex moved to the sphere.
void add_sphere(Scene& scene, std::uint32_t n) {
  const std::uint32_t m = n + 1;
  std::vector<std::uint32_t> ids(m * m * m, UINT32_MAX);
  const auto id = [&](std::array<std::uint32_t, 3> at) {
    std::uint32_t& id = ids[(at[0] * m + at[1]) * m + at[2]];
    if (id == UINT32_MAX) {
      id = std::uint32_t(scene.x.size());
      Point p;
      for (int k = 0; k < 3; ++k) p[k] = 2.0 * at[k] / n - 1.0;
      const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      for (double& c : p) c *= kRadius / length;
      scene.x.push_back(p);
    }
    return id;
  };
  for (std::uint32_t side = 0; side < 6; ++side) {
    for (std::uint32_t cell = 0; cell < n * n; ++cell) {
      const auto corner = [&](std::uint32_t du, std::uint32_t dv) {
        std::array<std::uint32_t, 3> at;
        at[side % 3] = side < 3 ? 0 : n;
        at[(side + 1) % 3] = cell % n + du;
        at[(side + 2) % 3] = cell / n + dv;
        return id(at);
      };
      scene.triangles.push_back({corner(0, 0), corner(1, 0), corner(0, 1)});
      scene.triangles.push_back({corner(0, 1), corner(1, 0), corner(1, 1)});
    }
  }
}

double distance(const Point& p, const Point& q) {
  const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

void run(std::size_t expected_contacts) {
  Scene scene;
  add_cloth(scene, 24);
  add_sphere(scene, 12);
  std::vector<Point>& x0 = scene.x;
  const std::size_t cloth_count = scene.cloth_count;

  CcdMesh* new_mesh = nullptr;
  const std::uint32_t* triangles = scene.triangles[0].data();
  check(ccd_mesh_create(x0.size(), triangles, scene.triangles.size(), sizeof(Triangle), &new_mesh));
  const Handle<CcdMesh> mesh(new_mesh);

  // Body 0 is the cloth, body 1 the sphere, which stands still.
  std::vector<std::uint32_t> body(x0.size(), 1);
  for (std::size_t v = 0; v < cloth_count; ++v) body[v] = 0;
  CcdBodies* new_bodies = nullptr;
  check(ccd_bodies_create(body.data(), body.size(), &new_bodies));
  const Handle<CcdBodies> bodies(new_bodies);
  check(ccd_bodies_set_fixed(bodies.get(), 1, 1));

  CcdOptions options;
  check(ccd_options_default(&options, sizeof options));
  options.backend = CCD_BACKEND_CPU;
  CcdSession* new_session = nullptr;
  check(ccd_session_create(mesh.get(), bodies.get(), &options, &new_session));
  const Handle<CcdSession> session(new_session);
  const char* place = nullptr;
  check(ccd_session_place(session.get(), &place));
  std::printf("ccd %u.%u, %zu vertices, %zu triangles, on %s\n", ccd_version() >> 16,
              ccd_version() >> 8 & 255, x0.size(), scene.triangles.size(), place);

  // Springs along the edges of the cloth.
  struct Spring {
    std::uint32_t a, b;
    double rest;
  };
  std::vector<Spring> springs;
  const CcdPairs edges = ccd_mesh_edges(mesh.get());
  for (std::size_t e = 0; e < edges.count; ++e) {
    const CcdPair edge = edges.data[e];
    if (edge.b < cloth_count) {
      springs.push_back({edge.a, edge.b, distance(x0[edge.a], x0[edge.b])});
    }
  }

  std::vector<Point> x1 = x0, before = x0;
  std::size_t contact_count = 0;
  bool touched = false;
  for (std::size_t frame = 0; frame < kFrames; ++frame) {
    // Where gravity, velocities and springs take the cloth.
    for (std::size_t v = 0; v < cloth_count; ++v) {
      for (int k = 0; k < 3; ++k) x1[v][k] = x0[v][k] + 0.99 * (x0[v][k] - before[v][k]);
      x1[v][1] -= 9.81 * kDt * kDt;
    }
    for (int round = 0; round < 4; ++round) {
      for (const Spring& spring : springs) {
        Point &p = x1[spring.a], &q = x1[spring.b];
        const double length = distance(p, q), part = 0.5 * (length - spring.rest) / length;
        for (int k = 0; k < 3; ++k) {
          const double move = part * (q[k] - p[k]);
          p[k] += move;
          q[k] -= move;
        }
      }
    }

    const CcdReport* report = nullptr;
    check(ccd_session_step(session.get(), positions(x0), positions(x1), &report));
    contact_count += report->contact_count;
    std::printf("frame %2zu: %5zu contacts, %llu undecided, earliest %.9f\n", frame,
                report->contact_count, (unsigned long long)report->undecided_count, report->toi);

    if (report->contact_count > 0 && !touched) {
      touched = true;
      const double toi = report->toi;
      double earliest = 0;
      check(ccd_session_earliest_toi(session.get(), positions(x0), positions(x1), &earliest));
      require(earliest <= toi && earliest > toi - 1e-6, "earliest and least time differ");
      // Until now the cloth is flat, and first meets the uppermost vertex of the sphere.
      const double exact = (x0[0][1] - kRadius) / (x0[0][1] - x1[0][1]);
      require(toi <= exact + 1e-12 && toi > exact - 2e-6, "the first time is not the true one");
      const CcdHit* hit = nullptr;
      check(ccd_session_first_contact(session.get(), positions(x0), positions(x1), &hit));
      require(hit != nullptr, "there is no first contact");
      const double* p = hit->geometry.point;
      const double* n = hit->geometry.normal;
      std::printf("first contact at (%.3f, %.3f, %.3f), normal (%.1f, %.1f, %.1f)\n", p[0], p[1],
                  p[2], n[0], n[1], n[2]);
    }

    // Vertices of the cloth that would touch stay where they are, until the frame is free.
    std::vector<bool> stays(cloth_count, false);
    for (;;) {
      check(ccd_session_step(session.get(), positions(x0), positions(x1), &report));
      if (report->contact_count == 0) break;
      bool any = false;
      for (std::size_t c = 0; c < report->contact_count; ++c) {
        for (const std::uint32_t v : report->contacts[c].vertices) {
          if (v >= cloth_count || stays[v]) continue;
          stays[v] = any = true;
          x1[v] = x0[v];
        }
      }
      require(any, "what does not move touches");
    }
    double free = 0;
    check(ccd_session_collision_free_stepsize(session.get(), positions(x0), positions(x1), &free));
    require(free == 1.0, "the frame is not free of contact");
    CcdPairs through;
    check(ccd_session_intersections(session.get(), positions(x1), &through));
    require(through.count == 0, "the cloth went through something");
    before = x0;
    x0 = x1;
  }

  require(contact_count == expected_contacts,
          std::to_string(contact_count) + " contacts, but " + std::to_string(expected_contacts) +
              " were expected");
  std::printf("%zu contacts in %zu frames, as expected\n", contact_count, kFrames);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : kExpectedContacts);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "falling_cloth: %s\n", error.what());
    return 1;
  }
}
