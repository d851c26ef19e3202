/* What is refused of the springs of a face: different bases, too little fracture energy. */
#include "core/contact/contacts.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

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

static void
test_bases (void)
{
  for (int basis = 0; basis < QN_BASIS_COUNT; basis++) {
    QnModel model;
    init (&model, 500, (QnBasis) basis);
    model.blocks[1].law = 1;
    g_assert_cmpint (problem_of (&model), ==,
                     basis == QN_BASIS_MATERIAL ? QN_PROBLEM_NONE
                                                : QN_PROBLEM_BASES_DIFFER);
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
  g_test_add_func ("/pair-springs/bases", test_bases);
  g_test_add_func ("/pair-springs/fracture-energy", test_fracture_energy);
}
