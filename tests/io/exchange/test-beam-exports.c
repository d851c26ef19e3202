/* What other programs get of beams: a cantilever of two elements as VTU, DXF and CSV. */
#include "core/path/analysis.h"
#include "io/exchange/dxf-export.h"
#include "io/exchange/table-csv.h"
#include "io/exchange/vtu.h"
#include "support/room.h"
#include "support/scratch.h"

#include <math.h>
#include <string.h>

/* 1000 N/m down on 2 m: V = 2000 N and M = -2000 N m where it is held. */
static const char json[] =
  "{ \"format\": \"quoin\", \"version\": 1,"
  "  \"sections\": [ { \"name\": \"s\", \"young\": 1e9, \"width\": 0.2, \"height\": 0.2 "
  "} ],"
  "  \"nodes\": [ { \"name\": \"a\", \"at\": [1, 3], \"support\": [true, true, true] },"
  "    { \"name\": \"b\", \"at\": [3, 3] } ],"
  "  \"beams\": [ { \"name\": \"arm, long\", \"nodes\": [\"a\", \"b\"], \"section\": "
  "\"s\","
  "    \"elements\": 2 } ],"
  "  \"loads\": { \"dead\": [ { \"kind\": \"line\", \"beam\": \"arm, long\","
  "    \"value\": [0, -1000] } ] } }";

typedef struct Fixture {
  QnProject project;
  QnContacts contacts;
  QnResult result;
  char *folder;
} Fixture;

static void
setup (Fixture *f, gconstpointer data)
{
  (void) data;
  g_autoptr (GError) error = NULL;
  qn_project_parse (json, strlen (json), "arm", NULL, &f->project, &error);
  g_assert_no_error (error);
  g_assert_cmpint (qn_contacts_detect (&f->project.model, &f->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_analysis_run (&f->project.model, &f->contacts, NULL, NULL, &f->result, NULL), ==,
    QN_OK);
  g_assert_cmpuint (f->result.step_count, >, 0);
  f->folder = test_scratch_new ();
}

static void
teardown (Fixture *f, gconstpointer data)
{
  (void) data;
  qn_result_clear (&f->result);
  qn_contacts_clear (&f->contacts);
  qn_project_clear (&f->project);
  test_scratch_free (f->folder);
}

static char *
read_file (Fixture *f, const char *name)
{
  g_autofree char *path = g_build_filename (f->folder, name, NULL);
  char *text = NULL;
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  return text;
}

static void
test_csv (Fixture *f, gconstpointer data)
{
  (void) data;
  g_autofree char *path = g_build_filename (f->folder, "beams.csv", NULL);
  g_assert_true (qn_result_table_write (path, QN_TABLE_BEAMS, &f->project, &f->contacts,
                                        &f->result, NULL));
  g_autofree char *text = read_file (f, "beams.csv");
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  g_assert_cmpuint (g_strv_length (lines), ==, 6); /* header, 2 x 2, and the end */
  g_assert_true (g_str_has_prefix (lines[0], "beam,element,node,x [m],y [m],s [m],"));
  g_assert_true (g_str_has_prefix (lines[1], "\"arm, long\",0,a,1,3,0,"));
  g_assert_true (g_str_has_prefix (lines[2], "\"arm, long\",0,\"arm, long.1\",2,3,1,"));
  g_assert_true (g_str_has_prefix (lines[4], "\"arm, long\",1,b,3,3,2,"));
  g_auto (GStrv) cells = g_strsplit (lines[1] + strlen ("\"arm, long\","), ",", -1);
  g_assert_cmpfloat_with_epsilon (g_ascii_strtod (cells[6], NULL), 2000, 1e-3);
  g_assert_cmpfloat_with_epsilon (g_ascii_strtod (cells[7], NULL), -2000, 1e-3);
}

static void
test_vtu (Fixture *f, gconstpointer data)
{
  (void) data;
  g_autofree char *path = g_build_filename (f->folder, "arm.pvd", NULL);
  g_assert_true (qn_vtu_export (&f->project.model, &f->contacts, &f->result, path, NULL));
  g_autofree char *list = read_file (f, "arm.pvd");
  g_assert_nonnull (strstr (list, "part=\"2\" file=\"arm_beams_0000.vtu\""));
  g_autofree char *text = read_file (f, "arm_beams_0000.vtu");
  g_assert_nonnull (strstr (text, "NumberOfPoints=\"4\" NumberOfCells=\"2\""));
  g_assert_nonnull (strstr (text, "1 3 0\n2 3 0\n2 3 0\n3 3 0\n"));
  const char *forces = strstr (text, "Name=\"normal_shear_moment\"");
  g_assert_nonnull (forces);
  char *at = strchr (forces, '\n');
  double first[3];
  for (int i = 0; i < 3; i++)
    first[i] = g_ascii_strtod (at, &at);
  g_assert_cmpfloat_with_epsilon (first[0], 0, 1e-6);
  g_assert_cmpfloat_with_epsilon (first[1], 2000, 1e-3);
  g_assert_cmpfloat_with_epsilon (first[2], -2000, 1e-3);
  const char *moved = strstr (text, "Name=\"displacement\"");
  at = strchr (moved, '\n');
  double last = 0;
  for (int i = 0; i < 11; i++) /* uy of the fourth point */
    last = g_ascii_strtod (at, &at);
  /* q L^4 / 8EI and q L^2 / 2kGA: E 1 GPa, I 0.2^4 / 12, G = E / 2 */
  double inertia = pow (0.2, 4) / 12;
  double bending = 1000 * 16 / (8 * 1e9 * inertia);
  double shear = 1000 * 4 / (2 * 5.0 / 6 * 0.5e9 * 0.04);
  g_assert_cmpfloat_with_epsilon (last, -(bending + shear), 1e-9);
}

/* Lines on a layer of their own, and where they have gone to; without beams no such layer. */
static void
test_dxf (Fixture *f, gconstpointer data)
{
  (void) data;
  g_autofree char *path = g_build_filename (f->folder, "arm.dxf", NULL);
  g_assert_true (
    qn_dxf_export (&f->project.model, &f->contacts, &f->result, 1, 0.001, path, NULL));
  g_autofree char *text = read_file (f, "arm.dxf");
  g_auto (GStrv) beams = g_strsplit (text, "  8\nBEAM_AXES\n", -1);
  g_assert_cmpuint (g_strv_length (beams), ==, 2);
  g_assert_true (g_str_has_prefix (beams[1],
                                   "100\nAcDbLine\n 10\n1000\n 20\n3000\n 30\n0.0\n"
                                   " 11\n3000\n 21\n3000\n 31\n0.0\n"));
  g_auto (GStrv) moved = g_strsplit (text, "  8\nDEFORMED\n", -1);
  g_assert_cmpuint (g_strv_length (moved), ==, 3);
  f->project.model.beam_count = 0;
  gsize elements = f->project.model.element_count;
  f->project.model.element_count = 0;
  g_assert_true (qn_dxf_export (&f->project.model, &f->contacts, NULL, 1, 1, path, NULL));
  g_autofree char *without = read_file (f, "arm.dxf");
  g_assert_null (strstr (without, "BEAM_AXES"));
  f->project.model.beam_count = 1;
  f->project.model.element_count = elements;
}

QN_TESTS
{
  g_test_add ("/io/beam-exports/csv", Fixture, NULL, setup, test_csv, teardown);
  g_test_add ("/io/beam-exports/vtu", Fixture, NULL, setup, test_vtu, teardown);
  g_test_add ("/io/beam-exports/dxf", Fixture, NULL, setup, test_dxf, teardown);
}
