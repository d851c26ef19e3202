#include "support/contacts.h"

#include <glib.h>

static void
check_face (const QnModel *model, const QnContacts *contacts, size_t index)
{
  const QnContactFace *face = &contacts->faces[index];
  double size = model->characteristic_length;
  QnVec2 along = qn_vec2_sub (face->end, face->start);
  g_assert_cmpint (face->a, <, face->b);
  g_assert_cmpfloat (face->length, >, 0);
  g_assert_cmpfloat_with_epsilon (qn_vec2_length (face->normal), 1, 1e-14);
  g_assert_cmpfloat_with_epsilon (qn_vec2_dot (along, face->tangent), face->length,
                                  1e-9 * size);
  QnVec2 turned = qn_vec2_perp (face->normal);
  g_assert_cmpfloat (turned.x, ==, face->tangent.x);
  g_assert_cmpfloat (turned.y, ==, face->tangent.y);

  if (index > 0) {
    const QnContactFace *before = face - 1;
    g_assert_true (before->a < face->a || (before->a == face->a && before->b <= face->b));
  }

  double sum = 0, last = -1;
  for (int32_t i = 0; i < face->pair_count; i++) {
    const QnContactPair *pair = &contacts->pairs[face->first_pair + i];
    QnVec2 arm = qn_vec2_sub (pair->point, face->start);
    g_assert_cmpint (pair->face, ==, (QnId) index);
    if (pair->bar != QN_NONE)
      continue;
    g_assert_cmpfloat (pair->abscissa, >, last);
    g_assert_cmpfloat_with_epsilon (qn_vec2_dot (arm, face->tangent), pair->abscissa,
                                    1e-6 * size);
    last = pair->abscissa;
    sum += pair->tributary;
  }
  g_assert_cmpfloat_with_epsilon (sum, face->length, 1e-12 * face->length);
}

void
test_detect (QnModel *model, QnContacts *contacts)
{
  QnDiag diag = { 0 };
  if (qn_model_prepare (model, &diag) != QN_OK
      || qn_contacts_detect (model, contacts, &diag) != QN_OK)
    g_error ("%s (%s, index %d)", qn_problem_text (diag.problem),
             diag.field != NULL ? diag.field : "whole", diag.index);
  size_t pairs = 0;
  for (size_t i = 0; i < contacts->face_count; i++) {
    g_assert_cmpint (contacts->faces[i].first_pair, ==, (QnId) pairs);
    pairs += (size_t) contacts->faces[i].pair_count;
    check_face (model, contacts, i);
  }
  g_assert_cmpuint (pairs, ==, contacts->pair_count);
}

void
test_detect_sound (QnModel *model, QnContacts *contacts)
{
  test_detect (model, contacts);
  g_assert_cmpint (qn_contacts_require_sound (model, contacts, NULL), ==, QN_OK);
  if (contacts->findings.count > 0)
    g_test_message ("%s: %g", qn_problem_text (contacts->findings.items[0].problem),
                    contacts->findings.items[0].value);
  g_assert_cmpuint (contacts->findings.count, ==, 0);
}

size_t
test_count_findings (const QnContacts *contacts, QnProblem problem)
{
  size_t count = 0;
  for (size_t i = 0; i < contacts->findings.count; i++)
    count += contacts->findings.items[i].problem == problem;
  return count;
}

const QnFinding *
test_the_finding (const QnContacts *contacts, QnProblem problem)
{
  const QnFinding *found = NULL;
  g_assert_cmpuint (test_count_findings (contacts, problem), ==, 1);
  for (size_t i = 0; i < contacts->findings.count; i++) {
    if (contacts->findings.items[i].problem == problem)
      found = &contacts->findings.items[i];
  }
  return found;
}

#define SAME(member) g_assert_true (f->member == e->member)
#define SAME_PLACE(member)                                                               \
  g_assert_true (f->member.x == e->member.x && f->member.y == e->member.y)

void
test_assert_same_faces (const QnContacts *found, const QnContacts *expected)
{
  g_assert_cmpuint (found->face_count, ==, expected->face_count);
  for (size_t i = 0; i < found->face_count; i++) {
    const QnContactFace *f = &found->faces[i], *e = &expected->faces[i];
    SAME (a);
    SAME (b);
    SAME (edge_a);
    SAME (edge_b);
    SAME_PLACE (start);
    SAME_PLACE (end);
    SAME_PLACE (normal);
    SAME_PLACE (tangent);
    SAME (length);
    SAME (thickness);
    SAME (law_a);
    SAME (law_b);
    SAME (first_pair);
    SAME (pair_count);
  }
  g_assert_cmpuint (found->pair_count, ==, expected->pair_count);
  for (size_t i = 0; i < found->pair_count; i++) {
    const QnContactPair *f = &found->pairs[i], *e = &expected->pairs[i];
    SAME (face);
    SAME (bar);
    SAME_PLACE (point);
    SAME (abscissa);
    SAME (tributary);
    SAME (found);
    SAME_PLACE (foot);
  }
}
