#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* A conversion, "%-12.4g", with its width and precision written out where arguments gave them. */
typedef struct Conversion {
  GString *spec;
  gboolean is_long, is_size;
} Conversion;

#pragma GCC diagnostic ignored "-Wformat-nonliteral" /* specs come from checked formats */

static void
append_broken (GString *text, const char *string)
{
  for (const char *end; (end = strchr (string, '\n')) != NULL; string = end + 1) {
    g_string_append_len (text, string, end - string);
    g_string_append (text, "\\u000a");
  }
  g_string_append (text, string);
}

static void
append_number (GString *text, const char *spec, double number, gboolean *finite)
{
  if (isfinite (number)) {
    g_string_append_printf (text, spec, number);
    return;
  }
  g_string_append (text, "–");
  if (finite != NULL)
    *finite = FALSE;
}

static void
append_string (GString *text, const char *spec, const char *string)
{
  g_autofree char *cell = g_strdup_printf (spec, string);
  append_broken (text, cell);
}

/* A walk through the format; va_list is passed by address, since functions that take one by value leave
 * it undefined. */
typedef struct Walk {
  va_list arguments;
} Walk;

/* Reads a conversion behind its "%"; returns the place of its letter. */
static const char *
read_conversion (const char *at, Walk *walk, Conversion *conversion)
{
  g_string_assign (conversion->spec, "%");
  conversion->is_long = conversion->is_size = FALSE;
  for (; strchr ("#0- +.123456789*lz", *at) != NULL && *at != '\0'; at++) {
    conversion->is_long |= *at == 'l';
    conversion->is_size |= *at == 'z';
    if (*at == '*')
      g_string_append_printf (conversion->spec, "%d", va_arg (walk->arguments, int));
    else
      g_string_append_c (conversion->spec, *at);
  }
  g_string_append_c (conversion->spec, *at);
  return at;
}

char *
qn_text_vprintf (gboolean *finite, const char *format, va_list arguments)
{
  GString *text = g_string_new (NULL);
  Conversion conversion = { .spec = g_string_new (NULL) };
  const char *spec = conversion.spec->str;
  Walk walk;
  va_copy (walk.arguments, arguments);
  for (const char *at = format; *at != '\0'; at++) {
    gsize plain = strcspn (at, "%");
    g_string_append_len (text, at, (gssize) plain);
    at += plain;
    if (*at == '\0')
      break;
    if (at[1] == '%') {
      g_string_append_c (text, *at++);
      continue;
    }
    at = read_conversion (at + 1, &walk, &conversion);
    spec = conversion.spec->str;
    if (strchr ("efgEG", *at) != NULL)
      append_number (text, spec, va_arg (walk.arguments, double), finite);
    else if (*at == 's')
      append_string (text, spec, va_arg (walk.arguments, const char *));
    else if (conversion.is_size)
      g_string_append_printf (text, spec, va_arg (walk.arguments, size_t));
    else if (conversion.is_long)
      g_string_append_printf (text, spec, va_arg (walk.arguments, long));
    else {
      g_assert (strchr ("diuxXoc", *at) != NULL);
      g_string_append_printf (text, spec, va_arg (walk.arguments, int));
    }
  }
  va_end (walk.arguments);
  g_string_free (conversion.spec, TRUE);
  return g_string_free (text, FALSE);
}

char *
qn_text_printf (const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  char *text = qn_text_vprintf (NULL, format, arguments);
  va_end (arguments);
  return text;
}

void
qn_text_append (GString *text, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *more = qn_text_vprintf (NULL, format, arguments);
  va_end (arguments);
  g_string_append (text, more);
}

char *
qn_widths_dup_text (double narrowest, double mean, double widest)
{
  g_autofree char *from = qn_text_printf ("%.3g", 1e3 * narrowest);
  g_autofree char *to = qn_text_printf ("%.3g mm", 1e3 * widest);
  return g_str_has_prefix (to, from) && to[strlen (from)] == ' '
           ? g_steal_pointer (&to)
           : qn_text_printf (_ ("%s to %s (mean %.3g mm)"), from, to, 1e3 * mean);
}
