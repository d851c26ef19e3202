#include "io/exchange/record-heading.h"
#include "io/exchange/record.h"

#include "io/text/file-read.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* More columns than a table has are numbers in a row. */
#define MAX_COLUMNS 64

/* Largest accelerations agree within this part. */
#define SAME_PEAK 0.005

/* A file that is being read. */
typedef struct Reading {
  const char *name;
  char **lines; /* NULL-terminated */
  const char *unit;
  double time_step;
  gboolean spectrum; /* accelerations by periods are wanted */
  QnRecordHeading heading;
  gboolean decimal_comma;
  gboolean packed;      /* numbers of fixed width may touch */
  gsize first;          /* index of the first line of data */
  guint columns;        /* of that line */
  gsize rows;           /* lines of data */
  gboolean even;        /* all of them have as many numbers */
  gboolean first_grows; /* the first number does, from line to line */
  double apart;         /* by so much from the first line to the second */
  guint time, value;    /* columns of a table */
  double time_factor;   /* s per unit */
  double factor;        /* m/s2 per unit */
  const char *own_unit; /* its name */
  GArray *points;
  GError **error;
} Reading;

static gboolean
fail (const Reading *r, gsize line, const char *message)
{
  return line > 0
           ? qn_io_fail (r->error, QN_IO_ERROR_INVALID, "%s:%" G_GSIZE_FORMAT ": %s",
                         r->name, line, message)
           : qn_io_fail (r->error, QN_IO_ERROR_INVALID, "%s: %s", r->name, message);
}

/* ---- numbers ---- */

/* The next number of a line; FALSE at its end, *bad where something else stands there. Fortran's
 * exponents may be a D. */
static gboolean
next_number (const Reading *r, const char **at, double *number, gboolean *bad)
{
  const char *separators = r->decimal_comma ? " \t;" : " \t,;";
  char token[64], *end;
  const char *c = *at + strspn (*at, separators);
  gsize length = strcspn (c, separators);
  if (length == 0)
    return FALSE;
  if (r->packed) /* those of a whole line may touch */
    length = MIN (length, sizeof token - 1);
  *bad = length >= sizeof token;
  if (*bad)
    return FALSE;
  memcpy (token, c, length);
  token[length] = '\0';
  g_strdelimit (token, "dD", 'e');
  if (r->decimal_comma)
    g_strdelimit (token, ",", '.');
  *number = g_ascii_strtod (token, &end);
  *bad = end == token || (*end != '\0' && !(r->packed && strchr ("+-", *end) != NULL));
  *at = c + (end - token);
  return !*bad;
}

static gboolean
is_passed_over (const char *line)
{
  line += strspn (line, " \t");
  return *line == '\0' || strchr ("#%!*|", *line) != NULL
         || g_str_has_prefix (line, "//");
}

/* Numbers of a line; 0 where anything else stands there, too. */
static guint
count_numbers (const Reading *r, const char *line, double *first)
{
  guint count = 0;
  double number;
  gboolean bad = FALSE;
  while (next_number (r, &line, &number, &bad))
    if (count++ == 0)
      *first = number;
  return bad ? 0 : count;
}

/* A comma is the decimal mark where no number has a point, all commas are between digits, and numbers
 * are separated by something else; or where it could only separate times that do not increase. */
static gboolean
has_decimal_comma (const Reading *r)
{
  gboolean comma = FALSE, other = FALSE;
  for (gsize i = r->first; r->lines[i] != NULL; i++) {
    const char *line = r->lines[i];
    if (is_passed_over (line))
      continue;
    if (strchr (line, '.') != NULL)
      return FALSE;
    for (const char *c = line; (c = strchr (c, ',')) != NULL; c++, comma = TRUE)
      if (c == line || !g_ascii_isdigit (c[-1]) || !g_ascii_isdigit (c[1]))
        return FALSE;
    g_autofree char *trimmed = g_strstrip (g_strdup (line));
    other = other || strpbrk (trimmed, "; \t") != NULL;
  }
  return comma
         && (other
             || (r->columns == 2
                 && (!r->first_grows || r->time_step > 0 || r->heading.time_step > 0)));
}

/* Counts the lines of data and what is in them. */
static void
survey (Reading *r)
{
  double last = -INFINITY, first = 0;
  r->apart = 0;
  r->columns = count_numbers (r, r->lines[r->first], &first);
  r->rows = 0;
  r->even = r->first_grows = TRUE;
  for (gsize i = r->first; r->lines[i] != NULL; i++) {
    if (is_passed_over (r->lines[i]))
      continue;
    r->even = r->even && count_numbers (r, r->lines[i], &first) == r->columns;
    r->first_grows = r->first_grows && first > last;
    if (r->rows++ == 1)
      r->apart = first - last;
    last = first;
  }
}

