/* A law in words: its line in the list of laws. */
#pragma once

#include "core/contact/contacts.h"
#include "doc/text/units.h"

/* Of the kinds and bases, to be translated. */
extern const char *const qn_law_kind_words[QN_LAW_KIND_COUNT];
extern const char *const qn_basis_words[QN_BASIS_COUNT];

/* Name of the number of a key ("Friction, tangent"), to be translated. */
const char *qn_law_number_word (const char *key);

/* Quantity of the number of a key ("kn", "friction", …) by basis. */
QnQuantity qn_law_quantity (const char *key, QnBasis basis);

/* Name; kind, basis and what has it; main numbers; the source: a line each. Free with g_free(). */
char *qn_law_dup_text (const QnModel *model, const QnContacts *contacts, QnId law,
                       QnUnits units);
