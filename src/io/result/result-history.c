#include "io/result/result-history.h"

#include "core/base/memory.h"
#include "io/project/project-names.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

static void
write_scalars (QnFileWriter *writer, const QnResult *result)
{
  const QnHistory *h = &result->history;
  const struct {
    const char *key;
    double number;
  } numbers[] = {
    { "end", h->end },
    { "energy_error", h->energy_error },
    { "largest_residual", h->largest_residual },
    { "largest_slip", h->largest_slip },
    { "shortest_step", h->shortest_step },
    { "steps", h->steps },
    { "rejected", h->rejected },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (numbers); i++) {
    qn_file_writer_printf (writer, "%s\"%s\": ", i > 0 ? ", " : "\n    ", numbers[i].key);
    qn_file_writer_number (writer, numbers[i].number);
  }
  if (!isnan (h->peak_time))
    qn_file_writer_puts_number (writer, ", \"time_of_peak\": ", h->peak_time);
  qn_file_writer_puts (writer, ", \"time_of_collapse\": ");
  if (result->outcome == QN_OUTCOME_COLLAPSE)
    qn_file_writer_number (writer, h->collapse_time);
  else
    qn_file_writer_puts (writer, "null");
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
    const QnFoundContact *c = &result->found[i].contact;
    const char *separator = "";
    qn_file_writer_printf (
      writer, "%s\n      { \"side\": [%d, %d], \"corner\": [%d, %d], \"foot\": ",
      i > 0 ? "," : "", c->block, c->side, c->other, c->corner);
    qn_file_writer_number (writer, c->foot);
    qn_file_writer_puts_number (writer, ", \"inset\": ", c->inset);
    qn_file_writer_puts_number (
      writer, in_time ? ", \"time\": " : ", \"step\": ", result->found[i].time);
    qn_file_writer_puts (writer, ", \"forces\": [");
    for (gsize k = first[i]; k < first[i + 1]; k++) {
      const QnFoundForce *force = &result->found_forces[places[k]];
      qn_file_writer_printf (writer, "%s[%d, ", separator, force->step);
      qn_file_writer_number (writer, force->normal);
      qn_file_writer_puts_number (writer, ", ", force->shear);
      qn_file_writer_printf (writer, ", %d]", (int) force->state);
      separator = ", ";
    }
    qn_file_writer_puts (writer, "] }");
  }
  qn_file_writer_puts (writer, "],\n    \"left\": [");
  for (size_t i = 0; i < result->left_count; i++) {
    qn_file_writer_printf (writer, "%s[%d, ", i > 0 ? ", " : "", result->left[i].face);
    qn_file_writer_number (writer, result->left[i].time);
    qn_file_writer_puts (writer, "]");
  }
  qn_file_writer_puts (writer, "]");
}

