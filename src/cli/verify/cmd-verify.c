#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "core/base/word.h"
#include "core/modal/modal.h"
#include "core/path/analysis.h"
#include "core/path/stability.h"

#include <errno.h>
#include <gio/gio.h>
#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Where the models and verify.desktop lie: files of examples/, compiled into the program, so that it can be verified
 * wherever it is installed. */
#define RESOURCES "/io/github/quoin/verify/"

/* What a case compares; verify.desktop explains them. */
typedef enum {
  COLLAPSE,
  DISPLACEMENT,
  MULTIPLIER,
  REACTION,
  CRITICAL,
  FREQUENCY,
  BRANCH,
  QUANTITY_COUNT
} Quantity;

typedef struct Case {
  const char *name, *model, *body; /* `name` is translatable */
  double reference;
  double
    tolerance; /* relative to the reference, or to `scale`; INFINITY: only reported */
  double published; /* 0 where there is no value */
  Quantity quantity;
  QnDof dof;
  int number;   /* of a stage or mode, from 1; 0: the last step */
  double scale; /* what errors are relative to; 0: the reference */
  double at;
} Case;

/* A table of cases: a group of verify.desktop, whose rows have its name with a slash and a number. */
typedef struct Table {
  GKeyFile *file;
  const char *name;
} Table;

static char *verify_keep; /* folder for result files, or NULL */

/* Tally over all cases. */
typedef struct Tally {
  guint met, missed, reported;
  guint uncertain; /* rows whose mechanism was not settled */
} Tally;

/* The bytes of a file that is compiled in. */
static GBytes *
look_up (const char *name)
{
  g_autofree char *path = g_strconcat (RESOURCES, name, NULL);
  GBytes *bytes = g_resources_lookup_data (path, 0, QN_TROUBLE);
  qn_cli_must (bytes != NULL);
  return bytes;
}

static const char *
text_of (GKeyFile *file, const char *group, const char *key)
{
  char *text = g_key_file_get_string (file, group, key, NULL);
  return text != NULL ? qn_cli_keep (text) : NULL;
}

/* A word of a list; the first one where none is given. */
static int
word_of (GKeyFile *file, const char *group, const char *key, const char *const *words,
         size_t count)
{
  int found = 0;
  const char *word = text_of (file, group, key);
  if (word != NULL && !qn_find_word (word, words, count, &found))
    g_error ("%s: %s: %s", group, key, word);
  return found;
}

static Case
read_case (GKeyFile *file, const char *row)
{
  static const char *const quantities[QUANTITY_COUNT] = { "collapse",   "displacement",
                                                          "multiplier", "reaction",
                                                          "critical",   "frequency",
                                                          "branch" };
  gboolean judged = g_key_file_has_key (file, row, "Tolerance", NULL);
  return (Case){
    .name = text_of (file, row, "Name"),
    .model = text_of (file, row, "Model"),
    .body = text_of (file, row, "Body"),
    .reference = g_key_file_get_double (file, row, "Reference", NULL),
    .tolerance = judged ? g_key_file_get_double (file, row, "Tolerance", NULL) : INFINITY,
    .published = g_key_file_get_double (file, row, "Published", NULL),
    .quantity = (Quantity) word_of (file, row, "Quantity", quantities, QUANTITY_COUNT),
    .dof = (QnDof) word_of (file, row, "Dof", qn_dof_names, QN_DOF_COUNT),
    .number = g_key_file_get_integer (file, row, "Number", NULL),
    .scale = g_key_file_get_double (file, row, "Scale", NULL),
    .at = g_key_file_get_double (file, row, "At", NULL),
  };
}

/* A column of `width` characters: text is padded by what is seen, not by bytes. */
static void
print_cell (const char *text, int width, gboolean left)
{
  int padding = MAX (0, width - (int) g_utf8_strlen (text, -1));
  if (left)
    qn_print ("%s%*s", text, padding, "");
  else
    qn_print (" %*s%s", padding, "", text);
}

static void
print_value (double value, gboolean known)
{
  int decimals = fabs (value) < 100 ? 6 : 3;
  g_autofree char *text =
    known ? g_strdup_printf ("%.*f", decimals, value) : g_strdup ("–");
  print_cell (text, 10, FALSE);
}

