#include "support/generate.h"

#include <glib.h>

static const QnGenerateMaterial default_material = {
  .thickness = 1, .unit_weight = 20000, .stiffness = 1e7, .friction = 0.65
};

QnWallRecipe
qn_wall_recipe_default (void)
{
  return (QnWallRecipe){ .material = default_material,
                         .unit = { 0.4, 0.175 },
                         .length = 8,
                         .courses = 10,
                         .openings = 0,
                         .seed = 1 };
}

QnArchRecipe
qn_arch_recipe_default (void)
{
  return (QnArchRecipe){ .material = default_material,
                         .radius = 1,
                         .ring = 0.15,
                         .embrace = G_PI,
                         .count = 27,
                         .segments = 1 };
}

/* The law and the loads. */
static void
begin (QnModel *model, const QnGenerateMaterial *material)
{
  QnLaw *law = qn_model_add_law (model, "joint");
  QnLoad *dead = qn_model_add_dead_load (model), *live = qn_model_add_live_load (model);
  g_assert_true (law != NULL && dead != NULL && live != NULL);
  law->kind = QN_LAW_COULOMB;
  law->basis = QN_BASIS_CONTACT;
  law->kn = law->ks = material->stiffness;
  law->friction = material->friction;
  model->contact.law = (QnId) model->law_count - 1;
  dead->kind = live->kind = QN_LOAD_WEIGHT;
  dead->vector = qn_vec2 (0, -1);
  live->vector = qn_vec2 (1, 0);
}

static void
add (QnModel *model, const QnGenerateMaterial *material, const char *name,
     const QnVec2 *vertices, size_t count, bool fixed)
{
  QnBlock *block = qn_model_add_block (model, name, vertices, count);
  g_assert_nonnull (block);
  block->thickness = material->thickness;
  block->unit_weight = material->unit_weight;
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    block->support[dof] = fixed;
}

/* ---- walls ---- */

/* The wall as a raster of cells, half a block long and one course high. */
typedef enum { MASONRY, OPENING, LINTEL } Cell;

typedef struct {
  unsigned char *cells; /* course by course */
  int32_t width, height;
} Raster;

static unsigned char *
cell_at (const Raster *raster, int32_t x, int32_t course)
{
  return &raster->cells[(size_t) course * (size_t) raster->width + (size_t) x];
}

/* SplitMix64 (Steele, Lea & Flood, "Fast splittable pseudorandom number generators", 2014),
 * reduced to 0 .. below - 1. */
