#include "core/limit/limit-sensitivity.h"

#include <math.h>

/* What a pair does in the mechanism; elongation rates by which the live load does unit power. */
typedef struct Rates {
  double opening, sliding; /* sliding >= 0 */
} Rates;

static double
weight_power (const QnModel *model, size_t block, const QnLoad *load, const double *v)
{
  const double *row = v + block * QN_DOF_COUNT;

  return model->blocks[block].weight
         * (load->vector.x * row[QN_DOF_UX] + load->vector.y * row[QN_DOF_UY]);
}

/* Power of one load on the velocities v. */
static double
load_power (const QnModel *model, const QnLoad *load, const double *v)
{
  double power = 0.0;

  if (load->kind == QN_LOAD_WEIGHT)
    for (size_t b = 0; b < model->block_count; b++)
      power += weight_power (model, b, load, v);
  if (load->kind == QN_LOAD_FORCE) {
    const double *row = v + (size_t) load->block * QN_DOF_COUNT;
    double arm_moment = qn_vec2_cross (qn_model_load_arm (model, load), load->vector);
    power = load->vector.x * row[QN_DOF_UX] + load->vector.y * row[QN_DOF_UY]
            + (load->moment + arm_moment) * row[QN_DOF_RZ];
  }
  return power;
}

static Rates
pair_rates (const QnModel *model, const QnContactFace *face, QnVec2 point,
            const double *v)
{
  double a[QN_DOF_COUNT], b[QN_DOF_COUNT];

  qn_body_velocity_at (v + (size_t) face->a * QN_DOF_COUNT,
                       qn_vec2_sub (point, model->blocks[face->a].centroid), a);
  qn_body_velocity_at (v + (size_t) face->b * QN_DOF_COUNT,
                       qn_vec2_sub (point, model->blocks[face->b].centroid), b);
  QnVec2 apart = qn_vec2 (b[QN_DOF_UX] - a[QN_DOF_UX], b[QN_DOF_UY] - a[QN_DOF_UY]);
  return (Rates){ qn_vec2_dot (apart, face->normal),
                  fabs (qn_vec2_dot (apart, face->tangent)) };
}

/* The law of the spring whose cone is nearer to the forces: the weaker of the two; and the area that its
 * strengths refer to, or 1. */
static QnId
governing_law (const QnModel *model, const QnContacts *contacts, size_t pair,
               const QnPairResult *force, double *unit)
{
  const QnContactPair *at = &contacts->pairs[pair];
  double slack[2], units[2];
  QnId laws[2];

  for (int side = 0; side < 2; side++) {
    laws[side] = qn_contacts_pair_law (model, contacts, pair, side);
    const QnLaw *law = &model->laws[laws[side]];
    units[side] = law->basis == QN_BASIS_CONTACT
                    ? 1.0
                    : at->tributary * contacts->faces[at->face].thickness;
    slack[side] = !qn_law_may_bond (law->kind)
                    ? (double) INFINITY
                    : law->cohesion * units[side] - law->friction * force->normal_force
                        - fabs (force->shear_force);
  }
  int weaker = slack[1] < slack[0];
  *unit = units[weaker];
  return laws[weaker];
}

/* The dual of a pair with friction: `cone` of its two shear rows together, `cut` of the tension. Where
 * the apex of the cone bounds tension, opening is flow of the cone. */
static void
add_strength (QnLawSensitivity *out, const QnLaw *law, double unit, Rates rates,
              double normal_force)
{
  bool by_apex = law->cohesion < law->friction * law->tension;
  double cone = rates.sliding;
  double cut = fmax (0.0, rates.opening - law->friction * rates.sliding);

  if (by_apex && law->friction > 0.0)
    cone = fmax (cone, rates.opening / law->friction);
  out->friction -= cone * normal_force;
  out->cohesion += cone * unit;
  if (law->cohesion > law->friction * law->tension)
    out->tension += cut * unit;
}

static bool
has_law (const QnModel *model, const QnBlock *block, QnId law)
{
  return (block->law != QN_NONE ? block->law : model->contact.law) == law;
}

/* What of a load acts at collapse. */
static double
part_of (const QnLoad *load, double multiplier)
{
  return load->set == QN_NONE ? 1.0 : load->set == 0 ? multiplier : 0.0;
}

