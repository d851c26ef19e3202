/* Pages under the drawing, in its window: runs beside each other, the capacity curve, the moving load, the
 * study, the figures of the project. Each is a floating widget that lives as long as its window shows it. What it has
 * of undo, redo, run and cancel (QN_ACTIONS) its window carries out while it is in sight. */
#pragma once

#include "doc/view/view-state.h"
#include <gtk/gtk.h>

/* The capacity curve of the model, and what it is held against. */
GtkWidget *qn_capacity_page_new (QnDocument *document);

/* The vehicle among the growing loads, moved over the structure. */
GtkWidget *qn_envelope_page_new (QnDocument *document);

/* The figures that the project keeps. */
GtkWidget *qn_figures_page_new (QnDocument *document);

/* Runs beside each other: those of `document` first, then of the others (borrowed, freed by the
 * caller) that `list_others` finds whenever the choice is listed anew. */
typedef GPtrArray *(*QnDocumentsFunc) (QnDocument *document);
GtkWidget *qn_compare_page_new (QnDocument *document, QnDocumentsFunc list_others);

/* The study of a project: what varies in it, its plan, and its cases as they come in. The study file lies
 * beside the project and is written whenever the study is run; every state of it has results of its own, so
 * that the same study goes on where it stopped. NULL with an error where the project has no file yet or
 * its study cannot be read. `path` (nullable): a study file other than the project's own. */
GtkWidget *qn_study_page_new (QnViewState *state, const char *path, GError **error);
const char *qn_study_page_get_path (GtkWidget *page);

/* Makes a number of the project vary. */
void qn_study_page_vary (GtkWidget *page, const char *path, double base);
