#include "doc/view/report-parts.h"

#include "core/result/curve-motion.h"
#include "doc/text/explain.h"
#include "doc/view/sheet.h"
#include "io/text/outcome-text.h"
#include "render/drawing/text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* What made it. */
#define QN_GENERATOR "quoin " QN_VERSION

const char *
qn_report_procedure (const QnModel *model)
{
  return model->stage_count > 0 ? _ ("load stages")
                                : qn_explain_procedure (&model->analysis);
}

const char *
qn_report_geometry (const QnModel *model)
{
  return model->analysis.geometry == QN_GEOMETRY_LINEAR
             || model->analysis.procedure == QN_PROCEDURE_LIMIT
           ? _ ("linear")
           : _ ("nonlinear");
}

void
qn_report_say (QnPages *pages, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *text = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  qn_pages_paragraph (pages, text);
}

/* "Length (%s)" with its unit. */
static char *
dup_heading (const char *format, const char *unit)
{
  g_auto (GStrv) parts = g_strsplit (format, "%s", 2);
  return g_strjoinv (unit, parts);
}

void
qn_report_row (GPtrArray *cells, QnUnits units, const char *kinds, ...)
{
  va_list arguments;
  va_start (arguments, kinds);
  for (const char *kind = kinds; *kind != '\0'; kind++) {
    const char *text = *kind != 'q' && *kind != 'z' ? va_arg (arguments, char *) : NULL;
    QnQuantity quantity =
      *kind == 'q' || *kind == 'u' ? va_arg (arguments, QnQuantity) : QN_QUANTITY_NUMBER;
    double value = *kind == 'q' || *kind == 'n' ? va_arg (arguments, double) : 0;
    int digits = *kind == 'q' ? va_arg (arguments, int) : 0;
    char *cell = *kind == 'z'   ? g_strdup_printf ("%zu", va_arg (arguments, size_t))
                 : *kind == 'o' ? (char *) text
                 : *kind == 'u' ? dup_heading (text, qn_units_symbol (units, quantity))
                 : *kind == 'w' ? g_strdup (text)
                 : !isfinite (value) ? g_strdup ("–")
                 : *kind == 'n'      ? qn_label_number (text, value)
                                     : qn_units_format (units, quantity, value, digits);
    g_ptr_array_add (cells, cell);
  }
  va_end (arguments);
}

void
qn_report_table (QnPages *pages, GPtrArray *cells, size_t columns)
{
  qn_pages_table (pages, (const char *const *) cells->pdata, cells->len / columns,
                  columns);
}

/* Whether two runs are one, computed twice: the same project and settings, and the same last step. */
static gboolean
same_run (const QnReportRun *a, const QnReportRun *b)
{
  const QnResult *x = &a->file.result, *y = &b->file.result;
  gsize rows = QN_DOF_COUNT * qn_result_body_count (x);
  const char *const none[] = { NULL };
  char **p = a->file.overrides, **q = b->file.overrides;
  return g_strcmp0 (a->file.model_sha256, b->file.model_sha256) == 0
         && g_strv_equal (p != NULL ? (const char *const *) p : none,
                          q != NULL ? (const char *const *) q : none)
         && x->outcome == y->outcome && x->step_count == y->step_count
         && x->limit.given == y->limit.given && x->limit.flow == y->limit.flow
         && rows == QN_DOF_COUNT * qn_result_body_count (y)
         && (x->step_count == 0
             || memcmp (qn_result_step_displacements (x, x->step_count - 1),
                        qn_result_step_displacements (y, y->step_count - 1),
                        rows * sizeof (double))
                  == 0);
}

/* The question that the analysis of a project answers. */
static const char *
question (const QnModel *model)
{
  if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    return _ ("Question: how does the structure move in time, and does it overturn?");
  if (model->stage_count == 0 && !qn_model_sets_have_force (model, 1))
    return _ ("Question: what do the settlements of the supports do to the structure?");
  return _ ("Question: which multiple of the live load does the structure carry?");
}

