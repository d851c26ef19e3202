/* A text that differs in single blocks is read from the project before it: the same as reading all
 * of it, or not at all. */
#include "core/base/memory.h"
#include "io/project/project.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1, \"title\": \"a \\\"blocks\\\": [ title\","
  "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "    \"friction\": 0.6 }, { \"name\": \"wet\", \"kind\": \"elastic\", \"kn\": 1e7,"
  "    \"ks\": 1e7 } ],"
  "  \"blocks\": ["
  "    { \"name\": \"a\", \"vertices\": [[0,0],[3,0],[3,1],[0,1]], \"thickness\": 1,"
  "      \"density\": 2000, \"support\": [true, true, true] },"
  "    { \"name\": \"b\", \"vertices\": [[0,1],[1,1],[1,2],[0,2]], \"thickness\": 1,"
  "      \"unit_weight\": 1e4, \"law\": \"wet\" },"
  "    { \"name\": \"c\", \"vertices\": [[1,1],[2,1],[2,2],[1,2]], \"thickness\": 1,"
  "      \"unit_weight\": 1e4 },"
  "    { \"name\": \"d\", \"vertices\": [[2,1],[3,1],[3,2],[2,2]], \"thickness\": 1,"
  "      \"unit_weight\": 1e4 } ],"
  "  \"walls\": [ { \"name\": \"w\", \"origin\": [0, 2], \"unit\": [1, 1], "
  "\"thickness\": 1,"
  "    \"unit_weight\": 1e4, \"courses\": [[1, 1, 1]] } ],"
  "  \"contact\": { \"law\": \"dry\" }, \"figures\": [ { \"name\": \"x\" } ] }";

static QnProject
read_whole (const char *json)
{
  QnProject project;
  g_autoptr (GError) error = NULL;
  qn_project_parse (json, strlen (json), "whole", NULL, &project, &error);
  g_assert_no_error (error);
  return project;
}

static void
check_same (const QnProject *a, const QnProject *b)
{
  g_autofree char *left = qn_project_to_text (a, NULL);
  g_autofree char *right = qn_project_to_text (b, NULL);
  g_assert_cmpstr (left, ==, right);
  g_assert_cmpstr (a->sha256, ==, b->sha256);
  g_assert_cmpuint (a->model.block_count, ==, b->model.block_count);
  g_assert_cmpfloat (a->model.characteristic_length, ==, b->model.characteristic_length);
  for (gsize i = 0; i < a->model.block_count; i++) {
    const QnBlock *x = &a->model.blocks[i], *y = &b->model.blocks[i];
    g_assert_cmpfloat (x->area, ==, y->area);
    g_assert_cmpfloat (x->centroid.x, ==, y->centroid.x);
    g_assert_cmpfloat (x->centroid.y, ==, y->centroid.y);
    g_assert_cmpfloat (x->polar_moment, ==, y->polar_moment);
    g_assert_cmpfloat (x->weight, ==, y->weight);
    g_assert_cmpint (x->law, ==, y->law);
    g_assert_cmpint (qn_model_find_block (&a->model, y->name), ==, (QnId) i);
  }
}

/* `base` with one part of it replaced; a canonical text again. */
static char *
replaced (const char *base, const char *part, const char *by)
{
  const char *at = strstr (base, part);
  g_assert_nonnull (at);
  return g_strdup_printf ("%.*s%s%s", (int) (at - base), base, by, at + strlen (part));
}

/* Reads `next` both ways: whether the quick one can is what is expected. */
static void
check (const QnProject *before, const char *base, const char *part, const char *by,
       gboolean quick)
{
  g_autofree char *next = replaced (base, part, by);
  QnProject like;
  gboolean done =
    qn_project_parse_like (next, strlen (next), "like", before, base, &like);
  g_assert_cmpint (done, ==, quick);
  if (!done)
    return;
  QnProject whole = read_whole (next);
  check_same (&like, &whole);
  qn_project_clear (&like);
  qn_project_clear (&whole);
}

