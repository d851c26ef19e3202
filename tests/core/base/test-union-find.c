#include "core/base/union-find.h"
#include "support/room.h"

#include <glib.h>

/* 0–9 joined as remainders of 3: each set has one root, its least item. */
static void
test_remainders (void)
{
  QnId parents[10];
  qn_sets_init (parents, G_N_ELEMENTS (parents));
  for (QnId i = 0; i < 10; i++)
    g_assert_cmpint (qn_sets_root (parents, i), ==, i);
  for (QnId i = 9; i >= 3; i--)
    qn_sets_join (parents, i, i - 3);
  for (QnId i = 0; i < 10; i++)
    g_assert_cmpint (qn_sets_root (parents, i), ==, i % 3);
}

/* In whatever order a chain is joined, it has one root; joining what is joined changes nothing. */
static void
test_orders (void)
{
  for (guint32 seed = 1; seed <= 20; seed++) {
    g_autoptr (GRand) rand = g_rand_new_with_seed (seed);
    QnId parents[200], links[199];
    qn_sets_init (parents, G_N_ELEMENTS (parents));
    for (QnId i = 0; i < 199; i++)
      links[i] = i;
    for (gsize i = 199; i > 1; i--) {
      gsize k = (gsize) g_rand_int_range (rand, 0, (gint32) i);
      QnId kept = links[i - 1];
      links[i - 1] = links[k];
      links[k] = kept;
    }
    for (gsize i = 0; i < 199; i++) {
      g_assert_cmpint (qn_sets_root (parents, links[i]), !=,
                       qn_sets_root (parents, links[i] + 1));
      qn_sets_join (parents, links[i], links[i] + 1);
      qn_sets_join (parents, links[i] + 1, links[i]);
    }
    for (QnId i = 0; i < 200; i++)
      g_assert_cmpint (qn_sets_root (parents, i), ==, 0);
  }
}

QN_TESTS
{
  g_test_add_func ("/union-find/remainders", test_remainders);
  g_test_add_func ("/union-find/orders", test_orders);
}
