#include "doc/masonry/masonry-field.h"
#include "core/base/integer.h"
#include "doc/edit/edit.h"
#include "doc/masonry/masonry-shape.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#define LARGEST 1e6  /* m */
#define SMALL   1e-3 /* m: least size */

/* The angle of a circular arch, from the plumb line to its joint at the springing, where its rise is. */
typedef enum { TYPE_NUMBER, TYPE_COUNT, TYPE_SEED, TYPE_SPRINGING } Type;

/* Objects that have a field, of those of its kind. */
typedef enum {
  ALWAYS,
  OF_CIRCULAR,      /* arches */
  OF_THREE_CENTRED, /* arches */
  OF_ARCHES,        /* portals */
  OF_STONES,        /* rubble, not cells of Voronoi */
  OF_BONDS,         /* walls that are not listed course by course */
  OF_RUNNING,       /* bond */
  OF_HEADERS,       /* bonds with headers */
  OF_SEGMENTAL,     /* heads of openings */
  OF_SPANNED,       /* openings, by anything, */
  OF_PIECES,        /* by voussoirs or a flat arch, */
  OF_FLAT_ARCH,     /* by that alone, */
  OF_LINTEL,        /* by a lintel */
  OF_SILL
} When;

typedef struct Field {
  QnFieldInfo info;
  int kind; /* QnMasonryKind, or one of those below */
  When when;
  Type type;
  gsize offset; /* in the object, the leaf or the opening */
} Field;

enum { ALL = -1, OPENING = -2, LEAF = -3 /* of a wall */ };

#define FIELD(text, quantity, least, most, kind, when, type, of, member)                 \
  {                                                                                      \
    { text, NULL, quantity, least, most }, kind, when, TYPE_##type,                      \
      G_STRUCT_OFFSET (of, member)                                                       \
  }
#define LENGTH(text, least, kind, when, of, member)                                      \
  FIELD (text, QN_QUANTITY_LENGTH, least, LARGEST, kind, when, NUMBER, of, member)
#define SIZE(text, kind, member)  LENGTH (text, SMALL, kind, ALWAYS, QnMasonry, member)
#define EXTRA(text, kind, member) LENGTH (text, 0.0, kind, ALWAYS, QnMasonry, member)
#define PART(text, most, kind, when, of, member)                                         \
  FIELD (text, QN_QUANTITY_NUMBER, 0.0, most, kind, when, NUMBER, of, member)
#define NUMBER(text, kind, when, member, least)                                          \
  FIELD (text, QN_QUANTITY_NUMBER, least, 10000.0, kind, when, COUNT, QnMasonry, member)
#define SEED(text, kind, member)                                                         \
  FIELD (text, QN_QUANTITY_NUMBER, 0.0, G_MAXUINT32, kind, ALWAYS, SEED, QnMasonry,      \
         member)
#define SPRINGING(kind, member)                                                          \
  FIELD (N_ ("Angle at the springing"), QN_QUANTITY_ANGLE, SMALL, M_PI_2, kind,          \
         OF_CIRCULAR, SPRINGING, QnMasonry, member)

