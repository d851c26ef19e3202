#include "core/base/memory.h"
#include "support/generate-parts.h"

#include <stdlib.h>

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
  int32_t begin = 0;
  for (int32_t x = 1; x <= raster->width; x++) {
    unsigned char kind = *cell_at (raster, begin, course);
    bool joint = kind == MASONRY && (x + course) % 2 == 0;
    if (x < raster->width && !joint && *cell_at (raster, x, course) == kind)
      continue;
    lengths[count++] = (kind == OPENING ? -0.5 : 0.5) * (x - begin);
    begin = x;
  }
  return count;
}

static QnStatus
check_wall (const QnWallRecipe *recipe, QnDiag *diag)
{
  QnStatus status = qn_generate_check_material (&recipe->material, diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->unit.x, false, "unit", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->unit.y, false, "unit", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->length, false, "length", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->courses, false, "courses", diag);
  if (status == QN_OK)
    status = qn_generate_check (recipe->openings, true, "openings", diag);
  if (status == QN_OK)
    status = qn_generate_check_blocks ((recipe->length + 1.0) * recipe->courses + 1,
                                       "courses", diag);
  return status;
}

static QnStatus
add_courses (QnModel *model, const QnWallRecipe *recipe, const Raster *raster,
             QnDiag *diag)
{
  QnWall *wall = qn_model_add_wall (model, "w");
  double *lengths = qn_alloc ((size_t) raster->width, sizeof *lengths);
  bool done = wall != NULL && lengths != NULL;
  if (done) {
    wall->unit = recipe->unit;
    wall->thickness = recipe->material.thickness;
    wall->unit_weight = recipe->material.unit_weight;
  }
  for (int32_t course = 0; course < raster->height && done; course++)
    done = qn_wall_add_course (wall, lengths, course_lengths (raster, course, lengths));
  free (lengths);
  return done ? QN_OK : qn_diag_no_memory (diag);
}

QnStatus
qn_generate_wall (QnModel *model, const QnWallRecipe *recipe, QnDiag *diag)
{
  QnStatus status = check_wall (recipe, diag);
  if (status != QN_OK)
    return status;

  Raster raster = { .width = 2 * recipe->length, .height = recipe->courses };
  raster.cells = qn_alloc ((size_t) raster.width * (size_t) raster.height, 1);
  if (raster.cells == NULL)
    return qn_diag_no_memory (diag);
  cut_openings (&raster, recipe->openings, recipe->seed);

  double length = recipe->unit.x * recipe->length, depth = recipe->unit.y;
  const QnVec2 base[] = { { 0, -depth }, { length, -depth }, { length, 0 }, { 0, 0 } };
  status = qn_generate_begin (model, &recipe->material, diag);
  if (status == QN_OK)
    status = qn_generate_add_fixed (model, &recipe->material, "base", base, 4, diag);
  if (status == QN_OK)
    status = add_courses (model, recipe, &raster, diag);
  free (raster.cells);
  return status;
}
