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

/* A contact that was found on the way, by time or by step. */
#define FOUND_MEMBERS(when)                                                              \
  {                                                                                      \
    QN_PAIR ("side", REQUIRED, QnFound, contact.block),                                  \
      QN_PAIR ("corner", REQUIRED, QnFound, contact.other),                              \
      QN_NUMBER ("foot", REQUIRED, FINITE, QnFound, contact.foot),                       \
      QN_NUMBER ("inset", WRITTEN, FINITE, QnFound, contact.inset),                      \
      QN_NUMBER (when, REQUIRED, FINITE, QnFound, time),                                 \
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

void
qn_result_found_write (QnFileWriter *writer, const QnResult *result)
{
  gboolean in_time = result->history.width > 0;
  g_autofree gsize *first = g_new0 (gsize, result->found_count + 2);
  /* The forces of found contacts, which the result has by step, by contact: those of
   * contact i from first[i] up to first[i + 1], each a place in the result's list. */
  g_autofree gsize *places = g_new (gsize, result->found_force_count);
  for (size_t k = 0; k < result->found_force_count; k++)
    first[result->found_forces[k].found + 2]++;
  for (size_t i = 0; i < result->found_count; i++)
    first[i + 2] += first[i + 1];
  for (size_t k = 0; k < result->found_force_count; k++)
    places[first[result->found_forces[k].found + 1]++] = k;
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
read_found_forces (const QnJsonValue *found, QnResult *result)
{
  QnJsonValue list, item = { 0 };
  if (!qn_member_array (found, "forces", QN_REQUIRED, &list))
    return FALSE;
  while (qn_json_value_next (&list, &item)) {
    QnFoundForce force = { .found = (QnId) result->found_count - 1 };
    double numbers[4];
    int32_t state;
    if (!qn_result_read_numbers (&item, numbers, 1, 4, NULL))
      return FALSE;
    const QnJsonValue of_step = qn_json_value_element (&item, 0, item.json->child),
                      of_state = qn_json_value_element (&item, 3, item.json->child->prev);
    if (!qn_read_index (&of_step, 0, &force.step)
        || !qn_read_index (&of_state, 0, &state))
      return FALSE;
    if (state >= QN_PAIR_STATE_COUNT)
      return qn_json_value_fail (&item, _ ("this is not a state of a contact pair"));
    force.normal = numbers[1];
    force.shear = numbers[2];
    force.state = (QnPairState) state;
    if (!qn_result_add_found_force (result, force))
      return qn_json_value_no_memory (&item);
  }
  return TRUE;
}

static gboolean
read_found (const QnJsonValue *owner, const QnMember *members, QnResult *result)
{
  QnJsonValue found, left, item = { 0 }, joint = { 0 };
  if (!qn_member_array (owner, "found", QN_OPTIONAL, &found)
      || !qn_member_array (owner, "left", QN_OPTIONAL, &left))
    return FALSE;
  while (qn_json_value_next (&found, &item)) {
    QnFound read = { 0 };
    if (!qn_result_object (&item, members, &read))
      return FALSE;
    if (!qn_result_add_found (result, read))
      return qn_json_value_no_memory (&item);
    if (!read_found_forces (&item, result))
      return FALSE;
  }
  while (qn_json_value_next (&left, &joint)) {
    double numbers[2];
    QnLeftFace face;
    if (!qn_result_read_numbers (&joint, numbers, 1, 2, NULL))
      return FALSE;
    const QnJsonValue first = qn_json_value_element (&joint, 0, joint.json->child);
    if (!qn_read_index (&first, 0, &face.face))
      return FALSE;
    face.time = numbers[1];
    if (!qn_result_add_left (result, face))
      return qn_json_value_no_memory (&joint);
  }
  if (result->found_force_count > 0)
    qsort (result->found_forces, result->found_force_count, sizeof (QnFoundForce),
           compare_forces);
  return TRUE;
}

/* A list, the member `key` of an object, into a column of the rows. */
static gboolean
read_column (const QnJsonValue *object, const char *key, QnHistory *history,
             size_t column)
{
  const QnJsonValue list = qn_json_value_member (object, key);
  return qn_result_read_numbers (&list, history->rows + column, history->width,
                                 history->row_count,
                                 _ ("lists of the history differ in length"));
}

/* Which block and component a track is of is the project's knowledge. */
static gboolean
read_columns (const QnJsonValue *place, QnHistory *history)
{
  const QnJsonValue ground = qn_json_value_member (place, "ground"),
                    energy = qn_json_value_member (place, "energy"),
                    tracks = qn_json_value_member (place, "tracks");
  QnJsonValue track = { 0 };
  gboolean done = read_column (place, "time", history, QN_HISTORY_TIME)
                  && read_column (&ground, "x", history, QN_HISTORY_GROUND_X)
                  && read_column (&ground, "y", history, QN_HISTORY_GROUND_Y);
  for (size_t kind = 0; done && kind < QN_ENERGY_KIND_COUNT; kind++)
    done =
      read_column (&energy, qn_energy_names[kind], history, QN_HISTORY_ENERGY + kind);
  while (done && qn_json_value_next (&tracks, &track))
    done = read_column (&track, "values", history, QN_HISTORY_TRACK + track.index);
  return done;
}

gboolean
qn_result_history_read (const QnJsonValue *root, QnResult *result)
{
  QnHistory *history = &result->history;
  const QnJsonValue place = qn_json_value_member (root, "history"),
                    found = qn_json_value_member (root, "found"),
                    left = qn_json_value_member (root, "left"),
                    peak = qn_json_value_member (&place, "peak");
  const gboolean outside = found.json != NULL || left.json != NULL;
  QnJsonValue times, tracks;
  if (place.json == NULL) {
    for (size_t i = 0; outside && i < result->step_count; i++)
      result->steps[i].time = (double) i; /* its number stands for its time */
    return read_found (root, found_by_step, result);
  }
  if (outside)
    return qn_json_value_fail (
      left.json != NULL ? &left : &found,
      _ ("contacts that an analysis in time found belong to its history"));
  history->peak_time = NAN;
  if (!qn_result_object (&place, scalars, history)
      || !qn_member_array (&place, "time", QN_REQUIRED, &times)
      || !qn_member_array (&place, "tracks", QN_REQUIRED, &tracks))
    return FALSE;
  if (isnan (history->collapse_time))
    history->collapse_time = 0;
  history->row_count = (size_t) cJSON_GetArraySize (times.json);
  history->width = QN_HISTORY_TRACK + (size_t) cJSON_GetArraySize (tracks.json);
  history->capacity = history->row_count * history->width;
  history->rows = qn_result_room (&place, history->capacity, sizeof *history->rows,
                                  _ ("lists of the history differ in length"));
  history->peaks = qn_alloc (result->block_count, sizeof *history->peaks);
  if (history->rows == NULL || history->peaks == NULL)
    return qn_json_value_no_memory (&place);
  return read_columns (&place, history)
         && qn_result_read_numbers (&peak, history->peaks, 1, result->block_count,
                                    _ ("lists of the history differ in length"))
         && read_found (&place, found_by_time, result);
}
