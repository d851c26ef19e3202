/* The energies of an analysis in time beneath its history: a cursor at the step that is shown, and
 * what every kind comes to there, or under the pointer. A click or drag goes to that time, the
 * arrow keys from step to step. */
#ifndef QN_APP_ENERGY_VIEW_H
#define QN_APP_ENERGY_VIEW_H

#include "doc/view/view-state.h"
#include <gtk/gtk.h>

/* Hidden where the current run is none in time. */
GtkWidget *qn_energy_view_new (QnViewState *state);

#endif
