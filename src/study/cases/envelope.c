#include "study/cases/envelope.h"

#include "core/base/box.h"
#include "core/base/integer.h"
#include "io/project/project-members.h"
#include "io/project/project-vehicle.h"
#include "io/project/project.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#define MOST_POSITIONS 10000

/* Places without an answer that are told. */
#define MOST_NAMED 5

/* ---- settings ---- */

static const char *const ways[] = { "both", "right", "left" };
static const char *const methods[] = { "limit", "non-associative", "path" };
static const QnMember members[] = {
  QN_NUMBER ("from", OPTIONAL, FINITE, QnEnvelopeSettings, from),
  QN_NUMBER ("to", OPTIONAL, FINITE, QnEnvelopeSettings, to),
  QN_NUMBER ("step", OPTIONAL, POSITIVE, QnEnvelopeSettings, step),
  QN_CHOICE ("ways", OPTIONAL, ways, QnEnvelopeSettings, ways),
  QN_CHOICE ("method", OPTIONAL, methods, QnEnvelopeSettings, method),
  QN_KNOWN ("vehicles"),
  { 0 },
};

static const QnEnvelopeSettings usual_settings = {
  NULL, (double) NAN, (double) NAN, 0.25, QN_WAYS_BOTH, QN_ENVELOPE_LIMIT
};

static gboolean
read_names (const QnJsonValue *place, char ***names)
{
  QnJsonValue array = { 0 }, name = { 0 };
  if (!qn_member_array (place, "vehicles", QN_OPTIONAL, &array))
    return FALSE;
  g_autoptr (GStrvBuilder) list = g_strv_builder_new ();
  while (array.json != NULL && qn_json_value_next (&array, &name)) {
    if (!cJSON_IsString (name.json))
      return qn_json_value_fail (&name, _ ("expected the name of a vehicle"));
    g_strv_builder_add (list, name.json->valuestring);
  }
  if (array.json != NULL && cJSON_GetArraySize (array.json) > 0)
    *names = g_strv_builder_end (list);
  return TRUE;
}

gboolean
qn_envelope_settings_read (const QnProject *project, QnEnvelopeSettings *settings,
                           GError **error)
{
  QnReader reader = qn_project_reader (project);
  *settings = usual_settings;
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue place = qn_json_value_member (&root, QN_ENVELOPE_MEMBER);
  if (place.json == NULL
      || (qn_members_read (&place, members, NULL, settings)
          && read_names (&place, &settings->vehicles)))
    return TRUE;
  g_propagate_error (error, reader.error);
  return FALSE;
}

char *
qn_envelope_settings_to_json (const QnEnvelopeSettings *settings)
{
  GString *json = g_string_new ("{");
  qn_members_write (json, members, NULL, settings, &usual_settings);
  if (settings->vehicles != NULL)
    qn_json_begin_member (json, "vehicles");
  for (gsize i = 0; settings->vehicles != NULL && settings->vehicles[i] != NULL; i++) {
    g_string_append (json, i == 0 ? "[" : ", ");
    qn_json_append_string (json, settings->vehicles[i]);
  }
  g_string_append (json, settings->vehicles != NULL ? "] }" : " }");
  return g_string_free (json, FALSE);
}

void
qn_envelope_settings_clear (QnEnvelopeSettings *settings)
{
  g_strfreev (settings->vehicles);
  *settings = usual_settings;
}

/* ---- lines and positions ---- */

gsize
qn_find_vehicle_load (const QnModel *model)
{
  for (gsize i = 0; i < model->live_load_count; i++)
    if (model->live_loads[i].kind == QN_LOAD_VEHICLE && model->live_loads[i].set == 0)
      return i;
  return G_MAXSIZE;
}

