#include "core/base/memory.h"
#include "support/room.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

static void
test_grow_keeps_and_zeroes (void)
{
  size_t capacity = 0;
  int *items = NULL;
  g_assert_true (qn_array_reserve (&items, &capacity, 3, sizeof *items));
  g_assert_cmpuint (capacity, >=, 3);
  for (size_t i = 0; i < capacity; i++) {
    g_assert_cmpint (items[i], ==, 0);
    items[i] = (int) i + 1;
  }

  size_t before = capacity;
  g_assert_true (qn_array_reserve (&items, &capacity, 1000, sizeof *items));
  g_assert_cmpuint (capacity, >=, 1000);
  for (size_t i = 0; i < capacity; i++)
    g_assert_cmpint (items[i], ==, i < before ? (int) i + 1 : 0);
  free (items);
}

static void
test_grow_refuses_overflow (void)
{
  size_t capacity = 0;
  void *items = NULL;
  g_assert_false (qn_array_reserve (&items, &capacity, SIZE_MAX / 4, 16));
  g_assert_cmpuint (capacity, ==, 0);
  g_assert_false (qn_array_reserve (&items, &capacity, SIZE_MAX, 1));
  g_assert_null (items);
}

static void
test_push (void)
{
  struct {
    int *items;
    size_t count, capacity;
  } list = { NULL, 0, 0 };
  for (int i = 0; i < 100; i++)
    g_assert_true (QN_ARRAY_PUSH (list.items, list.count, list.capacity, i * i));
  g_assert_cmpuint (list.count, ==, 100);
  for (int i = 0; i < 100; i++)
    g_assert_cmpint (list.items[i], ==, i * i);
  free (list.items);
}

static void
test_lines (void)
{
  for (size_t count = 0; count < 20; count++) {
    double *numbers = qn_alloc_lines (count, sizeof *numbers);
    g_assert_nonnull (numbers);
    g_assert_cmpuint ((uintptr_t) numbers % 64, ==, 0);
    memset (numbers, 0, count * sizeof *numbers);
    free (numbers);
  }
  g_assert_null (qn_alloc_lines (SIZE_MAX / 4, 16));
  g_assert_null (qn_alloc_lines (SIZE_MAX, 1));
}

static void
test_strdup (void)
{
  char *copy = qn_strdup ("joint");
  g_assert_cmpstr (copy, ==, "joint");
  free (copy);
  g_assert_null (qn_strdup (NULL));
}

QN_TESTS
{
  g_test_add_func ("/memory/grow/keeps-and-zeroes", test_grow_keeps_and_zeroes);
  g_test_add_func ("/memory/grow/refuses-overflow", test_grow_refuses_overflow);
  g_test_add_func ("/memory/push", test_push);
  g_test_add_func ("/memory/lines", test_lines);
  g_test_add_func ("/memory/strdup", test_strdup);
}
