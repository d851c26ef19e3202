/* The inner loops over contact faces: elongations, forces, tangents. */
#include "core/assembly/assembly-parts.h"

#include <string.h>

typedef double Two __attribute__ ((vector_size (16), aligned (8), may_alias));

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

/* rate = gradient * motion: in linear geometry, where the gradient is constant, the elongation at
 * v. The four terms are added up one after the other. */
static inline Two
pair_rate (const QnPairGradient *gradient, const Two motion[2])
{
  const Two *n = (const Two *) gradient->factors[0],
            *t = (const Two *) gradient->factors[1];
  Two sum = { 0 };

  QN_UNROLL
  for (int half = 0; half < 2; half++) {
    Two along = n[half] * motion[half], across = t[half] * motion[half];
    Two first = { along[0], across[0] }, second = { along[1], across[1] };
    sum = half == 0 ? first + second : sum + first + second;
  }
  return sum;
}

void
qn_assembly_elongation_rates (const QnAssembly *as, const double *v, double *rates)
{
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    double v_face[QN_FACE_UNKNOWNS];

    qn_assembly_gather (as, f, v, v_face);
    const double *a = v_face, *b = v_face + QN_DOF_COUNT;
    const Two motion[2] = { { a[2], b[0] - a[0] }, { b[1] - a[1], b[2] } };
    for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++)
      *(Two *) (rates + 2 * p) = pair_rate (&as->gradients[p], motion);
  }
}

void
qn_assembly_subtract_face_forces (const QnAssembly *as, const double *forces,
                                  size_t stride, double *residual)
{
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const int32_t *unknowns = as->face_unknowns + QN_FACE_UNKNOWNS * f;
    Two low = { 0 }, high = { 0 };

    for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++) {
      const Two *n = (const Two *) as->gradients[p].factors[0],
                *t = (const Two *) as->gradients[p].factors[1];
      const double *force = forces + stride * (size_t) p;
      low += n[0] * force[0] + t[0] * force[1]; /* P = G' f */
      high += n[1] * force[0] + t[1] * force[1];
    }
    const double part[QN_FACE_UNKNOWNS] = { -low[1], -high[0], low[0],
                                            low[1],  high[0],  high[1] };
    for (int i = 0; i < QN_FACE_UNKNOWNS; i++)
      if (unknowns[i] != QN_NONE)
        residual[unknowns[i]] -= part[i];
  }
}

/* Four rows of one column of a matrix. */
typedef struct {
  Two low, high;
} Column;

/* sum += c' D c of a pair */
static inline void
add_pair_tangent (const QnPairGradient *pair, const double *d,
                  Column sum[QN_PAIR_FACTORS])
{
  const Two *n = (const Two *) pair->factors[0], *t = (const Two *) pair->factors[1];

  QN_UNROLL
  for (int half = 0; half < 2; half++) {
    Two dn = n[half] * d[0] + t[half] * d[1], dt = n[half] * d[2] + t[half] * d[3];
    QN_UNROLL
    for (int k = 0; k < 2; k++) {
      sum[2 * half + k].low += n[0] * dn[k] + t[0] * dt[k];
      sum[2 * half + k].high += n[1] * dn[k] + t[1] * dt[k];
    }
  }
}

/* The tangent of a face by its factors. */
static inline void
face_tangent (const QnAssembly *as, size_t f, const double *tangents, size_t stride,
              Column sum[QN_PAIR_FACTORS])
{

  QN_UNROLL
  for (int j = 0; j < QN_PAIR_FACTORS; j++)
    sum[j] = (Column){ { 0 }, { 0 } };
  for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++)
    add_pair_tangent (&as->gradients[p], tangents + stride * (size_t) p, sum);
}

/* Which factor each unknown enters by, the first two with the other sign. */
static const int factor_of_unknown[QN_FACE_UNKNOWNS] = { 1, 2, 0, 1, 2, 3 };

/* The column of an unknown. */
static inline Column
column_of (const Column sum[QN_PAIR_FACTORS], int unknown)
{
  Column column = sum[factor_of_unknown[unknown]];

  return unknown < 2 ? (Column){ -column.low, -column.high } : column;
}

/* kf (rows) from the columns of its factors */
static inline void
spread (const Column sum[QN_PAIR_FACTORS], double kf[QN_FACE_UNKNOWNS][QN_FACE_UNKNOWNS])
{
  for (int j = 0; j < QN_FACE_UNKNOWNS; j++) {
    Column column = column_of (sum, j);
    kf[0][j] = -column.low[1];
    kf[1][j] = -column.high[0];
    kf[2][j] = column.low[0];
    kf[3][j] = column.low[1];
    kf[4][j] = column.high[0];
    kf[5][j] = column.high[1];
  }
}

/* sum += geometric stiffness of the pairs of a face */
static void
add_geometric_stiffness (const QnAssembly *as, size_t f, Column sum[QN_PAIR_FACTORS])
{
  double k[QN_PAIR_FACTORS][QN_PAIR_FACTORS] = { { 0 } };

  for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++)
    qn_pair_kinematics_add_stiffness (&as->kinematics[p], as->responses[p].force, k);
  for (int j = 0; j < QN_PAIR_FACTORS; j++) {
    sum[j].low += (Two){ k[0][j], k[1][j] };
    sum[j].high += (Two){ k[2][j], k[3][j] };
  }
}

void
qn_assembly_add_face_tangents (QnAssembly *as, const double *tangents, size_t stride)
{
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const int32_t *scatter = as->scatter + 36 * f;
    Column sum[QN_PAIR_FACTORS];

    face_tangent (as, f, tangents, stride, sum);
    if (as->nonlinear)
      add_geometric_stiffness (as, f, sum);
    double kf[QN_FACE_UNKNOWNS][QN_FACE_UNKNOWNS];
    spread (sum, kf);
    for (int i = 0; i < QN_FACE_UNKNOWNS; i++, scatter += QN_FACE_UNKNOWNS)
      for (int j = 0; j < QN_FACE_UNKNOWNS; j++)
        if (scatter[j] != QN_NONE)
          as->ax[scatter[j]] += kf[i][j];
  }
}
