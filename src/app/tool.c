#include "app/tool.h"

const QnTool *const qn_tools[] = { &qn_tool_select,  &qn_tool_wall,
                                   &qn_tool_opening, &qn_tool_rectangle,
                                   &qn_tool_polygon, &qn_tool_support,
                                   &qn_tool_force,   &qn_tool_measure,
                                   &qn_tool_picture, NULL };

const QnTool *
qn_tool_find (const char *name)
{
  for (int i = 0; qn_tools[i] != NULL; i++) {
    if (g_str_equal (qn_tools[i]->name, name))
      return qn_tools[i];
  }
  return NULL;
}
