#include "core/equilibrium/central-pack-loops.h"

#include "core/linalg/vector-loops.h"

/* --- Numbers side by side --------------------------------------------------------------- */

/* One vector of the numbers of eight pairs. */
PART Vector
take (const double *numbers)
{
  return *(const Vector *) numbers;
}

PART Mask
take_mask (const int64_t *mask)
{
  return *(const Mask *) mask;
}

PART void
put (double *numbers, Vector a)
{
  *(Vector *) numbers = a;
}

PART Vector
chosen (Mask mask, Vector yes, Vector no)
{
  return (Vector) (((Mask) yes & mask) | ((Mask) no & ~mask));
}

PART Vector
only (Mask mask, Vector a)
{
  return (Vector) ((Mask) a & mask);
}

/* The larger of two numbers, the second where the first is none. */
PART Vector
larger (Vector a, Vector b)
{
  return chosen ((Mask) (a > b), a, b);
}

PART Vector
size (Vector a)
{
  return (Vector) ((Mask) a & INT64_MAX);
}

PART double
largest (Vector a)
{
  double result = a[0];

  for (int i = 1; i < LANES; i++)
    result = qn_larger (a[i], result);
  return result;
}

PART double
sum (const QnPackVector a)
{
  return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]));
}

/* Numbers of one pair after the other from those of either direction, and back. */
PART void
put_pairs (Vector n, Vector t, double *out)
{
  put (out, SHUFFLE (n, t, ZIP_LOW));
  put (out + LANES, SHUFFLE (n, t, ZIP_HIGH));
}

PART void
take_pairs (const double *in, Vector *n, Vector *t)
{
  Vector a = take (in), b = take (in + LANES);

  *n = SHUFFLE (a, b, EVEN);
  *t = SHUFFLE (a, b, ODD);
}

/* --- Pairs ------------------------------------------------------------------------------ */

/* What a vector of pairs is made of. Everything that follows takes those from pair `at` of an
 * eight on. */
typedef struct {
  Mask row[QN_CENTRAL_ROWS]; /* which pairs have it */
  Vector friction, dilatancy[2];
} Kind;

PART Kind
kind (const QnCentralPack *e, int at)
{
  Mask shears = take_mask (e->has_shear + at);

  return (Kind){ { take_mask (e->has_tension + at), shears, shears,
                   take_mask (e->has_compression + at) },
                 take (e->friction + at),
                 { take (e->dilatancy[0] + at), take (e->dilatancy[1] + at) } };
}

/* out = G y */
PART void
apply_strength (const Kind *kind, const Vector y[2], Vector out[QN_CENTRAL_ROWS])
{
  out[0] = y[0];
  out[1] = kind->friction * y[0] + y[1];
  out[2] = kind->friction * y[0] - y[1];
  out[3] = -y[0];
}

/* out = flow z */
PART void
apply_flow (const Kind *kind, const Vector z[QN_CENTRAL_ROWS], Vector out[2])
{
  out[0] = z[0] - z[3] + kind->dilatancy[0] * z[1] + kind->dilatancy[1] * z[2];
  out[1] = z[1] - z[2];
}

/* H = 1/k + flow diag (ratio) G, ratio = z / s, inverted; its determinant without the terms that
 * cancel: (d1 r1 + d2 r2) (r1 + r2) - (d1 r1 - d2 r2) (r1 - r2) = 2 (d1 + d2) r1 r2. */
PART void
invert_flexibility (QnCentralPack *e, int at, const Kind *kind,
                    const Vector ratio[QN_CENTRAL_ROWS])
{
  Mask plastic = kind->row[0], shears = kind->row[1];
  Vector sum = ratio[1] + ratio[2], difference = ratio[1] - ratio[2];
  const Vector *dilatancy = kind->dilatancy;
  Vector positive = dilatancy[0] * ratio[1], negative = dilatancy[1] * ratio[2];
  Vector dilation = kind->friction * (positive + negative);
  Vector tangential = take (e->flexibility[1] + at);
  Vector normal = take (e->flexibility[0] + at) + ratio[0] + ratio[3];
  Vector nn = normal + dilation, tt = tangential + sum;
  Vector nt = positive - negative, tn = kind->friction * difference;
  Vector determinant =
    normal * tt + dilation * tangential
    + 2 * kind->friction * (dilatancy[0] + dilatancy[1]) * ratio[1] * ratio[2];
  Vector inverse = 1 / chosen (shears, determinant, normal);
  const Vector found[] = { chosen (shears, tt * inverse, inverse),
                           only (shears, -nt * inverse), only (shears, -tn * inverse),
                           only (shears, nn * inverse) };

  QN_UNROLL
  for (int k = 0; k < 4; k++)
    put (e->inverse[k] + at, chosen (plastic, found[k], take (e->inverse[k] + at)));
}

