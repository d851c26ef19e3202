/* The parameters of a masonry object or an opening as a list that a form can show: label,
 * quantity, limits, and what a new value does to the rest. Which of them there are depends on the
 * object: an arch has a rise, an opening with a lintel a bearing. */
#pragma once

#include "doc/masonry/masonry-shape.h"
#include "doc/text/units.h"

typedef enum {
  QN_MASONRY_ORIGIN_X,
  QN_MASONRY_ORIGIN_Y,
  QN_MASONRY_ROTATION,
  QN_MASONRY_LENGTH,
  QN_MASONRY_HEIGHT,
  QN_MASONRY_UNIT_X,
  QN_MASONRY_UNIT_Y,
  QN_MASONRY_LAP,
  QN_MASONRY_HEADER,
  QN_MASONRY_ARCH_SPAN,
  QN_MASONRY_ARCH_RISE,
  QN_MASONRY_ARCH_SPRINGING, /* of circular ones */
  QN_MASONRY_ARCH_RING,
  QN_MASONRY_ARCH_VOUSSOIRS,
  QN_MASONRY_ARCH_SPRINGER,
  QN_MASONRY_ARCH_RINGS,
  QN_MASONRY_ARCH_HAUNCH,
  QN_MASONRY_COLUMN_HEIGHT,
  QN_MASONRY_COLUMN_BOTTOM,
  QN_MASONRY_COLUMN_TOP,
  QN_MASONRY_COLUMN_DRUMS,
  QN_MASONRY_PLINTH_WIDTH,
  QN_MASONRY_PLINTH_HEIGHT,
  QN_MASONRY_CAPITAL_WIDTH,
  QN_MASONRY_CAPITAL_HEIGHT,
  QN_MASONRY_BUTTRESS_HEIGHT,
  QN_MASONRY_BUTTRESS_BOTTOM,
  QN_MASONRY_BUTTRESS_TOP,
  QN_MASONRY_BUTTRESS_COURSES,
  QN_MASONRY_PORTAL_BAYS,
  QN_MASONRY_PORTAL_SPAN,
  QN_MASONRY_PORTAL_PIER_WIDTH,
  QN_MASONRY_PORTAL_PIER_HEIGHT,
  QN_MASONRY_PORTAL_COURSES,
  QN_MASONRY_PORTAL_LINTEL,
  QN_MASONRY_PORTAL_RISE, /* up to the backing: of arches */
  QN_MASONRY_PORTAL_SPRINGING,
  QN_MASONRY_PORTAL_RING,
  QN_MASONRY_PORTAL_VOUSSOIRS,
  QN_MASONRY_PORTAL_RINGS,
  QN_MASONRY_PORTAL_HAUNCH,
  QN_MASONRY_PORTAL_BACKING,
  QN_MASONRY_RUBBLE_WIDTH,
  QN_MASONRY_RUBBLE_TOP,
  QN_MASONRY_RUBBLE_HEIGHT,
  QN_MASONRY_RUBBLE_STONE,
  QN_MASONRY_RUBBLE_IRREGULARITY,
  QN_MASONRY_RUBBLE_SEED,
  QN_MASONRY_THICKNESS,
  QN_MASONRY_UNIT_WEIGHT,
  QN_MASONRY_FOUNDATION,
  QN_MASONRY_PERTURBATION,
  QN_MASONRY_PERTURBATION_SEED,
  QN_MASONRY_FIELD_COUNT
} QnMasonryField;

typedef enum {
  QN_OPENING_LEFT, /* from the left edge and the foot of the wall */
  QN_OPENING_BOTTOM,
  QN_OPENING_WIDTH,
  QN_OPENING_HEIGHT,
  QN_OPENING_RISE,
  QN_OPENING_DEPTH,
  QN_OPENING_BEARING,
  QN_OPENING_VOUSSOIRS,
  QN_OPENING_SKEW,
  QN_OPENING_SILL_HEIGHT,
  QN_OPENING_SILL_BEARING,
  QN_OPENING_FIELD_COUNT
} QnOpeningField;

typedef struct QnFieldInfo {
  const char *label; /* to be translated */
  QnQuantity quantity;
  double least, most;
  gboolean whole;  /* a whole number */
  const char *key; /* in a project file, within the object */
} QnFieldInfo;

/* What a field is called and may be (static); whether an object has it; its value, SI. Setting one
 * does not check what else the object is made of: laying it again does. */
const QnFieldInfo *qn_masonry_field_info (QnMasonryField field);
gboolean qn_masonry_has_field (const QnMasonry *masonry, QnMasonryField field);
double qn_masonry_get_field (const QnMasonry *masonry, QnMasonryField field);
void qn_masonry_set_field (QnMasonry *masonry, QnMasonryField field, double value);

/* Lists of a portal: numbers of its first bays, or piers, from the left. */
typedef enum {
  QN_PORTAL_SPANS,
  QN_PORTAL_RISES,
  QN_PORTAL_RINGS,
  QN_PORTAL_PIERS,
  QN_PORTAL_LIST_COUNT
} QnPortalList;

/* As text with units and ";" between them; "" where all are alike. The caller frees it. Numbers that are
 * not positive, or more than there are, are refused. */
char *qn_portal_dup_list (const QnPortal *portal, QnPortalList list, QnUnits units);
gboolean qn_portal_take_list (QnPortal *portal, QnPortalList list, QnUnits units,
                              const char *text, GError **error);

/* The arch, or those of a portal (borrowed); NULL where there are none. */
QnArch *qn_masonry_get_arch (const QnMasonry *masonry);

/* The same of openings. */
const QnFieldInfo *qn_opening_field_info (QnOpeningField field);
gboolean qn_opening_has_field (const QnOpening *opening, QnOpeningField field);
double qn_opening_get_field (const QnOpening *opening, QnOpeningField field);
void qn_opening_set_field (QnOpening *opening, QnOpeningField field, double value);
