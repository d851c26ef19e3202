#include "stereotomy/sound.h"
#include "core/contact/contacts.h"
#include "stereotomy/polygon-ops.h"
#include "stereotomy/weld.h"
#include "support/auto-clear.h"

#include <glib.h>

void
test_sound_init (QnModel *model)
{
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "joint");
  law->kind = QN_LAW_COULOMB;
  law->kn = law->ks = 1e7;
  law->friction = 0.65;
  model->contact.law = 0;
}

static QnRing
block_ring (const QnModel *model, size_t block)
{
  return (QnRing){ model->vertices + model->blocks[block].first_vertex,
                   (size_t) model->blocks[block].vertex_count };
}

double
test_sound_perimeters (const QnModel *model)
{
  double sum = 0;
  for (size_t i = 0; i < model->block_count; i++) {
    QnRing ring = block_ring (model, i);
    sum += qn_ring_perimeter (&ring);
  }
  return sum;
}

static double
face_length (const QnModel *model)
{
  g_auto (QnContacts) contacts;
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_contacts_detect (model, &contacts, &diag), ==, QN_OK);
  double length = 0;
  for (size_t i = 0; i < contacts.face_count; i++)
    length += contacts.faces[i].length;
  for (size_t i = 0; i < contacts.findings.count; i++) {
    g_assert_cmpint (contacts.findings.items[i].problem, !=, QN_PROBLEM_BLOCKS_OVERLAP);
    g_assert_cmpint (contacts.findings.items[i].problem, !=,
                     QN_PROBLEM_NEAR_MISS_OVERLAP);
  }
  return length;
}

/* Area common to two blocks, and the length of their joint, to the tolerance of contacts: over a
 * short stretch edges within it touch, even at an angle. */
static void
compare_pair (const QnRing *a, const QnRing *b, double tolerance, double *overlap,
              double *joint)
{
  if (!qn_box_meets_within (qn_ring_bounds (a), qn_ring_bounds (b), 2e-7))
    return;
  /* Within half the contact tolerance of the smallest units that the tests lay. */
  *joint += qn_joint_length (a, b, tolerance);
  if (!qn_box_meets_within (qn_ring_bounds (a), qn_ring_bounds (b), -1e-8))
    return;
  g_auto (QnRings) common = { 0 };
  g_assert_cmpint (qn_polygon_intersection (a, b, &common, NULL), ==, QN_OK);
  for (size_t i = 0; i < common.count; i++)
    *overlap += qn_ring_area (&common.items[i]);
}

double
test_assert_sound (QnModel *model, double area)
{
  QnDiag diag = { 0 };
  if (qn_model_prepare (model, &diag) != QN_OK)
    g_error ("block %s: %s", diag.index >= 0 ? model->blocks[diag.index].name : "",
             qn_problem_text (diag.problem));
  double sum = 0, overlap = 0, joints = 0;
  double tolerance = model->contact.tolerance * model->characteristic_length;
  for (size_t i = 0; i < model->block_count; i++) {
    QnRing a = block_ring (model, i);
    g_assert_cmpint (qn_ring_check (&a, (QnId) i, NULL), ==, QN_OK);
    sum += qn_ring_area (&a);
    for (size_t k = 0; k < i; k++) {
      QnRing b = block_ring (model, k);
      compare_pair (&b, &a, tolerance, &overlap, &joints);
    }
  }
  g_assert_cmpfloat_with_epsilon (sum, area, 1e-9);
  g_assert_cmpfloat (overlap, <, 1e-9);
  g_assert_cmpfloat_with_epsilon (face_length (model), joints, 2e-5);
  return joints;
}
