/* Text of an SVG that stays text: to be searched, edited and read aloud. Cairo draws letters there as
 * outlines; so a text is drawn as a rectangle with a colour of its own, which is replaced by the text
 * once the SVG is written.
 */
#pragma once

#include "render/drawing/color.h"
#include "render/drawing/text.h"

#include <cairo.h>
#include <glib.h>
#include <pango/pango.h>

/* From here on the surface, of an SVG, collects its texts, in what is returned; free it with
 * g_ptr_array_unref() when the surface is gone. */
GPtrArray *qn_svg_text_collect (cairo_surface_t *surface);

/* Draws the layout at the current point, where the surface collects texts; false where it does not. */
bool qn_svg_text_draw (cairo_t *cr, PangoLayout *layout, const QnTextStyle *style,
                       QnColor color);

/* Puts the texts where their rectangles are. */
void qn_svg_text_insert (GString *svg, const GPtrArray *texts);

/* Text as XML: characters that XML forbids become U+FFFD. Free with g_free(). */
char *qn_xml_dup_text (const char *text);
