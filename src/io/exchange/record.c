#include "io/exchange/record.h"

#include "io/text/file-inside.h"
#include "io/text/file-read.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Standard gravity, m/s2: what AT2 files and "g" mean, whatever the project's gravity. */
#define STANDARD_GRAVITY 9.80665

/* A file that is being read. */
typedef struct Reading {
  const char *name;
  char **lines; /* NULL-terminated */
  const char *unit;
  double time_step;
  double factor; /* m/s2 per unit of the file; 0: not known */
  GArray *points;
  GError **error;
} Reading;

static gboolean
fail (const Reading *r, gsize line, const char *message)
{
  if (line > 0)
    g_set_error (r->error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s:%" G_GSIZE_FORMAT ": %s",
                 r->name, line, message);
  else
    g_set_error (r->error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s: %s", r->name, message);
  return FALSE;
}

/* m/s2 per unit; 0 where it is none. */
static double
unit_factor (const char *unit)
{
  static const struct {
    const char *name;
    double factor;
  } units[] = {
    { "m/s2", 1 },       { "m/s^2", 1 },
    { "m/s/s", 1 },      { "cm/s2", 0.01 },
    { "cm/s^2", 0.01 },  { "cm/s/s", 0.01 },
    { "gal", 0.01 },     { "mm/s2", 0.001 },
    { "mm/s^2", 0.001 }, { "g", STANDARD_GRAVITY },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (g_ascii_strcasecmp (unit, units[i].name) == 0)
      return units[i].factor;
  return 0;
}

/* Takes up a unit that the file says (nullable), beside the one that was given. */
static gboolean
settle_unit (Reading *r, gsize line, const char *said)
{
  double own = said != NULL ? unit_factor (said) : 0;
  double given = r->unit != NULL ? unit_factor (r->unit) : 0;
  if (r->unit != NULL && given == 0)
    return fail (r, 0, _ ("unit is not one of m/s2, cm/s2, gal, mm/s2 and g"));
  if (said != NULL && own == 0)
    return fail (r, line, _ ("unit is not one of m/s2, cm/s2, gal, mm/s2 and g"));
  if (own > 0 && given > 0 && own != given)
    return fail (r, line, _ ("the file states another unit than the one given"));
  if (own == 0 && given == 0)
    return fail (r, 0,
                 _ ("the file does not state the unit of its accelerations: give it "
                    "(unit: g, m/s2, cm/s2)"));
  r->factor = own > 0 ? own : given;
  return TRUE;
}

/* The same for the time between samples. */
static gboolean
settle_time_step (Reading *r, gsize line, double said)
{
  if (said > 0 && r->time_step > 0 && fabs (said / r->time_step - 1) > 1e-9)
    return fail (r, line, _ ("the file states another time step than the one given"));
  if (!(said > 0) && !(r->time_step > 0))
    return fail (r, 0,
                 _ ("the file does not state its time step: give it (time_step, s)"));
  r->time_step = said > 0 ? said : r->time_step;
  return TRUE;
}

/* Adds a sample; time NAN: one time step behind the last one. */
static gboolean
add_sample (Reading *r, gsize line, double time, double value)
{
  QnVec2 point = { time, value * r->factor };
  const guint count = r->points->len;
  if (count >= QN_MAX_SIGNAL_POINTS)
    return fail (r, line, _ (qn_problem_text (QN_PROBLEM_SIGNAL_TOO_LONG)));
  if (isnan (time))
    point.x = r->time_step * count;
  if (!isfinite (point.x) || !isfinite (point.y))
    return fail (r, line, _ ("number is not finite"));
  if (count > 0 && point.x <= g_array_index (r->points, QnVec2, count - 1).x)
    return fail (r, line, _ (qn_problem_text (QN_PROBLEM_SIGNAL_ORDER)));
  if (count == 0 && point.x < 0)
    return fail (r, line, _ ("times must not be negative"));
  g_array_append_val (r->points, point);
  return TRUE;
}

/* The next number of a line; FALSE at its end, *bad where something else stands there. */
static gboolean
next_number (const char **at, double *number, gboolean *bad)
{
  const char *c = *at + strspn (*at, " \t\r,;");
  char *end;
  if (*c == '\0')
    return FALSE;
  *number = g_ascii_strtod (c, &end);
  *bad = end == c || strchr (" \t\r,;", *end) == NULL;
  *at = end;
  return !*bad;
}

/* Accelerations alone, any number in a line, from a line on. */
static gboolean
read_samples (Reading *r, gsize first)
{
  for (gsize i = first; r->lines[i] != NULL; i++) {
    const char *at = r->lines[i];
    double number;
    gboolean bad = FALSE;
    while (next_number (&at, &number, &bad))
      if (!add_sample (r, i + 1, NAN, number))
        return FALSE;
    if (bad)
      return fail (r, i + 1, _ ("expected a number"));
  }
  return TRUE;
}

/* The value of KEY= or KEY: in a line; NULL where it is not there. */
static const char *
find_value (const char *line, const char *key)
{
  const char *at = strstr (line, key);
  if (at == NULL)
    return NULL;
  at += strlen (key);
  at += strspn (at, " \t");
  if (*at != '=' && *at != ':')
    return NULL;
  at++;
  return at + strspn (at, " \t");
}

static gboolean
check_count (const Reading *r, double said)
{
  if (said > 0 && (double) r->points->len < said)
    return fail (
      r, 0, _ ("record has fewer samples than its heading states: it is incomplete"));
  return TRUE;
}

/* --- Kinds of files ----------------------------------------------------------------------- */

static gboolean
read_at2 (Reading *r, gsize heading)
{
  const char *line = r->lines[heading];
  const char *step = find_value (line, "DT"), *count = find_value (line, "NPTS");
  return settle_unit (r, heading, "g")
         && settle_time_step (r, heading + 1, g_ascii_strtod (step, NULL))
         && read_samples (r, heading + 1)
         && check_count (r, count != NULL ? g_ascii_strtod (count, NULL) : 0);
}

static gboolean
read_esm (Reading *r)
{
  double step = 0, count = 0;
  g_autofree char *unit = NULL;
  gsize i = 0;
  for (; r->lines[i] != NULL && strchr (r->lines[i], ':') != NULL; i++) {
    const char *value;
    if ((value = find_value (r->lines[i], "SAMPLING_INTERVAL_S")) != NULL)
      step = g_ascii_strtod (value, NULL);
    else if ((value = find_value (r->lines[i], "NDATA")) != NULL)
      count = g_ascii_strtod (value, NULL);
    else if (g_str_has_prefix (r->lines[i], "UNITS")
             && (value = find_value (r->lines[i], "UNITS")) != NULL) {
      g_free (unit);
      unit = g_strstrip (g_strdup (value));
    }
  }
  return settle_unit (r, 0, unit) && settle_time_step (r, 0, step) && read_samples (r, i)
         && check_count (r, count);
}

/* The unit in brackets behind the last column of a header; NULL where there is none. */
static char *
header_unit (const char *header)
{
  const char *open = strrchr (header, '['), *close = strrchr (header, ']');
  if (open == NULL)
    open = strrchr (header, '(');
  if (close == NULL)
    close = strrchr (header, ')');
  if (open == NULL || close == NULL || close < open)
    return NULL;
  char *unit = g_strstrip (g_strndup (open + 1, (gsize) (close - open - 1)));
  if (strcmp (unit, "s") == 0) /* that of the time */
    g_clear_pointer (&unit, g_free);
  return unit;
}

static gboolean
is_numbers (const char *line)
{
  double number;
  gboolean bad = FALSE;
  return next_number (&line, &number, &bad);
}

static gboolean
is_blank (const char *line)
{
  return line[strspn (line, " \t\r")] == '\0';
}

static gboolean
read_table (Reading *r)
{
  gsize first = 0;
  while (r->lines[first] != NULL && is_blank (r->lines[first]))
    first++;
  if (r->lines[first] == NULL)
    return fail (r, 0, _ ("record is empty"));
  gboolean has_header = !is_numbers (r->lines[first]);
  g_autofree char *unit = has_header ? header_unit (r->lines[first]) : NULL;
  if (!settle_unit (r, first + 1, unit))
    return FALSE;
  if (r->time_step > 0)
    return fail (r, 0, _ ("the file has times: no time step may be given"));
  for (gsize i = first + (has_header ? 1 : 0); r->lines[i] != NULL; i++) {
    const char *at = r->lines[i];
    double time, value, more;
    gboolean bad = FALSE;
    if (is_blank (at))
      continue;
    if (!next_number (&at, &time, &bad) || !next_number (&at, &value, &bad)
        || next_number (&at, &more, &bad) || bad)
      return fail (r, i + 1, _ ("expected two numbers: time and acceleration"));
    if (!add_sample (r, i + 1, time, value))
      return FALSE;
  }
  return TRUE;
}

static gboolean
read_any (Reading *r)
{
  for (gsize i = 0; i < 8 && r->lines[i] != NULL; i++) {
    if (find_value (r->lines[i], "NPTS") != NULL
        && find_value (r->lines[i], "DT") != NULL)
      return read_at2 (r, i);
    if (g_str_has_prefix (r->lines[i], "EVENT_NAME:"))
      return read_esm (r);
  }
  return read_table (r);
}

gboolean
qn_record_parse (const char *text, gsize length, const char *name, const char *unit,
                 double time_step, QnRecord *record, GError **error)
{
  g_autofree char *copy = g_strndup (text, length);
  g_auto (GStrv) lines = g_strsplit (copy, "\n", -1);
  Reading reading = { .name = name,
                      .lines = lines,
                      .unit = unit,
                      .time_step = time_step,
                      .points = g_array_new (FALSE, FALSE, sizeof (QnVec2)),
                      .error = error };
  *record = (QnRecord){ 0 };
  gboolean done = read_any (&reading);
  if (done && reading.points->len < 2)
    done = fail (&reading, 0, _ (qn_problem_text (QN_PROBLEM_SIGNAL_EMPTY)));
  record->count = done ? reading.points->len : 0;
  record->points = (QnVec2 *) (void *) g_array_free (reading.points, !done);
  return done;
}

gboolean
qn_record_read (const char *path, const char *unit, double time_step, QnRecord *record,
                GError **error)
{
  gsize length;
  *record = (QnRecord){ 0 };
  g_autofree char *text = qn_file_read (path, &length, error);
  return text != NULL
         && qn_record_parse (text, length, path, unit, time_step, record, error);
}

void
qn_record_clear (QnRecord *record)
{
  g_free (record->points);
  *record = (QnRecord){ 0 };
}

QnRecordFacts
qn_record_facts (const QnRecord *record)
{
  QnRecordFacts facts = { 0 };
  double v = 0, d = 0;
  for (gsize i = 0; i < record->count; i++) {
    QnVec2 b = record->points[i];
    if (i > 0) {
      QnVec2 a = record->points[i - 1];
      double h = b.x - a.x;
      d += h * v
           + h * h * (2 * a.y + b.y) / 6; /* exact for straight lines between samples */
      v += 0.5 * h * (a.y + b.y);
    }
    facts.peak = MAX (facts.peak, fabs (b.y));
    facts.velocity = MAX (facts.velocity, fabs (v));
    facts.displacement = MAX (facts.displacement, fabs (d));
  }
  facts.duration = record->count > 0 ? record->points[record->count - 1].x : 0;

  return facts;
}

gboolean
qn_record_write (const char *path, const QnRecord *record, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path, error);
  if (writer == NULL)
    return FALSE;
  qn_file_writer_puts (writer, "time [s],acceleration [m/s2]\n");
  for (gsize i = 0; i < record->count; i++) {
    qn_file_writer_number (writer, record->points[i].x);
    qn_file_writer_puts_number (writer, ",", record->points[i].y);
    qn_file_writer_puts (writer, "\n");
  }
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
  g_set_error (
    error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
    _ ("the record ends at %.4g s, before the duration of %.4g s: shorten that, "
       "or set \"rest\" for ground that rests from then on"),
    end, duration);
  return FALSE;
}

static gboolean
take_record (QnProject *project, gsize index, const QnRecord *record, GError **error)
{
  QnGroundMotion *motion = &project->model.ground[index];
  double peak = qn_record_facts (record).peak;
  double scale = motion->peak > 0 && peak > 0 ? motion->peak / peak : 1;
  motion->point_count = 0;
  for (gsize i = 0; i < record->count; i++)
    if (!qn_ground_motion_add_point (motion, record->points[i].x,
                                     scale * record->points[i].y)) {
      g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s", project->name,
                   _ ("not enough memory"));
      return FALSE;
    }
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
      || !qn_record_read (path, motion->unit, motion->time_step, &record, &cause))
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
    if (project->model.ground[i].kind == QN_SIGNAL_RECORD
        && !qn_project_read_record (project, i, folder, allow_outside, error))
      return FALSE;
  return TRUE;
}
