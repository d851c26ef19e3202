/* A row of a form: a label with a mnemonic, and the field that it names, also for screen readers.
 * Shown exactly while its field is. Properties: "label", "field". */
#pragma once

#include <gtk/gtk.h>

#define QN_TYPE_ROW (qn_row_get_type ())
G_DECLARE_FINAL_TYPE (QnRow, qn_row, QN, ROW, GtkWidget)

GtkWidget *qn_row_new (const char *label, GtkWidget *field);

GtkWidget *qn_row_get_label (QnRow *row);
GtkWidget *qn_row_get_field (QnRow *row);
