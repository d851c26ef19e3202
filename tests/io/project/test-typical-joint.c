/* Typical joints are sound laws with a source, and new projects begin with one. */
#include "io/project/project.h"
#include "io/project/typical-joint.h"
#include "support/room.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

/* Each is a Coulomb law by area, whatever the law was before; its source holds until a number is
 * another. */
static void
test_laws (void)
{
  for (int kind = 0; kind < QN_JOINT_COUNT; kind++) {
    const QnTypicalJoint *joint = &qn_typical_joints[kind];
    gboolean holds = FALSE;
    QnLaw law = { .name = strdup ("joint"),
                  .kind = QN_LAW_STEEL,
                  .basis = QN_BASIS_MATERIAL,
                  .tension = 1e5,
                  .note = 7 };
    g_assert_null (qn_law_get_source (&law, &holds));
    g_assert_true (qn_law_make_joint (&law, (QnTypicalJointKind) kind));
    g_assert_cmpint (qn_law_check (&law, 0, NULL), ==, QN_OK);
    g_assert_cmpstr (law.name, ==, "joint");
    g_assert_cmpint (law.note, ==, 7);
    g_assert_cmpint (law.kind, ==, QN_LAW_COULOMB);
    g_assert_cmpint (law.basis, ==, QN_BASIS_SURFACE);
    g_assert_cmpfloat (law.tension, ==, 0.0);
    /* Lourenço & Rots 1997: 125 J/m2 with a cohesion of 0.35 MPa. */
    g_assert_cmpfloat_with_epsilon (law.fracture_energy_shear,
                                    law.cohesion * 125 / 0.35e6, 0.5);
    /* Two springs in series are the joint. */
    g_assert_cmpfloat_with_epsilon (1 / (1 / law.kn + 1 / law.kn), joint->kn, 1.0);
    g_assert_cmpfloat_with_epsilon (1 / (1 / law.ks + 1 / law.ks), joint->ks, 1.0);
    g_assert_cmpstr (qn_law_get_source (&law, &holds), ==, joint->source);
    g_assert_true (holds);
    law.fracture_energy_shear += 1;
    g_assert_nonnull (qn_law_get_source (&law, &holds));
    g_assert_false (holds);
    qn_law_clear (&law);
  }
}

/* Of no typical joint: as it is. */
static void
test_own_source (void)
{
  gboolean holds = FALSE;
  QnLaw law = { .source = (char *) "Tests on site" };
  g_assert_cmpstr (qn_law_get_source (&law, &holds), ==, "Tests on site");
  g_assert_true (holds);
}

/* Large displacements with dry joints by area; written and read it is the same. */
static void
test_begin (void)
{
  g_auto (QnProject) project, again;
  GError *error = NULL;
  g_assert_true (qn_project_begin (&project, "stone", &error));
  g_assert_no_error (error);
  g_assert_cmpint (project.model.analysis.geometry, ==, QN_GEOMETRY_NONLINEAR);
  g_assert_cmpuint (project.model.law_count, ==, 1);
  const QnLaw *law = &project.model.laws[0];
  g_assert_cmpint (law->basis, ==, QN_BASIS_SURFACE);
  g_assert_cmpstr (law->source, ==, qn_typical_joints[QN_JOINT_DRY_STONE].source);
  gsize length;
  g_autofree char *text = qn_project_to_text (&project, &length);
  g_assert_true (qn_project_parse (text, length, "new", NULL, &again, &error));
  g_assert_no_error (error);
  g_assert_cmpuint (again.warnings->len, ==, 0);
  g_assert_cmpstr (again.model.laws[0].source, ==, law->source);
  g_assert_cmpfloat (again.model.dead_loads[0].vector.y, ==, -1.0);
  g_assert_cmpfloat (again.model.live_loads[0].vector.x, ==, 1.0);
  g_autofree char *second = qn_project_to_text (&again, NULL);
  g_assert_cmpstr (second, ==, text);
}

QN_TESTS
{
  g_test_add_func ("/io/typical-joint/laws", test_laws);
  g_test_add_func ("/io/typical-joint/own-source", test_own_source);
  g_test_add_func ("/io/typical-joint/begin", test_begin);
}
