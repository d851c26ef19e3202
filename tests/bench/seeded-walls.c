#include "bench/seeded-walls.h"

#include "io/project/project-masonry.h"
#include "support/auto-clear.h"

#include <cjson/cJSON.h>
#include <math.h>

/* Blocks may differ from what was asked for by this part. */
#define COUNT_TOLERANCE 0.03

/* How often the size is corrected by what the last one gave. */
#define COUNT_ROUNDS 6

typedef enum { SOLID, LINTELS, ARCHES, BONDED, ASHLAR, RUBBLE, FAMILY_COUNT } Family;

/* What is drawn once for a wall; the size follows from the number of blocks. */
typedef struct Recipe {
  guint32 seed;
  Family family;
  double blocks;      /* wanted */
  QnVec2 unit;        /* m */
  double proportion;  /* length to height */
  double bay, storey; /* m, of façades */
  double friction, thickness;
  QnBond bond;
  double lap;
  QnCloser closer;
  double irregularity; /* of rubble */
} Recipe;

static Family
family_of (guint32 seed)
{
  return (Family) (seed % FAMILY_COUNT);
}

const char *
seeded_wall_family (guint32 seed)
{
  static const char *const names[FAMILY_COUNT] = { "solid",  "lintels", "arches",
                                                   "bonded", "ashlar",  "rubble" };
  return names[family_of (seed)];
}

/* Multiples of the golden ratio leave no part of the range empty, whichever seeds follow each
 * other. */
static double
spread (guint32 seed, double least, double most)
{
  double part = fmod (seed * 0.61803398874989485, 1);
  return least * pow (most / least, part);
}

static Recipe
draw_recipe (guint32 seed, int least, int most)
{
  static const double laps[] = { 1. / 2, 1. / 3, 1. / 4 };
  static const QnBond bonds[] = { QN_BOND_ENGLISH, QN_BOND_FLEMISH, QN_BOND_HEADER,
                                  QN_BOND_STACK };
  g_autoptr (GRand) rand = g_rand_new_with_seed (seed);
  Recipe r = { .seed = seed, .family = family_of (seed) };
  r.blocks = spread (seed, least, most);
  r.unit.x = 0.05 * g_rand_int_range (rand, 6, 11);
  r.unit.y = r.unit.x * g_rand_double_range (rand, 0.4, 0.6);
  r.proportion = g_rand_double_range (rand, 0.6, 1.8);
  r.bay = g_rand_double_range (rand, 2.6, 3.6);
  r.storey = g_rand_double_range (rand, 2.8, 3.6);
  r.friction = 0.05 * g_rand_int_range (rand, 11, 16);
  r.thickness = 0.1 * g_rand_int_range (rand, 3, 7);
  r.lap = laps[g_rand_int_range (rand, 0, G_N_ELEMENTS (laps))];
  r.irregularity = g_rand_double_range (rand, 0.1, 0.5);
  r.closer = (QnCloser) g_rand_int_range (rand, 0, QN_CLOSER_COUNT);
  r.bond = QN_BOND_RUNNING;
  if (r.family == RUBBLE) { /* stands by itself only if rough and not too steep */
    r.friction += 0.2;
    r.proportion = fmax (r.proportion, 1.2);
  }
  if (r.family == BONDED)
    r.bond = bonds[seed / FAMILY_COUNT % G_N_ELEMENTS (bonds)];
  return r;
}

/* Whole units and whole courses, except for rubble. */
static double
to_multiple (double value, double of)
{
  return of * fmax (1, round (value / of));
}

static void
lay_rubble (const Recipe *r, double height, QnMasonry *masonry)
{
  masonry->rubble = (QnRubble){ .width = r->proportion * height,
                                .top = 0.8 * r->proportion * height,
                                .height = height,
                                .stone = r->unit.x,
                                .irregularity = r->irregularity,
                                .seed = r->seed };
}

/* Courses from 0.7 to 1.3 units high, blocks from 0.5 to 1.5 units long, in eighths of a unit, so
 * that vertical joints meet or keep clear of each other. */
