/* How the law answers a typical history of elongations. */
#pragma once

#include "core/law/law.h"
#include <gtk/gtk.h>

/* Makes a QnPaperArea one. */
void qn_law_view_init (GtkWidget *area);

/* Takes a copy. */
void qn_law_view_set_law (GtkWidget *view, const QnLaw *law);
