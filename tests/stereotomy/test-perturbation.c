/* Irregular joints: nothing but the places of corners changes. Whatever the seed, every two blocks
 * that touched still touch in as many faces, nothing else does, and no gap or overlap opens. */
#include "stereotomy/masonry-parts.h"

#include "core/contact/contacts.h"
#include "stereotomy/masonry.h"
#include "stereotomy/sound.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib.h>
#include <string.h>

#define SEEDS 12

static void
init_object (QnMasonry *masonry, QnMasonryKind kind)
{
  qn_masonry_init (masonry, kind, "m");
  masonry->unit_weight = 2e4;
  masonry->foundation = 0.3;
  masonry->law = 0;
  switch (kind) {
  case QN_MASONRY_WALL: {
    masonry->wall.height = 2;
    masonry->wall.leaves[0].length = 3;
    masonry->wall.leaves[0].unit = qn_vec2 (0.4, 0.2);
    QnOpening *opening = qn_masonry_add_opening (masonry);
    opening->at = qn_vec2 (1.1, 0.4);
    opening->width = 0.8;
    opening->height = 0.9;
    opening->span = QN_SPAN_LINTEL;
    opening->depth = 0.2;
    opening->bearing = 0.2;
    break;
  }
  case QN_MASONRY_ARCH:
    masonry->arch = (QnArch){ .span = 3, .rise = 1.2, .ring = 0.3, .voussoirs = 15 };
    break;
  case QN_MASONRY_COLUMN:
    masonry->column = (QnColumn){ .height = 3, .bottom = 0.6, .top = 0.4, .drums = 6 };
    break;
  case QN_MASONRY_BUTTRESS:
    masonry->buttress =
      (QnButtress){ .height = 3, .bottom = 1, .top = 0.4, .courses = 9 };
    break;
  case QN_MASONRY_PORTAL:
    masonry->portal = (QnPortal){ .bays = 2,
                                  .span = 2,
                                  .pier_width = 0.6,
                                  .pier_height = 2,
                                  .courses = 5,
                                  .lintel_height = 0.4 };
    break;
  case QN_MASONRY_RUBBLE:
    masonry->rubble = (QnRubble){
      .width = 2, .top = 1.5, .height = 2, .stone = 0.3, .irregularity = 0.7, .seed = 3
    };
    break;
  case QN_MASONRY_KIND_COUNT:
    g_assert_not_reached ();
  }
}

/* Lays the object by itself; the model is prepared. */
static void
lay (const QnMasonry *masonry, QnModel *model, QnContacts *contacts)
{
  QnDiag diag = { 0 };
  test_sound_init (model);
  if (qn_masonry_expand (masonry, 0, model, &diag) != QN_OK
      || qn_model_prepare (model, &diag) != QN_OK)
    g_error ("%s", qn_problem_text (diag.problem));
  g_assert_cmpint (qn_contacts_detect (model, contacts, NULL), ==, QN_OK);
}

static void
clear (QnModel *model, QnContacts *contacts)
{
  qn_contacts_clear (contacts);
  qn_model_clear (model);
}

static int
compare_names (gconstpointer a, gconstpointer b)
{
  return strcmp (*(char *const *) a, *(char *const *) b);
}

/* Who touches whom, a line for every face. */
static char *
dup_touching (const QnModel *model, const QnContacts *contacts)
{
  g_autoptr (GPtrArray) lines = g_ptr_array_new_with_free_func (g_free);
  for (size_t i = 0; i < contacts->face_count; i++)
    g_ptr_array_add (lines,
                     g_strdup_printf ("%s %s", model->blocks[contacts->faces[i].a].name,
                                      model->blocks[contacts->faces[i].b].name));
  g_ptr_array_sort (lines, compare_names);
  g_ptr_array_add (lines, NULL);
  return g_strjoinv ("\n", (char **) lines->pdata);
}

static double
area_of (const QnModel *model)
{
  double area = 0;
  for (size_t i = 0; i < model->block_count; i++)
    area += model->blocks[i].area;
  return area;
}

static void
test_topology (gconstpointer data)
{
  QnMasonryKind kind = (QnMasonryKind) GPOINTER_TO_INT (data);
  g_auto (QnMasonry) masonry;
  QnModel plain, model;
  QnContacts plain_contacts, contacts;
  init_object (&masonry, kind);
  lay (&masonry, &plain, &plain_contacts);
  g_autofree char *expected = dup_touching (&plain, &plain_contacts);
  for (uint32_t seed = 0; seed < SEEDS; seed++) {
    masonry.perturbation = seed % 2 == 0 ? QN_MAX_PERTURBATION : 0.1;
    masonry.perturbation_seed = seed;
    lay (&masonry, &model, &contacts);
    g_autofree char *found = dup_touching (&model, &contacts);
    g_assert_cmpstr (found, ==, expected);
    g_assert_cmpuint (contacts.findings.count, ==, plain_contacts.findings.count);
    g_assert_cmpint (qn_contacts_require_sound (&model, &contacts, NULL), ==, QN_OK);
    /* Where the outline is straight the whole keeps its area. */
    if (kind != QN_MASONRY_ARCH && kind != QN_MASONRY_PORTAL)
      g_assert_cmpfloat_with_epsilon (area_of (&model), area_of (&plain), 1e-9);
    g_assert_cmpint (
      memcmp (model.vertices, plain.vertices, model.vertex_count * sizeof (QnVec2)), !=,
      0);
    clear (&model, &contacts);
  }
  clear (&plain, &plain_contacts);
}

/* The same seed gives the same coordinates, another one others, and no size none. */
static void
test_seed (void)
{
  g_auto (QnMasonry) masonry;
  QnModel models[4];
  QnContacts contacts[4];
  init_object (&masonry, QN_MASONRY_WALL);
  const uint32_t seeds[] = { 7, 7, 8, 9 };
  for (int i = 0; i < 4; i++) {
    masonry.perturbation = i < 3 ? 0.2 : 0;
    masonry.perturbation_seed = seeds[i];
    lay (&masonry, &models[i], &contacts[i]);
  }
  size_t size = models[0].vertex_count * sizeof (QnVec2);
  g_assert_cmpint (memcmp (models[0].vertices, models[1].vertices, size), ==, 0);
  g_assert_cmpint (memcmp (models[0].vertices, models[2].vertices, size), !=, 0);
  g_assert_cmpint (memcmp (models[0].vertices, models[3].vertices, size), !=, 0);
  for (int i = 0; i < 4; i++)
    clear (&models[i], &contacts[i]);
}

static void
test_refused (void)
{
  const double sizes[] = { -0.1, 0.41, NAN, INFINITY };
  g_auto (QnMasonry) masonry;
  QnDiag diag;
  init_object (&masonry, QN_MASONRY_WALL);
  for (gsize i = 0; i < G_N_ELEMENTS (sizes); i++) {
    g_auto (QnModel) model;
    qn_model_init (&model);
    masonry.perturbation = sizes[i];
    g_assert_cmpint (qn_masonry_expand (&masonry, 0, &model, &diag), ==,
                     QN_ERROR_INVALID);
    g_assert_cmpstr (diag.field, ==, "perturbation");
  }
}

QN_TESTS
{
  for (int kind = 0; kind < QN_MASONRY_KIND_COUNT; kind++) {
    g_autofree char *path =
      g_strdup_printf ("/perturbation/topology/%s", qn_masonry_kind_names[kind]);
    g_test_add_data_func (path, GINT_TO_POINTER (kind), test_topology);
  }
  g_test_add_func ("/perturbation/seed", test_seed);
  g_test_add_func ("/perturbation/refused", test_refused);
}
