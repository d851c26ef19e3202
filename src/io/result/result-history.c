#include "io/result/result-members.h"

#include "core/base/memory.h"
#include "io/project/project-members.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>

static const QnMember scalars[] = {
  QN_NUMBER ("end", REQUIRED, FINITE, QnHistory, end),
  QN_NUMBER ("energy_error", REQUIRED, FINITE, QnHistory, energy_error),
  QN_NUMBER ("largest_residual", REQUIRED, FINITE, QnHistory, largest_residual),
  QN_NUMBER ("largest_slip", REQUIRED, FINITE, QnHistory, largest_slip),
  QN_NUMBER ("shortest_step", REQUIRED, FINITE, QnHistory, shortest_step),
  QN_WHOLE ("steps", REQUIRED, 0, QnHistory, steps),
  QN_WHOLE ("rejected", REQUIRED, 0, QnHistory, rejected),
  QN_NUMBER ("time_of_peak", OPTIONAL, FINITE, QnHistory, peak_time),
  QN_MAYBE ("time_of_collapse", REQUIRED, QnHistory, collapse_time),
  { 0 },
};

/* Where the lists of a history are. */
typedef struct Lists {
  QnHistory history;
  gsize time, ground, energy, tracks, peak, found, left;
} Lists;

static const QnMember lists[] = {
  QN_PLACE ("time", REQUIRED, Lists, time),
  QN_PLACE ("ground", REQUIRED, Lists, ground),
  QN_PLACE ("energy", REQUIRED, Lists, energy),
  QN_PLACE ("tracks", REQUIRED, Lists, tracks),
  QN_PLACE ("peak", REQUIRED, Lists, peak),
  QN_PLACE ("found", OPTIONAL, Lists, found),
  QN_PLACE ("left", OPTIONAL, Lists, left),
  { 0 },
};

/* A contact that was found on the way, by time or by step. */
typedef struct Found {
  QnFound found;
  gsize forces;
} Found;

#define FOUND_MEMBERS(when)                                                              \
  {                                                                                      \
    QN_PAIR ("side", REQUIRED, Found, found.contact.block),                              \
      QN_PAIR ("corner", REQUIRED, Found, found.contact.other),                          \
      QN_NUMBER ("foot", REQUIRED, FINITE, Found, found.contact.foot),                   \
      QN_NUMBER ("inset", WRITTEN, FINITE, Found, found.contact.inset),                  \
      QN_NUMBER (when, REQUIRED, FINITE, Found, found.time),                             \
      QN_PLACE ("forces", REQUIRED, Found, forces),                                      \
    {                                                                                    \
      0                                                                                  \
    }                                                                                    \
  }
static const QnMember found_by_time[] = FOUND_MEMBERS ("time");
static const QnMember found_by_step[] = FOUND_MEMBERS ("step");

/* --- Writing ------------------------------------------------------------------------------ */

static void
write_list (QnFileWriter *writer, const double *first, size_t stride, size_t count)
{
  qn_file_writer_puts (writer, "[");
  for (size_t i = 0; i < count; i++)
    qn_file_writer_puts_number (writer, i > 0 ? ", " : "", first[i * stride]);
  qn_file_writer_puts (writer, "]");
}

static void
write_column (QnFileWriter *writer, const QnHistory *history, size_t column)
{
  write_list (writer, history->rows + column, history->width, history->row_count);
}

/* The forces of found contacts, which the result has by step, by contact: those of contact i from
 * first[i] up to first[i + 1], each a place in the result's list. first: found_count + 2 zeros. */
static gsize *
sort_by_contact (const QnResult *result, gsize *first)
{
  gsize *places = g_new (gsize, result->found_force_count);
  for (size_t k = 0; k < result->found_force_count; k++)
    first[result->found_forces[k].found + 2]++;
  for (size_t i = 0; i < result->found_count; i++)
    first[i + 2] += first[i + 1];
  for (size_t k = 0; k < result->found_force_count; k++)
    places[first[result->found_forces[k].found + 1]++] = k;
  return places;
}

