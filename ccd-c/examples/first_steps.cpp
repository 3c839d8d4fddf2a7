#include <ccd.h>
#include <cstdio>

int main() {
  // A triangle on the ground, and a vertex that falls through it.
  const float before[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0.2f, 1, 0.2f}};
  const float after[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0.2f, -1, 0.2f}};
  const uint32_t triangles[1][3] = {{0, 1, 2}};

  CcdMesh *mesh = nullptr;
  CcdSession *session = nullptr;
  if (ccd_mesh_create(4, triangles[0], 1, 0, &mesh) != CCD_STATUS_OK ||
      ccd_session_create(mesh, nullptr, nullptr, &session) != CCD_STATUS_OK) {
    std::fprintf(stderr, "%s\n", ccd_last_error());
    return 1;
  }
  const CcdPositions x0 = {before, 0, 4, CCD_COMPONENT_F32};
  const CcdPositions x1 = {after, 0, 4, CCD_COMPONENT_F32};
  const CcdReport *report = nullptr; // belongs to the session, until its next call
  if (ccd_session_step(session, x0, x1, &report) == CCD_STATUS_OK) {
    std::printf("%zu contacts, the first at %f\n", report->contact_count, report->toi);
  }
  ccd_session_destroy(session);
  ccd_mesh_destroy(mesh);
}