void
qn_result_history_write (QnFileWriter *writer, const QnModel *model,
                         const QnResult *result)
{
  const QnHistory *h = &result->history;
  qn_file_writer_puts (writer, "  \"history\": {");
  write_scalars (writer, result);
  qn_file_writer_puts (writer, ",\n    \"time\": ");
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
    qn_file_writer_puts_string (
      writer, i > 0 ? ",\n      { \"block\": " : "\n      { \"block\": ",
      model->blocks[track->block].name);
    qn_file_writer_printf (
      writer, ", \"component\": \"%s\", \"values\": ", qn_dof_names[track->dof]);
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

static gboolean
read_number (QnJsonStream *stream, gpointer target)
{
  double number;
  if (!qn_json_stream_number (stream, &number))
    return FALSE;
  g_array_append_val ((GArray *) target, number);
  return TRUE;
}

static gboolean
read_list (QnJsonStream *stream, gpointer target)
{
  GArray **list = target;
  *list = g_array_new (FALSE, FALSE, sizeof (double));
  return qn_json_stream_array (stream, read_number, *list);
}

static gboolean
read_collapse_time (QnJsonStream *stream, gpointer target)
{
  return stream->scanner.token == QN_JSON_NULL || qn_json_stream_number (stream, target);
}

/* Targets of the next three are lists by the columns of the history. */
#define COLUMN(name, index)                                                              \
  {                                                                                      \
    name, read_list, (index) * sizeof (GArray *), QN_JSON_REQUIRED                       \
  }

static gboolean
read_ground (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = { COLUMN ("x", QN_HISTORY_GROUND_X),
                                          COLUMN ("y", QN_HISTORY_GROUND_Y) };
  return qn_json_stream_object (stream, members, G_N_ELEMENTS (members), target);
}

static gboolean
read_energy (QnJsonStream *stream, gpointer target)
{
  QnJsonMember members[QN_ENERGY_KIND_COUNT];
  for (int kind = 0; kind < QN_ENERGY_KIND_COUNT; kind++)
    members[kind] =
      (QnJsonMember) COLUMN (qn_energy_names[kind], (gsize) (QN_HISTORY_ENERGY + kind));
  return qn_json_stream_object (stream, members, QN_ENERGY_KIND_COUNT, target);
}

/* Which block and component is the project's knowledge. */
static gboolean
read_track (QnJsonStream *stream, gpointer target)
{
  static const QnJsonMember members[] = { { "values", read_list, 0, QN_JSON_REQUIRED } };
  GArray *values = NULL;
  gboolean done =
    qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &values);
  if (values != NULL)
    g_ptr_array_add (*(GPtrArray **) target, values);
  return done;
}

static void
free_list (gpointer list)
{
  if (list != NULL)
    g_array_unref (list);
}

/* A number that counts something. */
static gboolean
take_count (QnJsonStream *stream, double number, int32_t *count)
{
  if (!(number >= 0 && number < INT32_MAX && number == floor (number)))
    return qn_json_stream_fail (stream,
                                _ ("expected a whole number that is not negative"));
  *count = (int32_t) number;
  return TRUE;
}

static gboolean
read_place (QnJsonStream *stream, gpointer target)
{
  double numbers[2];
  QnId *place = target;
  return qn_json_stream_numbers (stream, numbers, 2)
         && take_count (stream, numbers[0], &place[0])
         && take_count (stream, numbers[1], &place[1]);
}

/* One contact that was found on the way, while it is read. */
typedef struct ReadingFound {
  QnId side[2], corner[2];
  double foot, inset, time;
  GArray *forces; /* of the whole list */
  QnId index;
} ReadingFound;

static gboolean
read_found_force (QnJsonStream *stream, gpointer target)
{
  ReadingFound *found = target;
  double numbers[4];
  QnFoundForce force = { .found = found->index };
  int32_t state = 0;
  if (!qn_json_stream_numbers (stream, numbers, 4)
      || !take_count (stream, numbers[0], &force.step)
      || !take_count (stream, numbers[3], &state))
    return FALSE;
  if (state >= QN_PAIR_STATE_COUNT)
    return qn_json_stream_fail (stream, _ ("this is not a state of a contact pair"));
  force.normal = numbers[1];
  force.shear = numbers[2];
  force.state = (QnPairState) state;
  g_array_append_val (found->forces, force);
  return TRUE;
}

/* `when`: the key of when it was found. */
static gboolean
read_found_by (QnJsonStream *stream, const char *when, QnHistoryDraft *draft)
{
  const QnJsonMember members[] = {
    { "side", read_place, offsetof (ReadingFound, side), QN_JSON_REQUIRED },
    { "corner", read_place, offsetof (ReadingFound, corner), QN_JSON_REQUIRED },
    { "foot", qn_json_stream_number, offsetof (ReadingFound, foot), QN_JSON_REQUIRED },
    { "inset", qn_json_stream_number, offsetof (ReadingFound, inset), 0 },
    { when, qn_json_stream_number, offsetof (ReadingFound, time), QN_JSON_REQUIRED },
    { "forces", read_found_force, 0, QN_JSON_REQUIRED | QN_JSON_EACH },
  };
  if (draft->found == NULL) {
    draft->found = g_array_new (FALSE, FALSE, sizeof (QnFound));
    draft->found_forces = g_array_new (FALSE, FALSE, sizeof (QnFoundForce));
  }
  ReadingFound read = { .forces = draft->found_forces,
                        .index = (QnId) draft->found->len };
  if (!qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &read))
    return FALSE;
  QnFound found = { .contact = { .block = read.side[0],
                                 .side = read.side[1],
                                 .other = read.corner[0],
                                 .corner = read.corner[1],
                                 .foot = read.foot,
                                 .inset = read.inset },
                    .time = read.time };
  g_array_append_val (draft->found, found);
  return TRUE;
}

