/* Private to making a project of a drawing (drawing-import.h): shared data, and the steps in the order of
 * drawing-import.c. Each changes the work and adds lines to the report.
 */
#pragma once

#include "io/exchange/drawing-import.h"
#include "stereotomy/linework.h"

/* One outline on its way to a block. */
typedef struct QnOutline {
  QnRing ring; /* m; counter-clockwise */
  QnRole role;
  double density;   /* kg/m3; 0: that of the settings */
  double thickness; /* m; likewise */
  guint line;       /* of the file, from 1; 0 for faces of line work */
} QnOutline;

typedef struct QnImportWork {
  const QnDrawing *drawing;
  const QnImportSettings *settings;
  const char *name; /* of the file, for messages */
  QnImportReport *report;
  double unit;      /* m per unit of the drawing */
  double tolerance; /* m */
  GHashTable
    *layers; /* name, as the drawing keeps it, -> number from 1 in the report's list */
  GArray *outlines;                /* QnOutline */
  QnSegments soups[QN_ROLE_COUNT]; /* open lines, m, by what their faces become */
  gboolean has_mortar;             /* gaps became blocks */
} QnImportWork;

/* Adds a line, translated, to the report, and to its warnings where the user must look. */
void qn_import_tell (QnImportWork *work, gboolean warn, const char *format, ...)
  G_GNUC_PRINTF (3, 4);

/* The upper median of doubles, which are sorted by it; 0 where there are none. */
double qn_import_median (GArray *values);

/* ---- import-layers.c ---- */

/* Whether every entry of the settings' table of layers is of the form NAME=role;
 * else FALSE with QN_IO_ERROR_OVERRIDE. The others need a table that was checked. */
gboolean qn_import_check_layers (const QnImportSettings *settings, GError **error);
QnRole qn_import_propose_role (const QnImportSettings *settings, const char *layer,
                               gboolean *doubtful);

/* Lists the layers of the drawing with their roles in the report. FALSE with QN_IO_ERROR_OVERRIDE
 * where the table names one that is not there. */
gboolean qn_import_find_layers (QnImportWork *work, GError **error);

/* ---- import-outlines.c ---- */

/* Sorts every path into outlines and line work. */
void qn_import_sort_paths (QnImportWork *work);

/* Leaves out outlines that cross themselves or have no area. */
void qn_import_drop_flawed (QnImportWork *work);

/* Leaves out repetitions of an outline, equal within the tolerance. Openings stay. */
void qn_import_drop_repeated (QnImportWork *work);

/* Line work of one role into outlines. Outlines that are there already bound faces
 * too. */
QnStatus qn_import_take_faces (QnImportWork *work, QnRole role, QnDiag *diag);

/* Welds vertices, fits neighbours to each other and leaves out outlines without area. */
void qn_import_heal (QnImportWork *work);

/* Finds joints of mortar, reports them, and closes or fills them by the settings. */
void qn_import_treat_gaps (QnImportWork *work);

/* Cuts all openings out of the blocks and supports; no opening is left among the outlines. */
QnStatus qn_import_cut_openings (QnImportWork *work, QnDiag *diag);
