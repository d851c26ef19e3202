/* The side panels of a window; each looks at the view state and the canvas of its window. */
#pragma once

#include "app/canvas/canvas.h"

/* The tool's settings and what is selected: blocks, their wall, a contact face. */
GtkWidget *qn_properties_panel_new (QnCanvas *canvas);

/* The picture behind the drawing; hidden where there is none. */
GtkWidget *qn_picture_panel_new (QnCanvas *canvas);

/* Its parts, each hidden where it has nothing to say: what the current tool draws with, the
 * selected blocks, copies of them, the masonry they belong to, an opening, contact faces. */
GtkWidget *qn_style_form_new (QnCanvas *canvas);
GtkWidget *qn_block_form_new (QnCanvas *canvas);
GtkWidget *qn_array_form_new (QnCanvas *canvas);
GtkWidget *qn_wall_form_new (QnCanvas *canvas);
GtkWidget *qn_masonry_form_new (QnCanvas *canvas);
GtkWidget *qn_opening_form_new (QnCanvas *canvas);
GtkWidget *qn_face_form_new (QnCanvas *canvas);

/* Where the selection is, by numbers; the corners of a single block. */
GtkWidget *qn_place_form_new (QnCanvas *canvas);
GtkWidget *qn_corner_table_new (QnCanvas *canvas);

/* The selected beams, the two ends of a single one (end: 0, 1), their section. */
GtkWidget *qn_beam_form_new (QnCanvas *canvas);
GtkWidget *qn_beam_end_form_new (QnCanvas *canvas, int end);
GtkWidget *qn_section_form_new (QnCanvas *canvas);

/* Procedure and its parameters, loads, contacts, laws. */
GtkWidget *qn_analysis_panel_new (QnCanvas *canvas);

/* Single loads, and stages of loading; parts of the analysis panel. */
GtkWidget *qn_load_form_new (QnCanvas *canvas);
GtkWidget *qn_case_form_new (QnCanvas *canvas);
GtkWidget *qn_stage_form_new (QnCanvas *canvas);

/* Settings and ground motions of an analysis in time; part of the analysis panel, hidden where the
 * analysis is another. */
GtkWidget *qn_dynamic_form_new (QnCanvas *canvas);

/* Reinforcing bars; part of the analysis panel. */
GtkWidget *qn_bar_form_new (QnCanvas *canvas);

/* Ties; likewise. */
GtkWidget *qn_tie_form_new (QnCanvas *canvas);

/* The law of the contacts; part of the analysis panel. */
GtkWidget *qn_law_form_new (QnCanvas *canvas);

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
