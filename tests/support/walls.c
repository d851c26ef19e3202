#include "support/walls.h"

#include "core/contact/contacts.h"
#include "stereotomy/masonry.h"
#include "support/models.h"

#include <math.h>

#define UNIT_WEIGHT 20000 /* N/m3 */

static double
between (GRand *rand, double least, double most)
{
  return g_rand_double_range (rand, least, most);
}

/* From `least` to below `end`. */
static int
whole (GRand *rand, int least, int end)
{
  return g_rand_int_range (rand, least, end);
}

static bool
one_in (GRand *rand, int count)
{
  return whole (rand, 0, count) == 0;
}

/* Evenly distributed powers of ten. */
static double
power_between (GRand *rand, double least, double most)
{
  return pow (10, between (rand, log10 (least), log10 (most)));
}

/* One draw at a time: in which order the arguments of a call are computed is the compiler's choice. */
static QnVec2
place_between (GRand *rand, QnVec2 least, QnVec2 most)
{
  double y = between (rand, least.y, most.y);
  return qn_vec2 (between (rand, least.x, most.x), y);
}

/* ---- without masonry ---- */

/* SplitMix64 (Steele, Lea & Flood, "Fast splittable pseudorandom number generators", 2014), reduced to
 * 0 .. below - 1. */
