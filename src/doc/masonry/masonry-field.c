#include "doc/masonry/masonry-field.h"
#include "core/base/integer.h"
#include "doc/masonry/masonry-shape.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#define LARGEST 1e6  /* m */
#define SMALL   1e-3 /* m: least size */

/* The angle of a circular arch, from the plumb line to its joint at the springing, where its rise is. */
typedef enum { TYPE_NUMBER, TYPE_COUNT, TYPE_SEED, TYPE_SPRINGING } Type;

/* Where a field is: in the object, or in the leaf of a wall. */
typedef struct Field {
  QnFieldInfo info;
  int kind; /* QnMasonryKind, or -1 for all */
  Type type;
  gboolean leaf;
  gsize offset;
} Field;

#define ALL (-1)
#define SIZE(text, key, kind, member)                                                    \
  {                                                                                      \
    { text, QN_QUANTITY_LENGTH, SMALL, LARGEST, FALSE, key }, kind, TYPE_NUMBER, FALSE,  \
      G_STRUCT_OFFSET (QnMasonry, member)                                                \
  }
#define EXTRA(text, key, kind, member)                                                   \
  {                                                                                      \
    { text, QN_QUANTITY_LENGTH, 0.0, LARGEST, FALSE, key }, kind, TYPE_NUMBER, FALSE,    \
      G_STRUCT_OFFSET (QnMasonry, member)                                                \
  }
#define PLACE(text, key, member)                                                         \
  {                                                                                      \
    { text, QN_QUANTITY_LENGTH, -LARGEST, LARGEST, FALSE, key }, ALL, TYPE_NUMBER,       \
      FALSE, G_STRUCT_OFFSET (QnMasonry, member)                                         \
  }
#define NUMBER(text, key, kind, member, least)                                           \
  {                                                                                      \
    { text, QN_QUANTITY_NUMBER, least, 10000.0, TRUE, key }, kind, TYPE_COUNT, FALSE,    \
      G_STRUCT_OFFSET (QnMasonry, member)                                                \
  }
#define SPRINGING(kind, member)                                                          \
  {                                                                                      \
    { N_ ("Angle at the springing"), QN_QUANTITY_ANGLE, SMALL, M_PI_2, FALSE, "rise" },  \
      kind, TYPE_SPRINGING, FALSE, G_STRUCT_OFFSET (QnMasonry, member)                   \
  }
#define LEAF(text, key, quantity, least, most, member)                                   \
  {                                                                                      \
    { text, quantity, least, most, FALSE, key }, QN_MASONRY_WALL, TYPE_NUMBER, TRUE,     \
      G_STRUCT_OFFSET (QnLeaf, member)                                                   \
  }

