/* The springs of a face: of laws by contact, by area and by material in series; too little fracture
 * energy is refused. */
#include "core/contact/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <math.h>

static void
init (QnModel *model, double fracture_energy, QnBasis other)
{
  test_model_init_stack (model, 1, 1, 0.4);
  model->laws[0] = (QnLaw){ .name = model->laws[0].name,
                            .kind = QN_LAW_CONCRETE,
                            .basis = QN_BASIS_MATERIAL,
                            .kn = 30e9,
                            .ks = 12e9,
                            .strength = 30e6,
                            .tension = 3e6,
                            .fracture_energy = fracture_energy };
  QnLaw *law = qn_model_add_law (model, "other");
  law->kind = QN_LAW_ELASTIC;
  law->basis = other;
  law->kn = law->ks = 1e10;
}

static QnProblem
problem_of (QnModel *model)
{
  QnDiag diag = { 0 };
  QnContacts contacts;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  if (qn_contacts_detect (model, &contacts, &diag) == QN_OK) {
    qn_contacts_clear (&contacts);
  } else {
    g_assert_cmpint (diag.entity, ==, QN_ENTITY_BLOCK);
    g_assert_cmpint (diag.index, ==, 0);
    g_assert_cmpint (diag.other, ==, 1);
  }
  qn_model_clear (model);
  return diag.problem;
}

/* A block by contact on a cell by material: two springs in series, each by the law of its side. Per pair
 * 1e10 N/m, of which there are two at the ends then; by area 1e10 Pa/m. */
static void
test_series (void)
{
  for (int basis = 0; basis < QN_BASIS_MATERIAL; basis++) {
    QnModel model;
    QnContacts contacts;
    init (&model, 500, (QnBasis) basis);
    model.laws[0].kind = QN_LAW_ELASTIC;
    model.blocks[1].law = 1;
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    const double length = model.blocks[0].centroid.y - contacts.faces[0].start.y;
    const double area = contacts.faces[0].length * contacts.faces[0].thickness;
    double k[2], sum[2] = { 0, 0 };
    g_assert_cmpuint (contacts.pair_count, ==, basis == QN_BASIS_CONTACT ? 2 : 5);
    for (size_t i = 0; i < contacts.pair_count; i++) {
      const QnPairSprings springs = qn_contacts_pair_springs (&model, &contacts, i);
      g_assert_false (springs.equal);
      qn_pair_elastic_stiffness (&springs, k);
      sum[0] += k[0];
      sum[1] += k[1];
    }
    const double joint = basis == QN_BASIS_CONTACT ? 2e10 : 1e10 * area;
    const double depth = fabs (length);
    const double normal = 1 / (1 / joint + depth / (30e9 * area));
    const double shear = 1 / (1 / joint + depth / (12e9 * area));
    g_assert_cmpfloat_with_epsilon (sum[0] / normal, 1, 1e-12);
    g_assert_cmpfloat_with_epsilon (sum[1] / shear, 1, 1e-12);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
  }
}

/* Concrete that would snap back behind so soft a joint is refused, but where the joint is not strong
 * enough to crack or to crush it. */
static void
test_weaker_joint (void)
{
  static const struct {
    QnLawKind kind;
    double tension;
    QnProblem problem;
  } joints[] = {
    { QN_LAW_ELASTIC, 0, QN_PROBLEM_FRACTURE_ENERGY_TOO_SMALL },
    { QN_LAW_COULOMB, 4e6, QN_PROBLEM_FRACTURE_ENERGY_TOO_SMALL },
    { QN_LAW_COULOMB, 2e6, QN_PROBLEM_NONE },
    { QN_LAW_NO_TENSION, 0, QN_PROBLEM_NONE },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (joints); i++) {
    QnModel model;
    init (&model, 500, QN_BASIS_SURFACE);
    model.blocks[1].law = 1;
    model.laws[1].kind = joints[i].kind;
    model.laws[1].kn = model.laws[1].ks = 5e9;
    model.laws[1].friction = 0.1;
    model.laws[1].cohesion = 1e6;
    model.laws[1].tension = joints[i].tension;
    g_assert_cmpint (problem_of (&model), ==, joints[i].problem);
  }
}

/* Base 1 m high and block 0.4 m: 0.7 m of concrete needs more than ft^2 h / 2 E = 105 J/m2. */
static void
test_fracture_energy (void)
{
  QnModel model;
  test_model_init_stack (&model, 1, 1, 0.4);
  double height = model.vertices[2].y - model.vertices[0].y;
  double least = 3e6 * 3e6 * (height / 2 + 0.2) / (2 * 30e9);
  qn_model_clear (&model);
  init (&model, 1.01 * least, QN_BASIS_MATERIAL);
  g_assert_cmpint (problem_of (&model), ==, QN_PROBLEM_NONE);
  init (&model, 0.99 * least, QN_BASIS_MATERIAL);
  g_assert_cmpint (problem_of (&model), ==, QN_PROBLEM_FRACTURE_ENERGY_TOO_SMALL);
}

QN_TESTS
{
  g_test_add_func ("/pair-springs/series", test_series);
  g_test_add_func ("/pair-springs/weaker-joint", test_weaker_joint);
  g_test_add_func ("/pair-springs/fracture-energy", test_fracture_energy);
}
