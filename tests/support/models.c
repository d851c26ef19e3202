#include "support/models.h"

#include <glib.h>
#include <string.h>

/* Ferris & Tin-Loi, Int. J. Mech. Sci. 43 (2001) 209-224; block counts and multipliers as
 * published since (Gilbert, Casapulla & Ahmed 2006) and recomputed by linear programming. */
const TestWall test_walls[TEST_WALL_COUNT] = {
  { "E U E U E U", ".5 1 1 1 1 .5", "1 1 1 1 1", NULL, NULL, 33, 83, 0.64285900, 0.643 },
  { "E U E U E U E U E U", ".5 1 1 1 1 .5", "1 1 1 1 1", NULL, NULL, 55, 141, 0.57999861,
    0.564 },
  { "U E U w v w v w U E U", ".5 1 1 1 .5", "1 1 1 1", ".5 1 -1 1 .5", "1 .5 -1 .5 1", 46,
    102, 0.40369410, 0.356 },
  { "E U E w v w v w E U E", ".5 1 1 1 1 .5", "1 1 1 1 1", "1 -1 1 -1 1",
    ".5 .5 -1 .5 .5 -1 .5 .5", 55, 116, 0.33194840, 0.264 },
  { "E U E w v w v w E U E w v w v w E U E", ".5 1 1 .5", "1 1 1", "1 -1 1",
    ".5 .5 -1 .5 .5", 61, 120, 0.23964253, 0.216 },
  { "E U E U w v w v w U E U w v w v w U E U E", ".5 1 1 1 1 1 1 .5", "1 1 1 1 1 1 1",
    ".5 1 -1 1 1 -1 1 .5", "1 .5 -1 .5 1 .5 -1 .5 1", 146, 345, 0.34782456, 0.297 },
};

void
test_model_init (QnModel *model)
{
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "joint");
  g_assert_nonnull (law);
  law->kind = QN_LAW_COULOMB;
  law->basis = QN_BASIS_CONTACT;
  law->kn = law->ks = 1e7;
  law->friction = 0.65;
  model->contact.law = 0;
}

QnBlock *
test_model_add_rectangle (QnModel *model, const char *name, double x, double y,
                          double width, double height)
{
  const QnVec2 corners[] = {
    { x, y }, { x + width, y }, { x + width, y + height }, { x, y + height }
  };
  QnBlock *block = qn_model_add_block (model, name, corners, 4);
  g_assert_nonnull (block);
  block->thickness = 1;
  block->unit_weight = 10000;
  return block;
}

QnBlock *
test_model_add_base (QnModel *model, double x, double y, double width, double height)
{
  QnBlock *base = test_model_add_rectangle (model, "base", x, y, width, height);
  base->support[QN_DOF_UX] = base->support[QN_DOF_UY] = base->support[QN_DOF_RZ] = true;
  return base;
}

QnId
test_model_add_node (QnModel *model, const char *name, double x, double y,
                     const char *supports)
{
  QnNode *node = qn_model_add_node (model, name);
  node->at = qn_vec2 (x, y);
  node->support[0] = strchr (supports, 'x') != NULL;
  node->support[1] = strchr (supports, 'y') != NULL;
  node->support[2] = strchr (supports, 'r') != NULL;
  return (QnId) model->node_count - 1;
}

void
test_model_init_block_on_plane (QnModel *model, double width, double height)
{
  test_model_init (model);
  test_model_add_base (model, -2 * width, -height, 4 * width, height);
  test_model_add_rectangle (model, "block", -width / 2, 0, width, height);
}

void
test_model_init_stack (QnModel *model, int count, double width, double height)
{
  test_model_init (model);
  test_model_add_base (model, -width, -height, 3 * width, height);
  for (int i = 0; i < count; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i + 1);
    test_model_add_rectangle (model, name, 0, i * height, width, height);
  }
}