/* clang-format off */
static const Field fields[QN_MASONRY_FIELD_COUNT] = {
  [QN_MASONRY_ORIGIN_X] = PLACE (N_ ("Left edge"), "origin[0]", origin.x),
  [QN_MASONRY_ORIGIN_Y] = PLACE (N_ ("Lower edge"), "origin[1]", origin.y),
  [QN_MASONRY_ROTATION] = { { N_ ("Rotated by"), QN_QUANTITY_ANGLE, -10.0, 10.0, FALSE, "rotation" }, ALL, TYPE_NUMBER,
                          FALSE, G_STRUCT_OFFSET (QnMasonry, rotation) },
  [QN_MASONRY_LENGTH] = LEAF (N_ ("Length"), "length", QN_QUANTITY_LENGTH, SMALL, LARGEST, length),
  [QN_MASONRY_HEIGHT] = SIZE (N_ ("Height"), "height", QN_MASONRY_WALL, wall.height),
  [QN_MASONRY_UNIT_X] = LEAF (N_ ("Block length"), "unit[0]", QN_QUANTITY_LENGTH, SMALL, LARGEST, unit.x),
  [QN_MASONRY_UNIT_Y] = LEAF (N_ ("Course height"), "unit[1]", QN_QUANTITY_LENGTH, SMALL, LARGEST, unit.y),
  [QN_MASONRY_LAP] = LEAF (N_ ("Overlap, part of a block"), "lap", QN_QUANTITY_NUMBER, 0.0, 0.999, lap),
  [QN_MASONRY_HEADER] = LEAF (N_ ("Header length (0: half)"), "header", QN_QUANTITY_LENGTH, 0.0, LARGEST, header),
  [QN_MASONRY_ARCH_SPAN] = SIZE (N_ ("Span"), "span", QN_MASONRY_ARCH, arch.span),
  [QN_MASONRY_ARCH_RISE] = SIZE (N_ ("Rise"), "rise", QN_MASONRY_ARCH, arch.rise),
  [QN_MASONRY_ARCH_SPRINGING] = SPRINGING (QN_MASONRY_ARCH, arch),
  [QN_MASONRY_ARCH_RING] = SIZE (N_ ("Ring thickness"), "ring", QN_MASONRY_ARCH, arch.ring),
  [QN_MASONRY_ARCH_VOUSSOIRS] = NUMBER (N_ ("Voussoirs"), "voussoirs", QN_MASONRY_ARCH, arch.voussoirs, 2.0),
  [QN_MASONRY_ARCH_SPRINGER] = EXTRA (N_ ("Springer height"), "springer", QN_MASONRY_ARCH, arch.springer),
  [QN_MASONRY_ARCH_RINGS] = NUMBER (N_ ("Rings"), "rings", QN_MASONRY_ARCH, arch.rings, 1.0),
  [QN_MASONRY_ARCH_HAUNCH] = EXTRA (N_ ("Radius at the ends (0: usual)"), "haunch", QN_MASONRY_ARCH, arch.haunch),
  [QN_MASONRY_COLUMN_HEIGHT] = SIZE (N_ ("Height"), "height", QN_MASONRY_COLUMN, column.height),
  [QN_MASONRY_COLUMN_BOTTOM] = SIZE (N_ ("Width at the foot"), "width[0]", QN_MASONRY_COLUMN, column.bottom),
  [QN_MASONRY_COLUMN_TOP] = SIZE (N_ ("Width at the top"), "width[1]", QN_MASONRY_COLUMN, column.top),
  [QN_MASONRY_COLUMN_DRUMS] = NUMBER (N_ ("Drums"), "drums", QN_MASONRY_COLUMN, column.drums, 1.0),
  [QN_MASONRY_PLINTH_WIDTH] = EXTRA (N_ ("Plinth width"), "plinth[0]", QN_MASONRY_COLUMN, column.plinth_width),
  [QN_MASONRY_PLINTH_HEIGHT] = EXTRA (N_ ("Plinth height"), "plinth[1]", QN_MASONRY_COLUMN, column.plinth_height),
  [QN_MASONRY_CAPITAL_WIDTH] = EXTRA (N_ ("Capital width"), "capital[0]", QN_MASONRY_COLUMN, column.capital_width),
  [QN_MASONRY_CAPITAL_HEIGHT] = EXTRA (N_ ("Capital height"), "capital[1]", QN_MASONRY_COLUMN, column.capital_height),
  [QN_MASONRY_BUTTRESS_HEIGHT] = SIZE (N_ ("Height"), "height", QN_MASONRY_BUTTRESS, buttress.height),
  [QN_MASONRY_BUTTRESS_BOTTOM] = SIZE (N_ ("Width at the foot"), "width[0]", QN_MASONRY_BUTTRESS, buttress.bottom),
  [QN_MASONRY_BUTTRESS_TOP] = SIZE (N_ ("Width at the top"), "width[1]", QN_MASONRY_BUTTRESS, buttress.top),
  [QN_MASONRY_BUTTRESS_COURSES] = NUMBER (N_ ("Courses"), "courses", QN_MASONRY_BUTTRESS, buttress.courses, 1.0),
  [QN_MASONRY_PORTAL_BAYS] = NUMBER (N_ ("Bays"), "bays", QN_MASONRY_PORTAL, portal.bays, 1.0),
  [QN_MASONRY_PORTAL_SPAN] = SIZE (N_ ("Span"), "span", QN_MASONRY_PORTAL, portal.span),
  [QN_MASONRY_PORTAL_PIER_WIDTH] = SIZE (N_ ("Pier width"), "pier[0]", QN_MASONRY_PORTAL, portal.pier_width),
  [QN_MASONRY_PORTAL_PIER_HEIGHT] = SIZE (N_ ("Pier height"), "pier[1]", QN_MASONRY_PORTAL, portal.pier_height),
  [QN_MASONRY_PORTAL_COURSES] = NUMBER (N_ ("Courses per pier"), "courses", QN_MASONRY_PORTAL, portal.courses, 1.0),
  [QN_MASONRY_PORTAL_LINTEL] = EXTRA (N_ ("Lintel height (0: arches)"), "lintel", QN_MASONRY_PORTAL, portal.lintel_height),
  [QN_MASONRY_PORTAL_RISE] = SIZE (N_ ("Rise"), "arch.rise", QN_MASONRY_PORTAL, portal.arch.rise),
  [QN_MASONRY_PORTAL_SPRINGING] = SPRINGING (QN_MASONRY_PORTAL, portal.arch),
  [QN_MASONRY_PORTAL_RING] = SIZE (N_ ("Ring thickness"), "arch.ring", QN_MASONRY_PORTAL, portal.arch.ring),
  [QN_MASONRY_PORTAL_VOUSSOIRS] = NUMBER (N_ ("Voussoirs"), "arch.voussoirs", QN_MASONRY_PORTAL, portal.arch.voussoirs, 2.0),
  [QN_MASONRY_PORTAL_RINGS] = NUMBER (N_ ("Rings"), "arch.rings", QN_MASONRY_PORTAL, portal.arch.rings, 1.0),
  [QN_MASONRY_PORTAL_HAUNCH] = EXTRA (N_ ("Radius at the ends (0: usual)"), "arch.haunch", QN_MASONRY_PORTAL, portal.arch.haunch),
  [QN_MASONRY_PORTAL_BACKING] = EXTRA (N_ ("Height of the backing"), "backing", QN_MASONRY_PORTAL, portal.backing),
  [QN_MASONRY_RUBBLE_WIDTH] = SIZE (N_ ("Width at the foot"), "width[0]", QN_MASONRY_RUBBLE, rubble.width),
  [QN_MASONRY_RUBBLE_TOP] = SIZE (N_ ("Width at the top"), "width[1]", QN_MASONRY_RUBBLE, rubble.top),
  [QN_MASONRY_RUBBLE_HEIGHT] = SIZE (N_ ("Height"), "height", QN_MASONRY_RUBBLE, rubble.height),
  [QN_MASONRY_RUBBLE_STONE] = SIZE (N_ ("Size of stones"), "stone", QN_MASONRY_RUBBLE, rubble.stone),
  [QN_MASONRY_RUBBLE_IRREGULARITY] = { { N_ ("Irregularity, 0 to 1"), QN_QUANTITY_NUMBER, 0.0, 1.0, FALSE, "irregularity" },
                                     QN_MASONRY_RUBBLE, TYPE_NUMBER, FALSE,
                                     G_STRUCT_OFFSET (QnMasonry, rubble.irregularity) },
  [QN_MASONRY_RUBBLE_SEED] = { { N_ ("Seed"), QN_QUANTITY_NUMBER, 0.0, 4294967295.0, TRUE, "seed" }, QN_MASONRY_RUBBLE,
                             TYPE_SEED, FALSE, G_STRUCT_OFFSET (QnMasonry, rubble.seed) },
  [QN_MASONRY_THICKNESS] = SIZE (N_ ("Thickness"), "thickness", ALL, thickness),
  [QN_MASONRY_UNIT_WEIGHT] = { { N_ ("Unit weight"), QN_QUANTITY_UNIT_WEIGHT, 0.0, 1e9, FALSE, "unit_weight" }, ALL, TYPE_NUMBER,
                             FALSE, G_STRUCT_OFFSET (QnMasonry, unit_weight) },
  [QN_MASONRY_FOUNDATION] = EXTRA (N_ ("Fixed base, depth"), "foundation", ALL, foundation),
  [QN_MASONRY_PERTURBATION] = { { N_ ("Irregular joints, 0 to 0.4"), QN_QUANTITY_NUMBER, 0.0, 0.4, FALSE, "perturbation" }, ALL,
                              TYPE_NUMBER, FALSE, G_STRUCT_OFFSET (QnMasonry, perturbation) },
  [QN_MASONRY_PERTURBATION_SEED] = { { N_ ("Seed of the joints"), QN_QUANTITY_NUMBER, 0.0, 4294967295.0, TRUE, "perturbation_seed" }, ALL,
                                   TYPE_SEED, FALSE, G_STRUCT_OFFSET (QnMasonry, perturbation_seed) },
};
/* clang-format on */

