/* Columns and buttresses: courses above each other. */
#include "stereotomy/masonry-parts.h"

static QnStatus
check_column (const QnColumn *column, QnDiag *diag)
{
  const QnSubject of = qn_masonry_subject (diag);
  return qn_required (
    qn_require_length (of, "height", column->height, QN_RANGE_POSITIVE)
    && qn_require_length (of, "width", column->bottom, QN_RANGE_POSITIVE)
    && qn_require_length (of, "width", column->top, QN_RANGE_POSITIVE)
    && qn_require_pieces (of, "drums", column->drums, 1)
    && qn_require_length (of, "plinth", column->plinth_height, QN_RANGE_NOT_NEGATIVE)
    && (column->plinth_height == 0
        || qn_require_length (of, "plinth", column->plinth_width, QN_RANGE_POSITIVE))
    && qn_require_length (of, "capital", column->capital_height, QN_RANGE_NOT_NEGATIVE)
    && (column->capital_height == 0
        || qn_require_length (of, "capital", column->capital_width, QN_RANGE_POSITIVE)));
}

QnStatus
qn_masonry_lay_column (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag)
{
  const QnColumn *column = &masonry->column;
  const char *name = masonry->name;
  QnStatus status = check_column (column, diag);
  double plinth = column->plinth_height > 0 ? column->plinth_width : column->bottom;
  if (status != QN_OK)
    return status;
  if (masonry->foundation > 0)
    qn_pieces_add (pieces,
                   qn_rectangle (-plinth / 2, -masonry->foundation, plinth / 2, 0),
                   "%s.base", name)
      ->fixed = true;
  if (column->plinth_height > 0)
    qn_pieces_add (pieces,
                   qn_rectangle (-plinth / 2, 0, plinth / 2, column->plinth_height),
                   "%s.plinth", name);
  double foot = column->plinth_height;
  for (int32_t i = 0; i < column->drums; i++) {
    double s0 = (double) i / column->drums, s1 = (double) (i + 1) / column->drums;
    double w0 = column->bottom + s0 * (column->top - column->bottom);
    double w1 = column->bottom + s1 * (column->top - column->bottom);
    double y0 = foot + s0 * column->height, y1 = foot + s1 * column->height;
    const QnVec2 corners[] = {
      { -w0 / 2, y0 }, { w0 / 2, y0 }, { w1 / 2, y1 }, { -w1 / 2, y1 }
    };
    qn_pieces_add (pieces, qn_ring_of (corners, 4), "%s.%d", name, i + 1);
  }
  double head = foot + column->height, capital = column->capital_width;
  if (column->capital_height > 0)
    qn_pieces_add (
      pieces,
      qn_rectangle (-capital / 2, head, capital / 2, head + column->capital_height),
      "%s.capital", name);
  return QN_OK;
}

QnStatus
qn_masonry_lay_buttress (const QnMasonry *masonry, QnPieces *pieces, QnDiag *diag)
{
  const QnButtress *buttress = &masonry->buttress;
  const QnSubject of = qn_masonry_subject (diag);
  QnStatus status =
    qn_required (qn_require_length (of, "height", buttress->height, QN_RANGE_POSITIVE)
                 && qn_require_length (of, "width", buttress->bottom, QN_RANGE_POSITIVE)
                 && qn_require_length (of, "width", buttress->top, QN_RANGE_POSITIVE)
                 && qn_require_pieces (of, "courses", buttress->courses, 1));
  for (int32_t i = masonry->foundation > 0 ? -1 : 0;
       i < buttress->courses && status == QN_OK; i++) {
    double s0 = fmax (0, (double) i / buttress->courses);
    double s1 = (double) (i + 1) / buttress->courses;
    double w0 = buttress->bottom + s0 * (buttress->top - buttress->bottom);
    double w1 = buttress->bottom + s1 * (buttress->top - buttress->bottom);
    double y0 = i < 0 ? -masonry->foundation : s0 * buttress->height;
    double y1 = s1 * buttress->height;
    /* Counter-clockwise on either side of the vertical face. */
    const QnVec2 right[] = { { 0, y0 }, { w0, y0 }, { w1, y1 }, { 0, y1 } };
    const QnVec2 left[] = { { -w0, y0 }, { 0, y0 }, { 0, y1 }, { -w1, y1 } };
    const QnVec2 *corners = buttress->leans_right ? right : left;
    if (i < 0)
      qn_pieces_add (pieces, qn_ring_of (corners, 4), "%s.base", masonry->name)->fixed =
        true;
    else
      qn_pieces_add (pieces, qn_ring_of (corners, 4), "%s.%d", masonry->name, i + 1);
  }
  return status;
}
