/* Loops over the contact faces: elongations, forces, tangents; and the tangent of the structure. */
#include "core/assembly/assembly-parts.h"

#include "core/base/tolerance.h"

#include <math.h>
#include <string.h>

/* A joint without a bond is closed where this part of the largest force presses it together; less is what
 * is left of an iteration. */
#define TOUCH 1e-6

void
qn_assembly_gather (const QnAssembly *as, size_t face, const double *u,
                    double v[QN_FACE_UNKNOWNS])
{
  const int32_t *unknowns = as->face_unknowns + QN_FACE_UNKNOWNS * face;

  for (int i = 0; i < QN_FACE_UNKNOWNS; i++)
    v[i] = unknowns[i] == QN_NONE ? 0 : u[unknowns[i]];
}

void
qn_assembly_move_faces (QnAssembly *as, const double *u)
{
  if (as->nonlinear) {
    for (size_t f = 0; f < as->contacts->face_count; f++) {
      double v[QN_FACE_UNKNOWNS];

      int32_t first = as->first_pairs[f], end = as->first_pairs[f + 1];

      qn_assembly_gather (as, f, u, v);
      qn_pair_kinematics_update (as->kinematics + first, end - first, v);
      for (int32_t p = first; p < end; p++) {
        const QnPairKinematics *pair = &as->kinematics[p];
        as->gradients[p] = qn_pair_kinematics_gradient (pair);
        memcpy (as->elongations + 2 * p, pair->elongation, sizeof pair->elongation);
      }
    }
  } else
    qn_assembly_elongation_rates (as, u, as->elongations);
}

/* rate = gradient * motion: in linear geometry, where the gradient is constant, the elongation at v. */
void
qn_assembly_elongation_rates (const QnAssembly *as, const double *v, double *rates)
{
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    double v_face[QN_FACE_UNKNOWNS];

    qn_assembly_gather (as, f, v, v_face);
    const double *a = v_face, *b = v_face + QN_DOF_COUNT;
    const double motion[QN_PAIR_FACTORS] = { a[2], b[0] - a[0], b[1] - a[1], b[2] };
    for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++)
      for (int i = 0; i < 2; i++) {
        const double *g = as->gradients[p].factors[i];
        rates[2 * p + i] =
          g[0] * motion[0] + g[1] * motion[1] + g[2] * motion[2] + g[3] * motion[3];
      }
  }
}

/* The factor that each unknown of a face enters by, and its sign. */
static const struct {
  int factor;
  double sign;
} entries[QN_FACE_UNKNOWNS] = { { 1, -1 }, { 2, -1 }, { 0, 1 },
                                { 1, 1 },  { 2, 1 },  { 3, 1 } };

void
qn_assembly_subtract_face_forces (const QnAssembly *as, const double *forces,
                                  size_t stride, double *residual)
{
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const int32_t *unknowns = as->face_unknowns + QN_FACE_UNKNOWNS * f;
    double sum[QN_PAIR_FACTORS] = { 0 }; /* P = G' f */

    for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++) {
      const double *n = as->gradients[p].factors[0], *t = as->gradients[p].factors[1];
      const double *force = forces + stride * (size_t) p;
      for (int i = 0; i < QN_PAIR_FACTORS; i++)
        sum[i] += n[i] * force[0] + t[i] * force[1];
    }
    for (int i = 0; i < QN_FACE_UNKNOWNS; i++)
      if (unknowns[i] != QN_NONE)
        residual[unknowns[i]] -= entries[i].sign * sum[entries[i].factor];
  }
}

/* --- The whole tangent ------------------------------------------------------------------- */

/* The pattern is symmetric: a column says which columns have an entry in its row. */
static void
clear_settling_rows (QnAssembly *as)
{
  for (size_t s = 0; s < as->settling_count; s++) {
    int32_t i = as->settling[s].unknown;
    for (int32_t k = as->ap[i]; k < as->ap[i + 1]; k++)
      as->ax[qn_sparse_find (as->ap, as->ai, i, as->ai[k])] =
        as->ai[k] == i ? as->stiffness : 0;
  }
}