const QnFieldInfo *
qn_masonry_field_info (QnMasonryField field)
{
  return &fields[field].info;
}

gboolean
qn_masonry_has_field (const QnMasonry *masonry, QnMasonryField field)
{
  const Field *f = &fields[field];
  if (f->kind != ALL && f->kind != (int) masonry->kind)
    return FALSE;
  if (masonry->rubble.relaxed
      && (field == QN_MASONRY_RUBBLE_TOP || field == QN_MASONRY_RUBBLE_IRREGULARITY))
    return FALSE;
  const QnArch *arch = qn_masonry_get_arch (masonry);
  if (f->type == TYPE_SPRINGING)
    return arch != NULL && arch->shape == QN_ARCH_CIRCULAR;
  if (field == QN_MASONRY_ARCH_HAUNCH || field == QN_MASONRY_PORTAL_HAUNCH)
    return arch != NULL && arch->shape == QN_ARCH_THREE_CENTRED;
  if (masonry->kind == QN_MASONRY_PORTAL && field >= QN_MASONRY_PORTAL_RISE
      && field <= QN_MASONRY_PORTAL_BACKING)
    return !(masonry->portal.lintel_height > 0.0);
  if (masonry->kind != QN_MASONRY_WALL)
    return TRUE;
  QnBond bond = masonry->wall.leaves[0].bond;
  if (field == QN_MASONRY_LENGTH || field == QN_MASONRY_HEIGHT)
    return bond != QN_BOND_CUSTOM;
  if (field == QN_MASONRY_LAP)
    return bond == QN_BOND_RUNNING;
  if (field == QN_MASONRY_HEADER)
    return bond == QN_BOND_HEADER || bond == QN_BOND_ENGLISH || bond == QN_BOND_FLEMISH;
  return TRUE;
}

