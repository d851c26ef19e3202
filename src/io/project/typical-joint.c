#include "io/project/typical-joint.h"

#include "core/base/memory.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>

/* Energy of slip over cohesion as of the joint of Lourenço & Rots 1997, 125 J/m2 over 0.35 MPa.
 *
 * Blocks are rigid: joints of mortar are as flexible as the masonry that they hold together,
 * kn = E / h and ks = G / h over courses of the height h, 0.2 m of stone and 0.07 m of brick. */
const QnTypicalJoint qn_typical_joints[QN_JOINT_COUNT] = {
  [QN_JOINT_DRY_STONE] = { N_ ("Dry-jointed stone"), 0.65, 0.0, 0.0, 1e10, 1e10, 24e3,
                           N_ ("Friction: Ferris & Tin-Loi 2001. Stiffness: arch of "
                               "Lemos, 1e10 Pa/m.") },
  [QN_JOINT_LIME_MORTAR] = { N_ ("Lime mortar"), 0.4, 0.1e6, 36.0, 1.4e10, 4.7e9, 22e3,
                             N_ ("Strength: EN 1996-1-1, 3.6.2 and table 3.4. "
                                 "Fracture energy: Lourenço & Rots 1997, by cohesion. "
                                 "Stiffness: squared stone of Circolare 7/2019, table "
                                 "C8.5.I, courses of 0.2 m.") },
  [QN_JOINT_BRICK] = { N_ ("Brick, cement-lime mortar"), 0.4, 0.2e6, 71.0, 2.1e10, 7e9,
                       18e3,
                       N_ ("Strength: EN 1996-1-1, 3.6.2 and table 3.4. "
                           "Fracture energy: Lourenço & Rots 1997, by cohesion. "
                           "Stiffness: brick and lime mortar of Circolare 7/2019, table "
                           "C8.5.I, courses of 0.07 m.") },
  [QN_JOINT_SOIL] = { N_ ("Soil below a foundation (Winkler)"), 0.5, 0.0, 0.0, 3e7, 1.5e7,
                      18e3,
                      N_ ("Stiffness: subgrade reaction of medium dense sand, 9.6 to 80 "
                          "MN/m3, Bowles 1996, table 9-1. Friction and ks: assumed.") },
};

gboolean
qn_law_make_joint (QnLaw *law, QnTypicalJointKind kind)
{
  const QnTypicalJoint *joint = &qn_typical_joints[kind];
  char *source = qn_strdup (joint->source);
  if (source == NULL)
    return FALSE;
  free (law->source);
  *law = (QnLaw){ .name = law->name,
                  .source = source,
                  .note = law->note,
                  .kind = QN_LAW_COULOMB,
                  .basis = QN_BASIS_SURFACE,
                  .kn = 2.0 * joint->kn,
                  .ks = 2.0 * joint->ks,
                  .friction = joint->friction,
                  .cohesion = joint->cohesion,
                  .fracture_energy_shear = joint->fracture,
                  .exponential = joint->fracture > 0.0 };
  return TRUE;
}

const char *
qn_law_get_source (const QnLaw *law, gboolean *holds)
{
  *holds = TRUE;
  if (law->source == NULL || *law->source == '\0')
    return NULL;
  for (int i = 0; i < QN_JOINT_COUNT; i++)
    if (g_str_equal (law->source, qn_typical_joints[i].source)) {
      const QnTypicalJoint *joint = &qn_typical_joints[i];
      *holds = law->kind == QN_LAW_COULOMB && law->basis == QN_BASIS_SURFACE
               && law->kn == 2.0 * joint->kn && law->ks == 2.0 * joint->ks
               && law->friction == joint->friction && law->cohesion == joint->cohesion
               && law->fracture_energy_shear == joint->fracture && law->tension == 0.0
               && law->dilatancy == 0.0;
      return _ (qn_typical_joints[i].source);
    }
  return law->source;
}

const QnTypicalStone qn_typical_stones[QN_STONE_COUNT] = {
  { N_ ("Granite"), 28.5e3, N_ ("EN 1991-1-1, table A.2: 27 to 30 kN/m³") },
  { N_ ("Basalt"), 29e3, N_ ("EN 1991-1-1, table A.2: 27 to 31 kN/m³") },
  { N_ ("Sandstone"), 24e3, N_ ("EN 1991-1-1, table A.2: 21 to 27 kN/m³") },
  { N_ ("Dense limestone"), 24.5e3, N_ ("EN 1991-1-1, table A.2: 20 to 29 kN/m³") },
  { N_ ("Tuff, light limestone"), 20e3, N_ ("EN 1991-1-1, table A.2: 20 kN/m³") },
  { N_ ("Masonry of squared stone"), 22e3, N_ ("Circolare 7/2019, table C8.5.I") },
  { N_ ("Rubble masonry"), 19e3, N_ ("Circolare 7/2019, table C8.5.I") },
  { N_ ("Brick masonry"), 18e3, N_ ("Circolare 7/2019, table C8.5.I") },
};

int
qn_typical_stone_find (double unit_weight)
{
  for (int i = 0; i < QN_STONE_COUNT; i++)
    if (fabs (qn_typical_stones[i].unit_weight - unit_weight) <= 1e-9 * unit_weight)
      return i;
  return -1;
}