static int32_t
draw (uint64_t *state, int32_t below)
{
  uint64_t z = *state += UINT64_C (0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C (0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C (0x94d049bb133111eb);
  z ^= z >> 31;
  return (int32_t) (z % (uint64_t) below);
}

static bool
is_masonry (const Raster *raster, int32_t x0, int32_t x1, int32_t course0,
            int32_t course1)
{
  for (int32_t course = course0 > 0 ? course0 : 0;
       course < course1 && course < raster->height; course++) {
    for (int32_t x = x0; x < x1; x++) {
      if (*cell_at (raster, x, course) != MASONRY)
        return false;
    }
  }
  return true;
}

/* Cuts an opening of `width` x `height` cells with a lintel above where there is room for it:
 * a sill or the base below, piers of three cells between openings, two at the edges. */
static bool
try_opening (Raster *raster, int32_t x, int32_t course, int32_t width, int32_t height)
{
  if (x < 2 || x + width + 2 > raster->width || course + height >= raster->height
      || !is_masonry (raster, x - 2, x + width + 2, course - 1, course + height + 2))
    return false;

  for (int32_t c = course; c < course + height; c++) {
    for (int32_t i = x; i < x + width; i++)
      *cell_at (raster, i, c) = OPENING;
  }
  for (int32_t i = x - 1; i < x + width + 1; i++)
    *cell_at (raster, i, course + height) = LINTEL;
  return true;
}

static void
cut_openings (Raster *raster, int32_t wanted, uint64_t seed)
{
  enum { TRIES_PER_OPENING = 30 };
  int64_t tries = (int64_t) wanted * TRIES_PER_OPENING;
  for (int64_t i = 0; i < tries && wanted > 0; i++) {
    int32_t width = 2 + draw (&seed, 4), height = 2 + draw (&seed, 5);
    int32_t x = draw (&seed, raster->width), course = draw (&seed, raster->height);
    if (try_opening (raster, x, course, width, height))
      wanted--;
  }
}

/* Lengths of one course in full blocks; masonry is cut in running bond. */
static size_t
course_lengths (const Raster *raster, int32_t course, double *lengths)
{
  size_t count = 0;
  int32_t start = 0;
  for (int32_t x = 1; x <= raster->width; x++) {
    unsigned char kind = *cell_at (raster, start, course);
    bool joint = kind == MASONRY && (x + course) % 2 == 0;
    if (x < raster->width && !joint && *cell_at (raster, x, course) == kind)
      continue;
    lengths[count++] = (kind == OPENING ? -0.5 : 0.5) * (x - start);
    start = x;
  }
  return count;
}

void
qn_generate_wall (QnModel *model, const QnWallRecipe *recipe)
{
  Raster raster = { .width = 2 * recipe->length, .height = recipe->courses };
  g_autofree unsigned char *cells =
    g_malloc0 ((gsize) raster.width * (gsize) raster.height);
  g_autofree double *lengths = g_new (double, raster.width);
  raster.cells = cells;
  cut_openings (&raster, recipe->openings, recipe->seed);

  double length = recipe->unit.x * recipe->length, depth = recipe->unit.y;
  const QnVec2 base[] = { { 0, -depth }, { length, -depth }, { length, 0 }, { 0, 0 } };
  begin (model, &recipe->material);
  add (model, &recipe->material, "base", base, 4, true);
  QnWall *wall = qn_model_add_wall (model, "w");
  g_assert_nonnull (wall);
  wall->unit = recipe->unit;
  wall->thickness = recipe->material.thickness;
  wall->unit_weight = recipe->material.unit_weight;
  for (int32_t course = 0; course < raster.height; course++)
    g_assert_true (
      qn_wall_add_course (wall, lengths, course_lengths (&raster, course, lengths)));
}

/* ---- arches ---- */

/* Point of the ring at a share of the embrace, 0 at the right springing and 1 at the left one.
 * Equal shares from both sides give mirrored points to the last bit. */
static QnVec2
ring_point (const QnArchRecipe *recipe, double radius, int32_t step, int32_t steps)
{
  int32_t from_middle = 2 * step - steps;
  double angle = recipe->embrace * abs (from_middle) / (2.0 * steps);
  double x = radius * sin (angle);
  return qn_vec2 (from_middle < 0 ? x : -x, radius * cos (angle));
}

/* A fixed block behind a springing: the radial joint and the same moved backwards. */
static void
add_springer (QnModel *model, const QnArchRecipe *recipe, bool right)
{
  double inner = recipe->radius - recipe->ring / 2,
         outer = recipe->radius + recipe->ring / 2;
  QnVec2 p = ring_point (recipe, inner, right ? 0 : 1, 1);
  QnVec2 q = ring_point (recipe, outer, right ? 0 : 1, 1);
  QnVec2 out = qn_vec2_scale (1 / recipe->ring, qn_vec2_sub (q, p));
  QnVec2 back = right ? qn_vec2 (out.y, -out.x) : qn_vec2 (-out.y, out.x);
  QnVec2 shift = qn_vec2_scale (recipe->ring, back);
  const QnVec2 vertices[] = { p, q, qn_vec2_add (q, shift), qn_vec2_add (p, shift) };
  add (model, &recipe->material, right ? "right springer" : "left springer", vertices, 4,
       true);
}

void
qn_generate_arch (QnModel *model, const QnArchRecipe *recipe)
{
  int32_t segments = recipe->segments, steps = recipe->count * segments;
  double inner = recipe->radius - recipe->ring / 2,
         outer = recipe->radius + recipe->ring / 2;
  size_t vertex_count = 2 * ((size_t) segments + 1);
  g_autofree QnVec2 *vertices = g_new (QnVec2, vertex_count);

  begin (model, &recipe->material);
  add_springer (model, recipe, true);
  for (int32_t i = 0; i < recipe->count; i++) {
    for (int32_t s = 0; s <= segments; s++) {
      int32_t step = i * segments + s;
      vertices[s] = ring_point (recipe, outer, step, steps);
      vertices[vertex_count - 1 - (size_t) s] = ring_point (recipe, inner, step, steps);
    }
    g_autofree char *name = g_strdup_printf ("v%d", i + 1);
    add (model, &recipe->material, name, vertices, vertex_count, false);
  }
  add_springer (model, recipe, false);
}