/* A first line of the number of samples, maybe with their time step, is part of the heading. */
static void
pass_count (Reading *r)
{
  double first = 0, other, head[2] = { 0 }, count = 0;
  const char *at = r->lines[r->first];
  gboolean bad = FALSE;
  guint columns = count_numbers (r, at, &first);
  if (r->packed || columns > 2 || !(first > 1 && first == floor (first)))
    return;
  for (gsize i = r->first + 1; r->lines[i] != NULL; i++)
    if (!is_passed_over (r->lines[i]))
      count += count_numbers (r, r->lines[i], &other);
  if (count != first)
    return;
  for (guint i = 0; i < columns; i++)
    next_number (r, &at, &head[i], &bad);
  r->heading.count = count;
  r->heading.time_step = head[1] > 0 ? head[1] : r->heading.time_step;
  r->first++;
}

/* Where the data begin: behind the line that announces them, else at the first line of numbers. */
static gboolean
find_data (Reading *r)
{
  double first;
  for (gsize i = 0; r->lines[i] != NULL && !r->packed; i++)
    if (qn_record_is_descriptor (r->lines[i])) {
      r->packed = TRUE;
      r->first = i + 1;
    }
  while (!r->packed && r->lines[r->first] != NULL
         && (is_passed_over (r->lines[r->first])
             || count_numbers (r, r->lines[r->first], &first) == 0))
    r->first++;
  if (r->lines[r->first] == NULL) {
    gsize end = g_strv_length (r->lines);
    while (end > 0 && is_passed_over (r->lines[end - 1]))
      end--;
    if (end == 0)
      return fail (r, 0, _ ("record is empty: no line has numbers alone"));
    const char *last = r->lines[end - 1];
    g_autofree char *found = g_utf8_make_valid (last, (gssize) MIN (strlen (last), 40));
    g_autofree char *message =
      g_strdup_printf (_ ("no line has numbers alone; the last one is \"%s\""), found);
    return fail (r, end, message);
  }
  qn_record_heading_read (&r->heading, r->lines, r->first);
  pass_count (r);
  if (r->packed)
    return TRUE;
  survey (r);
  r->decimal_comma = has_decimal_comma (r);
  survey (r);
  return TRUE;
}

/* ---- unit and time step ---- */

static gboolean
fail_of_units (const Reading *r, gsize line)
{
  return fail (r, line, _ ("the heading states two different units"));
}

static gboolean
check_quantity (const Reading *r, gsize line, QnRecordQuantity quantity)
{
  if (quantity == QN_RECORD_VELOCITY)
    return fail (r, line, _ ("this is a record of velocity, not of acceleration"));
  if (quantity == QN_RECORD_DISPLACEMENT)
    return fail (r, line, _ ("this is a record of displacement, not of acceleration"));
  if (quantity == QN_RECORD_SPECTRUM && !r->spectrum)
    return fail (r, line, _ ("this is a spectrum, not a record of acceleration in time"));
  return TRUE;
}

/* Takes up the unit that the file says, beside the one that was given. */
static gboolean
settle_unit (Reading *r, gsize line, QnRecordUnit own)
{
  QnRecordUnit given = { QN_RECORD_UNKNOWN, 0 };
  if (r->unit != NULL) {
    given = qn_record_unit (r->unit);
    if (given.quantity != QN_RECORD_ACCELERATION)
      return fail (r, 0, _ ("unit is not one of m/s2, cm/s2, gal, mm/s2 and g"));
  }
  if (!check_quantity (r, line, own.quantity)
      || (r->heading.quantity == QN_RECORD_SPECTRUM
          && !check_quantity (r, 0, QN_RECORD_SPECTRUM)))
    return FALSE;
  if (r->heading.second_unit > 0)
    return fail_of_units (r, r->heading.second_unit);
  if (own.quantity != QN_RECORD_ACCELERATION) {
    if (!check_quantity (r, 0, r->heading.quantity))
      return FALSE;
    own = given;
  }
  if (own.factor == 0)
    return fail (r, 0,
                 _ ("the file does not state the unit of its accelerations: give it "
                    "(unit: g, m/s2, cm/s2)"));
  if (given.factor > 0 && own.factor != given.factor)
    return fail (r, line, _ ("the file states another unit than the one given"));
  r->own_unit = qn_record_unit_name (own);
  r->factor = own.factor * r->heading.scale;
  return TRUE;
}

