/* Values of the fields of forms (bound-form.h). */
#pragma once

#include "core/model/model.h"
#include <glib.h>

/* What a field shows, or what the user has entered. Zeroed to begin with. */
typedef struct QnValue {
  double number; /* in SI; row of a choice or a list, -1 for none; 1 for on */
  char *text;    /* owned */
  char **rows;   /* of a choice or a list, anew; owned; NULL: as they are in the file */
  guint row_count;
  const char *
    *icons; /* of the rows of a list; owned, the names are not; NULL: they have none */
  gboolean mixed;    /* a check or number that is not the same for all that is selected */
  gboolean disabled; /* shown, but not to be used now */
} QnValue;

/* The number as a whole one, of 0 or more; as a row, and whether it is on. */
int qn_value_int (const QnValue *value);

/* One more row of a choice or a list; `row` is taken over, or copied. */
void qn_value_take_row (QnValue *value, char *row);
void qn_value_add_row (QnValue *value, const char *row);
/* The icon of the last row; every row has one, or none has. */
void qn_value_set_icon (QnValue *value, const char *icon);

/* Names of laws as rows, with `first` (nullable) before them for none, and the row of `law`; the law
 * of such a row. */
void qn_value_set_laws (QnValue *value, const QnModel *model, const char *first,
                        QnId law);
QnId qn_value_get_law (const QnValue *value);

/* Names of sections likewise, without a row for none. */
void qn_value_set_sections (QnValue *value, const QnModel *model, QnId section);

/* What a field shows of where pairs lie on a face of a law; FALSE where the rule has no such number. */
typedef enum {
  QN_PAIRS_PLACEMENT,
  QN_PAIRS_OFFSET,
  QN_PAIRS_COUNT,
  QN_PAIRS_POSITIONS,
  QN_PAIRS_WEIGHTS
} QnPairField;
gboolean qn_value_set_pairs (QnValue *value, const QnModel *model, const QnPairRule *rule,
                             QnId law, QnPairField field);

/* Frees what it holds. */
void qn_value_clear (QnValue *value);
