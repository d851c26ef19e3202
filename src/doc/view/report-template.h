/* What a report holds and looks like, kept in the project as `report`: see data/project-format.md. */
#pragma once

#include "render/figure/pages.h"

#include "io/project/project.h"

typedef enum {
  QN_REPORT_TITLE,
  QN_REPORT_MODEL,
  QN_REPORT_MATERIALS,
  QN_REPORT_LOADS,
  QN_REPORT_ASSUMPTIONS,
  QN_REPORT_FINDINGS,
  QN_REPORT_CONTACTS,
  QN_REPORT_RESULTS,
  QN_REPORT_MECHANISM,
  QN_REPORT_COMBINATIONS,
  QN_REPORT_JOINTS,
  QN_REPORT_CERTIFICATE,
  QN_REPORT_COMPARISON,
  QN_REPORT_FILES,
  QN_REPORT_SECTION_COUNT
} QnReportSection;

/* "title", "model", "materials", …; NULL-terminated, in the order above. */
extern const char *const qn_report_section_names[];

#define QN_REPORT_MEMBER "report"

typedef struct QnReportTemplate {
  bool sections[QN_REPORT_SECTION_COUNT];
  bool every_joint; /* tables of joints are whole, however long */
  double demand;    /* load multiplier that shall be carried; 0: none */
  QnPaper paper;
  char *author, *text; /* of the title; NULL: none */
} QnReportTemplate;

/* What the project keeps, or all sections on A4; false with an error at what is wrong in it. To be
 * cleared in either case. */
gboolean qn_report_template_read (QnReportTemplate *plan, const QnProject *project,
                                  GError **error);

/* Sets "paper" to "a4" or "letter", "sections" to a list with commas, or "demand" to a number; false with
 * QN_IO_ERROR_OVERRIDE where that is none of these. */
gboolean qn_report_template_set (QnReportTemplate *plan, const char *option,
                                 const char *value, GError **error);

/* As JSON text, for qn_document_edit_extra(). Free with g_free(). */
char *qn_report_template_to_json (const QnReportTemplate *plan);

void qn_report_template_clear (QnReportTemplate *plan);
