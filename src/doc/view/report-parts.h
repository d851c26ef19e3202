/* Parts of a report, one file for each. Sections are written in the order of QnReportSection. */
#pragma once

#include "doc/view/report.h"

/* Rows of a table of joints unless all are requested; the others are counted. */
#define QN_REPORT_ROWS 120

/* Rows of the table of cracks. */
#define QN_REPORT_CRACKS 20

/* "displacement control"; of a project with stages, each of which has its own, "load stages". */
const char *qn_report_procedure (const QnModel *model);

/* "linear" or "nonlinear"; limit analysis takes the undeformed structure. */
const char *qn_report_geometry (const QnModel *model);

/* A paragraph. */
void qn_report_say (QnPages *pages, const char *format, ...) G_GNUC_PRINTF (2, 3);

/* ---- tables that grow by cells ---- */

/* Adds cells, whose kinds are letters: 'w' a word, copied; 'o' one that is taken over; 'u' a heading with "%s"
 * for the unit of a QnQuantity; 'q' a QnQuantity, a number and its digits; 'n' a format and a number; 'z'
 * a size_t. A number that is not finite is a dash. */
void qn_report_row (GPtrArray *cells, QnUnits units, const char *kinds, ...);
void qn_report_table (QnPages *pages, GPtrArray *cells, size_t columns);

/* ---- report-model.c ---- */

bool qn_report_write_model (QnPages *pages, const QnReport *report, GError **error);
void qn_report_write_materials (QnPages *pages, const QnReport *report);
void qn_report_write_loads (QnPages *pages, const QnReport *report);
void qn_report_write_findings (QnPages *pages, const QnReport *report);
void qn_report_write_ground_motion (QnPages *pages, const QnGroundMotion *motion);

/* ---- report-assumptions.c ---- */

/* What is taken for granted, and what was not checked: two sections, or paragraphs of `brief`. */
void qn_report_write_assumptions (QnPages *pages, const QnReport *report, GString *brief);

/* ---- report-joints.c ---- */

/* "b1 – b2" */
char *qn_report_dup_between (const QnModel *model, QnId a, QnId b);

bool qn_report_write_contacts (QnPages *pages, const QnReport *report, GError **error);
bool qn_report_has_forces (const QnReportRun *run);
bool qn_report_write_joints (QnPages *pages, const QnReport *report,
                             const QnReportRun *run, GError **error);

/* ---- report-result.c ---- */

/* The picture of a result: how it fails, or else how it has moved. False where there is none. */
bool qn_report_choose_picture (QnFigure *figure, const QnReportRun *run);
bool qn_report_write_result (QnPages *pages, const QnReportRun *run, QnUnits units,
                             GError **error);
void qn_report_write_certificate (QnPages *pages, const QnReport *report);
bool qn_report_write_comparison (QnPages *pages, const QnReport *report, GError **error);

/* ---- report-code.c ---- */

/* Every combination of load cases, analysed; nothing where the project has no code for them. False where it
 * is cancelled. */
bool qn_report_write_combinations (QnPages *pages, const QnReport *report,
                                   GError **error);

/* The kinematic check of a result's mechanism; nothing where the project does not ask for it. */
bool qn_report_write_mechanism (QnPages *pages, const QnReportRun *run, QnUnits units,
                                GError **error);