static gboolean
read_found (QnJsonStream *stream, gpointer target)
{
  return read_found_by (stream, "time", target);
}

gboolean
qn_result_found_read (QnJsonStream *stream, gpointer target)
{
  QnHistoryDraft *draft = target;
  draft->by_step = TRUE;
  return read_found_by (stream, "step", draft);
}

static gboolean
read_left (QnJsonStream *stream, gpointer target)
{
  QnHistoryDraft *draft = target;
  double numbers[2];
  QnLeftFace left;
  if (!qn_json_stream_numbers (stream, numbers, 2)
      || !take_count (stream, numbers[0], &left.face))
    return FALSE;
  left.time = numbers[1];
  if (draft->left == NULL)
    draft->left = g_array_new (FALSE, FALSE, sizeof (QnLeftFace));
  g_array_append_val (draft->left, left);
  return TRUE;
}

gboolean
qn_result_left_read (QnJsonStream *stream, gpointer target)
{
  ((QnHistoryDraft *) target)->by_step = TRUE;
  return read_left (stream, target);
}

/* The whole member. */
typedef struct Reading {
  GArray *columns[QN_HISTORY_TRACK];
  QnHistory history;
  GPtrArray *tracks;
  GArray *peaks;
  QnHistoryDraft draft; /* what was found on the way */
} Reading;

gboolean
qn_result_history_read (QnJsonStream *stream, gpointer target)
{
#define SCALAR(name, member, read)                                                       \
  {                                                                                      \
    name, read, offsetof (Reading, history.member), QN_JSON_REQUIRED                     \
  }
  static const QnJsonMember members[] = {
    SCALAR ("end", end, qn_json_stream_number),
    { "time_of_peak", qn_json_stream_number, offsetof (Reading, history.peak_time),
      QN_JSON_OPTIONAL },
    SCALAR ("energy_error", energy_error, qn_json_stream_number),
    SCALAR ("largest_residual", largest_residual, qn_json_stream_number),
    SCALAR ("largest_slip", largest_slip, qn_json_stream_number),
    SCALAR ("shortest_step", shortest_step, qn_json_stream_number),
    SCALAR ("steps", steps, qn_json_stream_int32),
    SCALAR ("rejected", rejected, qn_json_stream_int32),
    SCALAR ("time_of_collapse", collapse_time, read_collapse_time),
    COLUMN ("time", QN_HISTORY_TIME),
    { "ground", read_ground, 0, QN_JSON_REQUIRED },
    { "energy", read_energy, 0, QN_JSON_REQUIRED },
    { "tracks", read_track, offsetof (Reading, tracks), QN_JSON_REQUIRED | QN_JSON_EACH },
    { "peak", read_list, offsetof (Reading, peaks), QN_JSON_REQUIRED },
    { "found", read_found, offsetof (Reading, draft), QN_JSON_EACH },
    { "left", read_left, offsetof (Reading, draft), QN_JSON_EACH },
  };
#undef SCALAR
  Reading read = { .tracks = g_ptr_array_new_with_free_func (free_list),
                   .history.peak_time = NAN };
  gboolean done = qn_json_stream_object (stream, members, G_N_ELEMENTS (members), &read);
  QnHistoryDraft *draft = target;
  read.draft.by_step = draft->by_step;
  qn_history_draft_clear (draft);
  *draft = read.draft;
  draft->history = read.history;
  draft->peaks = read.peaks;
  draft->columns = read.tracks;
  for (gint i = 0; i < QN_HISTORY_TRACK; i++)
    g_ptr_array_insert (draft->columns, i, read.columns[i]);
  return done;
}

