/* What a window shows of its document: the view, the step, the scale and the switches.
 *
 * Several widgets look at it (drawing, curve, step slider); each change is announced by
 * "changed", without arguments. The document is not changed by looking at it.
 */
#pragma once

#include "doc/document/document.h"
#include "render/scene/view-options.h"

#define QN_TYPE_VIEW_STATE (qn_view_state_get_type ())
G_DECLARE_FINAL_TYPE (QnViewState, qn_view_state, QN, VIEW_STATE, GObject)

/* Read by all, changed by the functions below; but field, diagram, phase and the place of the underlay are set
 * in the options, before qn_view_state_changed(). A field that is not known at the step shown (stresses where
 * forces were not kept) is left out. The underlay is the picture as the document has it, or as it is being
 * moved until the document changes; its image is NULL where there is none or it cannot be read. */
struct _QnViewState {
  GObject parent_instance;
  QnDocument *document;
  QnViewOptions options; /* as they are set: see qn_view_state_get_options() */
  /* Of the underlay's image, which is owned, or of the one that could not be read, and why; NULL: nothing wrong. */
  char *image_path;
  GError *image_error;
  QnRun *onion;      /* a second run drawn as an outline over the current one, or NULL */
  bool result_loads; /* whether the views of results show loads */
  double mechanism_scale; /* a mechanism has no size, and a factor of its own */
  double fitting_scale;   /* of the current run; 0: not requested yet */
};

/* Shows the model; holds the document. */
QnViewState *qn_view_state_new (QnDocument *document);

/* Announces that something was set. */
void qn_view_state_changed (QnViewState *state);

/* Current options, step resolved to a number where there is a run. */
QnViewOptions qn_view_state_get_options (QnViewState *state);

void qn_view_state_set_view (QnViewState *state, QnView view);

/* Step of the current run, or QN_STEP_LAST; clamped to those there are. */
int qn_view_state_get_step (QnViewState *state);
/* Its number, 0 where there are no steps. */
gsize qn_view_state_get_shown_step (QnViewState *state);
void qn_view_state_set_step (QnViewState *state, int step);

/* The same, in the view of displacements where the one that is shown has no steps. */
void qn_view_state_show_step (QnViewState *state, int step);

/* Factor on displacements, QN_SCALE_AUTO for one that fits. The mechanism, whose size means nothing,
 * has one of its own, set and told while it is shown. */
void qn_view_state_set_scale (QnViewState *state, double scale);

/* The factor that the deformed view draws with: the one that is set, or the one that fits all steps
 * of the current run; 1 without a run. */
double qn_view_state_get_shown_scale (QnViewState *state);

/* Switches by the names of the window's actions: "ghost", "symbols", "loads", "dimensions",
 * "names", "values". Loads have one for the views of the model, on at first, and one for those of results. */
gboolean qn_view_state_get_switch (QnViewState *state, const char *name);
void qn_view_state_set_switch (QnViewState *state, const char *name, gboolean on);

/* The picture is again where the document has it. */
void qn_view_state_refresh_underlay (QnViewState *state);

/* Only a run of the same structure is taken. */
void qn_view_state_set_onion (QnViewState *state, QnRun *run);

/* The model, contacts and result that a view shows: those of the current run where the view needs a
 * result, else the document's. `result` is NULL for the latter. False where the view needs a result and
 * there is none. */
gboolean qn_view_state_get_content (QnViewState *state, QnView view,
                                    const QnModel **model, const QnContacts **contacts,
                                    const QnResult **result);
