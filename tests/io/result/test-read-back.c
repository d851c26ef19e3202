/* What is written of every kind of analysis, for every outcome, is read again and passes the check of
 * `quoin-cli check --result`; nothing in it is infinite or no number. So are its tables. Those of
 * capacity, of scaled records and of studies are read again by tests/cli. */
#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "core/path/stability.h"
#include "io/exchange/table-csv.h"
#include "io/result/result-file.h"
#include "io/text/fault-text.h"
#include "io/text/outcome-text.h"
#include "support/auto-clear.h"
#include "support/room.h"
#include "support/scratch.h"
#include "support/table.h"

#include <math.h>
#include <string.h>

typedef enum { ANALYSIS, REFUSED, CANCELLED, MODAL, LOADED, STABILITY } Kind;

typedef struct Row {
  const char *name;
  Kind kind;
  const char *example;
  const char *overrides[4];
  QnOutcome outcome;
} Row;

#define LIMIT           "analysis.procedure=limit"
#define NON_ASSOCIATIVE "analysis.flow=non-associative"
#define NONLINEAR       "analysis.geometry=nonlinear"

static const Row rows[] = {
  { "load", ANALYSIS, "01-sliding-block", { NULL }, QN_OUTCOME_COLLAPSE },
  { "load to an end",
    ANALYSIS,
    "01-sliding-block",
    { "analysis.max_multiplier=0.1" },
    QN_OUTCOME_TARGET_REACHED },
  { "dead load alone",
    ANALYSIS,
    "06-arch",
    { "analysis.max_multiplier=0" },
    QN_OUTCOME_TARGET_REACHED },
  { "load, large displacements",
    ANALYSIS,
    "ferris-tin-loi/wall1",
    { NONLINEAR, "laws[0].kn=1e9", "laws[0].ks=1e9" },
    QN_OUTCOME_COLLAPSE },
  { "jumps", ANALYSIS, "15-rubble-pier", { NULL }, QN_OUTCOME_COLLAPSE },
  { "stops at a jump",
    ANALYSIS,
    "15-rubble-pier",
    { "analysis.snap=stop" },
    QN_OUTCOME_SNAP },
  { "unbounded",
    ANALYSIS,
    "01-sliding-block",
    { "laws[0].kind=elastic" },
    QN_OUTCOME_UNBOUNDED },
  { "dead load unstable",
    ANALYSIS,
    "04-block-on-slope",
    { "laws[0].friction=0.1" },
    QN_OUTCOME_DEAD_LOAD_UNSTABLE },
  { "effort spent",
    ANALYSIS,
    "ferris-tin-loi/wall3",
    { "analysis.max_factorizations=10" },
    QN_OUTCOME_NOT_CONVERGED },
  { "no effort at all",
    ANALYSIS,
    "ferris-tin-loi/wall3",
    { "analysis.max_factorizations=1" },
    QN_OUTCOME_NOT_CONVERGED },
  { "refused", REFUSED, "ferris-tin-loi/wall1", { NULL }, QN_OUTCOME_NOT_CONVERGED },
  { "cancelled", CANCELLED, "ferris-tin-loi/wall3", { NULL }, QN_OUTCOME_CANCELLED },
  { "displacement", ANALYSIS, "24-rocking-block", { NULL }, QN_OUTCOME_TARGET_REACHED },
  { "contacts that follow",
    ANALYSIS,
    "29-block-over-an-edge",
    { NULL },
    QN_OUTCOME_TARGET_REACHED },
  { "work",
    ANALYSIS,
    "ferris-tin-loi/wall1",
    { "analysis.procedure=work" },
    QN_OUTCOME_COLLAPSE },
  { "arc length",
    ANALYSIS,
    "ferris-tin-loi/wall1",
    { "analysis.procedure=arc-length" },
    QN_OUTCOME_COLLAPSE },
  { "stages", ANALYSIS, "16-load-stages", { NULL }, QN_OUTCOME_COLLAPSE },
  { "unloading", ANALYSIS, "17-unloading", { NULL }, QN_OUTCOME_TARGET_REACHED },
  { "settlement", ANALYSIS, "18-spreading-arch", { NULL }, QN_OUTCOME_TARGET_REACHED },
  { "beams", ANALYSIS, "34-frame-hybrid", { NULL }, QN_OUTCOME_COLLAPSE },
  { "tie", ANALYSIS, "38-tied-walls", { NULL }, QN_OUTCOME_COLLAPSE },
  { "bars", ANALYSIS, "09-reinforced-cantilever", { NULL }, QN_OUTCOME_COLLAPSE },
  { "in time", ANALYSIS, "40-rocking-in-time", { NULL }, QN_OUTCOME_TARGET_REACHED },
  { "cancelled in time",
    CANCELLED,
    "40-rocking-in-time",
    { NULL },
    QN_OUTCOME_CANCELLED },
  { "limit", ANALYSIS, "ferris-tin-loi/wall1", { LIMIT }, QN_OUTCOME_COLLAPSE },
  { "fixed points",
    ANALYSIS,
    "ferris-tin-loi/wall4",
    { LIMIT, NON_ASSOCIATIVE },
    QN_OUTCOME_COLLAPSE },
  { "limit, unbounded",
    ANALYSIS,
    "01-sliding-block",
    { LIMIT, "loads.live=[{\"kind\": \"weight\", \"direction\": [0, -1]}]" },
    QN_OUTCOME_UNBOUNDED },
  { "limit, dead load unstable",
    ANALYSIS,
    "04-block-on-slope",
    { LIMIT, "laws[0].friction=0.1" },
    QN_OUTCOME_DEAD_LOAD_UNSTABLE },
  { "limit, cancelled",
    CANCELLED,
    "ferris-tin-loi/wall1",
    { LIMIT },
    QN_OUTCOME_CANCELLED },
  { "modes", MODAL, "11-vibrating-beam", { NULL }, QN_OUTCOME_TARGET_REACHED },
  { "modes under load",
    LOADED,
    "11-vibrating-beam",
    { NULL },
    QN_OUTCOME_TARGET_REACHED },
  { "stability", STABILITY, "21-column-pinned", { NULL }, QN_OUTCOME_SNAP },
  { "stability kept",
    STABILITY,
    "21-column-pinned",
    { "analysis.max_multiplier=0.5" },
    QN_OUTCOME_TARGET_REACHED },
};