static gboolean
add_lines (QnEnvelope *e, const QnEnvelopeSettings *settings, GError **error)
{
  char **names = settings->vehicles;
  const gsize vehicles = names != NULL ? g_strv_length (names) : 1;
  e->lines = g_new0 (QnEnvelopeLine, 2 * vehicles);
  for (gsize i = 0; i < vehicles; i++) {
    QnId vehicle = names != NULL ? qn_model_take_vehicle (&e->model, names[i])
                                 : e->model.live_loads[e->load].vehicle;
    if (vehicle == QN_NONE) {
      g_auto (GStrv) known = qn_dup_vehicle_names (NULL);
      g_autofree char *list = g_strjoinv (", ", known);
      return qn_io_fail (error, QN_IO_ERROR_OVERRIDE,
                         _ ("%s: no such vehicle; built in are %s"), names[i], list);
    }
    for (int way = 0; way < 2; way++)
      if (settings->ways == QN_WAYS_BOTH
          || way == (settings->ways == QN_WAYS_LEFT ? 1 : 0))
        e->lines[e->line_count++] =
          (QnEnvelopeLine){ .vehicle = vehicle, .reversed = way == 1 };
  }
  return TRUE;
}

/* From where the longest vehicle comes to the structure to where it has left it. */
static gboolean
place_positions (QnEnvelope *e, const QnEnvelopeSettings *settings, GError **error)
{
  const QnBox box = qn_box_of_points (e->model.vertices, e->model.vertex_count);
  const QnLoad *load = &e->model.live_loads[e->load];
  double from = box.min.x, to = box.max.x;
  for (gsize i = 0; i < e->line_count; i++) {
    const QnVehicle *vehicle = &e->model.vehicles[e->lines[i].vehicle];
    double length = load->convoy * (qn_vehicle_length (vehicle) + load->headway);
    if (settings->ways != QN_WAYS_RIGHT)
      from = fmin (from, box.min.x - length);
    if (settings->ways != QN_WAYS_LEFT)
      to = fmax (to, box.max.x + length);
  }
  from = isnan (settings->from) ? from : settings->from;
  to = isnan (settings->to) ? to : settings->to;
  double count = floor ((to - from) / settings->step + 1e-9) + 1;
  if (!(settings->step > 0) || !(count >= 1) || count > MOST_POSITIONS)
    return qn_io_fail (error, QN_IO_ERROR_OVERRIDE,
                       _ ("from, to and step give no positions, or more than %d"),
                       MOST_POSITIONS);
  e->count = (gsize) qn_to_integer (count, 1, MOST_POSITIONS);
  e->x = g_new (double, e->count);
  for (gsize i = 0; i < e->count; i++)
    e->x[i] = rint ((from + (double) i * settings->step) * 1e9) / 1e9; /* as written */
  for (gsize k = 0; k < e->line_count; k++) {
    e->lines[k].results = g_new0 (QnResult, e->count);
    for (gsize i = 0; i < e->count; i++)
      e->lines[k].results[i].collapse_multiplier = (double) NAN;
  }
  return TRUE;
}

gboolean
qn_envelope_init (QnEnvelope *e, const QnModel *model, const QnEnvelopeSettings *settings,
                  GError **error)
{
  QnDiag diag = { 0 };
  *e = (QnEnvelope){ .load = qn_find_vehicle_load (model) };
  gboolean ok = e->load != G_MAXSIZE
                || qn_io_fail (error, QN_IO_ERROR_OVERRIDE, "%s",
                               _ ("there is no vehicle among the live loads"));
  if (ok && qn_model_copy (model, &e->model, &diag) != QN_OK)
    ok =
      qn_io_fail (error, QN_IO_ERROR_OVERRIDE, "%s", _ (qn_problem_text (diag.problem)));
  if (ok && settings->method != QN_ENVELOPE_PATH)
    e->model.analysis.procedure = QN_PROCEDURE_LIMIT;
  if (ok && settings->method == QN_ENVELOPE_NON_ASSOCIATIVE)
    e->model.analysis.flow = QN_FLOW_NON_ASSOCIATIVE;
  ok = ok && add_lines (e, settings, error) && place_positions (e, settings, error);
  if (!ok)
    qn_envelope_clear (e);
  return ok;
}

void
qn_envelope_clear (QnEnvelope *e)
{
  for (gsize k = 0; k < e->line_count; k++) {
    for (gsize i = 0; e->lines[k].results != NULL && i < e->count; i++)
      qn_result_clear (&e->lines[k].results[i]);
    g_free (e->lines[k].results);
  }
  g_free (e->lines);
  g_free (e->x);
  qn_contacts_clear (&e->contacts);
  qn_model_clear (&e->model);
  *e = (QnEnvelope){ 0 };
}

/* ---- computing ---- */

