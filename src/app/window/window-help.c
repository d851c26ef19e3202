/* Which page of the manual is about what has the focus. */
#include "app/widgets/help.h"
#include "app/window/window-private.h"

/* Of tools that have a page of their own; the others are on that about drawing. */
static const struct {
  const char *tool, *page;
} tool_pages[] = {
  { "wall", "openings" },  { "opening", "openings" }, { "beam", "frames" },
  { "joint", "joints" },   { "support", "loads" },    { "force", "loads" },
  { "picture", "import" },
};

static const char *
page_of_drawing (QnWindow *self)
{
  const char *tool = self->canvas->tool->name;
  for (gsize i = 0; i < G_N_ELEMENTS (tool_pages); i++)
    if (g_str_equal (tool, tool_pages[i].tool))
      return tool_pages[i].page;
  if (self->document->selection->object != QN_NONE)
    return "openings";
  if (self->document->selection->ids[QN_PICK_FACE]->len > 0)
    return "joints";
  return self->document->selection->ids[QN_PICK_BEAM]->len > 0 ? "frames" : "drawing";
}

const char *
qn_window_get_help_page (QnWindow *self)
{
  GtkWidget *focus = gtk_window_get_focus (GTK_WINDOW (self));
  if (qn_window_is_blank (self))
    return "first-wall";
  const char *page = focus != NULL ? qn_help_find_page (focus) : NULL;
  return page != NULL ? page : page_of_drawing (self);
}

void
qn_window_add_help_pages (QnWindow *self)
{
  /* The panel about what is drawn has the page of the selection or the tool. */
  qn_help_set_page (GTK_WIDGET (self->analysis_scroller), "procedures");
  qn_help_set_page (GTK_WIDGET (self->result_scroller), "results");
  qn_help_set_page (GTK_WIDGET (self->findings_scroller), "contacts");
  qn_help_set_page (self->playback, "results");
}
