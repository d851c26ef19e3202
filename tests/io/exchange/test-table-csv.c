#include "io/exchange/table-csv.h"

#include "core/result/curve-motion.h"

#include "io/result-fixture.h"
#include "io/text/io-error.h"
#include "support/room.h"
#include "support/scratch.h"

typedef gboolean (*WriteFunc) (const char *path, const ResultFixture *fixture,
                               GError **error);

static gboolean
write_curve (const char *path, const ResultFixture *fixture, GError **error)
{
  return qn_result_table_write (path, QN_TABLE_CURVE, &fixture->project,
                                &fixture->contacts, &fixture->result, error);
}

static gboolean
write_displacements (const char *path, const ResultFixture *fixture, GError **error)
{
  return qn_result_table_write (path, QN_TABLE_DISPLACEMENTS, &fixture->project,
                                &fixture->contacts, &fixture->result, error);
}

static gboolean
write_contacts (const char *path, const ResultFixture *fixture, GError **error)
{
  return qn_result_table_write (path, QN_TABLE_CONTACTS, &fixture->project,
                                &fixture->contacts, &fixture->result, error);
}

static void
expect (const ResultFixture *fixture, WriteFunc write, const char *expected)
{
  char *folder = test_scratch_new ();
  char *path = g_build_filename (folder, "table.csv", NULL);
  char *text = NULL;
  g_autoptr (GError) error = NULL;
  g_assert_true (write (path, fixture, &error));
  g_assert_no_error (error);
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  g_assert_cmpstr (text, ==, expected);
  g_free (text);
  g_free (path);
  test_scratch_free (folder);

  g_assert_false (write ("/dev/full", fixture, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE);
}

static void
test_curve (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  expect (
    fixture, write_curve,
    "step,multiplier [-],top ux [m],top uy [m],top rz [rad],iterations,residual [-],"
    "event\n"
    "0,0,0,0,0,3,1e-12,\n"
    "1,0.2,1e-6,-2e-6,3e-9,4,3e-10,collapse\n");
}

/* The control block where there is one, even where it does not move; names that need quotes. */
static void
test_control_block (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  QnModel *model = &fixture->project.model;
  g_assert_cmpint (qn_result_curve_motion (model, &fixture->result).body, ==, 1);
  model->analysis.control.block = 0;
  g_assert_cmpint (qn_result_curve_motion (model, &fixture->result).body, ==, 0);
  model->blocks[0].name[0] = ',';
  model->blocks[0].name[1] = '"';
  expect (
    fixture, write_curve,
    "step,multiplier [-],\",\"\"se ux [m]\",\",\"\"se uy [m]\",\",\"\"se rz [rad]\","
    "iterations,residual [-],event\n"
    "0,0,0,0,0,3,1e-12,\n"
    "1,0.2,0,0,0,4,3e-10,collapse\n");
}

static void
test_no_steps (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  fixture->result.step_count = 0;
  g_assert_cmpint (
    qn_result_curve_motion (&fixture->project.model, &fixture->result).body, ==, QN_NONE);
  expect (fixture, write_curve, "step,multiplier [-],iterations,residual [-],event\n");
}

static void
test_displacements (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  expect (fixture, write_displacements,
          "block,x [m],y [m],ux [m],uy [m],rz [rad]\n"
          "base,1,-0.5,0,0,0\n"
          "top,1,0.5,1e-6,-2e-6,3e-9\n");
}

static void
test_contacts (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  fixture->result.pairs[1].damage = 0.25;
  expect (
    fixture, write_contacts,
    "pair,face,block a,block b,x [m],y [m],normal x [-],normal y [-],normal force [N],"
    "shear force [N],state,damage [-]\n"
    "0,0,base,top,1.5,0,0,1,-6000,-1000,stick,0\n"
    "1,0,base,top,0.5,0,0,1,-4000,-1000,stick,0.25\n");
}

QN_TESTS
{
  RESULT_FIXTURE_ADD ("/table-csv/curve", test_curve);
  RESULT_FIXTURE_ADD ("/table-csv/control-block", test_control_block);
  RESULT_FIXTURE_ADD ("/table-csv/no-steps", test_no_steps);
  RESULT_FIXTURE_ADD ("/table-csv/displacements", test_displacements);
  RESULT_FIXTURE_ADD ("/table-csv/contacts", test_contacts);
}
