/* What the C API refuses, with which status and message, in C11. */

#include <ccd.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void expect(CcdStatus status, CcdStatus wanted, const char *part) {
  if (status != wanted || strstr(ccd_last_error(), part) == NULL) {
    fprintf(stderr, "%s (%s), but %s with \"%s\" was expected\n", ccd_status_name(status),
            ccd_last_error(), ccd_status_name(wanted), part);
    exit(1);
  }
  printf("%s: %s\n", ccd_status_name(status), status == CCD_STATUS_OK ? "" : ccd_last_error());
}

/* A vertex of an engine. */
typedef struct Vertex {
  float normal[3];
  float position[3];
  float texture[2];
} Vertex;

static CcdPositions of(const Vertex *vertices, size_t count) {
  CcdPositions x = {vertices[0].position, sizeof(Vertex), count, CCD_COMPONENT_F32};
  return x;
}

int main(void) {
  const uint32_t triangle[3] = {0, 1, 2}, beyond[3] = {0, 1, 9};
  Vertex before[4] = {{{0}, {0, 0, 0}, {0}}, {{0}, {1, 0, 0}, {0}},
                      {{0}, {0, 0, 1}, {0}}, {{0}, {0.25f, 1, 0.25f}, {0}}};
  Vertex after[4];
  CcdMesh *mesh = NULL;
  CcdSession *session = NULL;
  CcdOptions options;
  const CcdReport *report = NULL;
  double toi = 0;

  if (ccd_version() >> 16 != CCD_VERSION_MAJOR) return 1;
  expect(ccd_mesh_create(4, NULL, 1, 0, &mesh), CCD_STATUS_INVALID_ARGUMENT, "triangles is NULL");
  expect(ccd_mesh_create(4, beyond, 1, 0, &mesh), CCD_STATUS_INVALID_INPUT, "vertex 9");
  expect(ccd_mesh_create(4, triangle, 1, 0, &mesh), CCD_STATUS_OK, "");
  expect(ccd_options_default(&options, 3), CCD_STATUS_INVALID_ARGUMENT, "size of 3 bytes");
  expect(ccd_options_default(&options, sizeof options), CCD_STATUS_OK, "");
  options.threads = 1;
  options.min_distance = -1;
  expect(ccd_session_create(mesh, NULL, &options, &session), CCD_STATUS_INVALID_INPUT, "-1");
  options.min_distance = 0;
  expect(ccd_session_create(mesh, NULL, &options, &session), CCD_STATUS_OK, "");

  memcpy(after, before, sizeof after);
  after[3].position[1] = -1;
  expect(ccd_session_step(session, of(before, 4), of(after, 3), &report), CCD_STATUS_INVALID_INPUT,
         "t1 has 3 vertices");
  if (report != NULL) return 1;
  expect(ccd_session_step(session, of(before, 4), of(after, 4), &report), CCD_STATUS_OK, "");
  if (report->contact_count != 1 || report->contacts[0].a != 3 || report->contacts[0].b != 0) {
    return 1;
  }
  if (!(report->toi <= 0.5 && report->toi > 0.5 - 1e-5)) return 1;
  after[1].position[2] = NAN;
  expect(ccd_session_earliest_toi(session, of(before, 4), of(after, 4), &toi),
         CCD_STATUS_INVALID_INPUT, "vertex 1 at t1 has z = NaN");
  expect(ccd_session_earliest_toi(NULL, of(before, 4), of(after, 4), &toi),
         CCD_STATUS_INVALID_ARGUMENT, "session is NULL");
  ccd_session_destroy(session);
  ccd_mesh_destroy(mesh);
  puts("all refused as expected");
  return 0;
}