/* clang-format off */
static const Field fields[] = {
  LENGTH (N_ ("Left edge"), -LARGEST, ALL, ALWAYS, QnMasonry, origin.x),
  LENGTH (N_ ("Lower edge"), -LARGEST, ALL, ALWAYS, QnMasonry, origin.y),
  FIELD (N_ ("Rotated by"), QN_QUANTITY_ANGLE, -10.0, 10.0, ALL, ALWAYS, NUMBER, QnMasonry, rotation),
  LENGTH (N_ ("Length"), SMALL, LEAF, OF_BONDS, QnLeaf, length),
  LENGTH (N_ ("Height"), SMALL, QN_MASONRY_WALL, OF_BONDS, QnMasonry, wall.height),
  LENGTH (N_ ("Block length"), SMALL, LEAF, ALWAYS, QnLeaf, unit.x),
  LENGTH (N_ ("Course height"), SMALL, LEAF, ALWAYS, QnLeaf, unit.y),
  PART (N_ ("Overlap, part of a block"), 0.999, LEAF, OF_RUNNING, QnLeaf, lap),
  LENGTH (N_ ("Header length (0: half)"), 0.0, LEAF, OF_HEADERS, QnLeaf, header),
  SIZE (N_ ("Span"), QN_MASONRY_ARCH, arch.span),
  SIZE (N_ ("Rise"), QN_MASONRY_ARCH, arch.rise),
  SPRINGING (QN_MASONRY_ARCH, arch),
  SIZE (N_ ("Ring thickness"), QN_MASONRY_ARCH, arch.ring),
  NUMBER (N_ ("Voussoirs"), QN_MASONRY_ARCH, ALWAYS, arch.voussoirs, 2.0),
  EXTRA (N_ ("Springer height"), QN_MASONRY_ARCH, arch.springer),
  NUMBER (N_ ("Rings"), QN_MASONRY_ARCH, ALWAYS, arch.rings, 1.0),
  LENGTH (N_ ("Radius at the ends (0: usual)"), 0.0, QN_MASONRY_ARCH, OF_THREE_CENTRED, QnMasonry, arch.haunch),
  SIZE (N_ ("Height"), QN_MASONRY_COLUMN, column.height),
  SIZE (N_ ("Width at the foot"), QN_MASONRY_COLUMN, column.bottom),
  SIZE (N_ ("Width at the top"), QN_MASONRY_COLUMN, column.top),
  NUMBER (N_ ("Drums"), QN_MASONRY_COLUMN, ALWAYS, column.drums, 1.0),
  EXTRA (N_ ("Plinth width"), QN_MASONRY_COLUMN, column.plinth_width),
  EXTRA (N_ ("Plinth height"), QN_MASONRY_COLUMN, column.plinth_height),
  EXTRA (N_ ("Capital width"), QN_MASONRY_COLUMN, column.capital_width),
  EXTRA (N_ ("Capital height"), QN_MASONRY_COLUMN, column.capital_height),
  SIZE (N_ ("Height"), QN_MASONRY_BUTTRESS, buttress.height),
  SIZE (N_ ("Width at the foot"), QN_MASONRY_BUTTRESS, buttress.bottom),
  SIZE (N_ ("Width at the top"), QN_MASONRY_BUTTRESS, buttress.top),
  NUMBER (N_ ("Courses"), QN_MASONRY_BUTTRESS, ALWAYS, buttress.courses, 1.0),
  NUMBER (N_ ("Bays"), QN_MASONRY_PORTAL, ALWAYS, portal.bays, 1.0),
  SIZE (N_ ("Span"), QN_MASONRY_PORTAL, portal.span),
  SIZE (N_ ("Pier width"), QN_MASONRY_PORTAL, portal.pier_width),
  SIZE (N_ ("Pier height"), QN_MASONRY_PORTAL, portal.pier_height),
  NUMBER (N_ ("Courses per pier"), QN_MASONRY_PORTAL, ALWAYS, portal.courses, 1.0),
  EXTRA (N_ ("Lintel height (0: arches)"), QN_MASONRY_PORTAL, portal.lintel_height),
  LENGTH (N_ ("Rise"), SMALL, QN_MASONRY_PORTAL, OF_ARCHES, QnMasonry, portal.arch.rise),
  SPRINGING (QN_MASONRY_PORTAL, portal.arch),
  LENGTH (N_ ("Ring thickness"), SMALL, QN_MASONRY_PORTAL, OF_ARCHES, QnMasonry, portal.arch.ring),
  NUMBER (N_ ("Voussoirs"), QN_MASONRY_PORTAL, OF_ARCHES, portal.arch.voussoirs, 2.0),
  NUMBER (N_ ("Rings"), QN_MASONRY_PORTAL, OF_ARCHES, portal.arch.rings, 1.0),
  LENGTH (N_ ("Radius at the ends (0: usual)"), 0.0, QN_MASONRY_PORTAL, OF_THREE_CENTRED, QnMasonry, portal.arch.haunch),
  LENGTH (N_ ("Height of the backing"), 0.0, QN_MASONRY_PORTAL, OF_ARCHES, QnMasonry, portal.backing),
  SIZE (N_ ("Width at the foot"), QN_MASONRY_RUBBLE, rubble.width),
  LENGTH (N_ ("Width at the top"), SMALL, QN_MASONRY_RUBBLE, OF_STONES, QnMasonry, rubble.top),
  SIZE (N_ ("Height"), QN_MASONRY_RUBBLE, rubble.height),
  SIZE (N_ ("Size of stones"), QN_MASONRY_RUBBLE, rubble.stone),
  PART (N_ ("Irregularity, 0 to 1"), 1.0, QN_MASONRY_RUBBLE, OF_STONES, QnMasonry, rubble.irregularity),
  SEED (N_ ("Seed"), QN_MASONRY_RUBBLE, rubble.seed),
  SIZE (N_ ("Thickness"), ALL, thickness),
  FIELD (N_ ("Unit weight"), QN_QUANTITY_UNIT_WEIGHT, 0.0, 1e9, ALL, ALWAYS, NUMBER, QnMasonry, unit_weight),
  EXTRA (N_ ("Fixed base, depth"), ALL, foundation),
  PART (N_ ("Irregular joints, 0 to 0.4"), 0.4, ALL, ALWAYS, QnMasonry, perturbation),
  SEED (N_ ("Seed of the joints"), ALL, perturbation_seed),
  LENGTH (N_ ("From the left"), -LARGEST, OPENING, ALWAYS, QnOpening, at.x),
  LENGTH (N_ ("From the foot"), -LARGEST, OPENING, ALWAYS, QnOpening, at.y),
  LENGTH (N_ ("Width"), SMALL, OPENING, ALWAYS, QnOpening, width),
  LENGTH (N_ ("Height"), SMALL, OPENING, ALWAYS, QnOpening, height),
  LENGTH (N_ ("Rise of the head"), SMALL, OPENING, OF_SEGMENTAL, QnOpening, rise),
  LENGTH (N_ ("Depth of what spans it"), SMALL, OPENING, OF_SPANNED, QnOpening, depth),
  LENGTH (N_ ("Bearing"), 0.0, OPENING, OF_LINTEL, QnOpening, bearing),
  FIELD (N_ ("Voussoirs"), QN_QUANTITY_NUMBER, 1.0, 1000.0, OPENING, OF_PIECES, COUNT, QnOpening, voussoirs),
  FIELD (N_ ("Inclination of the skewbacks"), QN_QUANTITY_ANGLE, 0.0, 1.5, OPENING, OF_FLAT_ARCH, NUMBER, QnOpening, skew),
  LENGTH (N_ ("Sill height"), 0.0, OPENING, ALWAYS, QnOpening, sill_height),
  LENGTH (N_ ("Sill bearing"), 0.0, OPENING, OF_SILL, QnOpening, sill_bearing),
};
/* clang-format on */