void
qn_assembly_tangent_of (QnAssembly *as, double multiplier, double viscosity,
                        const double *tangents, size_t stride)
{
  memset (as->ax, 0, (size_t) as->ap[as->unknown_count] * sizeof *as->ax);
  /* ax += G' D G of all pairs, and their geometric stiffness. */
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const int32_t *scatter = as->scatter + 36 * f;
    double k[QN_PAIR_FACTORS][QN_PAIR_FACTORS] = { { 0 } };         /* by columns */
    double geometric[QN_PAIR_FACTORS][QN_PAIR_FACTORS] = { { 0 } }; /* symmetric */
    for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++) {
      /* k, by columns, += g' D g of a pair */
      const QnPairGradient *pair = &as->gradients[p];
      const double *d = tangents + stride * (size_t) p;
      const double *n = pair->factors[0], *t = pair->factors[1];
      for (int j = 0; j < QN_PAIR_FACTORS; j++) {
        double dn = n[j] * d[0] + t[j] * d[1], dt = n[j] * d[2] + t[j] * d[3];
        for (int i = 0; i < QN_PAIR_FACTORS; i++)
          k[j][i] += n[i] * dn + t[i] * dt;
      }
      if (as->nonlinear)
        qn_pair_kinematics_add_stiffness (&as->kinematics[p], as->responses[p].force,
                                          geometric);
    }
    for (int i = 0; i < QN_FACE_UNKNOWNS; i++, scatter += QN_FACE_UNKNOWNS)
      for (int j = 0; j < QN_FACE_UNKNOWNS; j++)
        if (scatter[j] != QN_NONE) {
          int row = entries[i].factor, column = entries[j].factor;
          as->ax[scatter[j]] +=
            entries[i].sign * entries[j].sign * (k[column][row] + geometric[row][column]);
        }
  }
  qn_beam_assembly_add_tangent (as);
  for (int32_t i = 0; i < as->unknown_count; i++)
    as->ax[as->diagonal[i]] += viscosity * as->damping[i];
  if (as->nonlinear)
    qn_assembly_add_load_stiffness (as, multiplier);
  clear_settling_rows (as);
}

void
qn_assembly_tangent (QnAssembly *as, double multiplier, double viscosity)
{
  qn_assembly_tangent_of (as, multiplier, viscosity, as->responses[0].tangent[0],
                          sizeof *as->responses / sizeof (double));
}

static void
hold_settling (QnAssembly *as)
{
  for (size_t s = 0; s < as->settling_count; s++) {
    int32_t i = as->settling[s].unknown;
    for (int32_t k = as->ap[i]; k < as->ap[i + 1]; k++)
      if (as->ai[k] != i)
        as->ax[k] = 0;
  }
}

void
qn_assembly_tangent_of_vibration (QnAssembly *as, double multiplier, bool sliding,
                                  double *tangents)
{
  double largest = 0;

  for (size_t p = 0; p < as->pair_count; p++)
    largest =
      fmax (largest, hypot (as->responses[p].force[0], as->responses[p].force[1]));
  for (size_t p = 0; p < as->pair_count; p++)
    if (as->inactive[p])
      memset (tangents + 4 * p, 0, 4 * sizeof *tangents);
    else
      qn_pair_vibration_tangent (&as->springs[p], &as->responses[p], TOUCH * largest,
                                 sliding, tangents + 4 * p);
  qn_assembly_tangent_of (as, multiplier, 0, tangents, 4);
  hold_settling (as);
}

static bool
lets_go (const QnAssembly *as, size_t pair)
{
  const QnPairSprings *springs = &as->springs[pair];

  return springs->a.kind == QN_LAW_NO_TENSION && springs->b.kind == QN_LAW_NO_TENSION
         && as->responses[pair].state == QN_PAIR_SLIP;
}

void
qn_assembly_tangent_at_rest (QnAssembly *as, double multiplier)
{
  for (size_t p = 0; p < as->pair_count; p++)
    if (lets_go (as, p))
      memset (as->responses[p].tangent, 0, sizeof as->responses[p].tangent);
  qn_assembly_tangent (as, multiplier, 0);
  hold_settling (as);
  for (size_t p = 0; p < as->pair_count; p++)
    if (lets_go (as, p))
      qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                        &as->responses[p]);
}

bool
qn_assembly_is_symmetric (const QnAssembly *as)
{
  double largest = 0, skew = 0;

  for (int32_t j = 0; j < as->unknown_count; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++) {
      int32_t i = as->ai[k], low = as->ap[i];
      while (as->ai[low] != j)
        low++;
      largest = fmax (largest, fabs (as->ax[k]));
      skew = fmax (skew, fabs (as->ax[k] - as->ax[low]));
    }
  return skew <= QN_TOLERANCE_SYMMETRIC * largest;
}
