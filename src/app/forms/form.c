#include "app/forms/form.h"

#include "app/widgets/choice-list.h"

#define ROW_SPACING    6
#define COLUMN_SPACING 12
#define MARGIN         12

#define ROW_LABEL "qn-row-label"

GtkWidget *
qn_form_new (void)
{
  GtkWidget *grid = gtk_grid_new ();
  gtk_grid_set_row_spacing (GTK_GRID (grid), ROW_SPACING);
  gtk_grid_set_column_spacing (GTK_GRID (grid), COLUMN_SPACING);
  gtk_widget_set_margin_top (grid, MARGIN);
  gtk_widget_set_margin_bottom (grid, MARGIN);
  gtk_widget_set_margin_start (grid, MARGIN);
  gtk_widget_set_margin_end (grid, MARGIN);
  return grid;
}

static int
next_row (GtkWidget *form)
{
  int row = GPOINTER_TO_INT (g_object_get_data (G_OBJECT (form), "qn-rows"));
  g_object_set_data (G_OBJECT (form), "qn-rows", GINT_TO_POINTER (row + 1));
  return row;
}

void
qn_form_add_wide (GtkWidget *form, GtkWidget *widget)
{
  gtk_grid_attach (GTK_GRID (form), widget, 0, next_row (form), 2, 1);
}

GtkWidget *
qn_form_add_heading (GtkWidget *form, const char *text)
{
  GtkWidget *label = gtk_label_new (text);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_widget_add_css_class (label, "heading");
  gtk_widget_set_margin_top (label, ROW_SPACING);
  qn_form_add_wide (form, label);
  return label;
}

/* A row; the label gets the mnemonic in its text and names the field for screen readers. */
static void
add_row (GtkWidget *form, const char *text, GtkWidget *field)
{
  GtkWidget *label = gtk_label_new_with_mnemonic (text);
  gtk_label_set_mnemonic_widget (GTK_LABEL (label), field);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_widget_set_hexpand (label, TRUE);
  gtk_widget_set_halign (field, GTK_ALIGN_FILL);
  gtk_accessible_update_relation (GTK_ACCESSIBLE (field),
                                  GTK_ACCESSIBLE_RELATION_LABELLED_BY, label, NULL, -1);
  g_object_set_data (G_OBJECT (field), ROW_LABEL, label);
  int row = next_row (form);
  gtk_grid_attach (GTK_GRID (form), label, 0, row, 1, 1);
  gtk_grid_attach (GTK_GRID (form), field, 1, row, 1, 1);
}

GtkDropDown *
qn_form_add_choice (GtkWidget *form, const char *label, const char *const *choices,
                    GCallback selected, gpointer user_data)
{
  GtkWidget *choice = gtk_drop_down_new_from_strings (choices);
  qn_choice_list_prepare (GTK_DROP_DOWN (choice));
  g_signal_connect (choice, "notify::selected", selected, user_data);
  add_row (form, label, choice);
  return GTK_DROP_DOWN (choice);
}

GtkLabel *
qn_form_add_text (GtkWidget *form)
{
  GtkWidget *label = gtk_label_new (NULL);
  gtk_label_set_xalign (GTK_LABEL (label), 0.0f);
  gtk_label_set_wrap (GTK_LABEL (label), TRUE);
  gtk_label_set_wrap_mode (GTK_LABEL (label), PANGO_WRAP_WORD_CHAR);
  gtk_label_set_max_width_chars (GTK_LABEL (label), 36);
  gtk_label_set_selectable (GTK_LABEL (label), FALSE);
  qn_form_add_wide (form, label);
  return GTK_LABEL (label);
}

void
qn_form_set_row_visible (GtkWidget *field, gboolean visible)
{
  gtk_widget_set_visible (field, visible);
  GtkWidget *label = g_object_get_data (G_OBJECT (field), ROW_LABEL);
  if (label != NULL)
    gtk_widget_set_visible (label, visible);
}

void
qn_form_set_choice (GtkDropDown *choice, guint selected, gpointer user_data)
{
  g_signal_handlers_block_matched (choice, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                   user_data);
  gtk_drop_down_set_selected (choice, selected);
  g_signal_handlers_unblock_matched (choice, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                     user_data);
}

void
qn_form_fill_choice (GtkDropDown *choice, const char *const *strings, guint selected,
                     gpointer user_data)
{
  qn_choice_list_fill (choice, strings, selected, user_data);
}

void
qn_watch (GtkWidget *owner, gpointer object, const char *signal, GCallback func,
          gpointer data)
{
  GClosure *closure = g_cclosure_new_swap (func, data, NULL);
  g_object_watch_closure (G_OBJECT (owner), closure);
  g_signal_connect_closure (object, signal, closure, FALSE);
}

static void
on_owner_gone (gpointer data, GObject *where)
{
  (void) where;
  g_free (data);
}

void
qn_own (GtkWidget *owner, gpointer data)
{
  g_object_weak_ref (G_OBJECT (owner), on_owner_gone, data);
}
