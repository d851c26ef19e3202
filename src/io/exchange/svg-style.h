/* Attributes and style of elements of SVG that decide on the place and the visibility of a shape. Private to
 * reading SVG (svg-import.c). */
#pragma once

#include <glib.h>
#include <libxml/tree.h>

/* Rules of style sheets: selectors of an element, a class, an id, or an element with a class. */
typedef struct QnSvgStyle {
  GHashTable *selectors; /* "rect.stone", ".stone" -> what all rules for it declare */
  GPtrArray *texts;      /* of the style sheets, which hold the values */
  guint rule_count;
  guint odd; /* rules with selectors of other kinds, which are not followed */
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

typedef enum {
  QN_SVG_DISPLAY,
  QN_SVG_VISIBILITY,
  QN_SVG_OPACITY,
  QN_SVG_FILL,
  QN_SVG_FILL_OPACITY,
  QN_SVG_FILL_RULE,
  QN_SVG_STROKE,
  QN_SVG_STROKE_OPACITY,
  QN_SVG_TRANSLATE,
  QN_SVG_ROTATE,
  QN_SVG_SCALE,
  QN_SVG_TRANSFORM,
  QN_SVG_TRANSFORM_ORIGIN,
  QN_SVG_TRANSFORM_BOX,
  QN_SVG_CLIP_PATH,
  QN_SVG_PROPERTY_COUNT
} QnSvgProperty;

/* Strings by property, owned; NULL where the element itself says nothing. */
typedef struct QnSvgProperties {
  char *of[QN_SVG_PROPERTY_COUNT];
} QnSvgProperties;

/* From its style, else the style sheets, else its attributes. */
QnSvgProperties qn_svg_properties_of (const QnSvgStyle *style, const xmlNode *node);
void qn_svg_properties_clear (QnSvgProperties *properties);

/* The same of one length that places a shape, such as "width". */
char *qn_svg_dup_property (const QnSvgStyle *style, const xmlNode *node,
                           const char *name);
