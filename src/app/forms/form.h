/* What widgets of forms and panels hear and own. */
#pragma once

#include "app/canvas/canvas.h"

/* Calls `func` (data) on a signal without arguments for as long as `owner` lives. */
void qn_watch (GtkWidget *owner, gpointer object, const char *signal, GCallback func,
               gpointer data);

/* Frees `data` with g_free() when `owner` is gone. */
void qn_own (GtkWidget *owner, gpointer data);