static void
test_read (void)
{
  QnProject first = read_whole (text);
  g_autofree char *base = qn_project_to_text (&first, NULL);
  QnProject before = read_whole (base);
  /* Places, orientation, weight, law, support: first, middle and last line. */
  check (&before, base, "[0, 1], [1, 1], [1, 2], [0, 2]",
         "[0, 1], [0.9, 1], [1, 2], [0, 2]", TRUE);
  check (&before, base, "[0, 1], [1, 1], [1, 2], [0, 2]",
         "[0, 1], [0, 2], [1, 2], [1, 1]", TRUE);
  check (&before, base, "\"density\": 2000", "\"density\": 1500", TRUE);
  check (&before, base, "\"law\": \"wet\"", "\"law\": \"dry\"", TRUE);
  check (&before, base, ", \"law\": \"wet\"", "", TRUE);
  check (&before, base, "[2, 1], [3, 1], [3, 2], [2, 2]",
         "[2.5, 1], [3, 1], [3, 2], [2.5, 2]", TRUE);
  check (&before, base, "[true, true, true]", "[true, true, false]", TRUE);
  /* Everything else is read as a whole. */
  check (&before, base, "\"friction\": 0.6", "\"friction\": 0.5", FALSE);
  check (&before, base, "\"name\": \"b\"", "\"name\": \"e\"", FALSE);
  check (&before, base, "[0, 1], [1, 1], [1, 2], [0, 2]", "[0, 1], [1, 1], [0, 2]",
         FALSE);
  check (&before, base, "\"law\": \"wet\"", "\"law\": \"damp\"", FALSE);
  check (&before, base, "\"law\": \"wet\"", "\"colour\": \"wet\"", FALSE);
  check (&before, base, "[1, 2], [0, 2]", "[0, 2], [1, 2]", FALSE); /* crosses itself */
  check (&before, base, "[1, 2], [0, 2]", "[1, 2], [0, ]", FALSE);
  check (&before, base, "\"x\"", "\"y\"", FALSE);
  check (&before, base, "figures", "figures", FALSE); /* nothing is different */
  qn_project_clear (&first);
  qn_project_clear (&before);
}

/* Members that no layer knows take lines of their own: such texts are read as a whole. */
static void
test_unknown_members (void)
{
  g_autofree char *json = replaced (text, "\"thickness\": 1,      \"density\"",
                                    "\"colour\": [1, 2], \"thickness\": 1, \"density\"");
  QnProject first = read_whole (json);
  g_autofree char *base = qn_project_to_text (&first, NULL);
  QnProject before = read_whole (base);
  check (&before, base, "[0, 1], [1, 1], [1, 2], [0, 2]",
         "[0, 1], [0.9, 1], [1, 2], [0, 2]", FALSE);
  g_autofree char *like = qn_project_to_text_like (&before, &before, base, NULL);
  g_assert_cmpstr (like, ==, base);
  qn_project_clear (&first);
  qn_project_clear (&before);
}

/* Written with lines of another text, or without: the same. */
static void
test_write (void)
{
  QnProject first = read_whole (text);
  g_autofree char *base = qn_project_to_text (&first, NULL);
  QnProject before = read_whole (base), next = read_whole (base);
  QnVec2 *v = next.model.vertices + next.model.blocks[1].first_vertex;
  v[1].x = 1.0 / 3;
  next.model.blocks[2].support[QN_DOF_UY] = true;
  next.model.blocks[3].law = 1;
  gsize length = 0;
  g_autofree char *quick = qn_project_to_text_like (&next, &before, base, &length);
  g_autofree char *slow = qn_project_to_text (&next, NULL);
  g_assert_cmpstr (quick, ==, slow);
  g_assert_cmpuint (length, ==, strlen (slow));
  /* Blocks in another order are found by their names. */
  QnBlock swapped = next.model.blocks[0];
  next.model.blocks[0] = next.model.blocks[3];
  next.model.blocks[3] = swapped;
  g_autofree char *other = qn_project_to_text_like (&next, &before, base, NULL);
  g_autofree char *all = qn_project_to_text (&next, NULL);
  g_assert_cmpstr (other, ==, all);
  qn_project_clear (&first);
  qn_project_clear (&before);
  qn_project_clear (&next);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/io/project-read-like/read", test_read);
  g_test_add_func ("/io/project-read-like/unknown-members", test_unknown_members);
  g_test_add_func ("/io/project-read-like/write", test_write);
  return g_test_run ();
}
