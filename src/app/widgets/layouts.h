/* Layouts of boxes that GTK does not have. */
#pragma once

#include <gtk/gtk.h>

/* The box shows the first of its children that has room for what it asks for at least, else the
 * last. */
void qn_layout_first_fit (GtkWidget *box);

/* Two children beside each other, or, without room for that, the second below the first. One takes
 * the rest of the width: the second if it expands, which then has to have its least width, or the
 * first. One that expands and needs more width than the first goes above it. */
void qn_layout_wrap_pair (GtkWidget *box);

/* Children of one size, in as few columns as there is height for, all but the last of equal height. */
void qn_layout_even_columns (GtkWidget *box);
