/* A vehicle that moves over a structure: the load multiplier, and how it collapses, for every position of
 * its front. */
#pragma once

#include "core/path/analysis.h"
#include "io/project/project.h"

/* Member of a project file that keeps the settings. */
#define QN_ENVELOPE_MEMBER "envelope"

typedef enum { QN_WAYS_BOTH, QN_WAYS_RIGHT, QN_WAYS_LEFT, QN_WAYS_COUNT } QnWays;

/* Limit analysis with the project's flow, or non-associative whatever it says; the path by its procedure. */
typedef enum {
  QN_ENVELOPE_LIMIT,
  QN_ENVELOPE_NON_ASSOCIATIVE,
  QN_ENVELOPE_PATH,
  QN_ENVELOPE_METHOD_COUNT
} QnEnvelopeMethod;

typedef struct QnEnvelopeSettings {
  char *
    *vehicles; /* names, of the project's or built in; owned; NULL: that of the load */
  double from,
    to;        /* m, of the front; not-a-number: from before the structure to behind it */
  double step; /* m between positions, > 0 */
  QnWays ways;
  QnEnvelopeMethod method;
} QnEnvelopeSettings;

/* The project's settings, usual ones where it has none; FALSE with `error`. */
gboolean qn_envelope_settings_read (const QnProject *project,
                                    QnEnvelopeSettings *settings, GError **error);
char *qn_envelope_settings_to_json (const QnEnvelopeSettings *settings);
void qn_envelope_settings_clear (QnEnvelopeSettings *settings);

/* One vehicle on one way: a result for every position, of which multiplier and mechanism are kept. Where
 * the vehicle loads nothing, or nothing collapses, the multiplier is not-a-number; where the analysis came to no
 * answer, the outcome says so. */
typedef struct QnEnvelopeLine {
  QnId vehicle;
  bool reversed;
  QnResult *results;
} QnEnvelopeLine;

typedef struct QnEnvelope {
  QnModel model; /* a copy, prepared */
  QnContacts contacts;
  gsize load; /* of the model's live loads */
  gsize count;
  double *x; /* positions of the front, m, ascending */
  QnEnvelopeLine *lines;
  gsize line_count;
  bool unstable; /* the dead load alone has no stable equilibrium: nothing was found */
  gint done;     /* positions of all lines that are computed, line by line; atomic */
} QnEnvelope;

/* A position of a line. */
typedef struct QnEnvelopePlace {
  gsize line, position;
} QnEnvelopePlace;

/* The vehicle among the growing loads; G_MAXSIZE where there is none. */
gsize qn_find_vehicle_load (const QnModel *model);

/* An envelope of the project's model that is still to be computed. FALSE with `error`. */
gboolean qn_envelope_init (QnEnvelope *envelope, const QnModel *model,
                           const QnEnvelopeSettings *settings, GError **error);
void qn_envelope_clear (QnEnvelope *envelope);

/* Computes the envelope; other threads may read the first `done` positions meanwhile. QN_ERROR_CANCELLED by
 * `progress`; QN_ERROR_INVALID with the reason in `diag`. */
QnStatus qn_envelope_run (QnEnvelope *envelope, QnProgressFunc progress, void *data,
                          QnDiag *diag);

/* The structure with the vehicle there, prepared: qn_model_clear(). */
QnStatus qn_envelope_move (const QnEnvelope *envelope, QnEnvelopePlace at, QnModel *moved,
                           QnDiag *diag);

/* Whether the analysis found no answer there. */
gboolean qn_envelope_is_open (const QnEnvelope *envelope, QnEnvelopePlace at);

/* The multiplier found there; NaN: none. */
double qn_envelope_multiplier (const QnEnvelope *envelope, QnEnvelopePlace at);

/* The least computed multiplier; FALSE: none. */
gboolean qn_envelope_find_least (const QnEnvelope *envelope, QnEnvelopePlace *least);

/* "CS 454 bogie 1.3 m, to the left" */
char *qn_envelope_dup_line_name (const QnEnvelope *envelope, gsize line);
/* The adequacy factor there as a sentence; the same with the total axle load and, if `whole`, notes on all
 * positions: bounds, positions without an answer. Free with g_free(). */
char *qn_envelope_dup_factor (const QnEnvelope *envelope, QnEnvelopePlace at);
char *qn_envelope_dup_text (const QnEnvelope *envelope, QnEnvelopePlace at,
                            gboolean whole);

/* A row for each position: "position [m]", and the multiplier of each line, named by its way, and by
 * its vehicle where there are several. */
gboolean qn_envelope_write_table (const QnEnvelope *envelope, const char *path,
                                  GError **error);
