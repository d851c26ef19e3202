/* The side panels of a window; each looks at the view state and the canvas of its window. */
#pragma once

#include "app/forms/form.h"

/* The tool's settings and what is selected: blocks, their wall, a contact face. */
GtkWidget *qn_properties_panel_new (QnCanvas *canvas);

/* Its parts, each hidden where it has nothing to say: what the current tool draws with, the selected blocks,
 * copies of them, the masonry they belong to, an opening, contact faces; where the selection is, by numbers;
 * the selected beams, the two ends of a single one, their section; the picture behind the drawing. */
extern const QnFormKind qn_style_form, qn_block_form, qn_array_form, qn_wall_form,
  qn_masonry_form, qn_opening_form, qn_face_form, qn_place_form, qn_beam_form,
  qn_first_end_form, qn_second_end_form, qn_section_form, qn_picture_form;

/* The corners of a single block. */
GtkWidget *qn_corner_table_new (QnCanvas *canvas);

/* Procedure and its parameters; its parts: single loads, settlements, supports, load cases, stages of loading; settings and ground
 * motions of an analysis in time, hidden where the analysis is another; laws, reinforcing bars, ties. */
GtkWidget *qn_analysis_panel_new (QnCanvas *canvas);
extern const QnFormKind qn_load_form, qn_settlement_form, qn_support_form, qn_case_form,
  qn_stage_form, qn_dynamic_form, qn_law_form, qn_bar_form, qn_tie_form;

/* Outcome in words, curve, list of runs and steps, table of contacts. */
GtkWidget *qn_result_panel_new (QnCanvas *canvas);

/* The load–displacement curve of the current run, with a cursor bound to the drawing: drag it and the wall
 * moves. Other runs of the same blocks are drawn with it. While an analysis runs, the multipliers reached so
 * far, or the history up to now over the whole time. The axes fit the path up to its peak and a little more:
 * a last motion that runs away leaves the picture with an arrow, until the user zooms. Holds the state. The
 * plot view (app/widgets/plot-view.h) is called "curve". */
GtkWidget *qn_curve_view_new (QnViewState *state);

/* What is told of the point next to a place of the curve, px; NULL where there is none. The caller frees it. */
char *qn_curve_view_dup_values (GtkWidget *view, double x, double y);

/* The energies of an analysis in time beneath its history: a cursor at the step that is shown, and what every
 * kind comes to there, or under the pointer. A click or drag goes to that time, the arrow keys from step to
 * step. Hidden where the current run is none in time. */
GtkWidget *qn_energy_view_new (QnViewState *state);

/* Tables of the current run: a row leads to its step, or to its place in the drawing. */
GtkWidget *qn_step_table_new (QnViewState *state);
GtkWidget *qn_contact_table_new (QnCanvas *canvas);
GtkWidget *qn_beam_table_new (QnCanvas *canvas);

/* The answer of the current run beside everything else that was found for the same model. */
GtkWidget *qn_answer_card_new (QnDocument *document);

/* What the selected joint or block does at the step shown: its values, and of a joint the diagram of
 * normal against shear force. Hidden where there is nothing to tell. */
GtkWidget *qn_inspector_new (QnCanvas *canvas);

/* What contact detection has to tell, with buttons that show the place. */
GtkWidget *qn_findings_panel_new (QnCanvas *canvas);

/* The list of named steps; a click walks to one. For a popover. */
GtkWidget *qn_history_list_new (QnDocument *document);

/* What a window without a drawing shows: new, open, examples with thumbnails, recent files. Emits nothing: its
 * buttons are actions of the window ("win.open-path" with a path). */
GtkWidget *qn_start_page_new (void);

/* Play, step slider, speed and scale of results. */
GtkWidget *qn_playback_bar_new (QnViewState *state);
void qn_playback_bar_toggle (GtkWidget *bar);
