#include "io/exchange/record.h"

#include "core/dynamics/ground.h"
#include "io/text/file-read.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* A stronger record is probably in another unit; m/s2. */
#define DOUBTFUL_PEAK (3 * QN_STANDARD_GRAVITY)

/* Seismographs take samples at least ten times as often, s; a few points by hand may lie farther apart. */
#define DOUBTFUL_STEP 0.1
#define MANY_SAMPLES  100

/* Times of samples are written with few digits: steps that differ by less than this part are equal. */
#define EVEN 0.05

/* Longer ones are gaps, where even steps are so many times as many. */
#define GAP       1.5
#define MOST_EVEN 3

void
qn_record_clear (QnRecord *record)
{
  g_free (record->points);
  *record = (QnRecord){ 0 };
}

QnRecordFacts
qn_record_facts (const QnRecord *record)
{
  QnRecordFacts facts = { .time_step = NAN };
  double v = 0, d = 0, least = HUGE_VAL, greatest = 0;
  for (gsize i = 0; i < record->count; i++) {
    QnVec2 b = record->points[i];
    if (i > 0) {
      QnVec2 a = record->points[i - 1];
      double h = b.x - a.x;
      least = fmin (least, h);
      greatest = fmax (greatest, h);
      d += h * v
           + h * h * (2 * a.y + b.y) / 6; /* exact for straight lines between samples */
      v += 0.5 * h * (a.y + b.y);
    }
    facts.peak = MAX (facts.peak, fabs (b.y));
    facts.velocity = MAX (facts.velocity, fabs (v));
    facts.displacement = MAX (facts.displacement, fabs (d));
  }
  facts.duration = record->count > 0 ? record->points[record->count - 1].x : 0;
  if (record->count > 1 && greatest <= least * (1 + EVEN))
    facts.time_step =
      (facts.duration - record->points[0].x) / (double) (record->count - 1);
  facts.end_velocity = v;
  facts.end_displacement = d;
  return facts;
}

char *
qn_record_dup_doubt (const QnRecord *record)
{
  double peak = qn_record_facts (record).peak;
  if (peak > DOUBTFUL_PEAK)
    return g_strdup_printf (_ ("its largest acceleration is %.4g m/s2, more than 3 g: is "
                               "the unit right?"),
                            peak);
  double apart = record->count < MANY_SAMPLES
                   ? 0
                   : (record->points[record->count - 1].x - record->points[0].x)
                       / (double) (record->count - 1);
  if (apart > DOUBTFUL_STEP)
    return g_strdup_printf (_ ("its samples are %.4g s apart: is the first column the "
                               "time, in seconds?"),
                            apart);
  if (record->offset != 0)
    return g_strdup_printf (_ ("an offset of %.4g m/s2 was taken off"), record->offset);
  return NULL;
}

void
qn_record_find_gap (QnRecord *record)
{
  const QnVec2 *points = record->points;
  double least = HUGE_VAL, sum = 0;
  gsize even = 0, gaps = 0, first = 0;
  record->gap = 0;
  record->missing[0] = record->missing[1] = 0;
  for (gsize i = 1; i < record->count; i++)
    least = fmin (least, points[i].x - points[i - 1].x);
  for (gsize i = 1; i < record->count; i++)
    if (points[i].x - points[i - 1].x <= least * (1 + EVEN)) {
      sum += points[i].x - points[i - 1].x;
      even++;
    }
  for (gsize i = 1; i < record->count; i++) {
    double step = points[i].x - points[i - 1].x, steps = step * (double) even / sum;
    if (step <= least * (1 + EVEN))
      continue;
    if (!(steps > GAP)) /* uneven, as it is meant to be */
      return;
    record->missing[1] += round (steps) - 1;
    if (gaps++ == 0) {
      record->missing[0] = record->missing[1];
      first = i;
    }
  }
  if (MOST_EVEN * gaps <= even)
    record->gap = first;
}

char *
qn_record_dup_gap (const QnRecord *record, const char *file)
{
  const gsize at = record->gap;
  if (at == 0)
    return NULL;
  g_autofree char *text = g_strdup_printf (
    _ ("samples are missing from %.6g s to %.6g s: %.0f (%.0f in the whole record); "
       "straight lines take their place"),
    record->points[at - 1].x, record->points[at].x, record->missing[0],
    record->missing[1]);
  return file != NULL ? g_strdup_printf ("%s:%zu: %s", file, record->gap_line, text)
                      : g_steal_pointer (&text);
}

gboolean
qn_record_write (const char *path, const QnRecord *record, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path);
  qn_file_writer_puts (writer, "time [s],acceleration [m/s2]\n");
  for (gsize i = 0; i < record->count; i++)
    qn_file_writer_csv (writer, "%g,%g\n", record->points[i].x, record->points[i].y);
  return qn_file_writer_commit (writer, error);
}

/* --- Those of a project ------------------------------------------------------------------- */