G_STATIC_ASSERT (G_N_ELEMENTS (fields) == QN_MASONRY_FIELDS + QN_OPENING_FIELDS);

QnFieldInfo
qn_masonry_field_info (guint field)
{
  return fields[field].info;
}

gboolean
qn_masonry_has_field (const QnMasonry *masonry, int opening, guint field)
{
  const Field *f = &fields[field];
  const QnArch *arch = qn_masonry_get_arch (masonry);
  const int kind = f->kind == LEAF ? QN_MASONRY_WALL : f->kind;
  const QnBond bond =
    masonry->kind == QN_MASONRY_WALL ? masonry->wall.leaves[0].bond : QN_BOND_RUNNING;
  const QnOpening none = { 0 };
  const QnOpening *o =
    opening != QN_NO_OPENING ? &masonry->wall.openings[opening] : &none;
  const gboolean pieces = o->span == QN_SPAN_FLAT_ARCH || o->span == QN_SPAN_VOUSSOIRS;
  if ((kind == OPENING) != (opening != QN_NO_OPENING)
      || (kind >= 0 && kind != (int) masonry->kind))
    return FALSE;
  switch (f->when) {
  case ALWAYS:
    return TRUE;
  case OF_CIRCULAR:
    return arch != NULL && arch->shape == QN_ARCH_CIRCULAR;
  case OF_THREE_CENTRED:
    return arch != NULL && arch->shape == QN_ARCH_THREE_CENTRED;
  case OF_ARCHES:
    return arch != NULL;
  case OF_STONES:
    return !masonry->rubble.relaxed;
  case OF_BONDS:
    return bond != QN_BOND_CUSTOM;
  case OF_RUNNING:
    return bond == QN_BOND_RUNNING;
  case OF_HEADERS:
    return bond == QN_BOND_HEADER || bond == QN_BOND_ENGLISH || bond == QN_BOND_FLEMISH;
  case OF_SEGMENTAL:
    return o->head == QN_HEAD_SEGMENTAL;
  case OF_SPANNED:
    return pieces || o->span == QN_SPAN_LINTEL;
  case OF_PIECES:
    return pieces;
  case OF_FLAT_ARCH:
    return o->span == QN_SPAN_FLAT_ARCH;
  case OF_LINTEL:
    return o->span == QN_SPAN_LINTEL;
  case OF_SILL:
    return o->sill_height > 0.0;
  }
  return FALSE;
}

static gpointer
address (const QnMasonry *masonry, int opening, const Field *field)
{
  const void *base = opening != QN_NO_OPENING
                       ? (const void *) &masonry->wall.openings[opening]
                     : field->kind == LEAF ? (const void *) &masonry->wall.leaves[0]
                                           : masonry;
  return (char *) base + field->offset;
}

double
qn_masonry_get_field (const QnMasonry *masonry, int opening, guint field)
{
  const void *at = address (masonry, opening, &fields[field]);
  switch (fields[field].type) {
  case TYPE_NUMBER:
    return *(const double *) at;
  case TYPE_COUNT:
    return *(const int32_t *) at;
  case TYPE_SEED:
    return *(const uint32_t *) at;
  case TYPE_SPRINGING:
    return 2.0
           * atan2 (2.0 * ((const QnArch *) at)->rise,
                    fmax (((const QnArch *) at)->span, SMALL));
  }
  return 0.0;
}

