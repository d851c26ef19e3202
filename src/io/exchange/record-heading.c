#include "io/exchange/record-heading.h"

#include <math.h>
#include <string.h>

/* Entry of a COSMOS file's real header that is the time between samples, ms. */
#define COSMOS_STEP 34

static const struct {
  const char *name; /* as qn_record_unit() reduces it */
  QnRecordUnit unit;
} units[] = {
  { "m/s2", { QN_RECORD_ACCELERATION, 1 } },
  { "cm/s2", { QN_RECORD_ACCELERATION, 0.01 } },
  { "gal", { QN_RECORD_ACCELERATION, 0.01 } },
  { "gals", { QN_RECORD_ACCELERATION, 0.01 } },
  { "mm/s2", { QN_RECORD_ACCELERATION, 0.001 } },
  { "ft/s2", { QN_RECORD_ACCELERATION, 0.3048 } },
  { "in/s2", { QN_RECORD_ACCELERATION, 0.0254 } },
  { "um/s2", { QN_RECORD_ACCELERATION, 1e-6 } },
  { "nm/s2", { QN_RECORD_ACCELERATION, 1e-9 } },
  { "g", { QN_RECORD_ACCELERATION, QN_STANDARD_GRAVITY } },
  { "g/10", { QN_RECORD_ACCELERATION, 0.1 * QN_STANDARD_GRAVITY } },
  { "%g", { QN_RECORD_ACCELERATION, 0.01 * QN_STANDARD_GRAVITY } },
  { "mg", { QN_RECORD_ACCELERATION, 0.001 * QN_STANDARD_GRAVITY } },
  { "m/s", { QN_RECORD_VELOCITY, 1 } },
  { "cm/s", { QN_RECORD_VELOCITY, 0.01 } },
  { "mm/s", { QN_RECORD_VELOCITY, 0.001 } },
  { "in/s", { QN_RECORD_VELOCITY, 0.0254 } },
  { "m", { QN_RECORD_DISPLACEMENT, 1 } },
  { "cm", { QN_RECORD_DISPLACEMENT, 0.01 } },
  { "mm", { QN_RECORD_DISPLACEMENT, 0.001 } },
  { "in", { QN_RECORD_DISPLACEMENT, 0.0254 } },
  { "s", { QN_RECORD_TIME, 1 } },
  { "ms", { QN_RECORD_TIME, 0.001 } },
  { "min", { QN_RECORD_TIME, 60 } },
};

const char *
qn_record_unit_name (QnRecordUnit unit)
{
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (units[i].unit.quantity == unit.quantity && units[i].unit.factor == unit.factor)
      return units[i].name;
  return "";
}

