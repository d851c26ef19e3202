/* A law in words: its line in the list of laws. */
#pragma once

#include "core/contact/contacts.h"
#include "core/law/law.h"
#include "doc/text/units.h"
#include "render/figure/curve-plot.h"

#include <glib.h>

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

/* Most turning points of a history. */
#define QN_LAW_MAX_TURNS 64

typedef struct QnLawPreset {
  QnLaw law;
  gboolean shear;                 /* the history is one of slip, with `pressed` held */
  double pressed;                 /* normal elongation meanwhile, m or strain */
  double turns[QN_LAW_MAX_TURNS]; /* elongations that the history goes through, from 0 */
  gsize turn_count;
} QnLawPreset;

/* The preset of a kind; static. */
const QnLawPreset *qn_law_preset (QnLawKind kind);

/* Another kind for a law: what the new kind requires and the law does not have is typical. Laws of
 * members come with their basis and stiffness, and without a source; joints keep theirs. */
void qn_law_change_kind (QnLaw *law, QnLawKind kind);

/* One point of the history; normal and tangential. */
typedef struct QnLawSample {
  double elongation[2]; /* m, or strain in the material basis */
  double force[2];      /* N, or Pa in the other bases */
  double tangent[2];
} QnLawSample;

/* Takes a spring of unit area through the history of `what`; `length` (m) is that of the block's
 * side where the law speaks of strains, 1 elsewhere. Appends QnLawSample. FALSE where the law has
 * too little fracture energy for that length. */
gboolean qn_law_trace (const QnLawPreset *what, double length, GArray *samples);

/* A plot of such samples. */
QnPlot *qn_law_plot (const QnLawPreset *what, const GArray *samples);

/* A law of one's own with the typical history of its kind, scaled to its numbers. */
QnLawPreset qn_law_preset_for (const QnLaw *law);