/* Puts the key in front of what is wrong with its file. */
static gboolean
fail_at_key (const QnProject *project, gsize index, GError *cause, GError **error)
{
  g_autofree char *path =
    g_strdup_printf ("analysis.dynamic.ground[%" G_GSIZE_FORMAT "].record", index);
  GError *placed = NULL;
  qn_project_set_key_error (project, path, cause->message, &placed);
  placed->code = cause->code;
  g_error_free (cause);
  g_propagate_error (error, placed);
  return FALSE;
}

/* Samples stand for the time up to the next one: a record may end one of them before the duration. */
static gboolean
reaches_duration (const QnProject *project, gsize index, const QnRecord *record,
                  GError **error)
{
  double end = record->points[record->count - 1].x,
         apart = end - record->points[record->count - 2].x,
         duration = project->model.analysis.dynamic.duration;
  if (project->model.ground[index].rests || end + apart * (1 + 1e-9) >= duration)
    return TRUE;
  return qn_io_fail (
    error, QN_IO_ERROR_INVALID,
    _ ("the record ends at %.4g s, before the duration of %.4g s: shorten that, "
       "or set \"rest\" for ground that rests from then on"),
    end, duration);
}

/* Most of a signal's Arias intensity that an analysis may leave out at its end. */
#define MOST_CUT 0.01

gboolean
qn_record_is_cut (const QnModel *model, const QnGroundMotion *motion)
{
  double duration = model->analysis.dynamic.duration;
  return duration > 0 && qn_ground_motion_share_after (motion, duration) > MOST_CUT;
}

static gboolean
check_cut (const QnProject *project, gsize index, GError **error)
{
  const QnGroundMotion *motion = &project->model.ground[index];
  double duration = project->model.analysis.dynamic.duration;
  if (!qn_record_is_cut (&project->model, motion))
    return TRUE;
  g_autofree char *path =
    g_strdup_printf ("analysis.dynamic.ground[%" G_GSIZE_FORMAT "]", index);
  g_autofree char *message = g_strdup_printf (
    _ ("lasts %.4g s, and %.0f %% of its Arias intensity come after the duration of "
       "%.4g s: leave \"duration\" out to follow it to its end"),
    qn_ground_motion_end (motion), 100 * qn_ground_motion_share_after (motion, duration),
    duration);
  qn_project_set_key_error (project, path, message, error);
  return FALSE;
}

/* Says once what is odd about a record; NULL: nothing. */
static void
warn_at_key (QnProject *project, gsize index, const char *text)
{
  if (text == NULL)
    return;
  g_autofree char *warning =
    g_strdup_printf ("%s: analysis.dynamic.ground[%" G_GSIZE_FORMAT "].record: %s",
                     project->name, index, text);
  if (!g_ptr_array_find_with_equal_func (project->warnings, warning, g_str_equal, NULL))
    g_ptr_array_add (project->warnings, g_steal_pointer (&warning));
}

static gboolean
take_record (QnProject *project, gsize index, const QnRecord *record, GError **error)
{
  QnGroundMotion *motion = &project->model.ground[index];
  double peak = qn_record_facts (record).peak;
  double scale = motion->peak > 0 && peak > 0 ? motion->peak / peak : 1;
  g_autofree char *doubt = motion->peak > 0 ? NULL : qn_record_dup_doubt (record);
  g_autofree char *gap = qn_record_dup_gap (record, motion->record);
  warn_at_key (project, index, doubt);
  warn_at_key (project, index, gap);
  motion->point_count = 0;
  motion->record_unit = record->unit;
  for (gsize i = 0; i < record->count; i++)
    if (!qn_ground_motion_add_point (motion, record->points[i].x,
                                     scale * record->points[i].y))
      return qn_io_fail (error, QN_IO_ERROR_NO_MEMORY, "%s: %s", project->name,
                         _ ("not enough memory"));
  return TRUE;
}

gboolean
qn_project_read_record (QnProject *project, gsize index, const char *folder,
                        gboolean allow_outside, GError **error)
{
  const QnGroundMotion *motion = &project->model.ground[index];
  g_autofree char *own =
    project->path != NULL ? g_path_get_dirname (project->path) : NULL;
  GError *cause = NULL;
  QnRecord record;
  g_autofree char *path =
    qn_file_inside (folder != NULL ? folder : own, motion->record, allow_outside, &cause);
  if (path == NULL
      || !qn_record_read (path, motion->unit, motion->time_step, FALSE, &record, &cause))
    return fail_at_key (project, index, cause, error);
  gboolean reaches = reaches_duration (project, index, &record, &cause);
  gboolean done = reaches && take_record (project, index, &record, error);
  qn_record_clear (&record);
  return reaches ? done : fail_at_key (project, index, cause, error);
}

gboolean
qn_project_read_records (QnProject *project, const char *folder, gboolean allow_outside,
                         GError **error)
{
  for (gsize i = 0; i < project->model.ground_count; i++)
    if ((project->model.ground[i].kind == QN_SIGNAL_RECORD
         && !qn_project_read_record (project, i, folder, allow_outside, error))
        || !check_cut (project, i, error))
      return FALSE;
  return TRUE;
}
