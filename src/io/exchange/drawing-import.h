/* From a drawing to a project: unit, layers, healing, supports.
 *
 * Each layer has a role, by whole words of its name in four languages, unless the settings say
 * otherwise (case does not matter; an unknown layer in the settings is an error):
 *   SUPPORT, BASE, GROUND, FOUNDATION, FIXED …   fixed blocks
 *   OPENING, VOID, HOLE, WINDOW, DOOR            cut out of the blocks
 *   DIM, TEXT, AXIS, HATCH, DEFPOINTS, CONTACTS, DEFORMED, GRID    left out
 *   every other                                  blocks
 * Of several such words the last one counts, and WALL, STONE, FLOOR … mean blocks: GROUND FLOOR,
 * DIMENSION STONE, WINDOW ARCH. The report lists all layers, and warns where words contradict.
 *
 * Repairs, in this order, each listed in the report: outlines that end on or overrun their first
 * vertex are closed; repeated and collinear vertices are removed; outlines that are repeated, cross
 * themselves or have no area are left out; open paths are line work, whose enclosed faces become
 * outlines; vertices within the tolerance are welded, neighbours fitted to each other; joints of
 * mortar, drawn as gaps between blocks, are reported and closed, filled or left as the settings say;
 * openings are cut out.
 *
 * Without a layer of supports the blocks of the lowest row are fixed; of a flat arch, whose voussoirs
 * all begin at one height, only those at its ends.
 */
#pragma once

#include "io/exchange/drawing.h"
#include "io/project/project.h"
#include "stereotomy/gaps.h"

typedef enum {
  QN_ROLE_BLOCK,
  QN_ROLE_SUPPORT,
  QN_ROLE_OPENING,
  QN_ROLE_IGNORED,
  QN_ROLE_COUNT
} QnRole;

/* Treatment of gaps between blocks. */
typedef enum {
  QN_GAPS_OPEN,   /* they stay, and are reported */
  QN_GAPS_CLOSED, /* blocks grow to the middle */
  QN_GAPS_FILLED, /* a block of mortar in each */
  QN_GAPS_TREATMENT_COUNT
} QnGapTreatment;

typedef struct QnImportSettings {
  double unit; /* m per unit of the drawing; 0: from the file, checked with the extents */
  double tolerance;   /* m; 0: 0.2 % of the size of a block */
  double thickness;   /* m; of blocks of which the file tells none */
  double unit_weight; /* N/m3 */
  double friction;    /* >= 0 */
  QnGapTreatment gaps;
  double gap_width; /* m: wider ones are no joints; 0: qn_gaps_usual_width() */
  char **layers; /* nullable: "NAME=block|support|opening|ignored", * and ? in the name */
} QnImportSettings;

#define QN_IMPORT_DEFAULTS                                                               \
  ((QnImportSettings){ .thickness = 1, .unit_weight = 20000, .friction = 0.65 })

/* A layer of the drawing. */
typedef struct QnImportLayer {
  char *name;
  guint count, hidden; /* shapes; of them on hidden layers */
  QnRole role;
  gboolean asked;    /* by the settings; else proposed by its name */
  gboolean doubtful; /* the name has words of other roles too */
} QnImportLayer;

/* Report of the import; every line is translated. */
typedef struct QnImportReport {
  GPtrArray *lines;    /* char *: all of it, in order */
  GPtrArray *warnings; /* char *: what the user must look at, also among the lines */

  GArray *layers;    /* QnImportLayer, in the order of the file */
  QnGaps gaps;       /* joints of mortar as they were drawn, m */
  double widest_gap; /* m, each by its mean width; 0 where there is none */
} QnImportReport;

/* "mm", "cm", "dm", "m", "in", "ft"; 0 for anything else. */
double qn_import_unit (const char *name);

/* Sets an option of the command line: "unit" to "mm"; "tolerance", "thickness", "unit-weight", "friction",
 * "close-joints" and "mortar-joints" to a number. FALSE with QN_IO_ERROR_OVERRIDE, whose message begins
 * with the option. */
gboolean qn_import_settings_set (QnImportSettings *settings, const char *option,
                                 const char *value, GError **error);

/* Makes a project: one block per outline, dry joints, own weight as dead load and a horizontal
 * live load. Takes unbounded paths out of the drawing and nothing else. `project` and `report` are
 * overwritten without being cleared; FALSE with an error (domain QN_IO_ERROR) where there is
 * nothing to make blocks of or a setting is wrong (QN_IO_ERROR_OVERRIDE). The report says what was
 * found then, too. */
gboolean qn_drawing_to_project (QnDrawing *drawing, const char *name,
                                const QnImportSettings *settings, QnProject *project,
                                QnImportReport *report, GError **error);

void qn_import_report_clear (QnImportReport *report);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnImportReport, qn_import_report_clear)

/* Reads a file by its ending (.svg, .svgz; .json: COMPAS, .obj; .dxf; any other: text of HybriDFEM where it says
 * "Box", else DXF) and makes a project of it; as qn_drawing_to_project() otherwise. */
gboolean qn_import_file (const char *path, const QnImportSettings *settings,
                         QnProject *project, QnImportReport *report, GError **error);