QnRecordUnit
qn_record_unit (const char *text)
{
  g_autofree char *lower = g_utf8_strdown (text, -1);
  g_autoptr (GString) unit = g_string_new (lower);
  static const char *const spellings[][2] = {
    { " ", "" },     { "\t", "" },  { "²", "2" },   { "⁻2", "-2" },    { "^", "" },
    { "**", "" },    { "(", "" },   { ")", "" },    { "·", "" },       { "*", "" },
    { "µ", "u" },    { "μ", "u" },  { "sec", "s" }, { "/s/s", "/s2" }, { "s-2", "/s2" },
    { "s-1", "/s" }, { "./", "/" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (spellings); i++)
    g_string_replace (unit, spellings[i][0], spellings[i][1], 0);
  while (unit->len > 0 && strchr (".,;:", unit->str[unit->len - 1]) != NULL)
    g_string_truncate (unit, unit->len - 1);
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (strcmp (unit->str, units[i].name) == 0)
      return units[i].unit;
  return (QnRecordUnit){ QN_RECORD_UNKNOWN, 0 };
}

/* The longest beginning of a text that is a unit, by words. */
static QnRecordUnit
unit_at (const char *text)
{
  gsize longest = strcspn (text, ",;)]\"|\n");
  for (gsize length = longest; length > 0; length--) {
    if (length < longest && strchr (" \t(", text[length]) == NULL)
      continue;
    g_autofree char *words = g_strndup (text, length);
    QnRecordUnit unit = qn_record_unit (words);
    if (unit.quantity != QN_RECORD_UNKNOWN)
      return unit;
  }
  return (QnRecordUnit){ QN_RECORD_UNKNOWN, 0 };
}

QnRecordUnit
qn_record_unit_of_name (const char *name)
{
  QnRecordUnit unit = { QN_RECORD_UNKNOWN, 0 };
  for (const char *at = name; (at = strpbrk (at, "[(")) != NULL;) {
    QnRecordUnit own = unit_at (++at);
    if (own.quantity != QN_RECORD_UNKNOWN)
      unit = own;
  }
  const char *in = strstr (name, " in ");
  return unit.quantity == QN_RECORD_UNKNOWN && in != NULL ? unit_at (in + 4) : unit;
}

/* Whether a word of the text begins like this. */
static gboolean
has_word (const char *lower, const char *beginning)
{
  for (const char *at = lower; (at = strstr (at, beginning)) != NULL; at++)
    if (at == lower || !(g_ascii_isalnum (at[-1]) || (at[-1] & 0x80)))
      return TRUE;
  return FALSE;
}

/* The text behind a key, its unit in brackets and its colon or equals sign; NULL where the key is no
 * word of the line or, if `strict`, has no such sign. */
static const char *
value_of (const char *lower, const char *key, gboolean strict)
{
  const char *at = lower;
  gsize length = strlen (key);
  while ((at = strstr (at, key)) != NULL
         && ((at != lower && (g_ascii_isalnum (at[-1]) || at[-1] == '_'))
             || g_ascii_isalpha (at[length])))
    at++;
  if (at == NULL)
    return NULL;
  at += length;
  at += strspn (at, " \t");
  if (*at == '(' && strchr (at, ')') != NULL)
    at = strchr (at, ')') + 1;
  at += strspn (at, " \t");
  if (*at == ':' || *at == '=')
    at++;
  else if (strict)
    return NULL;
  return at + strspn (at, " \t");
}

gboolean
qn_record_is_of_spectrum (const char *name)
{
  static const char *const beginnings[] = { "period", "périod", "freq",
                                            "fréq",   "spectr", "psa" };
  g_autofree char *lower = g_utf8_strdown (name, -1);
  for (gsize i = 0; i < G_N_ELEMENTS (beginnings); i++)
    if (has_word (lower, beginnings[i]))
      return TRUE;
  return value_of (lower, "sa", FALSE) != NULL;
}

QnRecordQuantity
qn_record_quantity_of_name (const char *name)
{
  static const struct {
    const char *beginning;
    QnRecordQuantity quantity;
  } words[] = {
    { "acc", QN_RECORD_ACCELERATION },    { "beschl", QN_RECORD_ACCELERATION },
    { "acel", QN_RECORD_ACCELERATION },   { "vel", QN_RECORD_VELOCITY },
    { "geschw", QN_RECORD_VELOCITY },     { "vitesse", QN_RECORD_VELOCITY },
    { "disp", QN_RECORD_DISPLACEMENT },   { "versch", QN_RECORD_DISPLACEMENT },
    { "déplac", QN_RECORD_DISPLACEMENT }, { "deplac", QN_RECORD_DISPLACEMENT },
    { "spost", QN_RECORD_DISPLACEMENT },  { "time", QN_RECORD_TIME },
    { "zeit", QN_RECORD_TIME },           { "temps", QN_RECORD_TIME },
    { "tempo", QN_RECORD_TIME },
  };
  g_autofree char *lower = g_utf8_strdown (name, -1);
  for (gsize i = 0; i < G_N_ELEMENTS (words); i++)
    if (has_word (lower, words[i].beginning))
      return words[i].quantity;
  return QN_RECORD_UNKNOWN;
}

static double
number_of (const char *lower, const char *key, gboolean strict)
{
  const char *value = value_of (lower, key, strict);
  double number = value != NULL ? g_ascii_strtod (value, NULL) : 0;
  return isfinite (number) && number > 0 ? number : 0;
}

/* Two lines that state different things are a contradiction. */
static void
take_step (QnRecordHeading *heading, double step, gsize line)
{
  if (heading->time_step > 0 && fabs (step / heading->time_step - 1) > 0.01)
    heading->second_step = line;
  heading->time_step = step;
}

static void
read_step (QnRecordHeading *heading, const char *lower, gsize line)
{
  static const struct {
    const char *key;
    gboolean strict, rate;
  } steps[] = {
    { "dt", TRUE, FALSE },
    { "sampling_interval_s", FALSE, FALSE },
    { "sampling interval", FALSE, FALSE },
    { "time step", FALSE, FALSE },
    { "time_step", FALSE, FALSE },
    { "timestep", FALSE, FALSE },
    { "equally spaced at", FALSE, FALSE },
    { "sampling freq", FALSE, TRUE },
    { "sampling frequency", FALSE, TRUE },
    { "sampling rate", FALSE, TRUE },
    { "sampling_rate", FALSE, TRUE },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (steps); i++) {
    double number = number_of (lower, steps[i].key, steps[i].strict);
    if (number > 0)
      take_step (heading,
                 steps[i].rate                                        ? 1 / number
                 : has_word (lower, "ms") || has_word (lower, "msec") ? 0.001 * number
                                                                      : number,
                 line);
  }
  static const char *const counts[] = { "npts", "ndata", "number of data",
                                        "number of points", "number of samples" };
  for (gsize i = 0; i < G_N_ELEMENTS (counts); i++) {
    double number = number_of (lower, counts[i], TRUE);
    if (number > 0)
      heading->count = number;
  }
  /* Numbers before their names: older files of PEER. */
  char *end;
  double count = g_ascii_strtod (lower, &end), step = g_ascii_strtod (end, NULL);
  if (has_word (lower, "npts") && has_word (lower, "dt") && count > 0 && step > 0) {
    heading->count = count;
    take_step (heading, step, line);
  }
}

static void
read_unit (QnRecordHeading *heading, const char *lower, gsize line)
{
  const char *at = strstr (lower, "unit");
  if (at == NULL)
    at = strstr (lower, "einheit");
  if (at == NULL)
    return;
  while (g_ascii_isalpha (*at) || (*at & 0x80))
    at++;
  at += strspn (at, " \t:=[(");
  if (g_str_has_prefix (at, "of ") || g_str_has_prefix (at, "in "))
    at += 3;
  QnRecordUnit unit = unit_at (at + strspn (at, " \t"));
  if (unit.quantity == QN_RECORD_TIME && at[strcspn (at, ",;")] != '\0') {
    at += strcspn (at, ",;") + 1; /* that of the time comes first */
    unit = unit_at (at + strspn (at, " \t[("));
  }
  if (unit.quantity == QN_RECORD_UNKNOWN)
    return;
  if (heading->unit.quantity == unit.quantity && heading->unit.factor != unit.factor)
    heading->second_unit = line;
  heading->unit = unit;
  heading->unit_line = line;
}

/* K-NET and KiK-net: "Scale Factor 2000(gal)/8388608" for whole numbers, Japan's NIED. */
static void
read_scale (QnRecordHeading *heading, const char *lower, gsize line)
{
  if (number_of (lower, "max. acc.", FALSE) > 0)
    heading->peak_line = line;
  double span = number_of (lower, "scale factor", FALSE);
  const char *slash = strstr (lower, "(gal)/");
  double steps = slash != NULL ? g_ascii_strtod (slash + 6, NULL) : 0;
  if (!(span > 0) || !(steps > 0))
    return;
  heading->unit = qn_record_unit ("gal");
  heading->scale = span / steps;
  heading->unit_line = line;
}

gboolean
qn_record_is_descriptor (const char *line)
{
  return strcasestr (line, "pts, approx") != NULL
         || strcasestr (line, "data equally spaced at") != NULL;
}

/* The real header of COSMOS: so many numbers from the next line on. */
static void
read_cosmos (QnRecordHeading *heading, char *const *lines, gsize next, gsize end)
{
  guint seen = 0;
  for (gsize i = next; i < end; i++)
    for (const char *at = lines[i]; *at != '\0';) {
      char *stop;
      double number = g_ascii_strtod (at, &stop);
      if (stop == at)
        break;
      at = stop;
      if (++seen == COSMOS_STEP) {
        if (number > 0 && isfinite (number))
          heading->time_step = 0.001 * number;
        return;
      }
    }
}

void
qn_record_heading_read (QnRecordHeading *heading, char *const *lines, gsize end)
{
  *heading = (QnRecordHeading){ .scale = 1 };
  double duration = 0;
  for (gsize i = 0; i < end; i++) {
    g_autofree char *lower = g_utf8_strdown (lines[i], -1);
    read_step (heading, lower, i + 1);
    read_unit (heading, lower, i + 1);
    read_scale (heading, lower, i + 1);
    duration = fmax (duration, number_of (lower, "duration time", FALSE));
    if (strstr (lower, "real-header values follow") != NULL)
      read_cosmos (heading, lines, i + 1, end);
    if (i + 1 == end && qn_record_is_descriptor (lower)) {
      /* The line before the data of COSMOS, "8001 acceleration pts, approx 40 secs,
       * units=cm/sec2 (4)", and of CSMIP, "8000 points of accel data equally spaced at
       * .005 sec, in cm/sec2". */
      const char *approx = strstr (lower, "approx");
      double length = approx != NULL ? g_ascii_strtod (approx + 6, NULL) : 0;
      heading->count = g_ascii_strtod (lower, NULL);
      if (length > 0
          && fabs (heading->count * heading->time_step - length) > 1.01 + 0.01 * length)
        heading->time_step = 0; /* it was another number */
      heading->second_step = heading->second_unit = 0;
      heading->quantity = qn_record_quantity_of_name (lower);
      if (strstr (lower, "unit") == NULL) {
        heading->unit = qn_record_unit_of_name (lower);
        heading->unit_line = end;
      }
      return;
    }
    const char *type = value_of (lower, "data_type", TRUE);
    QnRecordQuantity words = type != NULL && has_word (type, "spectr")
                               ? QN_RECORD_SPECTRUM
                               : qn_record_quantity_of_name (lower);
    if (words != QN_RECORD_UNKNOWN && words != QN_RECORD_TIME
        && heading->quantity != QN_RECORD_ACCELERATION)
      heading->quantity = words;
  }
  if (heading->peak_line > 0 && duration > 0 && heading->time_step > 0)
    heading->count = round (duration / heading->time_step);
}