static void
lay_ashlar (const Recipe *r, GRand *rand, double length, double height,
            QnMasonry *masonry)
{
  enum { EIGHTHS = 8 };
  QnMasonryWall *wall = &masonry->wall;
  int eighths = EIGHTHS * (int) round (length / r->unit.x);
  size_t courses = (size_t) round (height / r->unit.y);
  g_autofree double *lengths = g_new (double, eighths);

  wall->course_heights = malloc (courses * sizeof *wall->course_heights);
  g_assert_nonnull (wall->course_heights);
  wall->course_height_count = courses;
  for (size_t c = 0; c < courses; c++) {
    size_t count = 0;
    int left = eighths;
    wall->course_heights[c] = r->unit.y * 0.05 * g_rand_int_range (rand, 14, 27);
    while (left > 0) {
      int next = g_rand_int_range (rand, EIGHTHS / 2, EIGHTHS * 3 / 2 + 1);
      next = left - next < EIGHTHS / 2 ? left : next;
      lengths[count++] = (double) next / EIGHTHS;
      left -= next;
    }
    g_assert_true (qn_wall_add_course (&wall->courses, lengths, count));
  }
}

/* Odd, stones about as wide as half a unit. */
static int32_t
voussoirs_along (const Recipe *r, double length)
{
  return 2 * (int32_t) round (length / r->unit.x) + 1;
}

static void
span_opening (const Recipe *r, GRand *rand, QnOpening *opening)
{
  int kind = r->family == ARCHES ? g_rand_int_range (rand, 0, 3) : 3;
  opening->depth = r->unit.y;
  switch (kind) {
  case 0:
    opening->head = QN_HEAD_SEMICIRCULAR;
    opening->span = QN_SPAN_VOUSSOIRS;
    opening->height = fmax (opening->height, 0.75 * opening->width);
    opening->voussoirs = voussoirs_along (r, G_PI_2 * opening->width);
    break;
  case 1:
    opening->head = QN_HEAD_SEGMENTAL;
    opening->span = QN_SPAN_VOUSSOIRS;
    opening->rise = 0.25 * opening->width;
    opening->voussoirs = voussoirs_along (r, 1.16 * opening->width);
    break;
  case 2:
    opening->span = QN_SPAN_FLAT_ARCH;
    opening->depth = 2 * r->unit.y;
    opening->voussoirs = voussoirs_along (r, opening->width);
    opening->skew = 0.3;
    break;
  default:
    opening->span = QN_SPAN_LINTEL;
    opening->bearing = r->unit.x / 2;
    break;
  }
}

/* One opening in every bay of every storey, jambs and sills where half units and courses end. */
static void
cut_openings (const Recipe *r, GRand *rand, double length, double height,
              QnMasonry *masonry)
{
  int bays = (int) fmax (1, round (length / r->bay));
  int storeys = (int) fmax (1, round (height / r->storey));
  double bay = length / bays, storey = height / storeys;

  for (int i = 0; i < storeys; i++)
    for (int k = 0; k < bays; k++) {
      QnOpening *opening = qn_masonry_add_opening (masonry);
      g_assert_nonnull (opening);
      double width = bay * g_rand_double_range (rand, 0.3, 0.45);
      double x = bay * k + (bay - width) * g_rand_double_range (rand, 0.4, 0.6);
      double sill = storey * (i + g_rand_double_range (rand, 0.2, 0.3));
      opening->at.x = to_multiple (x, r->unit.x / 2);
      opening->at.y = to_multiple (sill, r->unit.y);
      opening->width = to_multiple (width, r->unit.x / 2);
      opening->height =
        to_multiple (storey * g_rand_double_range (rand, 0.4, 0.5), r->unit.y);
      span_opening (r, rand, opening);
    }
}

/* A wall of this height. */
static void
lay (const Recipe *r, double height, QnMasonry *masonry)
{
  /* From the start for each size, so that only the size differs. */
  const guint32 numbers[] = { r->seed, 1 };
  g_autoptr (GRand) rand = g_rand_new_with_seed_array (numbers, G_N_ELEMENTS (numbers));
  QnMasonryKind kind = r->family == RUBBLE ? QN_MASONRY_RUBBLE : QN_MASONRY_WALL;

  qn_masonry_init (masonry, kind, "w");
  masonry->thickness = r->thickness;
  masonry->unit_weight = 20000;
  masonry->foundation = 0.5;
  if (kind == QN_MASONRY_RUBBLE) {
    lay_rubble (r, height, masonry);
  } else {
    QnLeaf *leaf = &masonry->wall.leaves[0];
    leaf->unit = r->unit;
    leaf->lap = r->lap;
    leaf->bond = r->family == ASHLAR ? QN_BOND_CUSTOM : r->bond;
    leaf->closer = r->closer;
    leaf->length = to_multiple (r->proportion * height, r->unit.x);
    masonry->wall.height = to_multiple (height, r->unit.y);
    if (r->family == ASHLAR)
      lay_ashlar (r, rand, leaf->length, masonry->wall.height, masonry);
    if (r->family != SOLID)
      cut_openings (r, rand, leaf->length, masonry->wall.height, masonry);
  }
}