/* The third question is answered with no. */
static bool
ask_thrice (const QnProgress *progress, void *count)
{
  (void) progress;
  return ++*(int *) count < 3;
}

static QnStatus
run (const Row *row, const QnProject *project, const QnContacts *contacts,
     QnResult *result, QnDiag *diag)
{
  const QnModel *model = &project->model;
  QnModes modes = { 0 };
  int count = 0;
  QnStatus status = QN_OK;

  switch (row->kind) {
  case ANALYSIS:
    return qn_analysis_run (model, contacts, NULL, NULL, result, diag);
  case REFUSED:
    status = qn_analysis_run (model, contacts, NULL, NULL, result, diag);
    if (status != QN_OK)
      return status;
    result->step_forces[(result->step_count - 1) * result->pair_count] -= 1e3;
    return qn_result_prove (model, contacts, result, diag);
  case CANCELLED:
    return qn_analysis_run (model, contacts, ask_thrice, &count, result, diag);
  case STABILITY:
    return qn_stability_run (model, contacts, NULL, NULL, result, diag);
  case MODAL:
  case LOADED:
    status = qn_modal_run (model, contacts,
                           row->kind == LOADED ? QN_MODAL_LOADED : QN_MODAL_DEAD_LOAD, 3,
                           NULL, NULL, &modes, result, diag);
    if (status == QN_OK)
      status = qn_modes_show (&modes, 1, model, result, diag);
    qn_modes_clear (&modes);
    break;
  }
  return status;
}

/* As `quoin-cli check --result` checks it. */
static void
check_read (const QnResultFile *file, const QnProject *project,
            const QnContacts *contacts)
{
  QnResultFaults faults;
  g_autoptr (GError) error = NULL;

  qn_result_file_find_faults (file, "result.json", project, contacts, &faults, &error);
  g_assert_no_error (error);
  if (faults.count > 0)
    g_error ("%s", qn_fault_dup_text (&project->model, contacts, &faults.items[0]));
}

static void
check_same (const QnResult *read, const QnResult *result)
{
  g_assert_cmpint (read->outcome, ==, result->outcome);
  g_assert_cmpuint (read->step_count, ==, result->step_count);
  g_assert_cmpuint (read->event_count, ==, result->event_count);
  g_assert_cmpint (read->solution_count, ==, result->solution_count);
  g_assert_cmpint (read->has_collapse_multiplier, ==, result->has_collapse_multiplier);
  g_assert_cmpint (read->has_first_limit_multiplier, ==,
                   result->has_first_limit_multiplier);
  g_assert_cmpint (read->has_unproved_multiplier, ==, result->has_unproved_multiplier);
  g_assert_cmpint (read->refused_count, ==, result->refused_count);
  for (int i = 0; i < read->refused_count; i++) {
    g_assert_cmpint (read->refused[i].claim, ==, result->refused[i].claim);
    g_assert_cmpint (read->refused[i].step, ==, result->refused[i].step);
    g_assert_cmpint (read->refused[i].index, ==, result->refused[i].index);
    if (!isnan (result->refused[i].stated))
      g_assert_cmpfloat (read->refused[i].stated, ==, result->refused[i].stated);
  }
  g_assert_cmpint (read->stability, ==, result->stability);
  g_assert_cmpint (read->vibration.mode, ==, result->vibration.mode);
  g_assert_cmpint (read->vibration.sliding, ==, result->vibration.sliding);
  g_assert_cmpuint (read->history.row_count, ==, result->history.row_count);
  if (result->step_count > 0)
    g_assert_cmpmem (
      read->displacements, read->step_count * qn_result_body_count (read) * 24,
      result->displacements, result->step_count * qn_result_body_count (result) * 24);
  if (result->has_collapse_multiplier)
    g_assert_cmpfloat (read->collapse_multiplier, ==, result->collapse_multiplier);
}