QnStatus
qn_envelope_move (const QnEnvelope *e, QnEnvelopePlace at, QnModel *moved, QnDiag *diag)
{
  QnStatus status = qn_model_copy (&e->model, moved, diag);
  if (status != QN_OK)
    return status;
  QnLoad *load = &moved->live_loads[e->load];
  load->vehicle = e->lines[at.line].vehicle;
  load->position = e->x[at.position];
  load->reversed = e->lines[at.line].reversed;
  status = qn_model_prepare (moved, diag);
  if (status != QN_OK)
    qn_model_clear (moved);
  return status;
}

/* One position; its multiplier and mechanism are kept. */
static QnStatus
solve_at (QnEnvelope *e, QnEnvelopePlace at, QnProgressFunc progress, void *data,
          QnDiag *diag)
{
  QnModel moved;
  QnResult result = { 0 };
  QnStatus status = qn_envelope_move (e, at, &moved, diag);
  if (status != QN_OK)
    return status;
  if (qn_model_load_resultant (&moved, moved.dead_load_count + e->load).y < 0)
    status = qn_analysis_run (&moved, &e->contacts, progress, data, &result, diag);
  if (status == QN_OK && result.outcome == QN_OUTCOME_CANCELLED)
    status = QN_ERROR_CANCELLED;
  e->unstable = status == QN_OK && result.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  if (status == QN_OK && result.outcome == QN_OUTCOME_COLLAPSE
      && result.has_collapse_multiplier) {
    e->lines[at.line].results[at.position] = (QnResult){
      .outcome = result.outcome,
      .has_collapse_multiplier = true,
      .collapse_multiplier = result.collapse_multiplier,
      .limit = result.limit,
      .block_count = result.block_count,
      .node_count = result.node_count,
      .mechanism = g_steal_pointer (&result.mechanism),
    };
  } else {
    e->lines[at.line].results[at.position].outcome = result.outcome;
  }
  qn_result_clear (&result);
  qn_model_clear (&moved);
  return status;
}

QnStatus
qn_envelope_run (QnEnvelope *e, QnProgressFunc progress, void *data, QnDiag *diag)
{
  const gsize all = e->line_count * e->count;
  QnStatus status = qn_contacts_detect (&e->model, &e->contacts, diag);
  if (status == QN_OK)
    status = qn_contacts_require_sound (&e->model, &e->contacts, diag);
  for (gsize i = 0; i < all && status == QN_OK && !e->unstable; i++) {
    status =
      solve_at (e, (QnEnvelopePlace){ i / e->count, i % e->count }, progress, data, diag);
    g_atomic_int_inc (&e->done);
  }
  return status;
}

/* ---- answers ---- */

double
qn_envelope_multiplier (const QnEnvelope *e, QnEnvelopePlace at)
{
  gsize number = at.line * e->count + at.position;
  return number < (gsize) g_atomic_int_get (&e->done)
           ? e->lines[at.line].results[at.position].collapse_multiplier
           : (double) NAN;
}

gboolean
qn_envelope_is_open (const QnEnvelope *e, QnEnvelopePlace at)
{
  return e->lines[at.line].results[at.position].outcome == QN_OUTCOME_NOT_CONVERGED;
}

gboolean
qn_envelope_find_least (const QnEnvelope *e, QnEnvelopePlace *least)
{
  double found = INFINITY;
  for (gsize i = 0; i < e->line_count * e->count; i++) {
    QnEnvelopePlace here = { i / e->count, i % e->count };
    double multiplier = qn_envelope_multiplier (e, here);
    if (multiplier < found) { /* false for NaN */
      found = multiplier;
      *least = here;
    }
  }
  return isfinite (found);
}

static const QnVehicle *
vehicle_of (const QnEnvelope *e, gsize line)
{
  return &e->model.vehicles[e->lines[line].vehicle];
}

char *
qn_envelope_dup_line_name (const QnEnvelope *e, gsize line)
{
  return g_strdup_printf (e->lines[line].reversed ? _ ("%s, to the left")
                                                  : _ ("%s, to the right"),
                          vehicle_of (e, line)->name);
}