void
qn_result_found_write (QnFileWriter *writer, const QnResult *result)
{
  gboolean in_time = result->history.width > 0;
  g_autofree gsize *first = g_new0 (gsize, result->found_count + 2);
  g_autofree gsize *places = sort_by_contact (result, first);
  qn_file_writer_puts (writer, "\"found\": [");
  for (size_t i = 0; i < result->found_count; i++) {
    const char *separator = "";
    qn_result_members_write (writer, i > 0 ? ",\n      { " : "\n      { ",
                             in_time ? found_by_time : found_by_step, &result->found[i],
                             NULL, ", \"forces\": [");
    for (gsize k = first[i]; k < first[i + 1]; k++) {
      const QnFoundForce *force = &result->found_forces[places[k]];
      qn_file_writer_puts (writer, separator);
      qn_file_writer_json (writer, "[%d, %g, %g, %d]", force->step, force->normal,
                           force->shear, (int) force->state);
      separator = ", ";
    }
    qn_file_writer_puts (writer, "] }");
  }
  qn_file_writer_puts (writer, "],\n    \"left\": [");
  for (size_t i = 0; i < result->left_count; i++) {
    qn_file_writer_puts (writer, i > 0 ? ", " : "");
    qn_file_writer_json (writer, "[%d, %g]", result->left[i].face, result->left[i].time);
  }
  qn_file_writer_puts (writer, "]");
}

void
qn_result_history_write (QnFileWriter *writer, const QnModel *model,
                         const QnResult *result)
{
  const QnHistory *h = &result->history, usual = { .peak_time = NAN };
  QnHistory told = *h;
  if (result->outcome != QN_OUTCOME_COLLAPSE)
    told.collapse_time = NAN;
  qn_result_members_write (writer, "  \"history\": {\n    ", scalars, &told, &usual,
                           ",\n    \"time\": ");
  write_column (writer, h, QN_HISTORY_TIME);
  qn_file_writer_puts (writer, ",\n    \"ground\": { \"x\": ");
  write_column (writer, h, QN_HISTORY_GROUND_X);
  qn_file_writer_puts (writer, ", \"y\": ");
  write_column (writer, h, QN_HISTORY_GROUND_Y);
  qn_file_writer_puts (writer, " },\n    \"energy\": {");
  for (int kind = 0; kind < QN_ENERGY_KIND_COUNT; kind++) {
    qn_file_writer_printf (writer, "%s\n      \"%s\": ", kind > 0 ? "," : "",
                           qn_energy_names[kind]);
    write_column (writer, h, (size_t) QN_HISTORY_ENERGY + (size_t) kind);
  }
  qn_file_writer_puts (writer, " },\n    \"tracks\": [");
  for (size_t i = 0; i < model->track_count; i++) {
    const QnTrack *track = &model->tracks[i];
    qn_file_writer_json (writer,
                         ",\n      { \"block\": %s, \"component\": %s, \"values\": ",
                         model->blocks[track->block].name, qn_dof_names[track->dof]);
    write_column (writer, h, QN_HISTORY_TRACK + i);
    qn_file_writer_puts (writer, " }");
  }
  qn_file_writer_puts (writer, "],\n    \"peak\": ");
  write_list (writer, h->peaks, 1, result->block_count);
  if (result->found_count > 0 || result->left_count > 0) {
    qn_file_writer_puts (writer, ",\n    ");
    qn_result_found_write (writer, result);
  }
  qn_file_writer_puts (writer, " },\n");
}

/* --- Reading ------------------------------------------------------------------------------ */

static int
compare_forces (const void *a, const void *b)
{
  const QnFoundForce *f = a, *g = b;
  return f->step != g->step ? (f->step < g->step ? -1 : 1)
                            : (f->found > g->found) - (f->found < g->found);
}

/* The forces of the contact that was found last. */
static gboolean
read_found_forces (QnJson *json, gsize at, QnResult *result)
{
  if (!qn_result_read_array (json, at))
    return FALSE;
  for (gsize i = at + 1; i < json->tokens[at].next; i = json->tokens[i].next) {
    QnFoundForce force = { .found = (QnId) result->found_count - 1 };
    double numbers[4];
    int32_t state;
    if (!qn_result_read_numbers (json, i, numbers, 1, 4, NULL)
        || !qn_result_read_id (json, i + 1, &force.step)
        || !qn_result_read_id (json, i + 4, &state))
      return FALSE;
    if (state >= QN_PAIR_STATE_COUNT)
      return qn_json_fail (json, i, _ ("this is not a state of a contact pair"));
    force.normal = numbers[1];
    force.shear = numbers[2];
    force.state = (QnPairState) state;
    if (!qn_result_add_found_force (result, force))
      return qn_json_no_memory (json);
  }
  return TRUE;
}

