/* Attributes and style of elements of SVG, as far as they decide where a shape is and whether it is
 * seen. Private to reading SVG (svg-import.c). */
#pragma once

#include <glib.h>
#include <libxml/tree.h>

/* Rules of style sheets: selectors of an element, a class, an id, or an element with a class. */
typedef struct QnSvgStyle {
  GPtrArray *rules; /* of the style sheets, in their order */
  gboolean odd;     /* there are selectors of other kinds, which are not followed */
} QnSvgStyle;

void qn_svg_style_init (QnSvgStyle *style);
void qn_svg_style_clear (QnSvgStyle *style);

/* Adds the rules of a style element. */
void qn_svg_style_add (QnSvgStyle *style, const xmlNode *node);

/* The name of an element without its name space, declared or not. */
const char *qn_svg_name (const xmlNode *node);

/* The value of an attribute without a name space, or with any of them where the key has one
 * ("xlink:href" is href in any, or none). NULL where it is not there. */
char *qn_svg_dup_attribute (const xmlNode *node, const char *key);

/* NULL where the element itself says nothing. */
typedef struct QnSvgProperties {
  char *display, *visibility, *fill, *stroke, *fill_rule, *transform,
    *clip_path; /* owned */
} QnSvgProperties;

/* From its style, else the style sheets, else its attributes. */
QnSvgProperties qn_svg_properties_of (const QnSvgStyle *style, const xmlNode *node);
void qn_svg_properties_clear (QnSvgProperties *properties);
