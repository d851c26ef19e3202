/* What the window tells of the joint or block under the pointer, in words and units.
 *
 * Numbers are those of render/scene/reading.h at the step that is shown. In the views of the model
 * they are told as long as the current run is of the same model; otherwise geometry alone. */
#pragma once

#include "doc/text/units.h"
#include "doc/view/view-state.h"
#include "render/scene/reading.h"

/* Content of a view: a result at its step. */
typedef struct QnStepView {
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result; /* NULL: none that fits */
  gsize step;             /* of it */
  QnPairResult *pairs;    /* at that step, owned; NULL: not known */
  QnTouch *touches;       /* contacts found on the way, at that step, owned */
  gsize touch_count;
  QnMotion motion; /* its displacements NULL: not known */
  double force,
    length; /* the largest at that step, of the field that values are read from, N and m */
} QnStepView;

/* FALSE where the view has nothing to show; nothing to clear then. */
gboolean qn_step_view_init (QnStepView *view, QnViewState *state);
void qn_step_view_clear (QnStepView *view);

/* A block, a joint (FACE), or a contact found on the way, of what the view shows
 * (qn_view_state_get_content()). The name of what it is: "Joint b1 – b2", "Contact b1 – b2", "Block b1"; and
 * its values, a line for each with a tab between name and value, the most important ones alone where `brief`. NULL
 * where there is no such joint or block; the caller frees them. */
char *qn_inspect_dup_title (const QnStepView *view, QnPick what);
char *qn_inspect_dup_values (const QnStepView *view, QnPick what, QnUnits units,
                             gboolean brief);
