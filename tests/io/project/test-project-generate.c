/* Masonry from keys: each kind as it is without any, and what keys do to it; nothing else is made of wrong
 * ones. Files and results of each are tried by tests/cli. */
#include "io/project/project-generate.h"
#include "support/room.h"

#include <glib.h>

/* The number of blocks for keys that are written one after the other. */
static gsize
count_blocks (const char *kind, const char *keys)
{
  g_autoptr (GError) error = NULL;
  g_auto (GStrv) list = g_strsplit (keys, " ", -1);
  QnProject project;
  g_assert_true (
    qn_project_generate (kind, (const char *const *) list, 0.65, &project, &error));
  g_assert_no_error (error);
  gsize count = project.model.block_count;
  qn_project_clear (&project);
  return count;
}

static void
test_kinds (void)
{
  static const struct {
    const char *kind, *keys;
    gsize blocks; /* with the ground */
  } cases[] = {
    { "arch", "", 17 },
    { "arch", "springing=0.5 voussoirs=9", 11 },
    { "column", "", 7 },
    { "column", "drums=4 width=.8x.7", 5 },
    { "buttress", "courses=4", 5 },
    { "grid", "cells=3x4", 13 },
    { "facade-strip", "", 9 },
    { "facade-strip", "storeys=3x2.5x2.5 courses=2", 7 },
    { "facade-strip", "storeys=3x3 courses=2 held=1,2 floors=8000 floor-friction=0.4",
      7 },
    { "facade-strip", "courses=1 parapet=0.8x0.3 ties=5e3 flanks=1e3 thrust=10", 4 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    const char *keys = cases[i].keys;
    gsize count = count_blocks (cases[i].kind, keys);
    if (count != cases[i].blocks)
      g_error ("%s %s: %zu blocks", cases[i].kind, keys, count);
  }
}

static void
test_refused (void)
{
  static const struct {
    const char *kind, *key;
  } cases[] = {
    { "tower", "height=1" },
    { "wall", "length" },
    { "wall", "=3" },
    { "wall", "lenght=3" },
    { "wall", "length=-3" },
    { "column", "width=.8x." },
    { "facade-strip", "storeys" },
    { "facade-strip", "storey=3" },
    { "facade-strip", "storeys=[]" },
    { "facade-strip", "storeys=3,-3" },
    { "facade-strip", "storeys=\"high\"" },
    { "facade-strip", "thickness=0" },
    { "facade-strip", "thickness=.5,.4,.3" },
    { "facade-strip", "bearing=0.6" },
    { "facade-strip", "width=1,2" },
    { "facade-strip", "courses=2.5" },
    { "facade-strip", "courses=101" },
    { "facade-strip", "held=3" },
    { "facade-strip", "floors=-1" },
    { "facade-strip", "parapet=0.8" },
    { "facade-strip", "parapet=0,0.3" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autoptr (GError) error = NULL;
    const char *const keys[] = { cases[i].key, NULL };
    QnProject project;
    if (qn_project_generate (cases[i].kind, keys, 0.65, &project, &error))
      g_error ("%s %s is taken", cases[i].kind, cases[i].key);
    g_assert_nonnull (error);
  }
}

QN_TESTS
{
  g_test_add_func ("/project-generate/kinds", test_kinds);
  g_test_add_func ("/project-generate/refused", test_refused);
}