static gboolean
read_found (QnJson *json, gsize found, gsize left, const QnMember *members,
            QnResult *result)
{
  const QnMember *const tables[] = { members, NULL };
  if ((found > 0 && !qn_result_read_array (json, found))
      || (left > 0 && !qn_result_read_array (json, left)))
    return FALSE;
  for (gsize i = found + 1; found > 0 && i < json->tokens[found].next;
       i = json->tokens[i].next) {
    Found read = { 0 };
    if (!qn_result_members_read (json, i, tables, &read))
      return FALSE;
    if (!qn_result_add_found (result, read.found))
      return qn_json_no_memory (json);
    if (!read_found_forces (json, read.forces, result))
      return FALSE;
  }
  for (gsize i = left + 1; left > 0 && i < json->tokens[left].next;
       i = json->tokens[i].next) {
    double numbers[2];
    QnLeftFace face;
    if (!qn_result_read_numbers (json, i, numbers, 1, 2, NULL)
        || !qn_result_read_id (json, i + 1, &face.face))
      return FALSE;
    face.time = numbers[1];
    if (!qn_result_add_left (result, face))
      return qn_json_no_memory (json);
  }
  if (result->found_force_count > 0)
    qsort (result->found_forces, result->found_force_count, sizeof (QnFoundForce),
           compare_forces);
  return TRUE;
}

/* A list, the member `key` of an object, into a column of the rows. */
static gboolean
read_column (QnJson *json, gsize object, const char *key, QnHistory *history,
             size_t column)
{
  gsize list = qn_json_member (json, object, key);
  return list > 0 ? qn_result_read_numbers (json, list, history->rows + column,
                                            history->width, history->row_count,
                                            _ ("lists of the history differ in length"))
                  : qn_json_fail_missing (json, object, key);
}

/* Which block and component a track is of is the project's knowledge. */
static gboolean
read_columns (QnJson *json, gsize at, const Lists *places, QnHistory *history)
{
  gboolean done =
    read_column (json, at, "time", history, QN_HISTORY_TIME)
    && read_column (json, places->ground, "x", history, QN_HISTORY_GROUND_X)
    && read_column (json, places->ground, "y", history, QN_HISTORY_GROUND_Y);
  for (size_t kind = 0; done && kind < QN_ENERGY_KIND_COUNT; kind++)
    done = read_column (json, places->energy, qn_energy_names[kind], history,
                        QN_HISTORY_ENERGY + kind);
  gsize track = places->tracks + 1;
  for (size_t i = QN_HISTORY_TRACK; done && i < history->width; i++) {
    done = read_column (json, track, "values", history, i);
    track = json->tokens[track].next;
  }
  return done;
}

gboolean
qn_result_history_read (QnJson *json, gsize at, gsize found, gsize left, QnResult *result)
{
  static const QnMember *const tables[] = { scalars, lists, NULL };
  QnHistory *history = &result->history;
  Lists read = { .history.peak_time = NAN };
  if (at == 0) {
    for (size_t i = 0; found + left > 0 && i < result->step_count; i++)
      result->steps[i].time = (double) i; /* its number stands for its time */
    return read_found (json, found, left, found_by_step, result);
  }
  if (found + left > 0)
    return qn_json_fail (
      json, MAX (found, left),
      _ ("contacts that an analysis in time found belong to its history"));
  if (!qn_result_members_read (json, at, tables, &read)
      || !qn_result_read_array (json, read.time)
      || !qn_result_read_array (json, read.tracks))
    return FALSE;
  *history = read.history;
  if (isnan (history->collapse_time))
    history->collapse_time = 0;
  history->row_count = qn_json_count (json, read.time);
  history->width = QN_HISTORY_TRACK + qn_json_count (json, read.tracks);
  history->capacity = history->row_count * history->width;
  history->rows = qn_result_room (json, at, history->capacity, sizeof *history->rows,
                                  _ ("lists of the history differ in length"));
  history->peaks = qn_alloc (result->block_count, sizeof *history->peaks);
  if (history->rows == NULL || history->peaks == NULL)
    return qn_json_no_memory (json);
  return read_columns (json, at, &read, history)
         && qn_result_read_numbers (json, read.peak, history->peaks, 1,
                                    result->block_count,
                                    _ ("lists of the history differ in length"))
         && read_found (json, read.found, read.left, found_by_time, result);
}