static QnCentralResiduals
prepare (QnCentralPack *packs, size_t count, const double *elongations, double shrink)
{
  Vector strain = { 0 }, strength = { 0 }, elongation = { 0 }, force = { 0 };
  QnPackVector products = { 0 };

  for (QnCentralPack *e = packs; e < packs + count; e++)
    for (int at = 0; at < QN_CENTRAL_WIDTH; at += LANES, elongations += 2 * LANES) {
      Kind k = kind (e, at);
      Vector q[2], y[2], z[QN_CENTRAL_ROWS], flow[2], used[QN_CENTRAL_ROWS],
        ratio[QN_CENTRAL_ROWS], product = take (products + at);
      const double *const limit[] = { e->tension, e->cohesion, e->cohesion,
                                      e->compression };
      QN_UNROLL
      for (int i = 0; i < 2; i++)
        y[i] = take (e->now.y[i] + at);
      apply_strength (&k, y, used);
      QN_UNROLL
      for (int i = 0; i < QN_CENTRAL_ROWS; i++) {
        Vector s = take (e->now.s[i] + at);
        z[i] = take (e->now.z[i] + at);
        Vector left = only (k.row[i], take (limit[i] + at) - used[i] - s);
        Vector inverse = 1 / s;
        put (e->strength[i] + at, left);
        put (e->inverse_s[i] + at, inverse);
        put (e->inverse_z[i] + at, only (k.row[i], 1 / z[i]));
        ratio[i] = z[i] * inverse;
        strength = larger (size (left), strength);
        product += s * z[i];
      }
      put (products + at, product);
      apply_flow (&k, z, flow);
      take_pairs (elongations, &q[0], &q[1]);
      QN_UNROLL
      for (int i = 0; i < 2; i++) {
        Vector beyond = q[i] * shrink - take (e->plastic[i] + at);
        Vector left =
          only (k.row[i], beyond - flow[i] - take (e->flexibility[i] + at) * y[i]);
        put (e->strain[i] + at, left);
        strain = larger (size (left), strain);
        elongation = larger (only (k.row[0], size (beyond)), elongation);
        force = larger (only (k.row[0], size (y[i])), force);
      }
      invert_flexibility (e, at, &k, ratio);
    }
  return (QnCentralResiduals){ .strain = largest (strain),
                               .strength = largest (strength),
                               .elongation = largest (elongation),
                               .force = largest (force),
                               .products = sum (products) };
}

/* dy = H \ strain */
PART void
apply_tangent (const QnCentralPack *e, int at, const Vector strain[2], Vector dy[2])
{
  QN_UNROLL
  for (int i = 0; i < 2; i++)
    dy[i] = take (e->inverse[2 * i] + at) * strain[0]
            + take (e->inverse[2 * i + 1] + at) * strain[1];
}

/* Target of s z in one row. */
PART Vector
target_product (const QnCentralPack *e, int at, const QnCentralState *step,
                const QnCentralAim *aim, QnCentralTarget target, int row)
{
  if (target == QN_CENTRAL_NOTHING)
    return (Vector){ 0 };

  Vector ds = take (step->s[row] + at), dz = take (step->z[row] + at);
  if (target == QN_CENTRAL_SECOND_ORDER)
    return aim->mean - ds * dz;

  Vector least = aim->mean / aim->spread + (Vector){ 0 },
         most = aim->mean * aim->spread + (Vector){ 0 };
  Vector found = (take (e->now.s[row] + at) + aim->length * ds)
                 * (take (e->now.z[row] + at) + aim->length * dz);
  Vector wanted = chosen ((Mask) (found < least), least, found);
  wanted = chosen ((Mask) (found > most), most, wanted);
  return take (e->product[row] + at) + larger (wanted - found, -most);
}

/* dz = (product - s z - z ds) / s,  ds = gain - G dy: what of it does not depend on dy is free. */
PART void
aim_all (QnCentralPack *packs, const QnCentralState *steps, size_t count,
         const QnCentralAim *aim, QnCentralTarget target, double force, double *forces)
{
  for (QnCentralPack *e = packs; e < packs + count; e++, steps++)
    for (int at = 0; at < QN_CENTRAL_WIDTH; at += LANES, forces += 2 * LANES) {
      Kind k = kind (e, at);
      Vector free_flow[QN_CENTRAL_ROWS], flow[2], free_strain[2], dy[2], found[2];
      QN_UNROLL
      for (int i = 0; i < QN_CENTRAL_ROWS; i++) {
        Vector z = take (e->now.z[i] + at);
        Vector product = only (k.row[i], target_product (e, at, steps, aim, target, i));
        Vector gain = aim->part * take (e->strength[i] + at);
        put (e->product[i] + at, product);
        put (e->gain[i] + at, gain);
        free_flow[i] = (product - z * gain) * take (e->inverse_s[i] + at) - z;
      }
      apply_flow (&k, free_flow, flow);
      QN_UNROLL
      for (int i = 0; i < 2; i++) {
        free_strain[i] = aim->part * take (e->strain[i] + at) - flow[i];
        put (e->free_strain[i] + at, free_strain[i]);
      }
      apply_tangent (e, at, free_strain, dy);
      QN_UNROLL
      for (int i = 0; i < 2; i++)
        found[i] = force * (take (e->now.y[i] + at) + dy[i]);
      put_pairs (found[0], found[1], forces);
    }
}