static gpointer
address (QnMasonry *masonry, const Field *field)
{
  char *base = field->leaf ? (char *) &masonry->wall.leaves[0] : (char *) masonry;
  return base + field->offset;
}

static double
get_number (gconstpointer at, Type type)
{
  switch (type) {
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

double
qn_masonry_get_field (const QnMasonry *masonry, QnMasonryField field)
{
  return get_number (address ((QnMasonry *) masonry, &fields[field]), fields[field].type);
}

void
qn_masonry_set_field (QnMasonry *masonry, QnMasonryField field, double value)
{
  const bool grid = masonry->kind == QN_MASONRY_WALL && masonry->wall.grid;
  const bool divides = field == QN_MASONRY_UNIT_X || field == QN_MASONRY_UNIT_Y;
  const QnVec2 cells = grid ? qn_masonry_count_cells (masonry) : qn_vec2 (0, 0);
  const QnRubble before = masonry->rubble;
  set_number (address (masonry, &fields[field]), fields[field].type, value);
  if (grid)
    qn_masonry_divide_grid (masonry, divides ? qn_masonry_count_cells (masonry) : cells);
  for (gsize i = 1; fields[field].leaf && i < masonry->wall.leaf_count; i++) {
    /* Leaves keep lengths of their own; blocks are alike. */
    if (field != QN_MASONRY_LENGTH)
      *(double *) ((char *) &masonry->wall.leaves[i] + fields[field].offset) = value;
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
  if (arch != NULL)
    qn_arch_fit_shape (arch);
  if (masonry->rubble.relaxed) {
    const QnVec2 size = { masonry->rubble.width, masonry->rubble.height };
    masonry->rubble.width = before.width;
    masonry->rubble.height = before.height;
    qn_masonry_resize_voronoi (&masonry->rubble, size);
  }
  if (field == QN_MASONRY_PLINTH_HEIGHT && column->plinth_width <= 0.0)
    column->plinth_width = 1.25 * column->bottom;
  if (field == QN_MASONRY_CAPITAL_HEIGHT && column->capital_width <= 0.0)
    column->capital_width = 1.25 * column->top;
  if (field == QN_MASONRY_UNIT_WEIGHT)
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
  return qn_units_format_list (units, QN_QUANTITY_LENGTH, numbers, count);
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
    if (!(numbers[i] >= SMALL && numbers[i] <= LARGEST)) {
      g_set_error (error, QN_UNITS_ERROR, QN_UNITS_ERROR_TOO_LARGE,
                   _ ("number must be positive"));
      return FALSE;
    }
  memcpy (portal_list (portal, list), numbers, sizeof numbers);
  return TRUE;
}

/* ---- openings ---- */

typedef struct OpeningField {
  QnFieldInfo info;
  gsize offset;
  guint spans; /* a bit for each QnSpan that has it; 0: all */
} OpeningField;

#define LENGTH(text, key, least, member, spans)                                          \
  {                                                                                      \
    { text, QN_QUANTITY_LENGTH, least, LARGEST, FALSE, key },                            \
      G_STRUCT_OFFSET (QnOpening, member), spans                                         \
  }
#define SPANS_PIECES (1u << QN_SPAN_FLAT_ARCH | 1u << QN_SPAN_VOUSSOIRS)
#define SPANS_ANY    (SPANS_PIECES | 1u << QN_SPAN_LINTEL)

/* clang-format off */
static const OpeningField opening_fields[QN_OPENING_FIELD_COUNT] = {
  [QN_OPENING_LEFT] = LENGTH (N_ ("From the left"), "at[0]", -LARGEST, at.x, 0),
  [QN_OPENING_BOTTOM] = LENGTH (N_ ("From the foot"), "at[1]", -LARGEST, at.y, 0),
  [QN_OPENING_WIDTH] = LENGTH (N_ ("Width"), "width", SMALL, width, 0),
  [QN_OPENING_HEIGHT] = LENGTH (N_ ("Height"), "height", SMALL, height, 0),
  [QN_OPENING_RISE] = LENGTH (N_ ("Rise of the head"), "rise", SMALL, rise, 0),
  [QN_OPENING_DEPTH] = LENGTH (N_ ("Depth of what spans it"), "depth", SMALL, depth, SPANS_ANY),
  [QN_OPENING_BEARING] = LENGTH (N_ ("Bearing"), "bearing", 0.0, bearing, 1u << QN_SPAN_LINTEL),
  [QN_OPENING_VOUSSOIRS] = { { N_ ("Voussoirs"), QN_QUANTITY_NUMBER, 1.0, 1000.0, TRUE, "voussoirs" },
                             G_STRUCT_OFFSET (QnOpening, voussoirs), SPANS_PIECES },
  [QN_OPENING_SKEW] = { { N_ ("Inclination of the skewbacks"), QN_QUANTITY_ANGLE, 0.0, 1.5, FALSE, "skew" },
                        G_STRUCT_OFFSET (QnOpening, skew), 1u << QN_SPAN_FLAT_ARCH },
  [QN_OPENING_SILL_HEIGHT] = LENGTH (N_ ("Sill height"), "sill[0]", 0.0, sill_height, 0),
  [QN_OPENING_SILL_BEARING] = LENGTH (N_ ("Sill bearing"), "sill[1]", 0.0, sill_bearing, 0),
};
/* clang-format on */

const QnFieldInfo *
qn_opening_field_info (QnOpeningField field)
{
  return &opening_fields[field].info;
}

gboolean
qn_opening_has_field (const QnOpening *opening, QnOpeningField field)
{
  const guint spans = opening_fields[field].spans;
  if (field == QN_OPENING_RISE)
    return opening->head == QN_HEAD_SEGMENTAL;
  if (field == QN_OPENING_SILL_BEARING)
    return opening->sill_height > 0.0;
  return spans == 0 || (spans >> opening->span & 1) != 0;
}

double
qn_opening_get_field (const QnOpening *opening, QnOpeningField field)
{
  const OpeningField *f = &opening_fields[field];
  return get_number ((const char *) opening + f->offset,
                     f->info.whole ? TYPE_COUNT : TYPE_NUMBER);
}

void
qn_opening_set_field (QnOpening *opening, QnOpeningField field, double value)
{
  const OpeningField *f = &opening_fields[field];
  set_number ((char *) opening + f->offset, f->info.whole ? TYPE_COUNT : TYPE_NUMBER,
              value);
}