/* Weight and thickness of the blocks that have a law. */
static void
add_blocks (const QnModel *model, const QnContacts *contacts, const QnResult *result,
            const double *v, QnId law, QnLawSensitivity *out)
{
  double power = 0.0, pressure = 0.0, lambda = result->collapse_multiplier;

  for (size_t b = 0; b < model->block_count; b++) {
    bool grows = has_law (model, &model->blocks[b], law);
    for (size_t i = 0; grows && i < qn_model_acting_count (model); i++) {
      const QnLoad load = qn_model_acting_load (model, i);
      double part = part_of (&load, lambda);
      QnLoadKind source = qn_model_load (model, qn_model_acting_source (model, i))->kind;
      bool is_pressure = source != QN_LOAD_EDGE && source != QN_LOAD_VEHICLE
                         && qn_load_is_on_edges (source);
      if (load.kind == QN_LOAD_WEIGHT)
        power += part * weight_power (model, b, &load, v);
      else if (is_pressure && load.kind == QN_LOAD_FORCE && load.block == (QnId) b)
        pressure += part * load_power (model, &load, v);
    }
  }
  out->weight = -power;
  /* What joints dissipate grows with their area: forces times rates. An area grows where
   * both blocks become thicker, or the thinner one does. */
  double joints = 0.0;
  for (size_t p = 0; p < contacts->pair_count; p++) {
    const QnContactPair *pair = &contacts->pairs[p];
    const QnContactFace *face = &contacts->faces[pair->face];
    const QnPairResult *force = &result->pairs[p];
    double unit;
    QnId id = governing_law (model, contacts, p, force, &unit);
    const QnBlock *a = &model->blocks[face->a], *b = &model->blocks[face->b];
    bool thickens = (a->thickness > b->thickness || has_law (model, a, law))
                    && (b->thickness > a->thickness || has_law (model, b, law));
    if (pair->bar != QN_NONE || model->laws[id].basis == QN_BASIS_CONTACT || !thickens)
      continue;
    Rates rates = pair_rates (model, face, pair->point, v);
    joints +=
      force->normal_force * rates.opening + fabs (force->shear_force) * rates.sliding;
  }
  out->thickness = -power - pressure + joints;
  for (size_t i = 0; i < qn_model_load_count (model); i++)
    if (model->soil_tie_count > 0 || qn_model_load (model, i)->kind == QN_LOAD_VEHICLE)
      out->thickness = NAN;
}

QnStatus
qn_limit_sensitivity (const QnModel *model, const QnContacts *contacts,
                      const QnResult *result, QnLimitSensitivity *out, QnDiag *diag)
{
  QN_ASSERT (result->outcome == QN_OUTCOME_COLLAPSE && result->limit.given
             && result->limit.flow == QN_FLOW_ASSOCIATIVE);
  size_t count = model->block_count * QN_DOF_COUNT;
  QnPool pool = { 0 };
  double *v = qn_pool_alloc (&pool, count, sizeof *v), power = 0.0;

  *out = (QnLimitSensitivity){
    .multiplier = result->collapse_multiplier,
    .laws = qn_pool_alloc (&pool, model->law_count, sizeof *out->laws),
    .dead_loads = qn_pool_alloc (&pool, model->dead_load_count, sizeof (double)),
    .live_loads = qn_pool_alloc (&pool, model->live_load_count, sizeof (double)),
  };
  out->pool = pool;
  if (pool.failed) {
    qn_limit_sensitivity_clear (out);
    return qn_diag_no_memory (diag);
  }
  /* The mechanism at unit power of the live load. */
  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    if (load.set == 0)
      power += load_power (model, &load, result->mechanism);
  }
  for (size_t i = 0; i < count; i++)
    v[i] = result->mechanism[i] / power;
  for (size_t p = 0; p < contacts->pair_count; p++) {
    const QnContactPair *pair = &contacts->pairs[p];
    double unit;
    QnId id = governing_law (model, contacts, p, &result->pairs[p], &unit);
    if (qn_law_may_bond (model->laws[id].kind))
      add_strength (&out->laws[id], &model->laws[id], unit,
                    pair_rates (model, &contacts->faces[pair->face], pair->point, v),
                    result->pairs[p].normal_force);
  }
  for (size_t l = 0; l < model->law_count; l++)
    add_blocks (model, contacts, result, v, (QnId) l, &out->laws[l]);
  for (size_t i = 0; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    size_t source = qn_model_acting_source (model, i), dead = model->dead_load_count;
    double change =
      -part_of (&load, result->collapse_multiplier) * load_power (model, &load, v);
    *(source < dead ? &out->dead_loads[source] : &out->live_loads[source - dead]) +=
      change;
  }
  /* The strength of soil grows with its weight. */
  for (size_t i = 0; i < model->dead_load_count && model->soil_tie_count > 0; i++)
    if (model->dead_loads[i].kind == QN_LOAD_FILL)
      out->dead_loads[i] = NAN;
  return QN_OK;
}

void
qn_limit_sensitivity_clear (QnLimitSensitivity *sensitivity)
{
  qn_pool_clear (&sensitivity->pool);
  *sensitivity = (QnLimitSensitivity){ 0 };
}