static int
split (guint64 *state, int below)
{
  guint64 z = *state += G_GUINT64_CONSTANT (0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * G_GUINT64_CONSTANT (0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * G_GUINT64_CONSTANT (0x94d049bb133111eb);
  z ^= z >> 31;
  return (int) (z % (guint64) below);
}

/* Cells of half a block by one course: 0 masonry, 'o' opening, 'l' lintel. Openings keep two cells from
 * the edges, leave two between them and one course below, and have room for a lintel above. */
static void
cut_cells (char *cells, int width, int height, int openings, guint64 seed)
{
  for (gint64 tries = (gint64) openings * 30; tries > 0 && openings > 0; tries--) {
    int w = 2 + split (&seed, 4), h = 2 + split (&seed, 5);
    int x = split (&seed, width), y = split (&seed, height);
    bool free_place = x >= 2 && x + w + 2 <= width && y + h < height;
    for (int j = MAX (y - 1, 0); free_place && j < MIN (y + h + 2, height); j++)
      for (int i = x - 2; i < x + w + 2; i++)
        free_place = free_place && cells[(gsize) j * width + i] == 0;
    if (!free_place)
      continue;
    for (int j = y; j < y + h; j++)
      memset (&cells[(gsize) j * width + x], 'o', w);
    memset (&cells[(gsize) (y + h) * width + x - 1], 'l', w + 2);
    openings--;
  }
}

void
test_bond_init (QnModel *model, QnVec2 unit, int length, int courses, int openings,
                guint64 seed)
{
  int width = 2 * length;
  g_autofree char *cells = g_malloc0 ((gsize) width * courses);
  g_autofree double *lengths = g_new (double, width);

  cut_cells (cells, width, courses, openings, seed);
  test_model_init (model);
  test_model_add_base (model, 0, -unit.y, unit.x * length, unit.y);
  test_model_add_weight_loads (model, 1);
  QnWall *wall = qn_model_add_wall (model, "w");
  wall->unit = unit;
  wall->thickness = 1;
  wall->unit_weight = UNIT_WEIGHT;
  for (int course = 0; course < courses; course++) {
    const char *row = &cells[(gsize) course * width];
    size_t count = 0;
    for (int x = 1, start = 0; x <= width; x++) {
      bool joint = row[start] == 0 && (x + course) % 2 == 0;
      if (x < width && !joint && row[x] == row[start])
        continue;
      lengths[count++] = (row[start] == 'o' ? -0.5 : 0.5) * (x - start);
      start = x;
    }
    g_assert_true (qn_wall_add_course (wall, lengths, count));
  }
}

void
test_arch_init (QnModel *model, double ring, int voussoirs, int segments)
{
  int steps = voussoirs * segments, corners = 2 * segments + 2;
  g_autofree QnVec2 *ends = g_new (QnVec2, corners);

  test_model_init (model);
  test_model_add_base (model, -2, -1, 4, 1);
  test_model_add_weight_loads (model, 1);
  for (int v = 0; v < voussoirs; v++) {
    g_autofree char *name = g_strdup_printf ("v%d", v + 1);
    for (int s = 0; s <= segments; s++) {
      /* From the middle, so that both halves are alike to the last bit. */
      int step = 2 * (v * segments + s) - steps;
      double angle = G_PI_2 * abs (step) / steps;
      QnVec2 out = qn_vec2 (step < 0 ? sin (angle) : -sin (angle), cos (angle));
      ends[s] = qn_vec2_scale (1 + ring / 2, out);
      ends[corners - 1 - s] = qn_vec2_scale (1 - ring / 2, out);
    }
    QnBlock *block = qn_model_add_block (model, name, ends, (size_t) corners);
    block->thickness = 1;
    block->unit_weight = UNIT_WEIGHT;
  }
}

void
test_wall_add_courses (QnWall *wall, GRand *rand, int courses, double length,
                       double least, double last)
{
  for (int course = 0; course < courses; course++) {
    double lengths[16], left = length;
    size_t count = 0;
    while (left > last) {
      lengths[count] = between (rand, least, 1.5);
      left -= lengths[count++];
    }
    lengths[count++] = left;
    g_assert_true (qn_wall_add_course (wall, lengths, count));
  }
}

/* ---- masonry ---- */

/* The model of an object, its blocks like others. */
static QnStatus
expand (const QnMasonry *masonry, QnModel *model, QnDiag *diag)
{
  test_model_init (model);
  QnStatus status = qn_masonry_expand (masonry, 0, model, diag);
  for (size_t i = 0; i < model->block_count; i++)
    model->blocks[i].masonry = QN_NONE;
  return status;
}

/* ---- six families ---- */

typedef enum { SOLID, LINTELS, ARCHES, BONDED, ASHLAR, RUBBLE, FAMILY_COUNT } Family;

const char *
test_wall_family (guint32 seed)
{
  static const char *const names[FAMILY_COUNT] = { "solid",  "lintels", "arches",
                                                   "bonded", "ashlar",  "rubble" };
  return names[seed % FAMILY_COUNT];
}

bool
test_wall_parse_seeds (const char *text, int *first, int *last)
{
  char *end;
  *first = *last = (int) g_ascii_strtoll (text, &end, 10);
  if (*end == '-')
    *last = (int) g_ascii_strtoll (end + 1, NULL, 10);
  return *first >= 1 && *last >= *first;
}

/* Whole units and whole courses, except for rubble. */
static double
to_multiple (double value, double of)
{
  return of * fmax (1, round (value / of));
}

/* Courses from 0.7 to 1.3 units high, blocks from 0.5 to 1.5 units long, in eighths of a unit, so
 * that vertical joints meet or keep clear of each other. */
static void
lay_ashlar (GRand *rand, QnMasonryWall *wall)
{
  QnVec2 unit = wall->leaves[0].unit;
  size_t courses = (size_t) round (wall->height / unit.y);
  int units = (int) round (wall->leaves[0].length / unit.x);
  g_autofree double *lengths = g_new (double, 2 * units);

  wall->course_heights = malloc (courses * sizeof *wall->course_heights);
  wall->course_height_count = courses;
  for (size_t c = 0; c < courses; c++) {
    size_t count = 0;
    wall->course_heights[c] = unit.y * 0.05 * whole (rand, 14, 27);
    for (int left = 8 * units; left > 0;) {
      int next = whole (rand, 4, 13);
      next = left - next < 4 ? left : next;
      lengths[count++] = next / 8.;
      left -= next;
    }
    g_assert_true (qn_wall_add_course (&wall->courses, lengths, count));
  }
}

/* One opening in every bay of every storey, jambs and sills where half units and courses end, voussoirs
 * about as wide as half a unit. */
static void
cut_openings (GRand *rand, QnMasonry *masonry, bool arches, double bay, double storey)
{
  QnVec2 unit = masonry->wall.leaves[0].unit;
  double length = masonry->wall.leaves[0].length, height = masonry->wall.height;
  int bays = (int) fmax (1, round (length / bay));
  int storeys = (int) fmax (1, round (height / storey));

  bay = length / bays;
  storey = height / storeys;
  for (int i = 0; i < storeys; i++)
    for (int k = 0; k < bays; k++) {
      QnOpening *opening = qn_masonry_add_opening (masonry);
      double width = bay * between (rand, 0.3, 0.45), arc;
      double x = bay * k + (bay - width) * between (rand, 0.4, 0.6);
      double sill = storey * (i + between (rand, 0.2, 0.3));
      opening->at.x = to_multiple (x, unit.x / 2);
      opening->at.y = to_multiple (sill, unit.y);
      opening->width = arc = to_multiple (width, unit.x / 2);
      opening->height = to_multiple (storey * between (rand, 0.4, 0.5), unit.y);
      opening->depth = unit.y;
      switch (arches ? whole (rand, 0, 3) : 3) {
      case 0:
        opening->head = QN_HEAD_SEMICIRCULAR;
        opening->span = QN_SPAN_VOUSSOIRS;
        opening->height = fmax (opening->height, 0.75 * opening->width);
        arc *= G_PI_2;
        break;
      case 1:
        opening->head = QN_HEAD_SEGMENTAL;
        opening->span = QN_SPAN_VOUSSOIRS;
        opening->rise = 0.25 * opening->width;
        arc *= 1.16;
        break;
      case 2:
        opening->span = QN_SPAN_FLAT_ARCH;
        opening->depth = 2 * unit.y;
        opening->skew = 0.3;
        break;
      default:
        opening->span = QN_SPAN_LINTEL;
        opening->bearing = unit.x / 2;
      }
      opening->voussoirs = 2 * (int) round (arc / unit.x) + 1;
    }
}

/* What a seed draws, of this height, or where that is 0 of the height that so many blocks should have,
 * which is put there. Returns the friction of the joints. */
static double
lay (guint32 seed, double blocks, double *height, QnMasonry *masonry)
{
  static const double laps[] = { 1. / 2, 1. / 3, 1. / 4 };
  static const QnBond bonds[] = { QN_BOND_ENGLISH, QN_BOND_FLEMISH, QN_BOND_HEADER,
                                  QN_BOND_STACK };
  const guint32 numbers[] = { seed, 1 };
  g_autoptr (GRand) rand = g_rand_new_with_seed (seed);
  g_autoptr (GRand) details = g_rand_new_with_seed_array (numbers, 2);
  Family family = (Family) (seed % FAMILY_COUNT);
  QnMasonryWall *wall = &masonry->wall;

  qn_masonry_init (masonry, family == RUBBLE ? QN_MASONRY_RUBBLE : QN_MASONRY_WALL, "w");
  QnLeaf *leaf = &wall->leaves[0];
  leaf->unit.x = 0.05 * whole (rand, 6, 11);
  leaf->unit.y = leaf->unit.x * between (rand, 0.4, 0.6);
  double proportion = between (rand, 0.6, 1.8); /* length to height */
  double bay = between (rand, 2.6, 3.6), storey = between (rand, 2.8, 3.6);
  double friction = 0.05 * whole (rand, 11, 16);
  masonry->thickness = 0.1 * whole (rand, 3, 7);
  masonry->unit_weight = UNIT_WEIGHT;
  masonry->foundation = 0.5;
  leaf->lap = laps[whole (rand, 0, G_N_ELEMENTS (laps))];
  double irregularity = between (rand, 0.1, 0.5);
  leaf->closer = (QnCloser) whole (rand, 0, QN_CLOSER_COUNT);
  if (family == RUBBLE) { /* stands by itself only if rough and not too steep */
    friction += 0.2;
    proportion = fmax (proportion, 1.2);
  }
  if (*height == 0)
    *height = sqrt (blocks * leaf->unit.x * leaf->unit.y / proportion);
  masonry->rubble = (QnRubble){ .width = proportion * *height,
                                .top = 0.8 * proportion * *height,
                                .height = *height,
                                .stone = leaf->unit.x,
                                .irregularity = irregularity,
                                .seed = seed };
  leaf->bond = family == ASHLAR   ? QN_BOND_CUSTOM
               : family == BONDED ? bonds[seed / FAMILY_COUNT % G_N_ELEMENTS (bonds)]
                                  : QN_BOND_RUNNING;
  leaf->length = to_multiple (proportion * *height, leaf->unit.x);
  wall->height = to_multiple (*height, leaf->unit.y);
  if (family == ASHLAR)
    lay_ashlar (details, wall);
  if (family != SOLID && family != RUBBLE)
    cut_openings (details, masonry, family == ARCHES, bay, storey);
  return friction;
}

void
test_wall_draw_sized (QnModel *model, guint32 seed, int least, int most)
{
  /* Multiples of the golden ratio leave no part of the range empty, whichever seeds follow each other. */
  double part = fmod (seed * 0.61803398874989485, 1), height = 0, ratio, friction;
  double blocks = least * pow ((double) most / least, part);
  QnDiag diag;

  /* The size is corrected by what the last one gave. */
  for (int round = 0;; round++) {
    g_auto (QnMasonry) masonry;
    friction = lay (seed, blocks, &height, &masonry);
    /* Openings that are refused, as where a lintel reaches beyond the wall, are left out. */
    while (expand (&masonry, model, &diag) != QN_OK) {
      g_assert_cmpstr (diag.field, ==, "openings");
      g_assert_cmpuint (diag.sub, <, masonry.wall.opening_count);
      masonry.wall.openings[diag.sub] =
        masonry.wall.openings[--masonry.wall.opening_count];
      qn_model_clear (model);
    }
    ratio = (double) model->block_count / blocks;
    if (round == 6 || fabs (ratio - 1) < 0.03)
      break;
    height /= sqrt (ratio);
    qn_model_clear (model);
  }
  test_model_add_weight_loads (model, 1);
  model->laws[0].kn = model->laws[0].ks = 1e8;
  model->laws[0].friction = friction;
  model->analysis.increments = 10;
  model->analysis.multiplier_tolerance = 1e-3;
  model->title = g_strdup_printf ("Seed %u: %s", seed, test_wall_family (seed));
  if (qn_model_prepare (model, &diag) != QN_OK)
    g_error ("seed %u: problem %d at %d", seed, (int) diag.problem, (int) diag.index);
}

/* ---- extremes ---- */

static void
draw_opening (GRand *rand, QnMasonry *masonry, int index, int count)
{
  QnMasonryWall *wall = &masonry->wall;
  double length = wall->leaves[0].length, height = wall->height, part = length / count;
  QnVec2 unit = wall->leaves[0].unit;
  QnOpening *opening = qn_masonry_add_opening (masonry);

  opening->width = between (rand, 0.3, 0.5) * part;
  opening->height = between (rand, 0.25, 0.45) * height;
  opening->at.y = one_in (rand, 2) ? 0 : between (rand, 0.1, 0.3) * height;
  opening->at.x = part * (index + between (rand, 0.25, 0.75)) - opening->width / 2;
  opening->depth = between (rand, 0.6, 1.2) * unit.y;
  switch (whole (rand, 0, 4)) {
  case 0:
    opening->span = QN_SPAN_LINTEL;
    opening->bearing = between (rand, 0.3, 0.6) * unit.x;
    break;
  case 1:
    opening->span = QN_SPAN_FLAT_ARCH;
    opening->voussoirs = 2 * whole (rand, 1, 4) + 1;
    opening->skew = between (rand, 0.1, 0.4);
    break;
  case 2:
    opening->head = QN_HEAD_SEGMENTAL;
    opening->rise = between (rand, 0.15, 0.4) * opening->width;
    opening->span = QN_SPAN_VOUSSOIRS;
    opening->voussoirs = 2 * whole (rand, 1, 4) + 1;
    opening->sides = one_in (rand, 2) ? QN_SIDES_STRAIGHT : QN_SIDES_CURVED;
    break;
  default: /* the fabric itself is cut and corbels over the opening */
    opening->width = fmin (opening->width, 0.9 * unit.x);
  }
}

static void
draw_bond (GRand *rand, QnMasonry *masonry)
{
  static const QnBond bonds[] = { QN_BOND_RUNNING, QN_BOND_RUNNING, QN_BOND_ENGLISH,
                                  QN_BOND_FLEMISH, QN_BOND_HEADER,  QN_BOND_STACK };
  QnMasonryWall *wall = &masonry->wall;
  QnLeaf *leaf = &wall->leaves[0];

  leaf->bond = bonds[whole (rand, 0, G_N_ELEMENTS (bonds))];
  leaf->unit = place_between (rand, qn_vec2 (0.3, 0.12), qn_vec2 (0.6, 0.3));
  leaf->lap = one_in (rand, 3) ? between (rand, 0.2, 0.45) : 0.5;
  leaf->closer = (QnCloser) whole (rand, 0, QN_CLOSER_COUNT);
  leaf->length = between (rand, 2, 6) * leaf->unit.x;
  wall->height = whole (rand, 4, 12) * leaf->unit.y;
  wall->minimum_piece = 0.25;
  wall->left = one_in (rand, 4) ? QN_EDGE_TOOTHED : QN_EDGE_STRAIGHT;
  int openings = leaf->bond == QN_BOND_STACK ? 0 : whole (rand, 0, 3);
  for (int i = 0; i < openings; i++)
    draw_opening (rand, masonry, i, openings);
}

static void
draw_courses (GRand *rand, QnMasonry *masonry)
{
  QnMasonryWall *wall = &masonry->wall;
  double length = between (rand, 3, 6);
  int courses = whole (rand, 4, 12);

  wall->leaves[0].bond = QN_BOND_CUSTOM;
  wall->leaves[0].unit = place_between (rand, qn_vec2 (0.3, 0.12), qn_vec2 (0.6, 0.3));
  test_wall_add_courses (&wall->courses, rand, courses, length, 0.6, 1.7);
}

static void
draw_rubble (GRand *rand, QnMasonry *masonry)
{
  QnRubble *rubble = &masonry->rubble;

  rubble->stone = between (rand, 0.25, 0.5);
  rubble->width = between (rand, 2, 6) * rubble->stone;
  rubble->top = one_in (rand, 2) ? rubble->width : between (rand, 0.6, 1) * rubble->width;
  rubble->height = between (rand, 2, 7) * rubble->stone;
  rubble->irregularity = between (rand, 0, 1);
  rubble->seed = g_rand_int (rand);
}

static void
draw_arch (GRand *rand, QnMasonry *masonry)
{
  QnArch *arch = &masonry->arch;

  arch->shape = (QnArchShape) whole (rand, 0, QN_ARCH_SHAPE_COUNT);
  arch->span = between (rand, 2, 5);
  arch->rise = arch->span
               * (arch->shape == QN_ARCH_CIRCULAR  ? between (rand, 0.15, 0.5)
                  : arch->shape == QN_ARCH_POINTED ? between (rand, 0.55, 0.9)
                                                   : between (rand, 0.3, 0.6));
  arch->ring = between (rand, 0.1, 0.2) * arch->span;
  arch->voussoirs = whole (rand, 7, 30);
  arch->sides = one_in (rand, 2) ? QN_SIDES_STRAIGHT : QN_SIDES_CURVED;
  arch->springer = one_in (rand, 2) ? 0.3 : 0;
}

static void
draw_portal (GRand *rand, QnMasonry *masonry)
{
  QnPortal *portal = &masonry->portal;

  portal->bays = whole (rand, 1, 4);
  portal->span = between (rand, 1, 2.5);
  portal->pier_width = between (rand, 0.6, 1.2);
  portal->pier_height = between (rand, 1, 3);
  portal->courses = whole (rand, 2, 8);
  if (one_in (rand, 2))
    portal->lintel_height = between (rand, 0.2, 0.5);
  portal->arch.rise = between (rand, 0.2, 0.5) * portal->span;
  portal->arch.ring = 0.45 * portal->pier_width;
  portal->arch.voussoirs = whole (rand, 5, 12);
}

static void
draw_buttress (GRand *rand, QnMasonry *masonry)
{
  QnButtress *buttress = &masonry->buttress;

  buttress->height = between (rand, 2, 6);
  buttress->bottom = between (rand, 0.8, 1.5);
  buttress->top = between (rand, 0.3, 0.8);
  buttress->courses = whole (rand, 8, 40);
  buttress->leans_right = one_in (rand, 2);
}

static void
draw_joints (GRand *rand, QnModel *model)
{
  QnLaw *law = &model->laws[0];
  double weight = UNIT_WEIGHT * 0.4 * 0.2; /* of a common block */

  law->kn = power_between (rand, 1e6, 1e10);
  law->ks = law->kn * power_between (rand, 0.1, 1);
  law->friction = between (rand, 0.3, 1.1);
  if (one_in (rand, 5)) {
    law->cohesion = power_between (rand, 0.01, 1) * weight;
    law->tension = one_in (rand, 2) ? between (rand, 0, 1) * law->cohesion : 0;
  }
  if (one_in (rand, 6)) {
    model->contact.pairs.placement =
      one_in (rand, 2) ? QN_PLACEMENT_UNIFORM : QN_PLACEMENT_GAUSS;
    model->contact.pairs.count = whole (rand, 2, 5);
  }
}

static void
draw_loads (GRand *rand, QnModel *model)
{
  double slope = one_in (rand, 4) ? between (rand, -0.5, 0.5) : 0;

  test_model_add_weight_loads (model, one_in (rand, 2) ? 1 : -1);
  model->live_loads[0].vector.y = slope;
  if (one_in (rand, 6)) {
    QnLoad *load = qn_model_add_live_load (model);
    load->kind = QN_LOAD_FORCE;
    load->block = (QnId) model->block_count - 1 - (QnId) one_in (rand, 2);
    load->vector = place_between (rand, qn_vec2 (-2000, -4000), qn_vec2 (2000, 0));
  }
  model->analysis.increments = 10;
}

/* Whether this is a structure to be analysed, and of the size that is wanted. */
static bool
is_sound (QnModel *model)
{
  g_auto (QnContacts) contacts = { 0 };

  return model->block_count >= TEST_WALL_FEWEST && model->block_count <= TEST_WALL_MOST
         && qn_model_prepare (model, NULL) == QN_OK
         && qn_contacts_detect (model, &contacts, NULL) == QN_OK
         && qn_contacts_require_sound (model, &contacts, NULL) == QN_OK;
}

/* False where the dice fell so that nothing can be laid, or too much. */
static bool
draw (GRand *rand, QnModel *model, char *description, gsize size)
{
  static const char *const bonds[QN_BOND_COUNT] = { "running bond", "stack bond",
                                                    "header bond",  "English bond",
                                                    "Flemish bond", "random courses" };
  static const struct {
    int below; /* of 20 */
    QnMasonryKind kind;
    void (*draw) (GRand *rand, QnMasonry *masonry);
  } kinds[] = {
    { 9, QN_MASONRY_WALL, draw_bond },      { 12, QN_MASONRY_WALL, draw_courses },
    { 17, QN_MASONRY_RUBBLE, draw_rubble }, { 18, QN_MASONRY_ARCH, draw_arch },
    { 19, QN_MASONRY_PORTAL, draw_portal }, { 20, QN_MASONRY_BUTTRESS, draw_buttress }
  };
  double lean = one_in (rand, 4) ? between (rand, -0.15, 0.15) : 0;
  double turn = one_in (rand, 4) ? between (rand, -G_PI, G_PI) : 0;
  g_auto (QnMasonry) masonry;
  int die = whole (rand, 0, 20), k = 0;

  while (die >= kinds[k].below)
    k++;
  qn_masonry_init (&masonry, kinds[k].kind, "w");
  masonry.unit_weight = UNIT_WEIGHT;
  masonry.foundation = 0.3;
  masonry.rotation = lean;
  masonry.law = 0;
  kinds[k].draw (rand, &masonry);
  gsize openings = masonry.wall.opening_count;
  g_snprintf (description, size, "%s%s%s%s",
              masonry.kind == QN_MASONRY_WALL ? bonds[masonry.wall.leaves[0].bond]
                                              : qn_masonry_kind_names[masonry.kind],
              openings == 0   ? ""
              : openings == 1 ? ", 1 opening"
                              : ", 2 openings",
              lean != 0 ? ", leaning" : "", turn != 0 ? ", turned" : "");
  if (expand (&masonry, model, NULL) != QN_OK)
    return false;
  draw_joints (rand, model);
  draw_loads (rand, model);
  if (turn != 0)
    test_model_rotate (model, turn);
  return is_sound (model);
}

void
test_wall_draw_any (QnModel *model, guint32 seed, char *description, gsize size)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (seed);

  for (int attempt = 0; attempt < 100; attempt++) {
    if (draw (rand, model, description, size))
      return;
    qn_model_clear (model);
  }
  g_error ("seed %u: nothing that can be laid in a hundred draws", seed);
}