static double
add_course (QnWall *wall, const char *text)
{
  double lengths[16], total = 0;
  size_t count = 0;
  char **words = g_strsplit (text, " ", 0);
  for (char **word = words; *word != NULL; word++) {
    lengths[count] = g_ascii_strtod (*word, NULL);
    total += fabs (lengths[count++]);
  }
  g_strfreev (words);
  g_assert_true (qn_wall_add_course (wall, lengths, count));
  return total;
}

void
test_model_init_wall (QnModel *model, int number, double dilatancy)
{
  g_assert_true (number >= 1 && number <= TEST_WALL_COUNT);
  const TestWall *data = &test_walls[number - 1];
  test_model_init (model);
  model->laws[0].dilatancy = dilatancy;

  QnWall *wall = qn_model_add_wall (model, "w");
  g_assert_nonnull (wall);
  wall->unit = qn_vec2 (0.4, 0.175);
  wall->thickness = 1;
  wall->unit_weight = 10000;
  double length = 0;
  for (const char *c = data->courses; *c != '\0'; c++) {
    if (*c != ' ')
      length = add_course (wall, *c == 'E'   ? data->E
                                 : *c == 'U' ? data->U
                                 : *c == 'w' ? data->w
                                             : data->v);
  }
  test_model_add_base (model, 0, -0.175, 0.4 * length, 0.175);
  test_model_add_weight_loads (model, 1);
}

void
test_model_soften_every_other_block (QnModel *model, double times)
{
  g_assert_cmpint (qn_model_expand_walls (model, NULL), ==, QN_OK);
  QnLaw *soft = qn_model_add_law (model, "soft");
  char *name = soft->name;

  *soft = model->laws[0];
  soft->name = name;
  soft->kn = model->laws[0].kn / times;
  soft->ks = model->laws[0].ks / times;
  for (size_t i = 0; i < model->block_count; i++)
    model->blocks[i].law = i % 2 == 0 ? 0 : 1;
}

void
test_model_add_weight_loads (QnModel *model, double direction)
{
  QnLoad *dead = qn_model_add_dead_load (model);
  QnLoad *live = qn_model_add_live_load (model);
  g_assert_true (dead != NULL && live != NULL);
  dead->kind = live->kind = QN_LOAD_WEIGHT;
  dead->vector = qn_vec2 (0, -1);
  live->vector = qn_vec2 (direction, 0);
}

/* Blocks of walls become blocks like others. */
static void
forget_walls (QnModel *model)
{
  QnDiag diag;
  g_assert_cmpint (qn_model_expand_walls (model, &diag), ==, QN_OK);
  for (size_t i = 0; i < model->block_count; i++)
    model->blocks[i].wall = QN_NONE;
  for (size_t i = 0; i < model->wall_count; i++) {
    free (model->walls[i].name);
    free (model->walls[i].lengths);
    free (model->walls[i].course_ends);
  }
  model->wall_count = model->expanded_wall_count = 0;
}

/* p -> matrix p + shift, for places; directions are turned only. */
static void
transform (QnModel *model, const double matrix[2][2], QnVec2 shift, double moment_factor)
{
  forget_walls (model);
  for (size_t i = 0; i < model->vertex_count; i++) {
    QnVec2 p = model->vertices[i];
    model->vertices[i] = qn_vec2 (matrix[0][0] * p.x + matrix[0][1] * p.y + shift.x,
                                  matrix[1][0] * p.x + matrix[1][1] * p.y + shift.y);
  }

  double scale = sqrt (fabs (matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]));
  for (int kind = 0; kind < 2; kind++) {
    QnLoad *loads = kind == 0 ? model->dead_loads : model->live_loads;
    size_t count = kind == 0 ? model->dead_load_count : model->live_load_count;
    for (size_t i = 0; i < count; i++) {
      QnVec2 v = loads[i].vector, p = loads[i].at;
      loads[i].vector = qn_vec2 ((matrix[0][0] * v.x + matrix[0][1] * v.y) / scale,
                                 (matrix[1][0] * v.x + matrix[1][1] * v.y) / scale);
      loads[i].at = qn_vec2 (matrix[0][0] * p.x + matrix[0][1] * p.y + shift.x,
                             matrix[1][0] * p.x + matrix[1][1] * p.y + shift.y);
      loads[i].moment *= moment_factor;
    }
  }
}

