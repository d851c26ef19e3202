/* What is described in ui/NAME.ui, and what widgets of it hear and own. */
#pragma once

#include <gtk/gtk.h>

/* Makes all that a description has; `name` is the file's without folder and ending. The caller takes
 * what it needs by id before it lets go of the builder. */
GtkBuilder *qn_builder_new (const char *name);

/* The widget of that id, borrowed. */
GtkWidget *qn_builder_get_widget (GtkBuilder *builder, const char *id);

/* The widget of that id, which nothing contains yet, floating: for a parent that outlives the builder; or a
 * window. It knows the other widgets of the description by their ids, as long as they live. */
GtkWidget *qn_builder_take_widget (GtkBuilder *builder, const char *id);
gpointer qn_part (gpointer taken, const char *id);

/* Actions of a widget and of what is in it, whose names begin so (a constant): also after it has moved into
 * another window, where GTK 4.8 forgets them. The widget keeps the group as QN_ACTIONS. */
#define QN_ACTIONS "qn-actions"
void qn_actions_insert (GtkWidget *widget, const char *prefix,
                        const GActionEntry *entries, gsize count, gpointer data);
void qn_actions_enable (GtkWidget *widget, const char *name, gboolean enabled);

/* Calls `func` (data), with what the signal tells behind it, for as long as `owner` lives. */
void qn_watch (GtkWidget *owner, gpointer object, const char *signal, GCallback func,
               gpointer data);

/* Frees `data`, all that the owner has so, with g_free() when `owner` is gone. */
void qn_own (GtkWidget *owner, gpointer data);
