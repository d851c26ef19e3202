#include "render/drawing/text.h"

#include "core/base/integer.h"
#include "render/drawing/paint.h"
#include "render/drawing/svg-text.h"

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
  if (!qn_svg_text_draw (cr, layout, style, color))
    pango_cairo_show_layout (cr, layout);
  cairo_restore (cr);
  g_object_unref (layout);
}
