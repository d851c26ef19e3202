#include "io/exchange/vtu.h"
#include "io/result-fixture.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>
#include <sys/wait.h>

static char *
read_text (const char *folder, const char *name)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  char *text;
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  return text;
}

/* Well-formed XML; element names are counted. */
static void
count_element (GMarkupParseContext *context, const char *name, const char **keys,
               const char **values, gpointer counts, GError **error)
{
  (void) context;
  (void) keys;
  (void) values;
  (void) error;
  int count = GPOINTER_TO_INT (g_hash_table_lookup (counts, name));
  g_hash_table_insert (counts, g_strdup (name), GINT_TO_POINTER (count + 1));
}

static GHashTable *
parse_xml (const char *text)
{
  const GMarkupParser parser = { .start_element = count_element };
  GHashTable *counts = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  GMarkupParseContext *context = g_markup_parse_context_new (&parser, 0, counts, NULL);
  g_autoptr (GError) error = NULL;
  if (!g_markup_parse_context_parse (context, text, -1, &error)
      || !g_markup_parse_context_end_parse (context, &error))
    g_error ("%s", error->message);
  g_markup_parse_context_free (context);
  return counts;
}

/* The numbers of a DataArray. */
static GArray *
array_of (const char *text, const char *name)
{
  g_autofree char *key = g_strdup_printf ("Name=\"%s\"", name);
  const char *start = strstr (text, key);
  g_assert_nonnull (start);
  start = strchr (start, '>') + 1;
  GArray *numbers = g_array_new (FALSE, FALSE, sizeof (double));
  char *end;
  for (;;) {
    double number = g_ascii_strtod (start, &end);
    if (end == start)
      break;
    g_array_append_val (numbers, number);
    start = end;
  }
  return numbers;
}

static double
number_at (const GArray *numbers, guint index)
{
  g_assert_cmpuint (index, <, numbers->len);
  return g_array_index (numbers, double, index);
}

static void
test_steps (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "out.pvd", NULL);
  g_autoptr (GError) error = NULL;
  const QnModel *model = &fixture->project.model;
  g_assert_true (
    qn_vtu_export (model, &fixture->contacts, &fixture->result, path, &error));
  g_assert_cmpuint (test_scratch_count (folder), ==, fixture->result.step_count + 2);

  g_autofree char *index = read_text (folder, "out.pvd");
  g_autoptr (GHashTable) sets = parse_xml (index);
  g_assert_cmpint (GPOINTER_TO_INT (g_hash_table_lookup (sets, "DataSet")), ==,
                   (int) fixture->result.step_count + 1);

  g_autofree char *step = read_text (folder, "out_0001.vtu");
  g_autoptr (GHashTable) elements = parse_xml (step);
  g_assert_cmpint (GPOINTER_TO_INT (g_hash_table_lookup (elements, "DataArray")), ==, 9);
  g_autoptr (GArray) points = array_of (step, "Points");
  g_autoptr (GArray) types = array_of (step, "types");
  g_autoptr (GArray) motion = array_of (step, "motion");
  g_autoptr (GArray) moved = array_of (step, "displacement");
  g_assert_cmpuint (points->len, ==, 3 * 8);
  g_assert_cmpuint (types->len, ==, model->block_count);
  g_assert_cmpfloat (number_at (types, 0), ==, 7);
  const double *u = qn_result_step_displacements (&fixture->result, 1) + QN_DOF_COUNT;
  for (guint dof = 0; dof < QN_DOF_COUNT; dof++)
    g_assert_cmpfloat (number_at (motion, QN_DOF_COUNT + dof), ==, u[dof]);
  /* The mean of the corners of a rectangle moves as its centroid. */
  double mean = 0;
  for (guint i = 4; i < 8; i++)
    mean += number_at (moved, 3 * i) / 4;
  g_assert_cmpfloat_with_epsilon (mean, u[QN_DOF_UX], 1e-15);
}

/* Forces on the second block of each face: the reaction of the base carries the block above. */
static void
test_forces (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "out.pvd", NULL);
  g_assert_true (qn_vtu_export (&fixture->project.model, &fixture->contacts,
                                &fixture->result, path, NULL));
  g_autofree char *text = read_text (folder, "out_forces.vtu");
  g_autoptr (GArray) forces = array_of (text, "normal_shear_force");
  g_autoptr (GArray) points = array_of (text, "Points");
  g_assert_cmpuint (forces->len, ==, 4);
  g_assert_cmpfloat_with_epsilon (number_at (forces, 0) + number_at (forces, 2), -10000,
                                  1e-6);
  for (guint pair = 0; pair < 2; pair++)
    g_assert_cmpfloat (number_at (points, 6 * pair + 4), >,
                       number_at (points, 6 * pair + 1));
}

static void
test_without_result (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "a & b.pvd", NULL);
  g_assert_true (
    qn_vtu_export (&fixture->project.model, &fixture->contacts, NULL, path, NULL));
  g_assert_cmpuint (test_scratch_count (folder), ==, 2);
  g_autofree char *index = read_text (folder, "a & b.pvd");
  g_autoptr (GHashTable) sets = parse_xml (index);
  g_assert_cmpint (GPOINTER_TO_INT (g_hash_table_lookup (sets, "DataSet")), ==, 1);
}

/* VTK's own reader, where Python has it. */
static void
test_vtk_reads (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  static const char script[] =
    "import sys\n"
    "try:\n from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader as R\n"
    "except ImportError: sys.exit(77)\n"
    "for f, cells in zip(sys.argv[1::2], sys.argv[2::2]):\n"
    " r = R(); r.SetFileName(f); r.Update(); g = r.GetOutput()\n"
    " assert r.GetErrorCode() == 0 and g.GetNumberOfCells() == int(cells), f\n"
    " assert g.GetCellData().GetNumberOfArrays() >= 3, f\n";
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "out.pvd", NULL);
  g_autofree char *step = g_build_filename (folder, "out_0000.vtu", NULL);
  g_autofree char *forces = g_build_filename (folder, "out_forces.vtu", NULL);
  g_assert_true (qn_vtu_export (&fixture->project.model, &fixture->contacts,
                                &fixture->result, path, NULL));
  char *arguments[] = { (char *) "/usr/bin/python3",
                        (char *) "-c",
                        (char *) script,
                        step,
                        (char *) "2",
                        forces,
                        (char *) "2",
                        NULL };
  int status = 0;
  if (!g_spawn_sync (NULL, arguments, NULL, G_SPAWN_DEFAULT, NULL, NULL, NULL, NULL,
                     &status, NULL)
      || g_spawn_check_wait_status (status, NULL) == FALSE)
    status = WIFEXITED (status) ? WEXITSTATUS (status) : 1;
  if (status == 77)
    g_test_skip ("VTK is not installed");
  else
    g_assert_cmpint (status, ==, 0);
}

QN_TESTS
{
  g_test_add ("/vtu/steps", ResultFixture, NULL, result_fixture_set_up, test_steps,
              result_fixture_tear_down);
  g_test_add ("/vtu/forces", ResultFixture, NULL, result_fixture_set_up, test_forces,
              result_fixture_tear_down);
  g_test_add ("/vtu/without-result", ResultFixture, NULL, result_fixture_set_up,
              test_without_result, result_fixture_tear_down);
  g_test_add ("/vtu/vtk-reads", ResultFixture, NULL, result_fixture_set_up,
              test_vtk_reads, result_fixture_tear_down);
}