/* The same for the time between samples. */
static gboolean
settle_time_step (Reading *r)
{
  double said = r->heading.time_step;
  if (r->heading.second_step > 0)
    return fail (r, r->heading.second_step,
                 _ ("the heading states two different time steps"));
  if (said > 0 && r->time_step > 0 && fabs (said / r->time_step - 1) > 1e-6)
    return fail (r, 0, _ ("the file states another time step than the one given"));
  if (!(said > 0) && !(r->time_step > 0))
    return fail (r, 0,
                 _ ("the file does not state its time step: give it (time_step, s)"));
  r->time_step = said > 0 ? said : r->time_step;
  return TRUE;
}

/* The unit that a heading of words has in brackets or behind "in"; only the last line of it may speak
 * of anything but acceleration. */
static QnRecordUnit
unit_of_heading (Reading *r)
{
  QnRecordUnit unit = r->heading.unit;
  for (gsize i = 0; i < r->first && unit.quantity == QN_RECORD_UNKNOWN; i++) {
    g_autofree char *lower = g_utf8_strdown (r->lines[i], -1);
    QnRecordUnit own = qn_record_unit_of_name (lower);
    if (own.quantity == QN_RECORD_ACCELERATION
        || (i + 1 == r->first && own.quantity != QN_RECORD_TIME)) {
      unit = own;
      r->heading.unit_line = i + 1;
      if (strstr (lower, "pga") || strstr (lower, "peak") || strstr (lower, "max"))
        r->heading.peak_line = i + 1;
    }
  }
  return unit;
}

/* ---- samples ---- */

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

/* Of a number that ends here, with its letter: 4 of "1.07E-02". */
static gsize
exponent_length (const char *start, const char *end)
{
  const char *c = end;
  while (c > start && strchr ("+-0123456789", c[-1]) != NULL)
    c--;
  return c > start && strchr ("eEdD", c[-1]) != NULL ? (gsize) (end - c) + 1 : 0;
}

/* Accelerations alone, any number in a line. A last number whose exponent alone is shorter than that of all
 * others is cut. */
static gboolean
read_samples (Reading *r)
{
  gsize i = r->first, last_line = 0;
  gsize first = 0, last = 0, others = 0; /* lengths of exponents; how many differ */
  if (!settle_unit (r, r->heading.unit_line, unit_of_heading (r))
      || !settle_time_step (r))
    return FALSE;
  for (; r->lines[i] != NULL; i++) {
    const char *at = r->lines[i];
    double number;
    gboolean bad = FALSE;
    if (is_passed_over (at))
      continue;
    if (r->packed
        && (qn_record_is_descriptor (at)
            || !strchr ("+-.0123456789", at[strspn (at, " ")])))
      break; /* the end mark, or velocities */
    for (const char *from = at; next_number (r, &at, &number, &bad); from = at) {
      last = exponent_length (from, at);
      last_line = i + 1;
      first = r->points->len == 0 ? last : first;
      others += last != first;
      if (!add_sample (r, i + 1, NAN, number))
        return FALSE;
    }
    if (bad)
      return fail (r, i + 1, _ ("expected a number"));
  }
  if (r->points->len == r->heading.count && others == 1 && last < first)
    return fail (r, last_line, _ ("the file ends within its last number"));
  for (; r->lines[i] != NULL; i++)
    if (qn_record_is_descriptor (r->lines[i])
        && qn_record_quantity_of_name (r->lines[i]) == QN_RECORD_ACCELERATION)
      return fail (r, i + 1,
                   _ ("a second record of acceleration begins here: keep the one to use, "
                      "in a file of its own"));
  return TRUE;
}

/* ---- tables ---- */

/* The names of the columns in the last line of the heading, as many as there are columns; else
 * NULL. */
static char **
dup_names (const Reading *r)
{
  gsize i = r->first;
  while (i > 0 && r->lines[i - 1][strspn (r->lines[i - 1], " \t#%!*|\"'")] == '\0')
    i--;
  if (i == 0)
    return NULL;
  const char *line = r->lines[i - 1] + strspn (r->lines[i - 1], " \t#%!*|\"'");
  static const char *const delimiters[] = { ";", "\t", ",", " " };
  for (gsize k = 0; k < G_N_ELEMENTS (delimiters); k++) {
    g_auto (GStrv) all = g_strsplit (line, delimiters[k], -1);
    g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
    guint count = 0;
    for (char **name = all; *name != NULL; name++)
      if (*g_strstrip (*name) != '\0' && ++count <= MAX_COLUMNS)
        g_strv_builder_add (names, *name);
    if (count == r->columns)
      return g_strv_builder_end (names);
  }
  return NULL;
}

