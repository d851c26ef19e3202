/* Text on a page, through Pango: any language, and the same layout on every surface. */
#pragma once

#include "render/drawing/color.h"

#include <cairo.h>
#include <glib.h>
#include <stdbool.h>

/* Moves the box of a text, px of the page, to a free
 * place; false: leave the text out. */
typedef bool (*QnTextPlace) (void *data, cairo_rectangle_t *box);

typedef struct QnTextStyle {
  double size; /* px, height of the font's em */
  bool bold;
  double halo;       /* px: rim of white that sets the text off its ground; 0: none */
  double width;      /* px: wraps to at most four lines, then shortens; 0: one line */
  QnTextPlace place; /* asked where the text stands level or upright; or NULL */
  void *place_data;
} QnTextStyle;

/* A number as text, with the decimal sign of the language of the words, whatever the locale of numbers,
 * and powers as "2·10⁻⁷"; `format` is one printf() conversion of a double. Newly allocated. */
char *qn_label_number (const char *format, double value);

/* A number and the text behind it, with the exponent as a power: "2e-07 m" as "2·10⁻⁷ m". Takes over the
 * text. */
char *qn_label_power (char *number);

/* Size of the text in px. */
void qn_text_measure (cairo_t *cr, const QnTextStyle *style, const char *text,
                      double *width, double *height);

/* Draws the text with its box aligned to (x, y): align 0 puts the left or top edge there, 1
 * the right or bottom edge. `angle` turns it counter-clockwise about (x, y). */
void qn_text_draw (cairo_t *cr, const QnTextStyle *style, const char *text, double x,
                   double y, double align_x, double align_y, double angle, QnColor color);

/* Text of an SVG stays text: to be searched, edited and read aloud. Cairo draws letters there as outlines;
 * so a text is drawn as a rectangle with a colour of its own, which is replaced by the text once the SVG
 * is written. From here on the surface, of an SVG, collects its texts, in what is returned; free it with
 * g_ptr_array_unref() when the surface is gone. */
GPtrArray *qn_svg_text_collect (cairo_surface_t *surface);

/* Puts the texts where their rectangles are. */
void qn_svg_text_insert (GString *svg, const GPtrArray *texts);

/* Text as XML: characters that XML forbids become U+FFFD. Free with g_free(). */
char *qn_xml_dup_text (const char *text);