/* Prints a row; returns whether the reference was met. */
static gboolean
print_row (const Case *test, const QnInput *input, const QnResult *result, double found,
           double bound)
{
  double scale = test->scale > 0 ? test->scale : fabs (test->reference);
  double error = (found - test->reference) / scale;
  if (test->scale == 0 && test->reference < 0)
    error = -error; /* too large in size is an excess */
  gboolean met = fabs (error) <= test->tolerance;

  size_t free_blocks = 0;
  for (size_t i = 0; i < input->project.model.block_count; i++)
    free_blocks += !qn_support_is_full (input->project.model.blocks[i].support);
  g_autofree char *name =
    g_strconcat (_ (test->name), result->mechanism_uncertain ? "‡" : "", NULL);
  print_cell (name, 23, TRUE);
  qn_print (" %6zu %5zu", free_blocks, input->contacts.face_count);
  print_value (test->reference, TRUE);
  print_value (test->published, test->published > 0);
  print_value (found, isfinite (found));
  qn_print (" %+8.4f", 100 * error);
  if (isfinite (test->tolerance))
    qn_print (" %7.4f", 100 * test->tolerance);
  else
    print_cell (_ ("none"), 7, FALSE);
  print_value (bound, isfinite (bound));
  print_value (result->first_limit_multiplier, result->has_first_limit_multiplier);
  qn_print (" %7.3f %14d %s\n", result->statistics.seconds,
            result->statistics.factorizations, met ? "" : _ ("MISSED"));
  fflush (stdout);
  return met;
}

/* Writes the result as FOLDER/GROUP/<name of the model file>.json. */
static void
keep_result (const char *table, const QnInput *input, const QnResult *result)
{
  if (verify_keep == NULL)
    return;
  g_autofree char *folder = g_build_filename (verify_keep, table, NULL);
  g_autofree char *base = g_path_get_basename (input->project.name);
  char *ending = g_strrstr (base, ".quoin");
  if (ending != NULL)
    *ending = '\0';
  g_autofree char *name = g_strconcat (base, ".json", NULL);
  g_autofree char *path = g_build_filename (folder, name, NULL);

  if (g_mkdir_with_parents (folder, 0777) != 0)
    qn_cli_fail (QN_EXIT_FILE, _ ("%s: cannot be made: %s"), folder, g_strerror (errno));
  qn_cli_must (qn_result_file_write (path, &input->project, &input->contacts, result,
                                     QN_DETAIL_FORCES, QN_TROUBLE));
}

/* --- What a case compares --- */

static double
find_reaction (const Case *test, const QnModel *model, const QnResult *result)
{
  QnId block = qn_model_find_block (model, test->body);
  for (size_t s = 0; s < result->support_count; s++)
    if (result->supports[s] == block)
      return qn_result_step_reactions (
        result, result->step_count - 1)[s * QN_DOF_COUNT + (size_t) test->dof];
  return NAN;
}

/* Displacement along x of the vertex of the block that lies furthest up and right. */
static double
corner_displacement (const QnModel *model, QnId block, const double *u)
{
  const QnVec2 *vertices = qn_model_block_vertices (model, block);
  QnVec2 corner = vertices[0];
  for (QnId v = 1; v < model->blocks[block].vertex_count; v++)
    if (vertices[v].x + vertices[v].y > corner.x + corner.y)
      corner = vertices[v];

  QnVec2 arm = qn_vec2_sub (corner, model->blocks[block].centroid);
  double rz = u[QN_DOF_RZ];
  return u[QN_DOF_UX] + qn_vec2_rotate (arm, cos (rz), sin (rz)).x - arm.x;
}

/* Not-a-number where the path does not come there. */
static double
read_branch (const Case *test, const QnModel *model, const QnResult *result)
{
  QnId block = qn_model_find_block (model, test->body);
  double before = NAN;
  if (block == QN_NONE)
    return NAN;
  for (size_t i = 0; i < result->step_count; i++) {
    const double *u =
      qn_result_step_displacements (result, i) + (size_t) block * QN_DOF_COUNT;
    double moved = corner_displacement (model, block, u);
    if (before < test->at && moved >= test->at) {
      double share = (test->at - before) / (moved - before);
      double last = result->steps[i - 1].multiplier;
      return last + share * (result->steps[i].multiplier - last);
    }
    before = moved;
  }
  return NAN;
}

