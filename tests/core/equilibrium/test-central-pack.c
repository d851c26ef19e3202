#include "core/equilibrium/central-pack.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Of the residuals, to be taken off by the last direction. */
#define PART 0.9

/* Pairs of all kinds, in as many packs as leave room for every mixture. */
enum { COUNT = 20, PAIRS = QN_CENTRAL_WIDTH * COUNT };

typedef struct {
  QnCentralPack packs[COUNT];
  QnCentralState steps[COUNT];
  double elongations[2 * PAIRS], rates[2 * PAIRS], forces[2 * PAIRS], tangents[4 * PAIRS];
  QnCentralResiduals residuals;
  QnCentralForecast reach;
} Case;

static void
fill_pair (QnCentralPack *e, int i, GRand *random)
{
  /* Another law; a limit of tension alone; friction too; cohesion too; compression too. */
  int kind = g_rand_int_range (random, 0, 6);

  for (int row = 0; row < QN_CENTRAL_ROWS; row++)
    e->now.s[row][i] = 1;
  for (int k = 0; k < 2; k++)
    e->now.y[k][i] = g_rand_double_range (random, -2, 0);
  if (kind == 0) {
    for (int k = 0; k < 4; k++)
      e->inverse[k][i] = g_rand_double_range (random, -1, 1);
    return;
  }
  bool crushes = kind > 3, shears = kind > 1 && kind < 5;
  const bool has[QN_CENTRAL_ROWS] = { true, shears, shears, crushes };
  e->has_tension[i] = -1;
  e->has_shear[i] = shears ? -1 : 0;
  e->has_compression[i] = crushes ? -1 : 0;
  e->friction[i] = shears ? g_rand_double_range (random, 0.1, 1) : 0;
  for (int k = 0; k < 2; k++)
    e->dilatancy[k][i] = e->friction[i] * g_rand_double_range (random, -1, 1);
  e->tension[i] = g_rand_double_range (random, 0, 1);
  e->compression[i] = crushes ? g_rand_double_range (random, 1, 3) : 0;
  e->cohesion[i] = shears && kind > 2 ? 0.3 : 0;
  for (int k = 0; k < 2; k++) {
    e->flexibility[k][i] = g_rand_double_range (random, 0.5, 2);
    e->plastic[k][i] = g_rand_double_range (random, -0.1, 0.1);
  }
  for (int row = 0; row < QN_CENTRAL_ROWS; row++) {
    if (!has[row])
      continue;
    e->now.s[row][i] = g_rand_double_range (random, 0.1, 1);
    e->now.z[row][i] = g_rand_double_range (random, 0.1, 1);
  }
}

static void
case_init (Case *c)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (31);

  memset (c, 0, sizeof *c);
  for (int p = 0; p < PAIRS; p++)
    fill_pair (&c->packs[p / QN_CENTRAL_WIDTH], p % QN_CENTRAL_WIDTH, random);
  for (int k = 0; k < 2 * PAIRS; k++) {
    c->elongations[k] = g_rand_double_range (random, -1, 1);
    c->rates[k] = g_rand_double_range (random, -1, 1);
  }
}

/* A predictor, a corrector and a centrality corrector, half of which is gone. */
static void
run (Case *c, const QnCentralLoops *loops)
{
  const QnCentralAim aims[] = {
    { .target = QN_CENTRAL_NOTHING, .part = 1 },
    { .target = QN_CENTRAL_SECOND_ORDER, .part = PART, .mean = 0.1 },
    { .target = QN_CENTRAL_CENTRE,
      .part = PART,
      .mean = 0.1,
      .length = 0.7,
      .spread = 10 },
  };

  c->residuals = loops->prepare (c->packs, COUNT, c->elongations, 0.5);
  loops->tangents (c->packs, COUNT, 3, c->tangents);
  for (size_t k = 0; k < G_N_ELEMENTS (aims); k++) {
    loops->aim (c->packs, c->steps, COUNT, &aims[k], 2, c->forces);
    c->reach = loops->complete (c->packs, COUNT, c->rates, 0.5, c->steps);
  }
}

static void
test_processors (void)
{
  static Case one, other;
  const int widths[] = { 4, 8 };

  for (size_t w = 0; w < G_N_ELEMENTS (widths); w++) {
    case_init (&one);
    case_init (&other);
    run (&one, qn_central_loops (2));
    run (&other, qn_central_loops (widths[w]));
    g_assert_cmpmem (&one, sizeof one, &other, sizeof other);
    qn_central_loops (2)->go (one.packs, one.steps, COUNT, 0.5);
    qn_central_loops (widths[w])->go (other.packs, other.steps, COUNT, 0.5);
    qn_central_loops (2)->forces (one.packs, COUNT, 2, one.forces);
    qn_central_loops (widths[w])->forces (other.packs, COUNT, 2, other.forces);
    g_assert_cmpmem (&one, sizeof one, &other, sizeof other);
  }
}

