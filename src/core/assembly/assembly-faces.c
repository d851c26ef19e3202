/* The inner loops over contact faces: elongations, forces, tangents. */
#include "core/assembly/assembly-parts.h"

#include <string.h>

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

/* k, by columns, += g' D g of a pair */
static inline void
add_pair_tangent (const QnPairGradient *pair, const double *d,
                  double k[QN_PAIR_FACTORS][QN_PAIR_FACTORS])
{
  const double *n = pair->factors[0], *t = pair->factors[1];

  for (int j = 0; j < QN_PAIR_FACTORS; j++) {
    double dn = n[j] * d[0] + t[j] * d[1], dt = n[j] * d[2] + t[j] * d[3];
    for (int i = 0; i < QN_PAIR_FACTORS; i++)
      k[j][i] += n[i] * dn + t[i] * dt;
  }
}

void
qn_assembly_add_face_tangents (QnAssembly *as, const double *tangents, size_t stride)
{
  for (size_t f = 0; f < as->contacts->face_count; f++) {
    const int32_t *scatter = as->scatter + 36 * f;
    double k[QN_PAIR_FACTORS][QN_PAIR_FACTORS] = { { 0 } };         /* by columns */
    double geometric[QN_PAIR_FACTORS][QN_PAIR_FACTORS] = { { 0 } }; /* symmetric */

    for (int32_t p = as->first_pairs[f]; p < as->first_pairs[f + 1]; p++) {
      add_pair_tangent (&as->gradients[p], tangents + stride * (size_t) p, k);
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
}