/* Results of the path of an analysis. */
static double
read_path (const Case *test, const QnModel *model, const QnResult *result)
{
  if (test->quantity == COLLAPSE)
    return result->outcome == QN_OUTCOME_COLLAPSE ? result->collapse_multiplier : NAN;
  if (test->quantity == BRANCH)
    return read_branch (test, model, result);
  gssize step = (gssize) result->step_count - 1; /* of the stage, or of the path */
  while (step >= 0 && test->number != 0 && result->steps[step].stage != test->number)
    step--;
  if (result->outcome != QN_OUTCOME_TARGET_REACHED || step < 0)
    return NAN;
  if (test->quantity == MULTIPLIER)
    return result->steps[step].multiplier;
  if (test->quantity == REACTION)
    return find_reaction (test, model, result);
  QnId block = qn_model_find_block (model, test->body);
  QnId node = qn_model_find_node (model, test->body);
  if (block == QN_NONE && node == QN_NONE)
    return NAN;
  size_t body = block != QN_NONE ? (size_t) block : model->block_count + (size_t) node;
  return qn_result_step_displacements (
    result, (size_t) step)[body * QN_DOF_COUNT + (size_t) test->dof];
}

/* Runs the analysis that the case asks for. *value is not-a-number where it did not come to what is
 * compared. *result is overwritten, empty on failure. */
static QnStatus
run_analysis (const Case *test, const QnInput *input, QnResult *result, double *value,
              QnDiag *diag)
{
  const QnModel *model = &input->project.model;
  const QnContacts *contacts = &input->contacts;
  QnModes modes;
  QnStatus status;

  *value = NAN;
  switch (test->quantity) {
  case FREQUENCY:
    status = qn_modal_run (model, contacts, QN_MODAL_DEAD_LOAD, (size_t) test->number,
                           qn_terminal_progress_update, NULL, &modes, result, diag);
    if (status != QN_OK)
      return status;
    if (modes.count >= (size_t) test->number)
      *value = modes.omega[test->number - 1];
    qn_modes_clear (&modes);
    return QN_OK;
  case CRITICAL:
    status =
      qn_stability_run (model, contacts, qn_terminal_progress_update, NULL, result, diag);
    if (status == QN_OK && result->outcome == QN_OUTCOME_SNAP)
      *value = result->first_limit_multiplier;
    return status;
  case COLLAPSE:
  case DISPLACEMENT:
  case MULTIPLIER:
  case REACTION:
  case BRANCH:
  case QUANTITY_COUNT:
    break;
  }
  status =
    qn_analysis_run (model, contacts, qn_terminal_progress_update, NULL, result, diag);
  if (status == QN_OK)
    *value = read_path (test, model, result);
  return status;
}

/* --- All of it --- */

static void
run_case (Table table, const Case *test, Tally *tally)
{
  QnInput input = { 0 };
  QnResult result = { 0 };
  QnDiag diag = { 0 };
  double found = NAN;

  const char *const overrides[] = { text_of (table.file, table.name, "Set"), NULL };
  gsize length = 0;
  g_autoptr (GBytes) bytes = look_up (test->model);
  const char *text = g_bytes_get_data (bytes, &length);
  qn_cli_must (
    qn_project_parse (text, length, test->model, overrides, &input.project, QN_TROUBLE));
  if (qn_contacts_detect (&input.project.model, &input.contacts, &diag) != QN_OK)
    qn_input_refuse (&input.project, &diag);
  qn_terminal_progress_begin ();
  QnStatus status = run_analysis (test, &input, &result, &found, &diag);
  gsize memory = qn_terminal_progress_done ();
  result.statistics.peak_memory_bytes = (int64_t) memory;
  if (status != QN_OK && status != QN_ERROR_CANCELLED)
    qn_input_refuse (&input.project, &diag);
  if (qn_interrupt_seen ())
    qn_cli_fail (QN_EXIT_CANCELLED, _ ("cancelled"));
  double bound = result.has_associative_bound
                     && g_key_file_get_boolean (table.file, table.name, "Bounded", NULL)
                   ? result.associative_bound
                   : NAN;
  gboolean met = print_row (test, &input, &result, found, bound);
  tally->uncertain += result.mechanism_uncertain;
  *(!isfinite (test->tolerance) ? &tally->reported
    : met                       ? &tally->met
                                : &tally->missed) += 1;
  keep_result (table.name, &input, &result);
  qn_result_clear (&result);
  qn_contacts_clear (&input.contacts);
  qn_project_clear (&input.project);
}

