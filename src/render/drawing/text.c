#include "render/drawing/text.h"

#include "core/base/integer.h"
#include "render/drawing/paint.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <pango/pangocairo.h>
#include <string.h>

char *
qn_label_number (const char *format, double value)
{
  char buffer[G_ASCII_DTOSTR_BUF_SIZE];
  g_ascii_formatd (buffer, sizeof buffer, format, value);
  /* What rounds to nothing has no sign. */
  bool nothing = buffer[0] == '-' && strpbrk (buffer, "123456789n") == NULL;
  GString *text = g_string_new (nothing ? buffer + 1 : buffer);
  g_string_replace (text, ".", C_ ("decimal sign", "."), 1);
  return qn_label_power (g_string_free (text, FALSE));
}

char *
qn_label_power (char *number)
{
  static const char *const raised[] = {
    "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"
  };
  const char *e = strchr (number, 'e');
  char *end = NULL;
  if (e == NULL || !(g_ascii_isdigit (e[1]) || e[1] == '-' || e[1] == '+'))
    return number;
  gint64 power = g_ascii_strtoll (e + 1, &end, 10);
  g_autofree char *digits = g_strdup_printf ("%" G_GINT64_FORMAT, ABS (power));
  GString *text = g_string_new_len (number, e - number);
  if (power != 0)
    g_string_append (text, power < 0 ? "·10⁻" : "·10");
  for (const char *d = digits; power != 0 && *d != '\0'; d++)
    g_string_append (text, raised[*d - '0']);
  g_string_append (text, end);
  g_free (number);
  return g_string_free (text, FALSE);
}

#define MOST_LINES 4

/* A layout whose lines do not depend on the surface: no hinting, no rounding to pixels. */
static PangoLayout *
create_layout (cairo_t *cr, const QnTextStyle *style, const char *text)
{
  PangoLayout *layout = pango_cairo_create_layout (cr);
  PangoContext *context = pango_layout_get_context (layout);
  cairo_font_options_t *options = cairo_font_options_create ();
  cairo_font_options_set_hint_style (options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics (options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias (options, CAIRO_ANTIALIAS_GRAY);
  pango_cairo_context_set_font_options (context, options);
  cairo_font_options_destroy (options);
  pango_context_set_round_glyph_positions (context, FALSE);

  PangoFontDescription *font = pango_font_description_new ();
  pango_font_description_set_family_static (font, "DejaVu Sans, Sans");
  pango_font_description_set_absolute_size (font, style->size * PANGO_SCALE);
  if (style->bold)
    pango_font_description_set_weight (font, PANGO_WEIGHT_BOLD);
  pango_layout_set_font_description (layout, font);
  pango_font_description_free (font);

  if (style->width > 0) {
    pango_layout_set_width (
      layout, (int) qn_to_integer (style->width * PANGO_SCALE, 0, G_MAXINT));
    pango_layout_set_height (layout, -MOST_LINES);
    pango_layout_set_wrap (layout, PANGO_WRAP_WORD_CHAR);
    pango_layout_set_ellipsize (layout, PANGO_ELLIPSIZE_END);
  }
  pango_layout_set_text (layout, text, -1);
  return layout;
}

static void
layout_size (PangoLayout *layout, double *width, double *height)
{
  int w, h;
  pango_layout_get_size (layout, &w, &h);
  *width = (double) w / PANGO_SCALE;
  *height = (double) h / PANGO_SCALE;
}

void
qn_text_measure (cairo_t *cr, const QnTextStyle *style, const char *text, double *width,
                 double *height)
{
  PangoLayout *layout = create_layout (cr, style, text);
  layout_size (layout, width, height);
  g_object_unref (layout);
}

/* Moves (x, y) as the style's owner wants it; false: the text is left out. */
static bool
ask_for_place (const QnTextStyle *style, double width, double height, double align_x,
               double align_y, double angle, double *x, double *y)
{
  const bool upright = fabs (sin (angle)) > 0.99;
  if (style->place == NULL || (!upright && fabs (sin (angle)) > 0.01))
    return true;
  const double left = upright ? align_y * height : align_x * width;
  const double above = upright ? (1 - align_x) * width : align_y * height;
  cairo_rectangle_t box = { *x - left, *y - above, upright ? height : width,
                            upright ? width : height };
  if (!style->place (style->place_data, &box))
    return false;
  *x = box.x + left;
  *y = box.y + above;
  return true;
}

/* ---- text of an SVG ----------------------------------------------------------------------- */

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

/* Draws the layout at the current point, where the surface collects texts; false where it does not. */
static bool
draw_for_svg (cairo_t *cr, PangoLayout *layout, const QnTextStyle *style, QnColor color)
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

/* ---- drawing ---------------------------------------------------------------------------- */

void
qn_text_draw (cairo_t *cr, const QnTextStyle *style, const char *text, double x, double y,
              double align_x, double align_y, double angle, QnColor color)
{
  PangoLayout *layout = create_layout (cr, style, text);
  double width, height;
  layout_size (layout, &width, &height);
  /* Lines of a wrapped text are aligned as the text is. */
  pango_layout_set_alignment (layout, align_x > 0.9   ? PANGO_ALIGN_RIGHT
                                      : align_x > 0.1 ? PANGO_ALIGN_CENTER
                                                      : PANGO_ALIGN_LEFT);
  double set_width = style->width > 0 ? style->width : width;
  if (!ask_for_place (style, set_width, height, align_x, align_y, angle, &x, &y)) {
    g_object_unref (layout);
    return;
  }
  cairo_save (cr);
  cairo_translate (cr, x, y);
  cairo_rotate (cr, -angle);
  if (style->halo > 0) {
    cairo_move_to (cr, -align_x * set_width, -align_y * height);
    pango_cairo_layout_path (cr, layout);
    cairo_set_source_rgb (cr, 1, 1, 1);
    cairo_set_line_width (cr, 2 * style->halo);
    cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke (cr);
  }
  qn_set_color (cr, color, 1);
  cairo_move_to (cr, -align_x * set_width, -align_y * height);
  if (!draw_for_svg (cr, layout, style, color))
    pango_cairo_show_layout (cr, layout);
  cairo_restore (cr);
  g_object_unref (layout);
}