/* The rows of the table that was just written, without its headings. */
static GPtrArray *
read_table (const char *path, gboolean written, GError *error, guint count)
{
  g_autofree char *text = NULL;
  g_assert_no_error (error);
  g_assert_true (written);
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  GPtrArray *table = test_table_read (text);
  g_assert_cmpuint (table->len, ==, count + 1);
  return table;
}

static void
check_curve (const GPtrArray *table, const QnResult *result)
{
  gboolean in_time = result->history.width > 0;
  for (guint i = 1; i < table->len; i++)
    if (in_time)
      g_assert_cmpfloat (test_table_number (table, i, "time [s]"), ==,
                         result->history.rows[(i - 1) * result->history.width]);
    else
      g_assert_cmpfloat (test_table_number (table, i, "multiplier [-]"), ==,
                         result->steps[i - 1].multiplier);
}

static void
check_tables (const char *folder, const QnProject *project, const QnContacts *contacts,
              const QnResult *result)
{
  g_autofree char *path = g_build_filename (folder, "table.csv", NULL);
  const QnModel *model = &project->model;
  GError *error = NULL;
  gboolean written =
    qn_result_table_write (path, QN_TABLE_CURVE, project, contacts, result, &error);
  g_autoptr (GPtrArray) curve = read_table (
    path, written, error,
    (guint) (result->history.width > 0 ? result->history.row_count : result->step_count));
  check_curve (curve, result);

  written =
    qn_result_table_write (path, QN_TABLE_CONTACTS, project, contacts, result, &error);
  g_autoptr (GPtrArray) pairs = read_table (
    path, written, error, result->step_count > 0 ? (guint) contacts->pair_count : 0);
  for (guint i = 1; result->step_count > 0 && i < pairs->len; i++) {
    g_assert_cmpfloat (test_table_number (pairs, i, "normal force [N]"), ==,
                       result->pairs[i - 1].normal_force);
    g_assert_cmpfloat (test_table_number (pairs, i, "damage [-]"), ==,
                       result->pairs[i - 1].damage);
  }

  bool has_beams = result->step_count > 0
                   && qn_result_step_beam_forces (result, result->step_count - 1) != NULL;
  written =
    qn_result_table_write (path, QN_TABLE_BEAMS, project, contacts, result, &error);
  g_autoptr (GPtrArray) beams =
    read_table (path, written, error, has_beams ? 2 * (guint) model->element_count : 0);
  g_assert_cmpuint (beams->len, >, 0);

  if (result->step_count == 0)
    return;
  size_t last = result->step_count - 1;
  const double *moved = qn_result_step_displacements (result, last);
  written = qn_result_table_write (path, QN_TABLE_DISPLACEMENTS, project, contacts,
                                   result, &error);
  g_autoptr (GPtrArray) blocks =
    read_table (path, written, error, (guint) (model->block_count + model->node_count));
  for (guint i = 1; i < blocks->len; i++)
    g_assert_cmpfloat (test_table_number (blocks, i, "rz [rad]"), ==,
                       moved[QN_DOF_COUNT * (i - 1) + QN_DOF_RZ]);
}

static void
test_row (gconstpointer data)
{
  const Row *row = data;
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "result.json", NULL);
  g_autofree char *name = g_strconcat (row->example, ".quoin", NULL);
  g_autofree char *example = g_build_filename (g_getenv ("QUOIN_EXAMPLES"), name, NULL);
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  QnResultFile file;
  QnDiag diag = { 0 };
  g_autoptr (GError) error = NULL;

  qn_project_load (example, row->overrides, &project, &error);
  g_assert_no_error (error);
  g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, NULL), ==, QN_OK);
  QnStatus status = run (row, &project, &contacts, &result, &diag);
  if (status != QN_OK)
    g_error ("%s", qn_problem_text (diag.problem));
  g_assert_cmpstr (qn_outcome_names[result.outcome], ==, qn_outcome_names[row->outcome]);
  for (int detail = 0; detail < QN_DETAIL_COUNT; detail++) {
    qn_result_file_write (path, &project, &contacts, &result, (QnResultDetail) detail,
                          &error);
    g_assert_no_error (error);
    qn_result_file_read (path, &file, &error);
    g_assert_no_error (error);
    check_same (&file.result, &result);
    check_read (&file, &project, &contacts);
    if (result.stop == QN_STOP_FACTORIZATIONS) {
      g_autofree char *said = qn_outcome_dup_reason (&project.model, &file.result);
      g_assert_nonnull (strstr (said, "max_factorizations"));
    }
    qn_result_file_clear (&file);
  }
  check_tables (folder, &project, &contacts, &result);
}

QN_TESTS
{
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++) {
    g_autofree char *path = g_strdup_printf ("/result/read-back/%s", rows[i].name);
    g_test_add_data_func (path, &rows[i], test_row);
  }
}