static void
set_number (gpointer at, Type type, double value)
{
  switch (type) {
  case TYPE_NUMBER:
    *(double *) at = value;
    break;
  case TYPE_COUNT:
    *(int32_t *) at = (int32_t) qn_to_integer (round (value), G_MININT32, G_MAXINT32);
    break;
  case TYPE_SEED:
    *(uint32_t *) at = (uint32_t) qn_to_integer (round (value), 0, G_MAXUINT32);
    break;
  case TYPE_SPRINGING:
    ((QnArch *) at)->rise =
      fmin (0.5 * ((QnArch *) at)->span * tan (0.5 * value), 0.5 * ((QnArch *) at)->span);
    break;
  }
}

QnArch *
qn_masonry_get_arch (const QnMasonry *masonry)
{
  if (masonry->kind == QN_MASONRY_PORTAL && !(masonry->portal.lintel_height > 0.0))
    return (QnArch *) &masonry->portal.arch;
  return masonry->kind == QN_MASONRY_ARCH ? (QnArch *) &masonry->arch : NULL;
}

void
qn_masonry_set_field (QnMasonry *masonry, int opening, guint field, double value)
{
  const Field *f = &fields[field];
  gpointer at = address (masonry, opening, f);
  const bool divides = f->kind == LEAF
                       && (f->offset == G_STRUCT_OFFSET (QnLeaf, unit.x)
                           || f->offset == G_STRUCT_OFFSET (QnLeaf, unit.y));
  QnMasonryCells cells = qn_masonry_get_cells (masonry);
  set_number (at, f->type, value);
  if (opening != QN_NO_OPENING)
    return;
  if (divides)
    cells = qn_masonry_get_cells (masonry);
  for (gsize i = 1; f->kind == LEAF && i < masonry->wall.leaf_count; i++) {
    /* Leaves keep lengths of their own; blocks are alike. */
    if (f->offset != G_STRUCT_OFFSET (QnLeaf, length))
      *(double *) ((char *) &masonry->wall.leaves[i] + f->offset) = value;
  }
  /* Numbers that others depend on take them along. */
  QnArch *arch = qn_masonry_get_arch (masonry);
  QnColumn *column = &masonry->column;
  if (arch != NULL && masonry->kind == QN_MASONRY_PORTAL) {
    const QnPortal *portal = &masonry->portal;
    if (arch->voussoirs == 0)
      *arch = (QnArch){ .rise = 0.25 * portal->span,
                        .ring = fmin (0.4 * portal->pier_width, 0.1 * portal->span),
                        .voussoirs = 21 };
    arch->span = portal->span;
  }
  qn_masonry_keep_cells (masonry, &cells);
  if (at == &column->plinth_height && column->plinth_width <= 0.0)
    column->plinth_width = 1.25 * column->bottom;
  if (at == &column->capital_height && column->capital_width <= 0.0)
    column->capital_width = 1.25 * column->top;
  if (at == &masonry->unit_weight)
    masonry->density = -1.0;
}

/* ---- lists of portals ---- */

static double *
portal_list (const QnPortal *portal, QnPortalList list)
{
  const double *lists[QN_PORTAL_LIST_COUNT] = { portal->spans, portal->rises,
                                                portal->rings, portal->piers };
  return (double *) lists[list];
}

char *
qn_portal_dup_list (const QnPortal *portal, QnPortalList list, QnUnits units)
{
  const double *numbers = portal_list (portal, list);
  gsize count = 0;
  while (count < QN_MOST_UNEQUAL && numbers[count] > 0.0)
    count++;
  return qn_units_format_list (units, QN_QUANTITY_LENGTH, numbers, count, 15);
}

gboolean
qn_portal_take_list (QnPortal *portal, QnPortalList list, QnUnits units, const char *text,
                     GError **error)
{
  double numbers[QN_MOST_UNEQUAL] = { 0 };
  const gsize places = (gsize) portal->bays + (list == QN_PORTAL_PIERS);
  gsize count;
  if (!qn_units_parse_list (units, QN_QUANTITY_LENGTH, text, numbers,
                            MIN (places, QN_MOST_UNEQUAL), &count, error))
    return FALSE;
  for (gsize i = 0; i < count; i++)
    if (!(numbers[i] >= SMALL && numbers[i] <= LARGEST))
      return qn_edit_refuse (error, _ ("number must be positive"));
  memcpy (portal_list (portal, list), numbers, sizeof numbers);
  return TRUE;
}
