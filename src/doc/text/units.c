#include "doc/text/units.h"

#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <locale.h>
#include <math.h>
#include <string.h>

typedef struct UnitRow {
  QnQuantity quantity;
  const char *symbol;
  double factor; /* SI value of one */
} UnitRow;

/* Every unit that is understood; of each quantity those come first in which it can be shown, in the order of
 * QnUnits. */
static const UnitRow unit_rows[] = {
  { QN_QUANTITY_NUMBER, "", 1.0 },
  { QN_QUANTITY_LENGTH, "m", 1.0 },
  { QN_QUANTITY_LENGTH, "cm", 1e-2 },
  { QN_QUANTITY_LENGTH, "mm", 1e-3 },
  { QN_QUANTITY_LENGTH, "in", 0.0254 },
  { QN_QUANTITY_LENGTH, "ft", 0.3048 },
  { QN_QUANTITY_DIAMETER, "mm", 1e-3 },
  { QN_QUANTITY_DIAMETER, "cm", 1e-2 },
  { QN_QUANTITY_DIAMETER, "m", 1.0 },
  { QN_QUANTITY_DIAMETER, "in", 0.0254 },
  { QN_QUANTITY_ANGLE, "°", G_PI / 180.0 },
  { QN_QUANTITY_ANGLE, "deg", G_PI / 180.0 },
  { QN_QUANTITY_ANGLE, "rad", 1.0 },
  { QN_QUANTITY_ROTATION, "mrad", 1e-3 },
  { QN_QUANTITY_ROTATION, "rad", 1.0 },
  { QN_QUANTITY_ROTATION, "°", G_PI / 180.0 },
  { QN_QUANTITY_ROTATION, "deg", G_PI / 180.0 },
  { QN_QUANTITY_FORCE, "N", 1.0 },
  { QN_QUANTITY_FORCE, "kN", 1e3 },
  { QN_QUANTITY_FORCE, "MN", 1e6 },
  { QN_QUANTITY_MOMENT, "N·m", 1.0 },
  { QN_QUANTITY_MOMENT, "kN·m", 1e3 },
  { QN_QUANTITY_MOMENT, "Nm", 1.0 },
  { QN_QUANTITY_MOMENT, "kNm", 1e3 },
  { QN_QUANTITY_STRESS, "Pa", 1.0 },
  { QN_QUANTITY_STRESS, "kPa", 1e3 },
  { QN_QUANTITY_STRESS, "MPa", 1e6 },
  { QN_QUANTITY_STRESS, "GPa", 1e9 },
  { QN_QUANTITY_STRESS, "N/mm²", 1e6 },
  { QN_QUANTITY_PRESSURE, "Pa", 1.0 },
  { QN_QUANTITY_PRESSURE, "kPa", 1e3 },
  { QN_QUANTITY_PRESSURE, "MPa", 1e6 },
  { QN_QUANTITY_STIFFNESS, "N/m", 1.0 },
  { QN_QUANTITY_STIFFNESS, "kN/m", 1e3 },
  { QN_QUANTITY_STIFFNESS, "kN/mm", 1e6 },
  { QN_QUANTITY_STIFFNESS, "N/mm", 1e3 },
  { QN_QUANTITY_SURFACE_STIFFNESS, "Pa/m", 1.0 },
  { QN_QUANTITY_SURFACE_STIFFNESS, "kPa/m", 1e3 },
  { QN_QUANTITY_SURFACE_STIFFNESS, "MPa/m", 1e6 },
  { QN_QUANTITY_SURFACE_STIFFNESS, "N/mm³", 1e9 },
  { QN_QUANTITY_UNIT_WEIGHT, "N/m³", 1.0 },
  { QN_QUANTITY_UNIT_WEIGHT, "kN/m³", 1e3 },
  { QN_QUANTITY_UNIT_WEIGHT, "N/m3", 1.0 },
  { QN_QUANTITY_UNIT_WEIGHT, "kN/m3", 1e3 },
  { QN_QUANTITY_DENSITY, "kg/m³", 1.0 },
  { QN_QUANTITY_DENSITY, "kg/m3", 1.0 },
  { QN_QUANTITY_TIME, "s", 1.0 },
  { QN_QUANTITY_TIME, "ms", 1e-3 },
  { QN_QUANTITY_ENERGY, "J", 1.0 },
  { QN_QUANTITY_SURFACE_ENERGY, "J/m²", 1.0 },
  { QN_QUANTITY_SURFACE_ENERGY, "J/m2", 1.0 },
};

