/* Reinforcing bars: where they cross contact faces they make pairs of their own. */
#include "core/base/memory.h"
#include "core/base/tolerance.h"
#include "core/contact/contact-search.h"

/* Where the bar crosses the line of the face, as parts of the bar and of the face. */
static bool
crossing (const QnBar *bar, const QnContactFace *face, double *on_bar, double *on_face)
{
  QnVec2 along = qn_vec2_sub (bar->end, bar->start);
  QnVec2 to = qn_vec2_sub (face->start, bar->start);
  double climb = qn_vec2_dot (along, face->normal);

  if (climb == 0)
    return false;
  *on_bar = qn_vec2_dot (to, face->normal) / climb;
  QnVec2 met = qn_vec2_add_scaled (bar->start, *on_bar, along);
  *on_face = qn_vec2_dot (qn_vec2_sub (met, face->start), face->tangent) / face->length;
  return *on_bar > 0 && *on_bar < 1 && *on_face >= 0 && *on_face <= 1;
}

static bool
is_oblique (const QnBar *bar, const QnContactFace *face)
{
  QnVec2 along = qn_vec2_sub (bar->end, bar->start);
  return fabs (qn_vec2_dot (along, face->tangent))
         > QN_TOLERANCE_OBLIQUE_BAR * qn_vec2_length (along);
}

QnStatus
qn_contacts_add_bars (const QnModel *model, QnContacts *contacts, QnId index, bool *used,
                      QnDiag *diag)
{
  QnContactFace *face = &contacts->faces[index];

  for (size_t i = 0; i < model->bar_count; i++) {
    const QnBar *bar = &model->bars[i];
    double on_bar, on_face;
    if (!crossing (bar, face, &on_bar, &on_face))
      continue;
    if (is_oblique (bar, face))
      return qn_diag_set_field (diag, QN_PROBLEM_BAR_OBLIQUE, QN_ENTITY_BAR, (QnId) i,
                                NULL, 0);
    QnContactPair *pairs = contacts->pair_count + 1 > INT32_MAX
                             ? NULL
                             : qn_array_grow (contacts->pairs, &contacts->pair_capacity,
                                              contacts->pair_count + 1, sizeof *pairs);
    if (pairs == NULL)
      return qn_diag_no_memory (diag);
    contacts->pairs = pairs;
    pairs[contacts->pair_count++] = (QnContactPair){
      .face = index,
      .point = qn_vec2_lerp (face->start, face->end, on_face),
      .abscissa = on_face * face->length,
      .tributary = bar->area / face->thickness,
      .bar = (QnId) i,
    };
    face->pair_count++;
    used[i] = true;
  }
  return QN_OK;
}