/* By what an answer was found, and whether it was checked. */
static char *
dup_basis (const QnReportRun *run)
{
  const QnModel *model = &run->project->model;
  const char *check = run->unchecked != NULL   ? _ ("not checked")
                      : run->faults.count == 0 ? _ ("the independent check is passed")
                                               : _ ("the independent check fails");
  return g_strdup_printf (
    _ ("It rests on %s in %s geometry, on the laws and the pairs of the "
       "joints as given; %s."),
    qn_report_procedure (model), qn_report_geometry (model), check);
}

/* What a result has proved of a path or of limit analysis: which multiplier is carried, and whether more than
 * that is known not to be. */
typedef struct Proof {
  double carried;
  bool ends;         /* it is the most */
  const char *doubt; /* why nothing is concluded, or NULL */
} Proof;

/* Whether a stage drives the loads that the last one does. */
static bool
drives_alike (const QnModel *model, const QnResult *r, int32_t stage)
{
  return stage == r->stage
         || (stage > 0 && r->stage > 0
             && model->stages[stage - 1].sets == model->stages[r->stage - 1].sets);
}

static Proof
find_proof (const QnReportRun *run, double demand)
{
  const QnModel *model = &run->project->model;
  const QnResult *r = &run->file.result;
  const QnPathEvent *buckling = qn_result_find_buckling (r);
  Proof proof = { .ends = r->outcome != QN_OUTCOME_TARGET_REACHED
                          && r->outcome != QN_OUTCOME_NOT_CONVERGED
                          && r->outcome != QN_OUTCOME_CANCELLED };
  for (size_t s = 0; !r->limit.given && s < r->step_count; s++)
    if (drives_alike (model, r, r->steps[s].stage))
      proof.carried = fmax (proof.carried, r->steps[s].multiplier);
  /* Where a displacement is prescribed the path goes on beyond its peak. */
  QnProcedure procedure =
    r->stage > 0 ? model->stages[r->stage - 1].procedure : model->analysis.procedure;
  if (r->step_count > 0 && procedure != QN_PROCEDURE_LOAD)
    proof.ends |= r->steps[r->step_count - 1].multiplier < proof.carried;
  if (r->has_collapse_multiplier)
    proof.carried = r->collapse_multiplier;
  if (r->outcome == QN_OUTCOME_SNAP && r->has_first_limit_multiplier)
    proof.carried = r->first_limit_multiplier;
  if (buckling != NULL && drives_alike (model, r, buckling->stage)
      && buckling->multiplier < proof.carried) {
    proof.carried = buckling->multiplier;
    proof.ends = true;
  }
  if (r->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    return proof; /* nothing is carried */
  if (r->vibration.mode > 0 || r->stability != QN_STABILITY_UNKNOWN
      || r->history.width > 0 || qn_result_settlement (model, r) != NULL)
    proof.doubt = _ ("the question is another one, without such a multiplier");
  else if (run->unchecked != NULL || run->faults.count > 0)
    proof.doubt = _ ("the independent check is not passed");
  else if (r->outcome == QN_OUTCOME_UNBOUNDED)
    proof.doubt = _ ("no collapse was found");
  else if (r->limit.given && r->limit.flow == QN_FLOW_ASSOCIATIVE
           && proof.carried >= demand)
    proof.doubt = _ ("the associative bound is an upper one");
  else if (r->linearity == QN_LINEARITY_BEYOND && demand > r->beyond_linear_multiplier
           && proof.carried >= demand)
    proof.doubt = _ ("linear geometry may not hold up to it: use large displacements");
  else if (!proof.ends && proof.carried < demand)
    proof.doubt = _ ("the path was not followed so far");
  return proof;
}

/* Whether a run meets the demand. */
static char *
dup_verdict (const QnReportRun *run, double demand)
{
  const Proof proof = find_proof (run, demand);
  g_autofree char *wanted = qn_label_number ("%.4g", demand);
  g_autofree char *carried = qn_label_number ("%.4g", proof.carried);
  g_autofree char *ratio = qn_label_number ("%.4g", proof.carried / demand);
  if (proof.doubt != NULL)
    return g_strdup_printf (_ ("Demand, a load multiplier of %s: not decided, for %s."),
                            wanted, proof.doubt);
  return g_strdup_printf (
    proof.carried >= demand
      ? _ ("Demand, a load multiplier of %s: met. %s is carried, %s times the demand.")
      : _ (
        "Demand, a load multiplier of %s: not met. %s is carried, %s times the demand."),
    wanted, carried, ratio);
}

/* The answer of a run, with the range that it lies in, and the verdict where a demand is given. */
static void
write_answer (QnPages *pages, const QnReportRun *run, double demand, bool named)
{
  const QnResult *result = &run->file.result;
  g_autofree char *text = qn_explain_outcome (&run->project->model, result);
  g_autofree char *line = named ? g_strdup_printf ("%s: %s", run->name, text) : NULL;
  g_autofree char *interval = qn_outcome_dup_interval (&run->project->model, result);
  g_autofree char *basis = dup_basis (run);
  g_autofree char *verdict = demand > 0 ? dup_verdict (run, demand) : NULL;
  qn_pages_paragraph (pages, named ? line : text);
  if (interval != NULL)
    qn_pages_paragraph (pages, interval);
  if (verdict != NULL)
    qn_pages_paragraph (pages, verdict);
  qn_pages_paragraph (pages, basis);
}

/* A page of its own: title, author, question and picture, the answers, and of what, by what and when it was
 * made. */
static bool
write_title (QnPages *pages, const QnReport *report, GError **error)
{
  const bool alone = !report->plan.sections[QN_REPORT_ASSUMPTIONS];
  /* What is said of each run leaves less to the picture; all of it stays on this page. */
  const double told = (double) MIN (report->run_count, 4);
  const double share =
    alone ? fmax (0.52 - 0.12 * told, 0.13) : 0.5 - 0.08 * fmax (told - 1, 0);
  g_autoptr (GString) foot = g_string_new (NULL);
  QnFigure figure;
  qn_pages_title (pages, qn_project_title (report->project));
  if (report->plan.author != NULL)
    qn_pages_paragraph (pages, report->plan.author);
  if (report->plan.text != NULL)
    qn_pages_paragraph (pages, report->plan.text);
  if (report->run_count == 1)
    qn_report_say (pages, _ ("%s The answer: figure\u00a0%d."),
                   question (&report->project->model), qn_pages_next_figure (pages));
  else if (report->run_count > 1)
    qn_report_say (pages, _ ("%s The answer of %s: figure\u00a0%d."),
                   question (&report->project->model), report->runs[0].name,
                   qn_pages_next_figure (pages));
  if (report->run_count == 0 || !qn_report_choose_picture (&figure, &report->runs[0])) {
    qn_figure_init (&figure, &report->project->model, report->contacts, NULL,
                    QN_VIEW_MODEL);
    figure.title = _ ("Model");
  }
  if (!qn_pages_figures (pages, &figure, 1, 1, share, error))
    return false;
  for (size_t i = 0; i < report->run_count; i++)
    write_answer (pages, &report->runs[i], report->plan.demand, report->run_count > 1);
  if (alone)
    qn_report_write_assumptions (pages, report, foot);
  g_autofree char *name = g_path_get_basename (report->project->name);
  /* Of SOURCE_DATE_EPOCH where it is set: then equal input gives equal bytes on all days. */
  const char *epoch = g_getenv ("SOURCE_DATE_EPOCH");
  g_autoptr (GDateTime) now =
    epoch != NULL ? g_date_time_new_from_unix_utc (g_ascii_strtoll (epoch, NULL, 10))
                  : g_date_time_new_now_local ();
  g_autofree char *date =
    now != NULL ? g_date_time_format (now, "%Y-%m-%d") : g_strdup ("–");
  g_string_append_printf (foot, _ ("%s, made by %s on %s"), name, QN_GENERATOR, date);
  if (report->project->sha256 != NULL)
    g_string_append_printf (foot, "\nSHA-256 %s", report->project->sha256);
  qn_pages_foot (pages, foot->str);
  return true;
}

static bool
write_all (QnPages *pages, const QnReport *report, GError **error)
{
  const bool *wanted = report->plan.sections;
  if (wanted[QN_REPORT_TITLE] && !write_title (pages, report, error))
    return false;
  if (wanted[QN_REPORT_MODEL] && !qn_report_write_model (pages, report, error))
    return false;
  if (wanted[QN_REPORT_MATERIALS])
    qn_report_write_materials (pages, report);
  if (wanted[QN_REPORT_LOADS])
    qn_report_write_loads (pages, report);
  if (wanted[QN_REPORT_ASSUMPTIONS])
    qn_report_write_assumptions (pages, report, NULL);
  if (wanted[QN_REPORT_FINDINGS])
    qn_report_write_findings (pages, report);
  if (wanted[QN_REPORT_CONTACTS] && report->contacts->face_count > 0
      && !qn_report_write_contacts (pages, report, error))
    return false;
  for (size_t i = 0; wanted[QN_REPORT_RESULTS] && i < report->run_count; i++)
    if (!qn_report_write_result (pages, &report->runs[i], report->units, error))
      return false;
  for (size_t i = 0; wanted[QN_REPORT_MECHANISM] && i < report->run_count; i++)
    if (!qn_report_write_mechanism (pages, &report->runs[i], report->units, error))
      return false;
  if (wanted[QN_REPORT_COMBINATIONS]
      && !qn_report_write_combinations (pages, report, error))
    return false;
  for (size_t i = 0; wanted[QN_REPORT_JOINTS] && i < report->run_count; i++)
    if (qn_report_has_forces (&report->runs[i])
        && report->runs[i].contacts->face_count > 0)
      if (!qn_report_write_joints (pages, report, &report->runs[i], error))
        return false;
  if (wanted[QN_REPORT_CERTIFICATE] && report->run_count > 0)
    qn_report_write_certificate (pages, report);
  if (wanted[QN_REPORT_COMPARISON] && report->run_count > 1
      && !qn_report_write_comparison (pages, report, error))
    return false;
  if (wanted[QN_REPORT_FILES]) {
    g_autoptr (GPtrArray) cells = g_ptr_array_new_with_free_func (g_free);
    g_autofree char *project = g_path_get_basename (report->project->name);
    qn_pages_heading (pages, _ ("Files and Versions"));
    qn_report_row (cells, report->units, "wwwwww", _ ("File"), _ ("Made by"),
                   _ ("SHA-256 of the project"), project, "–",
                   report->project->sha256 != NULL ? report->project->sha256 : "–");
    for (size_t i = 0; i < report->run_count; i++) {
      const QnResultFile *file = &report->runs[i].file;
      qn_report_row (cells, report->units, "www", report->runs[i].name,
                     file->generator != NULL ? file->generator : "–",
                     file->model_sha256 != NULL ? file->model_sha256 : "–");
    }
    qn_report_table (pages, cells, 3);
  }
  return true;
}

GBytes *
qn_report_encode (const QnReport *given, GError **error)
{
  g_autofree QnReportRun *runs = g_new (QnReportRun, given->run_count + 1);
  QnReport once = *given;
  const QnReport *report = &once;
  QnMetadata metadata;
  once.runs = runs;
  once.run_count = 0;
  for (size_t i = 0; i < given->run_count; i++) {
    gboolean told = FALSE;
    for (size_t k = 0; k < once.run_count; k++)
      told |= same_run (&runs[k], &given->runs[i]);
    if (!told)
      runs[once.run_count++] = given->runs[i];
  }
  qn_project_get_metadata (report->project, &metadata);
  metadata.title = qn_project_title (report->project);
  g_autofree char *footer =
    g_strdup_printf ("%s · %s", qn_project_title (report->project), QN_GENERATOR);
  QnPages *pages = qn_pages_new (report->plan.paper, footer, &metadata);
  bool done = write_all (pages, report, error);
  g_autoptr (GBytes) bytes = qn_pages_finish (pages, done ? error : NULL);
  return done ? g_steal_pointer (&bytes) : NULL;
}