/* The unit in which a quantity is shown. */
static const UnitRow *
shown_unit (QnUnits units, QnQuantity quantity)
{
  const unsigned chosen[QN_QUANTITY_COUNT] = {
    [QN_QUANTITY_LENGTH] = units.length,   [QN_QUANTITY_FORCE] = units.force,
    [QN_QUANTITY_MOMENT] = units.force,    [QN_QUANTITY_PRESSURE] = units.force,
    [QN_QUANTITY_STIFFNESS] = units.force, [QN_QUANTITY_UNIT_WEIGHT] = units.force,
    [QN_QUANTITY_STRESS] = units.stress,   [QN_QUANTITY_SURFACE_STIFFNESS] = units.stress,
  };
  const UnitRow *row = unit_rows;
  while (row->quantity != quantity)
    row++;
  return row + chosen[quantity];
}

QnUnits
qn_units_of_motion (QnUnits units)
{
  units.length = QN_LENGTH_MM;
  return units;
}

const char *
qn_units_symbol (QnUnits units, QnQuantity quantity)
{
  return shown_unit (units, quantity)->symbol;
}

double
qn_units_factor (QnUnits units, QnQuantity quantity)
{
  return shown_unit (units, quantity)->factor;
}

/* From here on numbers that are longer than their digits have a power of ten. */
#define LEAST_POWER 1e6

char *
qn_units_format (QnUnits units, QnQuantity quantity, double value, int digits)
{
  if (isinf (value))
    return g_strdup (value > 0.0 ? "∞" : "−∞");

  char format[8], number[G_ASCII_DTOSTR_BUF_SIZE];
  g_snprintf (format, sizeof format, "%%.%dg", CLAMP (digits, 1, 17));
  double shown = value / qn_units_factor (units, quantity);
  /* "-0" would make the reader look for a reason. */
  g_ascii_formatd (number, sizeof number, format, shown == 0.0 ? 0.0 : shown);
  if (fabs (shown) >= 1.0 && fabs (shown) < LEAST_POWER && strchr (number, 'e') != NULL)
    g_ascii_formatd (number, sizeof number, "%.0f", g_ascii_strtod (number, NULL));

  GString *text = g_string_new (number);
  g_string_replace (text, ".", localeconv ()->decimal_point, 1);
  return g_string_free (text, FALSE);
}

char *
qn_units_format_full (QnUnits units, QnQuantity quantity, double value, int digits)
{
  g_autofree char *number = qn_units_format (units, quantity, value, digits);
  const char *symbol = qn_units_symbol (units, quantity);
  if (*symbol == '\0')
    return g_steal_pointer (&number);
  /* The degree sign follows its number closely. */
  return g_strconcat (number, quantity == QN_QUANTITY_ANGLE ? "" : "\u00a0", symbol,
                      NULL);
}

/* ---- reading ---- */

/* Brackets and signs within each other. */
#define MOST_NESTED 40

/* A value while a sum is read: in SI once it has a unit, else a plain number. */
typedef struct Term {
  double value;
  gboolean has_unit;
} Term;

typedef struct Reader {
  QnUnits units;
  QnQuantity quantity;
  const char *whole, *at;
  int depth;
  GError **error;
} Reader;

static gboolean read_sum (Reader *r, Term *term);