static int
compare_forces (const void *a, const void *b)
{
  const QnFoundForce *f = a, *g = b;
  return f->step != g->step ? (f->step < g->step ? -1 : 1)
                            : (f->found > g->found) - (f->found < g->found);
}

/* A copy of a list as the core keeps it; false when memory runs out. */
static gboolean
copy_list (const GArray *list, gpointer items, size_t *count, size_t *capacity)
{
  gsize size = g_array_get_element_size ((GArray *) list);
  void *copy = qn_alloc (list->len, size);
  if (copy == NULL)
    return FALSE;
  if (list->len > 0)
    memcpy (copy, list->data, list->len * size);
  *(void **) items = copy;
  *count = *capacity = list->len;
  return TRUE;
}

static gboolean
take_found (const QnHistoryDraft *draft, QnResult *result)
{
  if (draft->found_forces != NULL && draft->found_forces->len > 0)
    qsort (draft->found_forces->data, draft->found_forces->len, sizeof (QnFoundForce),
           compare_forces);
  return (draft->found == NULL
          || (copy_list (draft->found, &result->found, &result->found_count,
                         &result->found_capacity)
              && copy_list (draft->found_forces, &result->found_forces,
                            &result->found_force_count, &result->found_force_capacity)))
         && (draft->left == NULL
             || copy_list (draft->left, &result->left, &result->left_count,
                           &result->left_capacity));
}

gboolean
qn_result_history_take (QnHistoryDraft *draft, QnJsonStream *stream, QnResult *result)
{
  if (draft->by_step && draft->columns != NULL)
    return qn_json_stream_fail_at (
      stream, "found",
      _ ("contacts that an analysis in time found belong to its history"));
  if (draft->by_step) /* the number of a step stands for its time */
    for (gsize i = 0; i < result->step_count; i++)
      result->steps[i].time = (double) i;
  if (draft->columns == NULL)
    return take_found (draft, result) || qn_json_stream_no_memory (stream);
  const GArray *time = g_ptr_array_index (draft->columns, 0);
  gsize rows = time->len, width = draft->columns->len;
  gboolean fits = draft->peaks->len == result->block_count;
  for (gsize c = 0; c < width; c++)
    fits = fits && ((GArray *) g_ptr_array_index (draft->columns, c))->len == rows;
  if (!fits)
    return qn_json_stream_fail_at (stream, "history",
                                   _ ("lists of the history differ in length"));
  QnHistory *history = &result->history;
  *history = draft->history;
  history->width = width;
  history->row_count = rows;
  history->capacity = rows * width;
  history->rows = qn_alloc (rows * width, sizeof *history->rows);
  history->peaks = qn_alloc (result->block_count, sizeof *history->peaks);
  if (history->rows == NULL || history->peaks == NULL || !take_found (draft, result))
    return qn_json_stream_no_memory (stream);
  for (gsize c = 0; c < width; c++) {
    const GArray *column = g_ptr_array_index (draft->columns, c);
    for (gsize i = 0; i < rows; i++)
      history->rows[i * width + c] = g_array_index (column, double, i);
  }
  if (result->block_count > 0)
    memcpy (history->peaks, draft->peaks->data,
            result->block_count * sizeof *history->peaks);
  return TRUE;
}

void
qn_history_draft_clear (QnHistoryDraft *draft)
{
  g_clear_pointer (&draft->columns, g_ptr_array_unref);
  g_clear_pointer (&draft->peaks, g_array_unref);
  g_clear_pointer (&draft->found, g_array_unref);
  g_clear_pointer (&draft->found_forces, g_array_unref);
  g_clear_pointer (&draft->left, g_array_unref);
}
