#include "core/base/name-index.h"
#include "support/room.h"

#include <glib.h>

typedef struct {
  char *name;
  int payload;
} Item;

enum { COUNT = 5000 };

static void
test_many_names (void)
{
  Item *items = g_new0 (Item, COUNT);
  QnNameIndex index = { 0 };
  for (int i = 0; i < COUNT; i++) {
    items[i].name = g_strdup_printf ("w.%d.%d", i / 50 + 1, i % 50 + 1);
    g_assert_true (qn_name_index_add (&index, items, sizeof *items, i));
  }
  for (int i = 0; i < COUNT; i++)
    g_assert_cmpint (qn_name_index_find (&index, items, sizeof *items, items[i].name), ==,
                     i);
  g_assert_cmpint (qn_name_index_find (&index, items, sizeof *items, "w.101.1"), ==,
                   QN_NONE);
  g_assert_cmpint (qn_name_index_find (&index, items, sizeof *items, ""), ==, QN_NONE);
  g_assert_cmpint (qn_name_index_find (&index, items, sizeof *items, NULL), ==, QN_NONE);

  qn_name_index_clear (&index);
  g_assert_cmpint (qn_name_index_find (&index, items, sizeof *items, "w.1.1"), ==,
                   QN_NONE);
  for (int i = 0; i < COUNT; i++)
    g_free (items[i].name);
  g_free (items);
}

static void
test_first_of_equals (void)
{
  Item items[200];
  QnNameIndex index = { 0 };
  for (int i = 0; i < 200; i++) {
    items[i].name = i == 0 ? NULL : (char *) "same";
    g_assert_true (qn_name_index_add (&index, items, sizeof *items, i));
  }
  g_assert_cmpint (qn_name_index_find (&index, items, sizeof *items, "same"), ==, 1);
  g_assert_cmpint (qn_name_index_find (&index, items, sizeof *items, ""), ==, 0);
  qn_name_index_clear (&index);
}

QN_TESTS
{
  g_test_add_func ("/name-index/many-names", test_many_names);
  g_test_add_func ("/name-index/first-of-equals", test_first_of_equals);
}