static gboolean
refuse (Reader *r)
{
  return qn_io_fail (r->error, QN_IO_ERROR_INVALID, _ ("“%s” is not a number"), r->whole);
}

static void
skip_spaces (Reader *r)
{
  while (*r->at != '\0' && g_unichar_isspace (g_utf8_get_char (r->at)))
    r->at = g_utf8_next_char (r->at);
}

/* Goes past the next sign where it is one of these. */
static gunichar
take_sign (Reader *r, const char *signs)
{
  skip_spaces (r);
  gunichar c = g_utf8_get_char (r->at);
  if (c == 0 || g_utf8_strchr (signs, -1, c) == NULL)
    return 0;
  r->at = g_utf8_next_char (r->at);
  return c;
}

/* "1,5e-3", by either decimal sign. */
static gboolean
read_number (Reader *r, double *value)
{
  g_autoptr (GString) number = g_string_new (NULL);
  gboolean had_exponent = FALSE;
  skip_spaces (r);
  for (; *r->at != '\0'; r->at++) {
    const char *p = r->at;
    if (g_ascii_isdigit (*p))
      g_string_append_c (number, *p);
    else if (*p == ',' || *p == '.')
      g_string_append_c (number, '.');
    else if ((*p == 'e' || *p == 'E') && !had_exponent && number->len > 0
             && (g_ascii_isdigit (p[1])
                 || ((p[1] == '-' || p[1] == '+') && g_ascii_isdigit (p[2])))) {
      had_exponent = TRUE;
      g_string_append_len (number, p, 2);
      r->at++;
    } else
      break;
  }
  char *end = NULL;
  *value = g_ascii_strtod (number->str, &end);
  return (number->len > 0 && *end == '\0') || refuse (r);
}

/* The longest unit that fits here. */
static const UnitRow *
take_unit (Reader *r)
{
  const UnitRow *found = NULL;
  gsize longest = 0;
  skip_spaces (r);
  for (gsize i = 0; i < G_N_ELEMENTS (unit_rows); i++) {
    gsize length = strlen (unit_rows[i].symbol);
    const char *behind = r->at + length;
    if (unit_rows[i].quantity != r->quantity || length <= longest
        || strncmp (r->at, unit_rows[i].symbol, length) != 0
        || g_unichar_isalnum (g_utf8_get_char (behind)))
      continue;
    found = &unit_rows[i];
    longest = length;
  }
  r->at += longest;
  return found;
}

static gboolean
read_factor (Reader *r, Term *term)
{
  if (++r->depth > MOST_NESTED)
    return refuse (r);
  gunichar sign = take_sign (r, "+-−");
  if (take_sign (r, "(") != 0) {
    if (!read_sum (r, term))
      return FALSE;
    if (take_sign (r, ")") == 0)
      return refuse (r);
  } else {
    *term = (Term){ 0 };
    if (!read_number (r, &term->value))
      return FALSE;
  }
  const UnitRow *unit = term->has_unit ? NULL : take_unit (r);
  if (unit != NULL)
    *term = (Term){ term->value * unit->factor, TRUE };
  if (sign != 0 && sign != '+')
    term->value = -term->value;
  r->depth--;
  return TRUE;
}

/* Lengths are not multiplied with each other, and nothing is divided by one but a length. */
static gboolean
read_product (Reader *r, Term *term)
{
  gunichar sign;
  if (!read_factor (r, term))
    return FALSE;
  while ((sign = take_sign (r, "*×·/÷")) != 0) {
    Term other;
    gboolean divides = sign == '/' || sign == 0xf7;
    if (!read_factor (r, &other))
      return FALSE;
    if (other.has_unit && (divides ? !term->has_unit : term->has_unit))
      return refuse (r);
    term->value = divides ? term->value / other.value : term->value * other.value;
    term->has_unit =
      divides ? term->has_unit && !other.has_unit : term->has_unit || other.has_unit;
  }
  return TRUE;
}

