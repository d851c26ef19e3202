#include "app/widgets/paper-area.h"

/* What black ink and white paper become. */
#define DARK_INK   0.92F
#define DARK_PAPER 0.13F

struct _QnPaperArea {
  GtkDrawingArea parent_instance;
};

G_DEFINE_FINAL_TYPE (QnPaperArea, qn_paper_area, GTK_TYPE_DRAWING_AREA)

/* The rotation of hues by 180 degrees is that of SVG. */
gboolean
qn_paper_area_push_dark (GtkWidget *widget, GtkSnapshot *snapshot)
{
  static const float turn[3][3] = { { -0.574F, 1.430F, 0.144F },
                                    { 0.426F, 0.430F, 0.144F },
                                    { 0.426F, 1.430F, -0.856F } };
  float values[16] = { [15] = 1.0F };
  GdkRGBA color;
#if GTK_CHECK_VERSION(4, 10, 0)
  gtk_widget_get_color (widget, &color);
#else
  gtk_style_context_get_color (gtk_widget_get_style_context (widget), &color);
#endif
  if (color.red + color.green + color.blue <= 1.5F)
    return FALSE;
  for (int row = 0; row < 3; row++)
    for (int column = 0; column < 3; column++)
      values[4 * column + row] = -(DARK_INK - DARK_PAPER) * turn[row][column];
  graphene_matrix_t matrix;
  graphene_vec4_t offset;
  graphene_matrix_init_from_float (&matrix, values);
  graphene_vec4_init (&offset, DARK_INK, DARK_INK, DARK_INK, 0.0F);
  gtk_snapshot_push_color_matrix (snapshot, &matrix, &offset);
  return TRUE;
}

static void
qn_paper_area_snapshot (GtkWidget *widget, GtkSnapshot *snapshot)
{
  gboolean dark = qn_paper_area_push_dark (widget, snapshot);
  gtk_snapshot_append_color (
    snapshot, &(GdkRGBA){ 1.0F, 1.0F, 1.0F, 1.0F },
    &GRAPHENE_RECT_INIT (0, 0, (float) gtk_widget_get_width (widget),
                         (float) gtk_widget_get_height (widget)));
  GTK_WIDGET_CLASS (qn_paper_area_parent_class)->snapshot (widget, snapshot);
  if (dark)
    gtk_snapshot_pop (snapshot);
}

static void
qn_paper_area_class_init (QnPaperAreaClass *klass)
{
  GTK_WIDGET_CLASS (klass)->snapshot = qn_paper_area_snapshot;
}

static void
qn_paper_area_init (QnPaperArea *self)
{
}
