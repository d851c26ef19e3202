/* Forms of the side panels: rows of a label and a field, in a grid. */
#ifndef QN_APP_FORM_H
#define QN_APP_FORM_H

#include "app/canvas/canvas.h"
#include "app/widgets/quantity-entry.h"
#include "core/model/model.h"

/* An empty form. */
GtkWidget *qn_form_new (void);

/* A heading over the rows that follow. */
GtkWidget *qn_form_add_heading (GtkWidget *form, const char *text);

/* A row; the label gets the mnemonic in its text and names the field for screen readers. */
void qn_form_add_row (GtkWidget *form, const char *label, GtkWidget *field);

/* A widget over both columns. */
void qn_form_add_wide (GtkWidget *form, GtkWidget *widget);

/* A row with a quantity, calling `committed` (QnQuantityEntry *, user_data) for new values. */
QnQuantityEntry *qn_form_add_quantity (GtkWidget *form, const char *label,
                                       QnQuantity quantity, double least, double most,
                                       GCallback committed, gpointer user_data);

/* A row with a choice, calling `selected` (GtkDropDown *, GParamSpec *, user_data). */
GtkDropDown *qn_form_add_choice (GtkWidget *form, const char *label,
                                 const char *const *choices, GCallback selected,
                                 gpointer user_data);

/* An entry for words; `activate` (GtkEntry *, user_data) when it is to be taken. */
GtkWidget *qn_form_add_entry (GtkWidget *form, const char *label, int width_chars,
                              GCallback activate, gpointer user_data);

/* A paragraph that wraps. */
GtkLabel *qn_form_add_text (GtkWidget *form);

/* Shows or hides a row by its field. */
void qn_form_set_row_visible (GtkWidget *field, gboolean visible);

/* A check button over both columns, calling `toggled` (GtkCheckButton *, user_data). */
GtkWidget *qn_form_add_check (GtkWidget *form, const char *label, gboolean active,
                              GCallback toggled, gpointer user_data);
void qn_form_set_check (GtkWidget *check, gboolean active, gpointer user_data);

/* Fills a choice with strings, without calling back. */
void qn_form_fill_choice (GtkDropDown *choice, const char *const *strings, guint selected,
                          gpointer user_data);

/* Fills a choice with the laws of a model, `first` before them standing for none. */
void qn_form_fill_laws (GtkDropDown *choice, const QnModel *model, const char *first,
                        QnId law, gpointer user_data);
/* The law that such a choice shows, or QN_NONE. */
QnId qn_form_get_law (GtkDropDown *choice);

/* A list of lines over both columns, of which one is selected, calling `selected` (GtkListBox *,
 * GtkListBoxRow *, user_data); `name` is for screen readers. */
GtkWidget *qn_form_add_list (GtkWidget *form, const char *name, GCallback selected,
                             gpointer user_data);
/* Fills it without calling back; selected < 0: none. It hides while it has no lines. */
void qn_form_fill_list (GtkWidget *list, const char *const *lines, int selected,
                        gpointer user_data);

/* Buttons beside each other over both columns. */
GtkWidget *qn_form_add_buttons (GtkWidget *form);
/* One of them, calling `clicked` (user_data). */
GtkWidget *qn_form_add_button (GtkWidget *buttons, const char *label, const char *tooltip,
                               GCallback clicked, gpointer user_data);

/* Sets a choice without calling back. */
void qn_form_set_choice (GtkDropDown *choice, guint selected, gpointer user_data);

/* Calls `func` (data) on a signal without arguments for as long as `owner` lives. */
void qn_watch (GtkWidget *owner, gpointer object, const char *signal, GCallback func,
               gpointer data);

/* Frees `data` with g_free() when `owner` is gone. */
void qn_own (GtkWidget *owner, gpointer data);

/* Both for a form of what is selected: it owns `data`, and `update` (data) is called when the
 * document or the selection has changed. */
void qn_form_follow_canvas (GtkWidget *form, QnCanvas *canvas, GCallback update,
                            gpointer data);

#endif
