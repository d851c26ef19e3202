#include "render/drawing/svg-text.h"

#include "core/base/integer.h"

#include <math.h>
#include <string.h>

/* The colour of rectangles: red and green are these, which no picture has, blue is the text's number
 * from 1 in millionths. Cairo writes six decimals of a percentage. */
#define MARK_RED   0.01234567
#define MARK_GREEN 0.07654321
#define MARK_BLUE  1e-6
#define MARK       "1.234567%"

static const cairo_user_data_key_t texts_key;

char *
qn_xml_dup_text (const char *text)
{
  g_autoptr (GString) allowed = g_string_new (NULL);
  for (const char *c = text; *c != '\0'; c = g_utf8_next_char (c)) {
    gunichar character = g_utf8_get_char (c);
    gboolean control = g_unichar_iscntrl (character) && strchr ("\n\t", *c) == NULL;
    g_string_append_unichar (allowed,
                             control || (character | 1) == 0xffff ? 0xfffd : character);
  }
  return g_markup_escape_text (allowed->str, -1);
}

GPtrArray *
qn_svg_text_collect (cairo_surface_t *surface)
{
  GPtrArray *texts = g_ptr_array_new_with_free_func (g_free);
  cairo_surface_set_user_data (surface, &texts_key, texts, NULL);
  return texts;
}

/* What a line shows: where it was shortened, the ellipsis in place of what it hides. */
static char *
dup_line (PangoLayout *layout, PangoLayoutLine *line)
{
  const char *text = pango_layout_get_text (layout);
  int at = line->start_index, end = line->start_index + line->length;
  g_autoptr (GString) shown = g_string_new (NULL);
  for (GSList *l = line->runs; l != NULL; l = l->next) {
    const PangoItem *item = ((PangoLayoutRun *) l->data)->item;
    if ((item->analysis.flags & PANGO_ANALYSIS_FLAG_IS_ELLIPSIS) == 0)
      continue;
    g_string_append_len (shown, text + at, item->offset - at);
    g_string_append (shown, "…");
    at = item->offset + item->length;
  }
  g_string_append_len (shown, text + at, MAX (end - at, 0));
  return qn_xml_dup_text (g_strstrip (shown->str));
}

static void
append_attribute (GString *out, const char *name, double value)
{
  char buffer[G_ASCII_DTOSTR_BUF_SIZE];
  g_string_append_printf (out, " %s=\"%s\"", name,
                          g_ascii_formatd (buffer, sizeof buffer, "%.7g", value));
}

/* One line as an element: at its baseline, and as wide as here whatever the font that is found. */
static void
append_line (GString *out, cairo_t *cr, PangoLayout *layout, PangoLayoutIter *iter,
             const QnTextStyle *style, QnColor color)
{
  PangoRectangle extents;
  cairo_matrix_t m;
  double x, y;
  char buffer[G_ASCII_DTOSTR_BUF_SIZE];
  g_autofree char *text = dup_line (layout, pango_layout_iter_get_line_readonly (iter));
  if (*text == '\0')
    return;
  pango_layout_iter_get_line_extents (iter, NULL, &extents);
  cairo_get_current_point (cr, &x, &y);
  cairo_get_matrix (cr, &m);
  const double matrix[] = { m.xx, m.yx, m.xy, m.yy, m.x0, m.y0 };
  g_string_append (out, "<text transform=\"matrix(");
  for (gsize i = 0; i < G_N_ELEMENTS (matrix); i++)
    g_string_append_printf (out, "%s%s", i > 0 ? "," : "",
                            g_ascii_formatd (buffer, sizeof buffer, "%.7g", matrix[i]));
  g_string_append (out, ")\"");
  append_attribute (out, "x", x + (double) extents.x / PANGO_SCALE);
  append_attribute (out, "y",
                    y + (double) pango_layout_iter_get_baseline (iter) / PANGO_SCALE);
  append_attribute (out, "textLength", (double) extents.width / PANGO_SCALE);
  g_string_append (out, " lengthAdjust=\"spacingAndGlyphs\" font-family=\"'DejaVu Sans', "
                        "sans-serif\"");
  append_attribute (out, "font-size", style->size);
  if (style->bold)
    g_string_append (out, " font-weight=\"bold\"");
  g_string_append_printf (out, " fill=\"#%02x%02x%02x\"", color.r, color.g, color.b);
  if (color.a < 255)
    append_attribute (out, "fill-opacity", color.a / 255.0);
  g_string_append_printf (out, ">%s</text>\n", text);
}

bool
qn_svg_text_draw (cairo_t *cr, PangoLayout *layout, const QnTextStyle *style,
                  QnColor color)
{
  GPtrArray *texts = cairo_surface_get_user_data (cairo_get_target (cr), &texts_key);
  if (texts == NULL)
    return false;
  GString *lines = g_string_new (NULL);
  PangoLayoutIter *iter = pango_layout_get_iter (layout);
  PangoRectangle box;
  double x, y;
  do
    append_line (lines, cr, layout, iter, style, color);
  while (pango_layout_iter_next_line (iter));
  pango_layout_iter_free (iter);
  g_ptr_array_add (texts, g_string_free (lines, FALSE));

  pango_layout_get_extents (layout, NULL, &box);
  cairo_get_current_point (cr, &x, &y);
  cairo_new_path (cr);
  cairo_rectangle (cr, x + (double) box.x / PANGO_SCALE, y + (double) box.y / PANGO_SCALE,
                   (double) box.width / PANGO_SCALE, (double) box.height / PANGO_SCALE);
  cairo_set_source_rgb (cr, MARK_RED, MARK_GREEN, MARK_BLUE * texts->len);
  cairo_fill (cr);
  return true;
}

void
qn_svg_text_insert (GString *svg, const GPtrArray *texts)
{
  g_autoptr (GString) out = g_string_sized_new (svg->len);
  const char *at = svg->str, *hit;
  while ((hit = strstr (at, MARK)) != NULL) {
    const char *element = g_strrstr_len (at, hit - at, "<"), *end = strstr (hit, "/>");
    const char *blue = strchr (hit, ',');
    blue = blue != NULL ? strchr (blue + 1, ',') : NULL;
    if (element == NULL || end == NULL || blue == NULL)
      break;
    gint64 number = qn_to_integer (
      round (g_ascii_strtod (blue + 1, NULL) / 100 / MARK_BLUE), 0, texts->len);
    g_string_append_len (out, at, element - at);
    if (number > 0)
      g_string_append (out, texts->pdata[number - 1]);
    at = end + strlen ("/>");
  }
  g_string_append (out, at);
  g_string_assign (svg, out->str);
}