#define assert_near(a, b) g_assert_cmpfloat (fabs ((a) - (b)), <, 1e-10)

/* The direction of one pair meets the linear equations it is to meet, and takes its part off the
 * residuals. */
static void
check_direction (const Case *c, int p)
{
  const QnCentralPack *e = &c->packs[p / QN_CENTRAL_WIDTH];
  const QnCentralState *d = &c->steps[p / QN_CENTRAL_WIDTH];
  int i = p % QN_CENTRAL_WIDTH;
  const bool has[] = { true, e->has_shear[i], e->has_shear[i], e->has_compression[i] };
  double mu = e->friction[i];
  const double psi[2] = { e->dilatancy[0][i], e->dilatancy[1][i] };
  const double y[2] = { e->now.y[0][i], e->now.y[1][i] };
  const double dy[2] = { d->y[0][i], d->y[1][i] };
  const double limit[] = { e->tension[i], e->cohesion[i], e->cohesion[i],
                           e->compression[i] };
  const double used[] = { y[0], mu * y[0] + y[1], mu * y[0] - y[1], -y[0] };
  const double more[] = { dy[0], mu * dy[0] + dy[1], mu * dy[0] - dy[1], -dy[0] };
  double z[QN_CENTRAL_ROWS];

  for (int row = 0; row < QN_CENTRAL_ROWS; row++) {
    double s = e->now.s[row][i], ds = d->s[row][i], dz = d->z[row][i];
    z[row] = e->now.z[row][i] + dz;
    if (!has[row]) {
      g_assert_cmpfloat (ds, ==, 0);
      g_assert_cmpfloat (z[row], ==, 0);
      continue;
    }
    assert_near (used[row] + more[row] + s + ds + (1 - PART) * e->strength[row][i],
                 limit[row]);
    assert_near (s * e->now.z[row][i] + e->now.z[row][i] * ds + s * dz,
                 e->product[row][i]);
    g_assert_cmpfloat (s + ds / c->reach.boundary, >=, -1e-12);
    g_assert_cmpfloat (e->now.z[row][i] + dz / c->reach.boundary, >=, -1e-12);
  }
  const double flow[2] = { z[0] - z[3] + psi[0] * z[1] + psi[1] * z[2], z[1] - z[2] };
  for (int k = 0; k < (e->has_shear[i] ? 2 : 1); k++)
    assert_near (0.5 * (c->elongations[2 * p + k] + c->rates[2 * p + k]),
                 e->plastic[k][i] + flow[k] + e->flexibility[k][i] * (y[k] + dy[k])
                   + (1 - PART) * e->strain[k][i]);
  if (!e->has_shear[i])
    g_assert_cmpfloat (dy[1], ==, 0);
}

static void
test_direction (void)
{
  static Case c;
  double products = 0, after = 0;

  case_init (&c);
  run (&c, qn_central_loops (QN_CENTRAL_WIDTH));
  for (int p = 0; p < PAIRS; p++) {
    const QnCentralPack *e = &c.packs[p / QN_CENTRAL_WIDTH];
    const QnCentralState *d = &c.steps[p / QN_CENTRAL_WIDTH];
    int i = p % QN_CENTRAL_WIDTH;
    for (int k = 0; k < 4; k++)
      g_assert_cmpfloat (c.tangents[4 * p + k], ==, 3 * e->inverse[k][i]);
    if (e->has_tension[i])
      check_direction (&c, p);
    else
      for (int k = 0; k < 2; k++) {
        g_assert_cmpfloat (c.forces[2 * p + k], ==, 2 * e->now.y[k][i]);
        g_assert_cmpfloat (d->y[k][i], ==, 0);
      }
    for (int row = 0; row < QN_CENTRAL_ROWS; row++) {
      double s = e->now.s[row][i], z = e->now.z[row][i];
      products += s * z;
      after += (s + 0.3 * d->s[row][i]) * (z + 0.3 * d->z[row][i]);
    }
  }
  assert_near (c.residuals.products, products);
  assert_near (products + 0.3 * c.reach.first + 0.09 * c.reach.second, after);
}

QN_TESTS
{
  g_test_add_func ("/central-pack/processors", test_processors);
  g_test_add_func ("/central-pack/direction", test_direction);
}
