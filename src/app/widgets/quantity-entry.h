/* An entry for a quantity: shows its unit, accepts any other, and says what is wrong.
 *
 * Emits "committed" when the user has entered a new, valid value (Enter, or leaving the
 * field). What cannot be read, or lies outside of the limits, is marked and not committed:
 * "refused" has the reason. "menu" is before the context menu opens, which GTK makes.
 * Properties of .ui files: "quantity" (length, stress, …), "least", "most". */
#pragma once

#include "doc/text/units.h"
#include <gtk/gtk.h>

#define QN_TYPE_QUANTITY_ENTRY (qn_quantity_entry_get_type ())
G_DECLARE_FINAL_TYPE (QnQuantityEntry, qn_quantity_entry, QN, QUANTITY_ENTRY, GtkEntry)

/* Values outside of least .. most are refused. */
GtkWidget *qn_quantity_entry_new (QnQuantity quantity, double least, double most);

/* The value that was committed last is not taken: what was typed stays, with the reason. */
void qn_quantity_entry_refuse (QnQuantityEntry *entry, const char *message);

/* A value other than the present one that lies within the limits: the `attempt`-th of several, near
 * ones first; FALSE where there are no more. */
gboolean qn_quantity_entry_get_other (QnQuantityEntry *entry, guint attempt,
                                      double *value);

double qn_quantity_entry_get_value (QnQuantityEntry *entry); /* SI */
void qn_quantity_entry_set_value (QnQuantityEntry *entry, double value);

/* There is no one value: the entry is empty and says so, and any value that is entered is new. */
void qn_quantity_entry_set_mixed (QnQuantityEntry *entry);
