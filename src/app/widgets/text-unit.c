#include "app/widgets/text-unit.h"

#include <pango/pangocairo.h>

#define USUAL_POINTS    10.0
#define POINTS_PER_INCH 72.0

double
qn_text_unit (GtkWidget *widget)
{
  PangoContext *context = gtk_widget_get_pango_context (widget);
  const PangoFontDescription *font = pango_context_get_font_description (context);
  double size = (double) pango_font_description_get_size (font) / PANGO_SCALE;
  if (!pango_font_description_get_size_is_absolute (font))
    size *= pango_cairo_context_get_resolution (context) / POINTS_PER_INCH;
  return MAX (size / USUAL_POINTS, QN_TEXT_UNIT);
}