void
test_model_rotate (QnModel *model, double angle)
{
  const double matrix[2][2] = { { cos (angle), -sin (angle) },
                                { sin (angle), cos (angle) } };
  transform (model, matrix, qn_vec2 (0, 0), 1);
}

void
test_model_translate (QnModel *model, double dx, double dy)
{
  const double matrix[2][2] = { { 1, 0 }, { 0, 1 } };
  transform (model, matrix, qn_vec2 (dx, dy), 1);
}

void
test_model_scale (QnModel *model, double factor)
{
  const double matrix[2][2] = { { factor, 0 }, { 0, factor } };
  transform (model, matrix, qn_vec2 (0, 0), factor);
  model->contact.pairs.offset *= factor;
  for (size_t i = 0; i < model->override_count; i++)
    model->overrides[i].pairs.offset *= factor;
  if (model->analysis.control.dof != QN_DOF_RZ)
    model->analysis.control.target *= factor;
}

void
test_model_mirror (QnModel *model)
{
  const double matrix[2][2] = { { -1, 0 }, { 0, 1 } };
  transform (model, matrix, qn_vec2 (0, 0), -1);
}

void
test_model_renumber (QnModel *model, unsigned seed)
{
  forget_walls (model);
  g_autoptr (GRand) random = g_rand_new_with_seed (seed);
  size_t count = model->block_count;
  QnId *new_of_old = g_new (QnId, count), *old_of_new = g_new (QnId, count);
  for (size_t i = 0; i < count; i++)
    old_of_new[i] = (QnId) i;
  for (size_t i = count; i > 1; i--) {
    size_t j = (size_t) g_rand_int_range (random, 0, (gint32) i);
    QnId swap = old_of_new[i - 1];
    old_of_new[i - 1] = old_of_new[j];
    old_of_new[j] = swap;
  }

  g_auto (QnModel) source;
  g_assert_cmpint (qn_model_copy (model, &source, NULL), ==, QN_OK);
  for (size_t i = 0; i < count; i++)
    free (model->blocks[i].name);
  qn_name_index_clear (&model->block_names);
  model->block_count = model->vertex_count = 0;
  for (size_t i = 0; i < count; i++) {
    const QnBlock *from = &source.blocks[old_of_new[i]];
    const QnVec2 *vertices = qn_model_block_vertices (&source, old_of_new[i]);
    g_autofree QnVec2 *turned = g_new (QnVec2, from->vertex_count);
    QnId first = g_rand_int_range (random, 0, from->vertex_count);
    for (QnId v = 0; v < from->vertex_count; v++)
      turned[v] = vertices[(v + first) % from->vertex_count];
    QnBlock *to =
      qn_model_add_block (model, from->name, turned, (size_t) from->vertex_count);
    g_assert_nonnull (to);
    to->thickness = from->thickness;
    to->unit_weight = from->unit_weight;
    to->density = from->density;
    to->law = from->law;
    memcpy (to->support, from->support, sizeof to->support);
    new_of_old[old_of_new[i]] = (QnId) i;
  }

  for (size_t i = 0; i < model->override_count; i++) {
    model->overrides[i].block_a = new_of_old[model->overrides[i].block_a];
    model->overrides[i].block_b = new_of_old[model->overrides[i].block_b];
  }
  for (size_t i = 0; i < model->dead_load_count; i++) {
    if (model->dead_loads[i].kind == QN_LOAD_FORCE)
      model->dead_loads[i].block = new_of_old[model->dead_loads[i].block];
  }
  for (size_t i = 0; i < model->live_load_count; i++) {
    if (model->live_loads[i].kind == QN_LOAD_FORCE)
      model->live_loads[i].block = new_of_old[model->live_loads[i].block];
  }
  if (model->analysis.control.block != QN_NONE)
    model->analysis.control.block = new_of_old[model->analysis.control.block];

  g_free (new_of_old);
  g_free (old_of_new);
}