/* Openings that are refused, as where a lintel reaches beyond the wall, are left out. */
static size_t
count_blocks (QnMasonry *masonry)
{
  QnMasonryWall *wall = &masonry->wall;
  for (;;) {
    g_auto (QnModel) model;
    QnDiag diag;
    qn_model_init (&model);
    QnStatus status = qn_masonry_expand (masonry, 0, &model, &diag);
    size_t count = model.block_count;
    if (status == QN_OK)
      return count;
    g_assert_cmpstr (diag.field, ==, "openings");
    g_assert_cmpuint (diag.sub, <, wall->opening_count);
    free (wall->openings[diag.sub].name);
    wall->openings[diag.sub] = wall->openings[--wall->opening_count];
  }
}

/* The masonry with as many blocks as the recipe wants. */
static void
lay_to_count (const Recipe *r, QnMasonry *masonry)
{
  double height = sqrt (r->blocks * r->unit.x * r->unit.y / r->proportion);
  for (int round = 0;; round++) {
    lay (r, height, masonry);
    double ratio = (double) count_blocks (masonry) / r->blocks;
    if (round == COUNT_ROUNDS || fabs (ratio - 1) < COUNT_TOLERANCE)
      return;
    height /= sqrt (ratio);
    qn_masonry_clear (masonry);
  }
}

static void
set_up_model (const Recipe *r, QnModel *model)
{
  QnLaw *law = qn_model_add_law (model, "joint");
  law->kind = QN_LAW_COULOMB;
  law->basis = QN_BASIS_CONTACT;
  law->kn = law->ks = 1e8;
  law->friction = r->friction;
  model->contact.law = 0;
  QnLoad *load = qn_model_add_dead_load (model);
  load->kind = QN_LOAD_WEIGHT;
  load->vector = qn_vec2 (0, -1);
  load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_WEIGHT;
  load->vector = qn_vec2 (1, 0);
  model->analysis.increments = 10;
  model->analysis.multiplier_tolerance = 1e-3;
}

/* The blocks of the masonry, and its parameters, which are written to a file in their place. */
static bool
add_masonry (QnProject *project, const QnMasonry *masonry, QnDiag *diag)
{
  QnModel *model = &project->model;
  g_autoptr (GString) json = g_string_new (NULL);
  if (qn_masonry_expand (masonry, 0, model, diag) != QN_OK)
    return false;
  for (size_t i = 0; i < model->block_count; i++)
    model->blocks[i].masonry = 0;
  qn_masonry_append_json (json, masonry, model);
  project->extras = cJSON_CreateObject ();
  return cJSON_AddItemToArray (
    cJSON_AddArrayToObject (project->extras, QN_MASONRY_MEMBER), cJSON_Parse (json->str));
}

void
seeded_wall_init (QnProject *project, guint32 seed, int least, int most)
{
  Recipe recipe = draw_recipe (seed, least, most);
  QnDiag diag = { 0 };
  QnMasonry masonry;

  qn_project_init (project);
  set_up_model (&recipe, &project->model);
  lay_to_count (&recipe, &masonry);
  if (!add_masonry (project, &masonry, &diag))
    g_error ("seed %u: problem %d", seed, (int) diag.problem);
  qn_masonry_clear (&masonry);
  g_free (project->model.title);
  project->model.title = g_strdup_printf ("Seed %u: %s", seed, seeded_wall_family (seed));
  if (qn_model_prepare (&project->model, &diag) != QN_OK)
    g_error ("seed %u: problem %d at %d", seed, (int) diag.problem, (int) diag.index);
}

gboolean
seeded_wall_parse_range (const char *text, int *first, int *last)
{
  char *end;
  *first = *last = (int) g_ascii_strtoll (text, &end, 10);
  if (*end == '-')
    *last = (int) g_ascii_strtoll (end + 1, NULL, 10);
  return *first >= 1 && *last >= *first;
}
