#include "io/exchange/dxf-shim.h"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <sstream>
#include <string>
#include <vector>

namespace
{

typedef void (*Callback) (const QnDxfEntity *, void *);

/* Hands over single entities at once; polylines and splines when the next thing begins. */
class Sink : public DL_CreationAdapter
{
public:
  Sink (Callback callback_, void *data_) : callback (callback_), data (data_)
  {
  }

  void
  flush ()
  {
    if (!pending)
      return;
    pending = false;
    held.points = points.empty () ? nullptr : points.data ();
    held.point_count = points.size () / 3;
    held.knots = knots.empty () ? nullptr : knots.data ();
    held.knot_count = knots.size ();
    held.layer = layer.c_str ();
    callback (&held, data);
  }

  void
  addBlock (const DL_BlockData &block) override
  {
    tell (QN_DXF_BLOCK, &block.name, { block.bpx, block.bpy });
  }

  void
  endBlock () override
  {
    tell (QN_DXF_BLOCK_END, nullptr, {});
  }

  void
  addLine (const DL_LineData &line) override
  {
    tell (QN_DXF_LINE, nullptr, { line.x1, line.y1, line.x2, line.y2 });
  }

  void
  addArc (const DL_ArcData &arc) override
  {
    tell (QN_DXF_ARC, nullptr, { arc.cx, arc.cy, arc.radius, arc.angle1, arc.angle2 });
  }

  void
  addCircle (const DL_CircleData &circle) override
  {
    tell (QN_DXF_ARC, nullptr, { circle.cx, circle.cy, circle.radius, 0, 360 });
  }

  void
  addEllipse (const DL_EllipseData &e) override
  {
    tell (QN_DXF_ELLIPSE, nullptr,
          { e.cx, e.cy, e.mx, e.my, e.ratio, e.angle1, e.angle2 });
  }

  void
  addSolid (const DL_SolidData &s) override
  {
    /* The third and fourth corner of a SOLID cross over. */
    tell (QN_DXF_FACE, nullptr,
          { s.x[0], s.y[0], s.x[1], s.y[1], s.x[3], s.y[3], s.x[2], s.y[2] });
  }

  void
  addInsert (const DL_InsertData &i) override
  {
    tell (QN_DXF_INSERT, &i.name,
          { i.ipx, i.ipy, i.sx, i.sy, i.angle, double (i.cols), double (i.rows), i.colSp,
            i.rowSp });
  }

  void
  addPolyline (const DL_PolylineData &polyline) override
  {
    hold (QN_DXF_POLYLINE, polyline.flags);
  }

  void
  addVertex (const DL_VertexData &vertex) override
  {
    if (pending && held.kind == QN_DXF_POLYLINE)
      add (vertex.x, vertex.y, vertex.bulge);
  }

  void
  addSpline (const DL_SplineData &spline) override
  {
    hold (QN_DXF_SPLINE, spline.flags);
    held.numbers[0] = spline.degree;
  }

  void
  addControlPoint (const DL_ControlPointData &point) override
  {
    if (pending && held.kind == QN_DXF_SPLINE)
      add (point.x, point.y, point.w);
  }

  void
  addKnot (const DL_KnotData &knot) override
  {
    if (pending && held.kind == QN_DXF_SPLINE)
      knots.push_back (knot.k);
  }

private:
  Callback callback;
  void *data;
  bool pending = false;
  QnDxfEntity held{};
  std::string layer;
  std::vector<double> points, knots;

  void
  add (double x, double y, double z)
  {
    points.push_back (x);
    points.push_back (y);
    points.push_back (z);
  }

  void
  prepare (QnDxfEntity &entity, QnDxfKind kind)
  {
    flush ();
    entity = QnDxfEntity{};
    entity.kind = kind;
    layer = getAttributes ().getLayer ();
    entity.layer = layer.c_str ();
    entity.extrusion_z = getExtrusion ()->getDirection ()[2];
  }

  void
  tell (QnDxfKind kind, const std::string *name, std::initializer_list<double> numbers)
  {
    QnDxfEntity entity;
    prepare (entity, kind);
    entity.name = name != nullptr ? name->c_str () : nullptr;
    size_t i = 0;
    for (double number : numbers)
      entity.numbers[i++] = number;
    callback (&entity, data);
  }

  void
  hold (QnDxfKind kind, int flags)
  {
    prepare (held, kind);
    held.flags = flags;
    points.clear ();
    knots.clear ();
    pending = true;
  }
};

}

bool
qn_dxf_parse (const char *text, size_t length,
              void (*entity) (const QnDxfEntity *entity, void *data), void *data)
{
  try {
    std::istringstream stream (std::string (text, length));
    Sink sink (entity, data);
    DL_Dxf dxf;
    bool done = dxf.in (stream, &sink);
    sink.flush ();
    return done;
  } catch (...) {
    return false;
  }
}
