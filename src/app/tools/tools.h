/* All tools. */
#pragma once

#include "app/canvas/canvas.h"

/* Selects what lies at a place of the screen, as a click of the select tool does, unless it is selected
 * already; nothing where there is nothing. */
void qn_tool_select_under (QnCanvas *canvas, QnVec2 screen);

/* Gives contact faces the law of this name; NULL or empty: that of their blocks. */
void qn_tool_joint_set_law (QnCanvas *canvas, const QnId *ids, guint count,
                            const char *law);

/* Chooses the tool for edge loads, to put the selected one on the edges that are clicked next. */
void qn_tool_edge_load_choose (QnCanvas *canvas);

/* In the order of the palette; NULL-terminated. */
extern const QnTool *const qn_tools[];
const QnTool *qn_tool_find (const char *name);

extern const QnTool qn_tool_select, qn_tool_wall, qn_tool_opening, qn_tool_arch,
  qn_tool_column, qn_tool_rectangle, qn_tool_polygon, qn_tool_beam, qn_tool_bar,
  qn_tool_tie, qn_tool_cut, qn_tool_rotate, qn_tool_mirror, qn_tool_joint,
  qn_tool_support, qn_tool_force, qn_tool_edge_load, qn_tool_measure, qn_tool_picture;

/* Style of single blocks. */
QnBlockStyle qn_tool_block_style (QnCanvas *canvas);