static gboolean
choose_columns (Reading *r, char **names)
{
  guint accelerations = 0, unknown = 0, other = 0, times = 0;
  QnRecordQuantity wrong = QN_RECORD_UNKNOWN;
  QnRecordUnit unit = { QN_RECORD_UNKNOWN, 0 };
  gsize line = r->first;
  for (guint i = 0; i < r->columns; i++) {
    g_autofree char *lower = g_utf8_strdown (names[i], -1);
    QnRecordUnit own = qn_record_unit_of_name (lower);
    if (own.quantity == QN_RECORD_UNKNOWN)
      own = qn_record_unit (lower);
    if (!r->spectrum && qn_record_is_of_spectrum (lower))
      return check_quantity (r, line, QN_RECORD_SPECTRUM);
    if (r->spectrum && strstr (lower, "freq") != NULL)
      return fail (r, line, _ ("a spectrum by frequencies: give it by periods"));
    QnRecordQuantity quantity = own.quantity != QN_RECORD_UNKNOWN
                                  ? own.quantity
                                  : qn_record_quantity_of_name (lower);
    if (quantity == QN_RECORD_TIME || (quantity == QN_RECORD_UNKNOWN && i == 0)) {
      times++;
      r->time = i;
      r->time_factor = own.factor > 0 ? own.factor : 1;
    } else if (quantity == QN_RECORD_ACCELERATION) {
      accelerations++;
      r->value = i;
      unit = own;
    } else if (quantity == QN_RECORD_UNKNOWN) {
      unknown++;
      other = i;
    } else {
      wrong = quantity;
    }
  }
  if (times == 0)
    return fail (r, line, _ ("no column is named as a time"));
  if (accelerations == 0 && unknown == 1)
    r->value = other;
  else if (accelerations == 0 && !check_quantity (r, line, wrong))
    return FALSE;
  else if (accelerations != 1)
    return fail (r, line,
                 _ ("there are several columns besides the time: keep the one of "
                    "acceleration, or name it"));
  if (unit.factor > 0 && r->heading.unit.factor > 0
      && (unit.factor != r->heading.unit.factor
          || r->heading.unit.quantity != QN_RECORD_ACCELERATION))
    return fail_of_units (r, line);
  if (unit.quantity != QN_RECORD_UNKNOWN)
    return settle_unit (r, line, unit);
  return settle_unit (r, r->heading.unit_line, r->heading.unit);
}

static gboolean
read_table (Reading *r)
{
  if (r->time_step > 0)
    return fail (r, 0, _ ("the file has times: no time step may be given"));
  g_auto (GStrv) names = dup_names (r);
  r->time_factor = 1;
  r->value = 1;
  if (names == NULL && r->columns > 2)
    return fail (r, r->first + 1,
                 _ ("more than two columns without a heading that names them: keep "
                    "time and acceleration"));
  if (names != NULL ? !choose_columns (r, names)
                    : !settle_unit (r, r->heading.unit_line, unit_of_heading (r)))
    return FALSE;
  for (gsize i = r->first; r->lines[i] != NULL; i++) {
    const char *at = r->lines[i];
    double numbers[MAX_COLUMNS];
    gboolean bad = FALSE;
    guint count = 0;
    if (is_passed_over (at))
      continue;
    while (count < r->columns && next_number (r, &at, &numbers[count], &bad))
      count++;
    if (bad || count < r->columns || at[strspn (at, " \t,;")] != '\0')
      return fail (r, i + 1,
                   _ ("expected numbers, as many as in the first line of the table"));
    if (!add_sample (r, i + 1, r->time_factor * numbers[r->time], numbers[r->value]))
      return FALSE;
  }
  return TRUE;
}

/* Whether every line is a time and what belongs to it. */
static gboolean
is_table (const Reading *r)
{
  double step = r->heading.time_step;
  if (r->packed || r->columns < 2 || r->columns > MAX_COLUMNS)
    return FALSE;
  if (step > 0)
    return r->even && r->first_grows && fabs (r->apart / step - 1) < 0.01;
  return r->even ? r->first_grows || !(r->time_step > 0) : r->columns == 2;
}

/* Whether the heading states this largest acceleration, or none. */
static gboolean
states_peak (const Reading *r, double peak, double part)
{
  gboolean any = FALSE;
  if (r->heading.peak_line == 0)
    return TRUE;
  g_autofree char *lower = g_utf8_strdown (r->lines[r->heading.peak_line - 1], -1);
  double factor = qn_record_unit_of_name (lower).factor;
  for (const char *at = lower; *(at += strcspn (at, "0123456789.")) != '\0';) {
    char *end;
    double number = factor * g_ascii_strtod (at, &end);
    if (number > 0 && fabs (peak - number) <= part * number)
      return TRUE;
    any = any || number > 0;
    at = MAX (end, at + 1);
  }
  return !any;
}

