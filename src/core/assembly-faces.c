/* The inner loops over contact faces: elongations, forces, tangents.
 *
 * Translations of the two blocks of a face enter with opposite signs, so that a pair depends on
 * four numbers only, c = (rotation of a, u_b - u_a in x and y, rotation of b). Their factors
 * stand side by side in the gradient. */
#include "core/assembly-parts.h"

#include <string.h>

enum { FACTORS = 4, FIRST_FACTOR = 2 };

typedef double Four __attribute__ ((vector_size (32), aligned (8), may_alias));

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
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const QnContactFace *face = &as->contacts->faces[f];
    double v[QN_FACE_UNKNOWNS];

    qn_assembly_gather (as, f, u, v);
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++) {
      if (as->nonlinear)
        qn_pair_kinematics_update (&as->kinematics[p], v);
      else
        qn_pair_kinematics_update_linear (&as->kinematics[p], v);
    }
  }
}

void
qn_assembly_elongation_rates (const QnAssembly *as, const double *v, double *rates)
{
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const QnContactFace *face = &as->contacts->faces[f];
    double local[QN_FACE_UNKNOWNS];

    qn_assembly_gather (as, f, v, local);
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++)
      qn_pair_kinematics_rate (&as->kinematics[p], local, rates + 2 * p);
  }
}

void
qn_assembly_subtract_face_forces (const QnAssembly *as, const double *forces,
                                  size_t stride, double *residual)
{
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const QnContactFace *face = &as->contacts->faces[f];
    const int32_t *unknowns = as->face_unknowns + QN_FACE_UNKNOWNS * f;
    Four sum = { 0 };

    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++) {
      double (*g)[QN_FACE_UNKNOWNS] = as->kinematics[p].gradient;
      const double *force = forces + stride * (size_t) p;
      sum += *(const Four *) (g[0] + FIRST_FACTOR) * force[0]
             + *(const Four *) (g[1] + FIRST_FACTOR) * force[1]; /* P = G' f */
    }
    const double part[QN_FACE_UNKNOWNS] = { -sum[1], -sum[2], sum[0],
                                            sum[1],  sum[2],  sum[3] };
    for (int i = 0; i < QN_FACE_UNKNOWNS; i++)
      if (unknowns[i] != QN_NONE)
        residual[unknowns[i]] -= part[i];
  }
}

/* sum (rows) += c' D c of a pair */
static inline void
add_pair_tangent (const QnPairKinematics *pair, const double *d, Four sum[FACTORS])
{
  Four n = *(const Four *) (pair->gradient[0] + FIRST_FACTOR);
  Four t = *(const Four *) (pair->gradient[1] + FIRST_FACTOR);
  Four dn = n * d[0] + t * d[1], dt = n * d[2] + t * d[3];

  QN_UNROLL
  for (int i = 0; i < FACTORS; i++)
    sum[i] += dn * n[i] + dt * t[i];
}

/* kf (rows) from the four rows of its factors */
static inline void
spread (const Four sum[FACTORS], double kf[QN_FACE_UNKNOWNS][QN_FACE_UNKNOWNS])
{
  static const int factor[QN_FACE_UNKNOWNS] = { 1, 2, 0, 1, 2, 3 };

  QN_UNROLL
  for (int i = 0; i < QN_FACE_UNKNOWNS; i++) {
    Four row = i < 2 ? -sum[factor[i]] : sum[factor[i]];
    kf[i][0] = -row[1];
    kf[i][1] = -row[2];
    *(Four *) (kf[i] + FIRST_FACTOR) = row;
  }
}

void
qn_assembly_add_face_tangents (QnAssembly *as, const double *tangents, size_t stride)
{
  double *ax = as->ax;

  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const QnContactFace *face = &as->contacts->faces[f];
    const int32_t *scatter = as->scatter + 36 * f;
    double kf[QN_FACE_UNKNOWNS][QN_FACE_UNKNOWNS];
    Four sum[FACTORS] = { { 0 } };

    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++)
      add_pair_tangent (&as->kinematics[p], tangents + stride * (size_t) p, sum);
    spread (sum, kf);
    for (QnId p = face->first_pair;
         as->nonlinear && p < face->first_pair + face->pair_count; p++)
      qn_pair_kinematics_add_stiffness (&as->kinematics[p], as->responses[p].force, kf);
    for (int i = 0; i < QN_FACE_UNKNOWNS; i++, scatter += QN_FACE_UNKNOWNS)
      QN_UNROLL
    for (int j = 0; j < QN_FACE_UNKNOWNS; j++)
      if (scatter[j] != QN_NONE)
        ax[scatter[j]] += kf[i][j];
  }
}
