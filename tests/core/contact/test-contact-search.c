#include "core/contact/contact-search.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

static void
init_search (QnModel *model, QnContactSearch *search, QnPool *room)
{
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  qn_contact_search_init (search, model, qn_contact_lengths (model), room);
  g_assert_false (room->failed);
}

/* The tolerance follows the blocks, not the extent of the model, whatever the scale. */
static void
test_tolerance_is_relative (void)
{
  const double scales[] = { 1e-3, 1, 1e3 };
  for (size_t i = 0; i < G_N_ELEMENTS (scales); i++) {
    g_auto (QnModel) model;
    QnContactSearch search;
    QnPool room = { 0 };
    test_model_init_stack (&model, 4, 1, 0.25);
    test_model_add_rectangle (&model, "cliff", 5, -100, 100, 100);
    test_model_scale (&model, scales[i]);
    model.contact.tolerance = 2e-5;
    init_search (&model, &search, &room);
    g_assert_cmpfloat_with_epsilon (search.lengths.tolerance, 2e-5 * 0.5 * scales[i],
                                    1e-12 * scales[i]);
    g_assert_cmpfloat_with_epsilon (search.lengths.gap_limit, 0.02 * 0.5 * scales[i],
                                    1e-12 * scales[i]);
    qn_pool_clear (&room);
  }
}

/* It never falls below what rounding leaves of the coordinates, even if asked to be zero. */
static void
test_tolerance_has_a_floor (void)
{
  g_auto (QnModel) model;
  QnContactSearch search;
  QnPool room = { 0 };
  test_model_init_stack (&model, 4, 1, 0.25);
  test_model_translate (&model, 1e6, 0);
  model.contact.tolerance = 0;
  init_search (&model, &search, &room);
  g_assert_cmpfloat (search.lengths.tolerance, >, 1e-10);
  g_assert_cmpfloat (search.lengths.tolerance, <, 1e-8);
  qn_pool_clear (&room);
}

static void
test_convexity (void)
{
  g_auto (QnModel) model;
  QnContactSearch search;
  QnPool room = { 0 };
  const QnVec2 l[] = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };
  const QnVec2 straight[] = { { 10, 0 }, { 11, 1e-8 }, { 12, 0 }, { 12, 1 }, { 10, 1 } };
  test_model_init (&model);
  qn_model_add_block (&model, "l", l, 6)->thickness = 1;
  qn_model_add_block (&model, "straight", straight, 5)->thickness = 1;
  init_search (&model, &search, &room);
  g_assert_false (search.convex[0]);
  g_assert_true (search.convex[1]); /* the dent is within the tolerance */
  g_assert_cmpuint (search.sides.count, ==, 10);
  qn_pool_clear (&room);
}

QN_TESTS
{
  g_test_add_func ("/contact-search/tolerance/relative", test_tolerance_is_relative);
  g_test_add_func ("/contact-search/tolerance/floor", test_tolerance_has_a_floor);
  g_test_add_func ("/contact-search/convexity", test_convexity);
}