/* Takes off the offset of raw data (K-NET) where the heading's largest acceleration says so. */
static gboolean
take_off_offset (Reading *r, QnRecord *record)
{
  double peak = 0, sum = 0;
  QnVec2 *points = (QnVec2 *) (void *) r->points->data;
  for (guint i = 0; i < r->points->len; i++) {
    peak = fmax (peak, fabs (points[i].y));
    sum += points[i].y;
  }
  if (states_peak (r, peak, SAME_PEAK))
    return TRUE;
  record->offset = sum / r->points->len;
  peak = 0;
  for (guint i = 0; i < r->points->len; i++) {
    points[i].y -= record->offset;
    peak = fmax (peak, fabs (points[i].y));
  }
  return states_peak (r, peak, 0.05)
         || fail (r, r->heading.peak_line,
                  _ ("the largest acceleration is not that of the heading"));
}

/* Fewer samples than stated are a part of a record; what is more may be anything. */
static gboolean
check_count (const Reading *r)
{
  double said = r->heading.count;
  g_autofree char *message = g_strdup_printf (
    _ ("record has %u samples, and its heading states %.0f"), r->points->len, said);
  return said == 0 || r->points->len == said || fail (r, 0, message);
}

static gboolean
read_any (Reading *r)
{
  if (!find_data (r))
    return FALSE;
  if (is_table (r))
    return read_table (r) && check_count (r);
  /* Several numbers in every line follow each other where the heading counts them all. */
  gboolean counted = r->heading.count > (double) r->rows;
  if (r->even && r->columns > 1 && !r->packed && !counted)
    return fail (
      r, r->first + 1,
      _ ("several records side by side, as AFAD publishes them: keep the one to "
         "use, in a file of its own; if the numbers follow each other, state how many "
         "there are in a line above (NPTS=)"));
  return read_samples (r) && check_count (r);
}

/* The line of a sample of a table. */
static gsize
line_of (const Reading *r, gsize sample)
{
  gsize i = r->first;
  while (r->lines[i + 1] != NULL && (is_passed_over (r->lines[i]) || sample-- > 0))
    i++;
  return i + 1;
}

gboolean
qn_record_parse (const char *text, gsize size, const char *name, const char *unit,
                 double time_step, gboolean spectrum, QnRecord *record, GError **error)
{
  gsize length;
  g_autofree char *decoded = qn_text_decode (text, size, NULL, &length);
  gboolean text_file = strlen (decoded) == length;
  g_autoptr (GString) plain = g_string_new (decoded);
  g_string_replace (plain, "\",\"", ";", 0); /* quoted cells may have decimal commas */
  g_string_replace (plain, "\"", " ", 0);
  g_string_replace (plain, "\xe2\x88\x92", "-", 0); /* the minus sign of typesetters */
  g_auto (GStrv) lines = g_strsplit (plain->str, "\n", -1);
  Reading reading = { .name = name,
                      .lines = lines,
                      .unit = unit,
                      .time_step = time_step,
                      .spectrum = spectrum,
                      .points = g_array_new (FALSE, FALSE, sizeof (QnVec2)),
                      .error = error };
  *record = (QnRecord){ 0 };
  gboolean done =
    text_file
      ? read_any (&reading)
      : fail (&reading, 0,
              _ ("not a text file: records in binary form (SAC, miniSEED) must be "
                 "written as text by their program first"));
  if (done && reading.points->len < 2)
    done = fail (&reading, 0, _ (qn_problem_text (QN_PROBLEM_SIGNAL_EMPTY)));
  done = done && take_off_offset (&reading, record);
  record->unit = reading.own_unit;
  record->count = done ? reading.points->len : 0;
  record->points = (QnVec2 *) (void *) g_array_free (reading.points, !done);
  if (!spectrum)
    qn_record_find_gap (record);
  if (record->gap > 0)
    record->gap_line = line_of (&reading, record->gap);
  return done;
}

gboolean
qn_record_read (const char *path, const char *unit, double time_step, gboolean spectrum,
                QnRecord *record, GError **error)
{
  gsize length;
  *record = (QnRecord){ 0 };
  g_autofree char *text = qn_file_read (path, &length, error);
  return text != NULL
         && qn_record_parse (text, length, path, unit, time_step, spectrum, record,
                             error);
}
