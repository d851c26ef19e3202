/* The heading of a record of ground motion: quantity, unit, time step, number of samples. Private to
 * reading records (record-read.c). One reader for all: PEER, ESM, COSMOS, CSMIP, K-NET, AFAD, the first
 * line of a table, comments. */
#pragma once

#include "core/base/base.h"

#include <glib.h>

typedef enum {
  QN_RECORD_UNKNOWN,
  QN_RECORD_ACCELERATION,
  QN_RECORD_VELOCITY,
  QN_RECORD_DISPLACEMENT,
  QN_RECORD_TIME,
  QN_RECORD_SPECTRUM
} QnRecordQuantity;

typedef struct QnRecordUnit {
  QnRecordQuantity quantity; /* UNKNOWN where the text is no unit */
  double factor;             /* SI units per unit */
} QnRecordUnit;

typedef struct QnRecordHeading {
  QnRecordUnit unit;         /* as the heading states it */
  double scale;              /* of the file's numbers, to be in that unit */
  QnRecordQuantity quantity; /* in words */
  gsize unit_line;           /* from 1; 0: none */
  double time_step;          /* s; 0: not stated */
  double count;              /* samples; 0: not stated */
  gsize peak_line;   /* from 1, with the largest acceleration or several; 0: none */
  gsize second_step; /* a line that states another time step than one before; 0: none */
  gsize second_unit; /* the same of the unit */
} QnRecordHeading;

/* "m/s2", "cm/sec^2", "m s-2", "gal", "G", "CM/S" …; blanks, powers and case do not matter. */
QnRecordUnit qn_record_unit (const char *text);

/* One name of a unit; "" of none. */
const char *qn_record_unit_name (QnRecordUnit unit);

/* The unit in brackets or behind "in" in the name of a column, and the quantity that unit or words
 * say: "Beschleunigung [m/s2]", "vel", "acc in g". */
QnRecordUnit qn_record_unit_of_name (const char *name);
QnRecordQuantity qn_record_quantity_of_name (const char *name);

/* Whether a column of this name belongs to a spectrum: "Period (s)", "Sa [g]", "frequency". */
gboolean qn_record_is_of_spectrum (const char *name);

/* Whether the line states the number of samples that follow it, as in COSMOS and CSMIP. */
gboolean qn_record_is_descriptor (const char *line);

/* Reads the lines before `end`. */
void qn_record_heading_read (QnRecordHeading *heading, char *const *lines, gsize end);