static void
aim (QnCentralPack *packs, const QnCentralState *steps, size_t count,
     const QnCentralAim *aim, double force, double *forces)
{
  if (aim->target == QN_CENTRAL_NOTHING)
    aim_all (packs, steps, count, aim, QN_CENTRAL_NOTHING, force, forces);
  else if (aim->target == QN_CENTRAL_SECOND_ORDER)
    aim_all (packs, steps, count, aim, QN_CENTRAL_SECOND_ORDER, force, forces);
  else
    aim_all (packs, steps, count, aim, QN_CENTRAL_CENTRE, force, forces);
}

static void
forces (const QnCentralPack *packs, size_t count, double force, double *out)
{
  for (const QnCentralPack *e = packs; e < packs + count; e++)
    for (int at = 0; at < QN_CENTRAL_WIDTH; at += LANES, out += 2 * LANES)
      put_pairs (force * take (e->now.y[0] + at), force * take (e->now.y[1] + at), out);
}

static void
tangents (const QnCentralPack *packs, size_t count, double stiffness, double *out)
{
  for (const QnCentralPack *e = packs; e < packs + count; e++)
    for (int at = 0; at < QN_CENTRAL_WIDTH; at += LANES, out += 4 * LANES) {
      double rows[2][2 * LANES];
      QN_UNROLL
      for (int i = 0; i < 2; i++)
        put_pairs (stiffness * take (e->inverse[2 * i] + at),
                   stiffness * take (e->inverse[2 * i + 1] + at), rows[i]);
      QN_UNROLL
      for (int half = 0; half < 2; half++) {
        Vector n = take (rows[0] + LANES * half), t = take (rows[1] + LANES * half);
        put (out + 2 * LANES * half, SHUFFLE (n, t, ZIP_TWO_LOW));
        put (out + 2 * LANES * half + LANES, SHUFFLE (n, t, ZIP_TWO_HIGH));
      }
    }
}

static QnCentralForecast
complete (const QnCentralPack *packs, size_t count, const double *rates, double shrink,
          QnCentralState *steps)
{
  Vector fastest = { 0 };
  QnPackVector first = { 0 }, second = { 0 };

  for (const QnCentralPack *e = packs; e < packs + count; e++, steps++)
    for (int at = 0; at < QN_CENTRAL_WIDTH; at += LANES, rates += 2 * LANES) {
      Kind k = kind (e, at);
      Vector rate[2], used[QN_CENTRAL_ROWS], dy[2], once = take (first + at),
                                                    twice = take (second + at);
      take_pairs (rates, &rate[0], &rate[1]);
      QN_UNROLL
      for (int i = 0; i < 2; i++)
        rate[i] = rate[i] * shrink + take (e->free_strain[i] + at);
      apply_tangent (e, at, rate, dy);
      apply_strength (&k, dy, used);
      QN_UNROLL
      for (int i = 0; i < QN_CENTRAL_ROWS; i++) {
        Vector z = take (e->now.z[i] + at), inverse = take (e->inverse_s[i] + at);
        Vector ds = only (k.row[i], take (e->gain[i] + at) - used[i]);
        Vector dz = (take (e->product[i] + at) - z * ds) * inverse - z;
        fastest = larger (-ds * inverse, fastest);
        fastest = larger (-dz * take (e->inverse_z[i] + at), fastest);
        once += take (e->now.s[i] + at) * dz + z * ds;
        twice += ds * dz;
        put (steps->s[i] + at, ds);
        put (steps->z[i] + at, dz);
      }
      QN_UNROLL
      for (int i = 0; i < 2; i++)
        put (steps->y[i] + at, only (k.row[0], dy[i]));
      put (first + at, once);
      put (second + at, twice);
    }
  return (QnCentralForecast){ largest (fastest), sum (first), sum (second) };
}

/* now (count) += part * step */
PART void
advance (double *now, const double *step, size_t count, double part)
{
  for (size_t i = 0; i < count; i += LANES)
    put (now + i, take (now + i) + part * take (step + i));
}

static void
go (QnCentralPack *packs, const QnCentralState *steps, size_t count, double part)
{
  for (size_t k = 0; k < count; k++)
    advance ((double *) &packs[k].now, (const double *) &steps[k],
             sizeof *steps / sizeof (double), part);
}

const QnCentralLoops WITH_WIDTH (qn_central_loops) = { prepare,  aim,      forces,
                                                       tangents, complete, go };
