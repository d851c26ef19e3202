/* Forms of the side panels: rows of a label and a field, in a grid. */
#ifndef QN_APP_FORM_H
#define QN_APP_FORM_H

#include "app/canvas/canvas.h"

/* An empty form. */
GtkWidget *qn_form_new (void);

/* A heading over the rows that follow. */
GtkWidget *qn_form_add_heading (GtkWidget *form, const char *text);

/* A widget over both columns. */
void qn_form_add_wide (GtkWidget *form, GtkWidget *widget);

/* A row with a choice, calling `selected` (GtkDropDown *, GParamSpec *, user_data). */
GtkDropDown *qn_form_add_choice (GtkWidget *form, const char *label,
                                 const char *const *choices, GCallback selected,
                                 gpointer user_data);

/* A paragraph that wraps. */
GtkLabel *qn_form_add_text (GtkWidget *form);

/* Shows or hides a row by its field. */
void qn_form_set_row_visible (GtkWidget *field, gboolean visible);

/* Fills a choice with strings, without calling back. */
void qn_form_fill_choice (GtkDropDown *choice, const char *const *strings, guint selected,
                          gpointer user_data);

/* Sets a choice without calling back. */
void qn_form_set_choice (GtkDropDown *choice, guint selected, gpointer user_data);

/* Calls `func` (data) on a signal without arguments for as long as `owner` lives. */
void qn_watch (GtkWidget *owner, gpointer object, const char *signal, GCallback func,
               gpointer data);

/* Frees `data` with g_free() when `owner` is gone. */
void qn_own (GtkWidget *owner, gpointer data);

#endif
