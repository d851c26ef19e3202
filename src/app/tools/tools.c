#include "app/tools/tools.h"

const QnTool *const qn_tools[] = {
  &qn_tool_select,    &qn_tool_wall,      &qn_tool_opening, &qn_tool_arch,
  &qn_tool_column,    &qn_tool_rectangle, &qn_tool_polygon, &qn_tool_beam,
  &qn_tool_bar,       &qn_tool_tie,       &qn_tool_cut,     &qn_tool_rotate,
  &qn_tool_mirror,    &qn_tool_joint,     &qn_tool_support, &qn_tool_force,
  &qn_tool_edge_load, &qn_tool_measure,   &qn_tool_picture, NULL
};

const QnTool *
qn_tool_find (const char *name)
{
  for (int i = 0; qn_tools[i] != NULL; i++) {
    if (g_str_equal (qn_tools[i]->name, name))
      return qn_tools[i];
  }
  return NULL;
}

QnBlockStyle
qn_tool_block_style (QnCanvas *canvas)
{
  const QnMasonryStyle *masonry = &canvas->settings->masonry;
  return (QnBlockStyle){ .thickness = masonry->thickness,
                         .unit_weight = masonry->unit_weight,
                         .law = masonry->law };
}
