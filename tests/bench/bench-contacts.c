/* Processor time of contact detection against the number of blocks: a bonded wall with openings,
 * upright and turned by one radian, 1,000 to 100,000 blocks, with --all a million. The exponent
 * between two sizes is 1 where twice the blocks take twice the time. Run by
 * `meson test --benchmark --verbose`. */
#include "core/generate.h"
#include "support/contacts.h"
#include "support/models.h"

#include <glib.h>
#include <time.h>

typedef struct {
  size_t blocks, faces;
  double prepare, detect, update; /* s, best of a few */
} Timing;

/* Processor time used since `start`, s: machines are shared. */
static double
since (clock_t start)
{
  return (double) (clock () - start) / CLOCKS_PER_SEC;
}

/* Moves one block a little and updates. */
static double
time_update (const QnModel *model, const QnContacts *contacts)
{
  QnModel moved;
  QnContacts updated;
  g_assert_cmpint (qn_model_copy (model, &moved, NULL), ==, QN_OK);
  const QnBlock *block = &moved.blocks[moved.block_count / 2];
  for (QnId i = 0; i < block->vertex_count; i++)
    moved.vertices[block->first_vertex + i].x += 0.05;
  clock_t start = clock ();
  g_assert_cmpint (qn_contacts_update (model, contacts, &moved, &updated, NULL), ==,
                   QN_OK);
  double seconds = since (start);
  qn_contacts_clear (&updated);
  qn_model_clear (&moved);
  return seconds;
}

static Timing
time_wall (int32_t length, int32_t courses, double angle)
{
  QnModel model;
  QnContacts contacts;
  QnWallRecipe recipe = qn_wall_recipe_default ();
  recipe.length = length;
  recipe.courses = courses;
  recipe.openings = length * courses / 200;
  qn_model_init (&model);
  g_assert_cmpint (qn_generate_wall (&model, &recipe, NULL), ==, QN_OK);
  test_model_rotate (&model, angle);

  Timing best = { .prepare = G_MAXDOUBLE, .detect = G_MAXDOUBLE, .update = G_MAXDOUBLE };
  for (int i = 0; i < 3; i++) {
    clock_t start = clock ();
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    best.prepare = MIN (best.prepare, since (start));
    start = clock ();
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    best.detect = MIN (best.detect, since (start));
    best.update = MIN (best.update, time_update (&model, &contacts));
    best.blocks = model.block_count;
    best.faces = contacts.face_count;
    g_assert_cmpuint (contacts.findings.count, ==, 0);
    qn_contacts_clear (&contacts);
  }
  qn_model_clear (&model);
  return best;
}

int
main (int argc, char **argv)
{
  static const int32_t sizes[][2] = {
    { 25, 40 }, { 100, 100 }, { 250, 400 }, { 900, 1000 }
  };
  gboolean all = argc > 1 && g_str_equal (argv[1], "--all");
  g_test_init (&argc, &argv, NULL);
  for (int turned = 0; turned < 2; turned++) {
    g_print ("%s\n%9s %9s %10s %10s %10s %9s\n", turned ? "turned by 1 rad" : "upright",
             "blocks", "faces", "prepare s", "detect s", "update s", "exponent");
    Timing last = { 0 };
    for (size_t i = 0; i < G_N_ELEMENTS (sizes) - (all ? 0 : 1); i++) {
      Timing timing = time_wall (sizes[i][0], sizes[i][1], turned);
      g_print ("%9zu %9zu %10.4f %10.4f %10.4f", timing.blocks, timing.faces,
               timing.prepare, timing.detect, timing.update);
      if (i > 0)
        g_print (" %9.2f", log (timing.detect / last.detect)
                             / log ((double) timing.blocks / (double) last.blocks));
      g_print ("\n");
      last = timing;
    }
  }
  return 0;
}
