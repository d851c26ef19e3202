/* The parameters of a masonry object or an opening as a list that a form can show: label,
 * quantity, limits, and what a new value does to the rest. Which of them there are depends on the
 * object: an arch has a rise, an opening with a lintel a bearing. */
#pragma once

#include "doc/masonry/masonry-shape.h"
#include "doc/text/units.h"

/* Fields are numbered: those of objects, behind them those of openings, of which the first two are its place. */
enum { QN_MASONRY_FIELDS = 53, QN_OPENING_FIELDS = 11, QN_OPENING_PLACE_FIELDS = 2 };

typedef struct QnFieldInfo {
  const char *label; /* to be translated, as the next one */
  const char *step;  /* that a new value is; NULL: "Change %s", with the label */
  QnQuantity quantity;
  double least, most;
} QnFieldInfo;

/* What a field is called and may be (static); whether an object, or with `opening` that one of a wall, has it;
 * its value, SI. Setting one does not check what else the object is made of: laying it again does. */
QnFieldInfo qn_masonry_field_info (guint field);
gboolean qn_masonry_has_field (const QnMasonry *masonry, int opening, guint field);
double qn_masonry_get_field (const QnMasonry *masonry, int opening, guint field);
void qn_masonry_set_field (QnMasonry *masonry, int opening, guint field, double value);

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