char *
qn_envelope_dup_factor (const QnEnvelope *e, QnEnvelopePlace at)
{
  return g_strdup_printf (
    e->lines[at.line].reversed
      ? _ ("%s: adequacy factor %.5g, its front at x = %.6g m, to the left")
      : _ ("%s: adequacy factor %.5g, its front at x = %.6g m, to the right"),
    vehicle_of (e, at.line)->name, qn_envelope_multiplier (e, at), e->x[at.position]);
}

char *
qn_envelope_dup_text (const QnEnvelope *e, QnEnvelopePlace at, gboolean whole)
{
  const QnAnalysisSettings *analysis = &e->model.analysis;
  const gboolean bounds =
    analysis->procedure == QN_PROCEDURE_LIMIT && analysis->flow == QN_FLOW_ASSOCIATIVE;
  const QnVehicle *vehicle = vehicle_of (e, at.line);
  const double share = qn_model_load_factor (&e->model, &e->model.live_loads[e->load]);
  const double factor = qn_envelope_multiplier (e, at);
  g_autofree char *sentence = qn_envelope_dup_factor (e, at);
  GString *text = g_string_new (sentence);
  gboolean others = FALSE;
  double sum = 0, largest = 0;
  for (int32_t i = 0; i < vehicle->axle_count; i++) {
    sum += share * vehicle->axles[i].load;
    largest = fmax (largest, share * vehicle->axles[i].load);
  }
  if (sum > 0) {
    g_string_append_c (text, '\n');
    g_string_append_printf (
      text, _ ("axles of %.5g kN in all carry %.5g kN, the heaviest %.5g kN"), sum / 1000,
      factor * sum / 1000, factor * largest / 1000);
  }
  for (gsize i = 0; i < e->model.live_load_count; i++)
    others |= i != e->load && e->model.live_loads[i].set == 0;
  if (whole && others)
    g_string_append_printf (
      text, "\n%s", _ ("Other growing loads grow with the vehicle, by the same factor."));
  if (whole && bounds)
    g_string_append_printf (text, "\n%s",
                            _ ("All are bounds from above where joints slide: "
                               "non-associative limit analysis or the path may find "
                               "less."));
  for (gsize k = 0; whole && k < e->line_count; k++) {
    /* Where a line has no answer, by the first few places. */
    g_autoptr (GString) places = g_string_new (NULL);
    gsize count = 0;
    for (gsize i = 0; i < e->count; i++)
      if (qn_envelope_is_open (e, (QnEnvelopePlace){ k, i }) && count++ < MOST_NAMED)
        g_string_append_printf (places, "%s%.6g", count > 1 ? "; " : "", e->x[i]);
    if (count == 0)
      continue;
    g_autofree char *name = qn_envelope_dup_line_name (e, k);
    g_string_append_c (text, '\n');
    g_string_append_printf (text, _ ("%s: no answer with the front at x = %s%s m"), name,
                            places->str, count > MOST_NAMED ? "; …" : "");
  }
  return g_string_free (text, FALSE);
}

gboolean
qn_envelope_write_table (const QnEnvelope *e, const char *path, GError **error)
{
  static const char *const way_names[] = { "to the right", "to the left" };
  const bool one = e->lines[0].vehicle == e->lines[e->line_count - 1].vehicle;
  QnFileWriter *writer = qn_file_writer_open (path);
  qn_file_writer_puts (writer, "position [m]");
  for (gsize k = 0; k < e->line_count; k++) {
    g_autofree char *name =
      g_strdup_printf ("%s %s", vehicle_of (e, k)->name, way_names[e->lines[k].reversed]);
    qn_file_writer_puts (writer, ",");
    if (one)
      qn_file_writer_puts (writer, way_names[e->lines[k].reversed]);
    else
      qn_file_writer_quoted (writer, name);
  }
  qn_file_writer_puts (writer, "\n");
  for (gsize i = 0; i < e->count; i++) {
    qn_file_writer_rounded (writer, e->x[i], "%.10g");
    for (gsize k = 0; k < e->line_count; k++) {
      double multiplier = qn_envelope_multiplier (e, (QnEnvelopePlace){ k, i });
      qn_file_writer_puts (writer, ",");
      if (!isnan (multiplier))
        qn_file_writer_rounded (writer, multiplier, "%.10g");
    }
    qn_file_writer_puts (writer, "\n");
  }
  return qn_file_writer_commit (writer, error);
}
