#include "doc/text/points-text.h"

#include "doc/text/units.h"

#include <math.h>

/* Two numbers and nothing else. */
static gboolean
parse_point (const char *text, QnVec2 *point)
{
  double values[2];
  int count = 0;
  g_auto (GStrv) words = g_strsplit_set (text, " \t", -1);
  for (gsize i = 0; words[i] != NULL; i++) {
    if (*words[i] == '\0')
      continue;
    if (count == 2
        || !qn_units_parse (QN_UNITS_SI, QN_QUANTITY_NUMBER, words[i], &values[count],
                            NULL)
        || !isfinite (values[count]))
      return FALSE;
    count++;
  }
  if (count < 2)
    return FALSE;
  *point = qn_vec2 (values[0], values[1]);
  return TRUE;
}

gboolean
qn_points_parse (const char *text, QnVec2 *points, int32_t most, int32_t *count)
{
  g_auto (GStrv) parts = g_strsplit (text, ";", -1);
  *count = 0;
  for (gsize i = 0; parts[i] != NULL; i++) {
    if (*g_strstrip (parts[i]) == '\0')
      continue;
    if (*count == most || !parse_point (parts[i], &points[*count]))
      return FALSE;
    ++*count;
  }
  return *count > 0;
}

char *
qn_points_dup_text (const QnVec2 *points, int32_t count)
{
  GString *text = g_string_new (NULL);
  for (int32_t i = 0; i < count; i++) {
    g_autofree char *x =
      qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, points[i].x, 9);
    g_autofree char *y =
      qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, points[i].y, 9);
    g_string_append_printf (text, "%s%s %s", i > 0 ? "; " : "", x, y);
  }
  return g_string_free (text, FALSE);
}