/* Beside values with a unit plain numbers are in the displayed one. */
static void
give_unit (const Reader *r, Term *term)
{
  if (!term->has_unit)
    term->value *= qn_units_factor (r->units, r->quantity);
  term->has_unit = TRUE;
}

static gboolean
read_sum (Reader *r, Term *term)
{
  gunichar sign;
  if (!read_product (r, term))
    return FALSE;
  while ((sign = take_sign (r, "+-−")) != 0) {
    Term other;
    if (!read_product (r, &other))
      return FALSE;
    if (term->has_unit || other.has_unit) {
      give_unit (r, term);
      give_unit (r, &other);
    }
    term->value += sign == '+' ? other.value : -other.value;
  }
  return TRUE;
}

/* "∞" or "inf", with or without a unit that fits, as it is shown. */
static gboolean
is_infinity (QnQuantity quantity, const char *text)
{
  gboolean word = g_ascii_strncasecmp (text, "inf", 3) == 0;
  if (!word && !g_str_has_prefix (text, "∞"))
    return FALSE;
  Reader r = { .quantity = quantity,
               .at = text + (word ? strlen ("inf") : strlen ("∞")) };
  take_unit (&r);
  return *r.at == '\0';
}

gboolean
qn_units_parse (QnUnits units, QnQuantity quantity, const char *text, double *value,
                GError **error)
{
  g_return_val_if_fail (text != NULL && value != NULL, FALSE);

  g_autofree char *stripped = g_strstrip (g_strdup (text));
  if (is_infinity (quantity, stripped)) {
    *value = INFINITY;
    return TRUE;
  }
  Reader reader = {
    .units = units, .quantity = quantity, .whole = text, .at = stripped, .error = error
  };
  Term term;
  if (!g_utf8_validate (stripped, -1, NULL))
    return refuse (&reader);
  if (!read_sum (&reader, &term))
    return FALSE;
  skip_spaces (&reader);
  if (*reader.at != '\0')
    return qn_io_fail (error, QN_IO_ERROR_INVALID,
                       _ ("“%s” is not a unit that fits here"), reader.at);
  give_unit (&reader, &term);
  if (!isfinite (term.value))
    return qn_io_fail (error, QN_IO_ERROR_INVALID, _ ("“%s” is too large"), text);
  *value = term.value;
  return TRUE;
}

char *
qn_units_format_pair (QnUnits units, QnQuantity quantity, QnVec2 pair, int digits)
{
  g_autofree char *first = qn_units_format (units, quantity, pair.x, digits);
  g_autofree char *second = qn_units_format_full (units, quantity, pair.y, digits);
  return g_strdup_printf ("%s; %s", first, second);
}

char *
qn_units_format_list (QnUnits units, QnQuantity quantity, const double *values,
                      gsize count, int digits)
{
  GString *text = g_string_new (NULL);
  for (gsize i = 0; i < count; i++) {
    g_autofree char *number = qn_units_format_full (units, quantity, values[i], digits);
    g_string_append_printf (text, "%s%s", i > 0 ? "; " : "", number);
  }
  return g_string_free (text, FALSE);
}

gboolean
qn_units_parse_list (QnUnits units, QnQuantity quantity, const char *text, double *values,
                     gsize most, gsize *count, GError **error)
{
  g_auto (GStrv) parts = g_strsplit (text, ";", -1);
  guint given = g_strv_length (parts);
  while (given > 0 && *g_strstrip (parts[given - 1]) == '\0')
    given--;
  for (*count = 0; *count < given; ++*count) {
    if (*count == most)
      return qn_io_fail (error, QN_IO_ERROR_INVALID, _ ("expected up to %d numbers"),
                         (int) most);
    if (!qn_units_parse (units, quantity, parts[*count], &values[*count], error))
      return FALSE;
  }
  return TRUE;
}
