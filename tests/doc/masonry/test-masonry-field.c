#include "doc/masonry/masonry-field.h"
#include "stereotomy/masonry.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

/* The field of this label that the object, or that opening of it, has; -1: none. */
static int
find (const QnMasonry *masonry, int opening, const char *label)
{
  for (guint field = 0; field < QN_MASONRY_FIELDS + QN_OPENING_FIELDS; field++)
    if (qn_masonry_has_field (masonry, opening, field)
        && strcmp (qn_masonry_field_info (field).label, label) == 0)
      return (int) field;
  return -1;
}

/* Another for counts and seeds, which are whole. */
static double
value_for (guint field)
{
  const double most = qn_masonry_field_info (field).most;
  return most == 1000.0 || most == 10000.0 || most == G_MAXUINT32 ? 7.0 : 0.75;
}

/* Every field of every kind of object comes back as it was set and touches no other, but for those
 * that must follow. */
static void
test_fields (void)
{
  for (int kind = 0; kind < QN_MASONRY_KIND_COUNT; kind++) {
    QnMasonry masonry;
    qn_masonry_init (&masonry, (QnMasonryKind) kind, "m");
    guint shown = 0;
    for (guint field = 0; field < QN_MASONRY_FIELDS; field++) {
      const QnFieldInfo info = qn_masonry_field_info (field);
      g_assert_nonnull (info.label);
      g_assert_cmpfloat (info.least, <, info.most);
      if (!qn_masonry_has_field (&masonry, QN_NO_OPENING, field))
        continue;
      shown++;
      qn_masonry_set_field (&masonry, QN_NO_OPENING, field, value_for (field));
      g_assert_cmpfloat (qn_masonry_get_field (&masonry, QN_NO_OPENING, field), ==,
                         value_for (field));
    }
    g_assert_cmpuint (shown, >=, 9);
    /* All of them at once: those set before have kept their values. */
    for (guint field = 0; field < QN_MASONRY_FIELDS; field++)
      if (qn_masonry_has_field (&masonry, QN_NO_OPENING, field))
        g_assert_cmpfloat (qn_masonry_get_field (&masonry, QN_NO_OPENING, field), ==,
                           value_for (field));
    qn_masonry_clear (&masonry);
  }
}

static void
test_listed_wall (void)
{
  g_auto (QnMasonry) wall;
  qn_masonry_init (&wall, QN_MASONRY_WALL, "w");
  g_assert_cmpint (find (&wall, QN_NO_OPENING, "Length"), >=, 0);
  g_assert_cmpint (find (&wall, QN_NO_OPENING, "Overlap, part of a block"), >=, 0);
  wall.wall.leaves[0].bond = QN_BOND_CUSTOM;
  g_assert_cmpint (find (&wall, QN_NO_OPENING, "Length"), <, 0);
  g_assert_cmpint (find (&wall, QN_NO_OPENING, "Overlap, part of a block"), <, 0);
  g_assert_cmpint (find (&wall, QN_NO_OPENING, "Block length"), >=, 0);
}

static void
test_opening (void)
{
  g_auto (QnMasonry) wall;
  qn_masonry_init (&wall, QN_MASONRY_WALL, "w");
  QnOpening *opening = qn_masonry_add_opening (&wall);
  g_assert_nonnull (opening);
  opening->span = QN_SPAN_FLAT_ARCH;
  for (guint i = 0; i < QN_OPENING_FIELDS; i++) {
    guint field = QN_MASONRY_FIELDS + i;
    qn_masonry_set_field (&wall, 0, field, value_for (field));
    g_assert_cmpfloat (qn_masonry_get_field (&wall, 0, field), ==, value_for (field));
  }
  g_assert_cmpint (opening->voussoirs, ==, 7);
  g_assert_cmpint (find (&wall, 0, "Inclination of the skewbacks"), >=, 0);
  g_assert_cmpint (find (&wall, 0, "Bearing"), <, 0);
  g_assert_cmpint (find (&wall, 0, "Rise of the head"), <, 0);
  g_assert_cmpint (find (&wall, 0, "Thickness"), <, 0);
  opening->span = QN_SPAN_LINTEL;
  g_assert_cmpint (find (&wall, 0, "Bearing"), >=, 0);
  opening->head = QN_HEAD_SEGMENTAL;
  g_assert_cmpint (find (&wall, 0, "Rise of the head"), >=, 0);
}

/* The angle at the springing is the rise of a circular arch: 3 tan 30 degrees; a right angle is a
 * semicircle. Lists are those of the first bays, and nothing is changed by one that is refused. */
static void
test_portal (void)
{
  g_auto (QnMasonry) masonry;
  qn_masonry_init (&masonry, QN_MASONRY_PORTAL, "p");
  QnPortal *portal = &masonry.portal;
  *portal = (QnPortal){ .bays = 2,
                        .span = 6,
                        .arch = { .span = 6, .rise = 1, .ring = 0.5, .voussoirs = 9 } };
  int springing = find (&masonry, QN_NO_OPENING, "Angle at the springing");
  g_assert_cmpint (springing, >=, 0);
  qn_masonry_set_field (&masonry, QN_NO_OPENING, (guint) springing, G_PI / 3);
  g_assert_cmpfloat (fabs (portal->arch.rise - sqrt (3)), <, 1e-12);
  g_assert_cmpfloat (
    fabs (qn_masonry_get_field (&masonry, QN_NO_OPENING, (guint) springing) - G_PI / 3),
    <, 1e-12);
  qn_masonry_set_field (&masonry, QN_NO_OPENING, (guint) springing, G_PI / 2);
  g_assert_cmpfloat (fabs (portal->arch.rise - 3), <, 1e-12);
  g_assert_cmpint (portal->arch.shape, ==, QN_ARCH_CIRCULAR);
  portal->arch.shape = QN_ARCH_ELLIPTIC;
  g_assert_cmpint (find (&masonry, QN_NO_OPENING, "Angle at the springing"), <, 0);

  static const char *const wrong[] = { "4; 5; 6", "4; 0", "4; -1", "wide" };
  g_assert_true (
    qn_portal_take_list (portal, QN_PORTAL_SPANS, QN_UNITS_SI, "4; 750 cm", NULL));
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    g_autoptr (GError) error = NULL;
    g_assert_false (
      qn_portal_take_list (portal, QN_PORTAL_SPANS, QN_UNITS_SI, wrong[i], &error));
    g_assert_nonnull (error);
  }
  g_assert_cmpfloat (portal->spans[1], ==, 7.5);
  g_autofree char *spans = qn_portal_dup_list (portal, QN_PORTAL_SPANS, QN_UNITS_SI);
  g_assert_cmpstr (spans, ==, "4\302\240m; 7.5\302\240m");
  g_assert_true (
    qn_portal_take_list (portal, QN_PORTAL_PIERS, QN_UNITS_SI, "1; 2; 1", NULL));
  g_assert_true (qn_portal_take_list (portal, QN_PORTAL_SPANS, QN_UNITS_SI, "", NULL));
  g_assert_cmpfloat (portal->spans[0], ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/doc/masonry-field/portal", test_portal);
  g_test_add_func ("/doc/masonry-field/fields", test_fields);
  g_test_add_func ("/doc/masonry-field/listed-wall", test_listed_wall);
  g_test_add_func ("/doc/masonry-field/opening", test_opening);
}