static void
run_verify (char **names)
{
  g_autoptr (GBytes) bytes = look_up ("verify.desktop");
  g_autoptr (GKeyFile) file = g_key_file_new ();
  qn_cli_must (g_key_file_load_from_bytes (file, bytes, G_KEY_FILE_NONE, QN_TROUBLE));
  g_auto (GStrv) groups = g_key_file_get_groups (file, NULL);
  Tally tally = { 0 };

  for (char **name = names; *name != NULL; name++)
    if (strchr (*name, '/') != NULL || !g_key_file_has_group (file, *name))
      qn_cli_usage_error (_ ("no group is called “%s”"), *name);
  for (char **group = groups; *group != NULL; group++) {
    const Table table = { file, *group };
    if (strchr (*group, '/') != NULL
        || (*names != NULL && !g_strv_contains ((const char *const *) names, *group)))
      continue;
    qn_print ("%s (%s)\n", _ (text_of (file, *group, "Name")),
              _ (text_of (file, *group, "Comment")));
    print_cell ("", 23, TRUE);
    print_cell (_ ("blocks"), 6, FALSE);
    print_cell (_ ("faces"), 5, FALSE);
    print_cell (_ ("reference"), 10, FALSE);
    print_cell (_ ("HybriDFEM*"), 10, FALSE);
    print_cell (_ ("Quoin"), 10, FALSE);
    print_cell (_ ("error %"), 8, FALSE);
    print_cell (_ ("allowed"), 7, FALSE);
    print_cell (_ ("bound†"), 10, FALSE);
    print_cell (_ ("1st limit"), 10, FALSE);
    print_cell (_ ("seconds"), 7, FALSE);
    print_cell (_ ("factorisations"), 14, FALSE);
    qn_print ("\n");
    for (char **row = group + 1; *row != NULL && strchr (*row, '/') != NULL; row++) {
      const Case test = read_case (file, *row);
      run_case (table, &test, &tally);
    }
    qn_print ("\n");
  }
  qn_print (_ ("* HybriDFEM as published, for comparison.\n"
               "† Upper bound of the associative limit analysis, computed now.\n"));
  if (tally.uncertain > 0)
    qn_print ("%s\n", _ ("‡ How the structure moves above its multiplier was not "
                         "determined: the mechanism is its last motion."));
  qn_print (_ ("%u met, %u missed, %u reported only.\n"), tally.met, tally.missed,
            tally.reported);
  if (tally.missed > 0)
    qn_cli_stop (QN_EXIT_INTERNAL);
}

static const GOptionEntry verify_entries[] = {
  { "keep", 'k', 0, G_OPTION_ARG_FILENAME, &verify_keep,
    N_ ("Keep the result files in this folder"), N_ ("FOLDER") },
  { "quiet", 'q', 0, G_OPTION_ARG_NONE, &qn_cli_quiet, N_ ("Show no progress"), NULL },
  G_OPTION_ENTRY_NULL,
};

const QnSubcommand qn_cmd_verify = {
  .name = "verify",
  .arguments = "[walls|associative|closed-forms|members|stages|columns|elastica|rocking|"
               "vibrations|branches|beams|beam-elastica|frame-sway|frame-collapse]…",
  .summary = N_ ("Compute the published cases now and compare, as a table"),
  .help = N_ ("All groups where none is named. The exit code is 1 when a value misses "
              "its tolerance."),
  .options = verify_entries,
  .many = TRUE,
  .optional = TRUE,
  .run = run_verify,
};
