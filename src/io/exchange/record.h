/* Records of ground motion: accelerations in time, from the files that seismologists publish.
 *
 *   table       columns separated by commas, semicolons, tabs or blanks; the first is the time. The
 *               last line of the heading may name columns and units: "time [s], acceleration
 *               [m/s2]"; of more than two the one of acceleration is taken. A decimal comma is
 *               recognised. Lines that begin with # % ! * | or // are comments, and may state the
 *               unit: "# units: m/s2"
 *   samples     accelerations alone, any number a line, under a heading that may state unit, time
 *               step and number: PEER (AT2, older ones too), ESM/Itaca, COSMOS and CSMIP (V2),
 *               K-NET and KiK-net, AFAD with one component
 *
 * The kind is told from the contents, encoded in UTF-8, UTF-16 or Windows-1252. Units are m/s2, cm/s2
 * (also gal), mm/s2, um/s2, nm/s2, ft/s2, in/s2 and g = 9.80665 m/s2 (also mg, %g, g/10), however spelt.
 * If a file does not state its unit or its time step, they must be given. Errors: a given unit or time
 * step that differs from the file's; a heading with two of them, or with another number of samples; a
 * largest acceleration in the heading, which alone states the unit, that the data do not have. Records of
 * velocity and of displacement, and spectra, are refused. The offset of raw data of K-NET is removed if
 * the largest acceleration in their heading is one without it.
 */
#pragma once

#include "io/project/project.h"

typedef struct QnRecord {
  QnVec2 *points; /* s, m/s2; free with g_free() */
  gsize count;
  const char *unit;  /* of the file's numbers; not to be freed */
  double offset;     /* m/s2, taken off raw data */
  gsize gap;         /* the sample behind the first gap; 0: none */
  gsize gap_line;    /* of that sample in the file; 0: not of a file */
  double missing[2]; /* samples, in that gap and in all */
} QnRecord;

/* Reads a record, or if `spectrum` accelerations by periods, s. `unit` (nullable) and `time_step` (s; 0:
 * not given): of files that do not state them. `record` is overwritten without being cleared and holds
 * nothing on failure. Errors: QN_IO_ERROR, with the line where there is one. */
gboolean qn_record_read (const char *path, const char *unit, double time_step,
                         gboolean spectrum, QnRecord *record, GError **error);

/* The same from memory; `name` stands for the file in messages. */
gboolean qn_record_parse (const char *text, gsize length, const char *name,
                          const char *unit, double time_step, gboolean spectrum,
                          QnRecord *record, GError **error);

void qn_record_clear (QnRecord *record);

/* Duration and peaks of a record, without correction of the base line. */
typedef struct QnRecordFacts {
  double duration;     /* s */
  double peak;         /* m/s2 */
  double velocity;     /* m/s, largest */
  double displacement; /* m, largest */
  double time_step;    /* s between samples; NAN where they do not follow evenly */
  double end_velocity, end_displacement; /* m/s, m: drift of the base line */
} QnRecordFacts;

QnRecordFacts qn_record_facts (const QnRecord *record);

/* Warnings: a peak above 3 g, many samples far apart, an offset; NULL: none. Free with g_free(). */
char *qn_record_dup_doubt (const QnRecord *record);

/* Finds the samples that are missing in an otherwise even column of times, as it has been done for a record
 * that was read. */
void qn_record_find_gap (QnRecord *record);

/* The warning of that, behind file (NULL: without) and line; NULL: none. Free with g_free(). */
char *qn_record_dup_gap (const QnRecord *record, const char *file);

/* Writes time and acceleration as CSV that says its unit. */
gboolean qn_record_write (const char *path, const QnRecord *record, GError **error);

/* Whether the duration of an analysis in time is given, and leaves out more than a hundredth of the
 * Arias intensity of a motion, whose points must be there. */
gboolean qn_record_is_cut (const QnModel *model, const QnGroundMotion *motion);

/* Reads the record that a ground motion of a project names, from the folder where the project lies
 * (NULL: that of its path), and scales it to its peak; and those of all ground motions. Three
 * things are refused: a record that ends more than a sample before the duration of an analysis in
 * time, unless the ground motion has `rest`; a file outside the project's folder, unless
 * `allow_outside`; and, by the second form, a record, points or a pulse that the duration cuts. */
gboolean qn_project_read_record (QnProject *project, gsize index, const char *folder,
                                 gboolean allow_outside, GError **error);
gboolean qn_project_read_records (QnProject *project, const char *folder,
                                  gboolean allow_outside, GError **error);
