/* Parametric masonry: walls with bonds and openings, arches, columns, buttresses, portals and
 * rubble, kept as parameters and expanded into plain blocks.
 *
 * All lengths in m, angles in rad. Every object has a frame of its own: `origin` is where its
 * local (0, 0) lies in the model, `rotation` turns it counter-clockwise about that point.
 * Geometry is computed in the local frame and moved last.
 *
 * Names are deterministic, so that loads, overrides and results survive a change of parameters
 * wherever the piece survives:
 *   wall      <name>.<course>.<position>, counted from 1 from the bottom and from the left as
 *             the bond lays them: openings cut pieces away but never renumber. A unit that an
 *             opening parts gets a, b, c … from left to right. With several leaves,
 *             <name>.<leaf>.<course>.<position>, leaves lettered a, b, c …
 *   opening   <name>.<opening>.lintel, .sill, .v1 … .vn (voussoirs from left to right)
 *   arch      <name>.v1 … .vn from the left, of ring k > 1 <name>.r<k>.v1 …;
 *             <name>.springer.left and .right
 *   column    <name>.plinth, <name>.1 … <name>.n from the bottom, <name>.capital
 *   buttress  <name>.1 … <name>.n
 *   portal    <name>.pier<i>.<course>, <name>.lintel<i>, <name>.arch<i>.v1 …,
 *             <name>.skewback<i>, <name>.backing<i>
 *   rubble    <name>.<row>.<column>
 *   foundations, which are the fixed blocks: <name>.base, or .base.left, .base.right,
 *             <name>.base<i> under piers
 *
 * The minimum piece rule. A unit cut by the end of the wall or by an opening may leave a
 * sliver: less area than `minimum_piece` times the uncut unit's, or thinner (least width of its
 * convex hull) than `minimum_piece` times the unit's smaller side. A sliver is merged with the
 * piece of the same leaf with which it shares the longest joint, pieces of its own course first,
 * the one laid first where lengths are equal; if the two form no simple polygon, with the next
 * one. The neighbour keeps its name. A sliver that touches no other piece of the fabric stays.
 *
 * Voussoirs, lintels and sills are never merged with the fabric.
 */
#pragma once

#include "core/model/model.h"

#include <glib.h>

typedef enum {
  QN_MASONRY_WALL,
  QN_MASONRY_ARCH,
  QN_MASONRY_COLUMN,
  QN_MASONRY_BUTTRESS,
  QN_MASONRY_PORTAL,
  QN_MASONRY_RUBBLE,
  QN_MASONRY_KIND_COUNT
} QnMasonryKind;

/* Project files have names for varieties of these besides: cells of continuous walls. */
enum {
  QN_MASONRY_GRID =
    QN_MASONRY_KIND_COUNT, /* a wall in stack bond, so many cells each way */
  QN_MASONRY_VORONOI, /* rubble between upright sides, relaxed to cells of like size */
  QN_MASONRY_NAME_COUNT
};

/* The kind of what has such a name. */
static inline QnMasonryKind
qn_masonry_kind_of (int name)
{
  return name == QN_MASONRY_GRID      ? QN_MASONRY_WALL
         : name == QN_MASONRY_VORONOI ? QN_MASONRY_RUBBLE
                                      : (QnMasonryKind) name;
}

typedef enum {
  QN_BOND_RUNNING, /* stretchers, every other course shifted by `lap` of a unit */
  QN_BOND_STACK,   /* all joints above each other */
  QN_BOND_HEADER,  /* headers, every other course shifted by half a header */
  QN_BOND_ENGLISH, /* courses of stretchers and of headers in turn */
  QN_BOND_FLEMISH, /* stretcher and header in turn, headers centred on stretchers below */
  QN_BOND_CUSTOM,  /* courses listed one by one, as in walls[] */
  QN_BOND_COUNT
} QnBond;

/* What closes a course at a straight edge so that no vertical joints meet (English and Flemish
 * bond; half and header bonds need none). */
typedef enum {
  QN_CLOSER_NONE,          /* the bond runs on and is cut by the edge */
  QN_CLOSER_QUEEN,         /* half a header behind the first header */
  QN_CLOSER_THREE_QUARTER, /* one and a half headers at the edge */
  QN_CLOSER_COUNT
} QnCloser;

typedef enum {
  QN_EDGE_STRAIGHT, /* units are cut along the edge */
  QN_EDGE_TOOTHED,  /* units that the edge would cut are left whole and stand out */
  QN_EDGE_COUNT
} QnEdge;

typedef enum {
  QN_HEAD_FLAT,
  QN_HEAD_SEGMENTAL,
  QN_HEAD_SEMICIRCULAR,
  QN_HEAD_COUNT
} QnHead;

typedef enum {
  QN_SPAN_NONE,      /* the fabric itself is cut */
  QN_SPAN_LINTEL,    /* one beam with `bearing` on either side; flat heads */
  QN_SPAN_FLAT_ARCH, /* voussoirs with a level intrados; flat heads */
  QN_SPAN_VOUSSOIRS, /* a ring of voussoirs; segmental and semicircular heads */
  QN_SPAN_COUNT
} QnSpan;

typedef enum { QN_SIDES_CURVED, QN_SIDES_STRAIGHT, QN_SIDES_COUNT } QnSides;

typedef enum {
  QN_ARCH_CIRCULAR,      /* segment of a circle: 0 < rise <= span / 2 */
  QN_ARCH_POINTED,       /* two circles: rise > span / 2 */
  QN_ARCH_ELLIPTIC,      /* half an ellipse: any rise */
  QN_ARCH_PARABOLIC,     /* any rise */
  QN_ARCH_THREE_CENTRED, /* arcs of a smaller circle at both ends: rise < span / 2 */
  QN_ARCH_SHAPE_COUNT
} QnArchShape;

/* A hole in a wall and what carries the fabric above it. */
typedef struct QnOpening {
  char *name;    /* owned; NULL: o1, o2 … */
  QnVec2 at;     /* lower left corner in the wall's frame, m; may lie outside the wall */
  double width;  /* m, > 0 */
  double height; /* m, > 0, to the crown of the intrados */
  QnHead head;
  double rise; /* m, SEGMENTAL: 0 < rise < width / 2 and <= height */
  QnSpan span;
  double depth;        /* m, > 0: height of lintel or ring; ignored without span */
  double bearing;      /* m, >= 0, LINTEL */
  int32_t voussoirs;   /* >= 1, FLAT_ARCH and VOUSSOIRS */
  double skew;         /* rad, 0 <= skew < pi/2: lean of the skewbacks of a FLAT_ARCH */
  QnSides sides;       /* of VOUSSOIRS */
  double sill_height;  /* m, 0: no sill */
  double sill_bearing; /* m, >= 0, beyond the opening on either side */
} QnOpening;

/* How the units of one leaf are laid. */
typedef struct QnLeaf {
  double length; /* m, > 0; follows from the courses in CUSTOM bond */
  QnVec2 unit;   /* m, length of the stretcher and height of a course, > 0 */
  double header; /* m, length of the header; 0: half a unit */
  double
    lap; /* shift of every other course in running bond, part of a unit, 0 <= lap < 1 */
  QnBond bond;
  QnCloser closer;
} QnLeaf;

typedef struct QnMasonryWall {
  double height;  /* m, > 0; follows from the courses in CUSTOM bond */
  QnLeaf *leaves; /* owned; side by side from the left, at least one */
  size_t leaf_count, leaf_capacity;
  double
    *course_heights; /* owned, nullable: from the bottom, repeated; instead of unit.y */
  size_t course_height_count;
  QnWall courses; /* CUSTOM: only lengths, course_ends, course_count are used */
  QnEdge left, right;
  double minimum_piece; /* 0 <= minimum_piece < 1; 0 turns the rule off */
  bool
    grid; /* written by the number of its cells, as long as one leaf is in stack bond */
  QnOpening *openings; /* owned */
  size_t opening_count, opening_capacity;
} QnMasonryWall;

/* An arch over (0, 0) … (span, 0), the ends of the intrados. */
typedef struct QnArch {
  double span, rise; /* m, > 0 */
  double ring;       /* m, > 0: thickness, radial */
  int32_t rings;     /* that it consists of, alike; 0: 1. More than 1 not of POINTED */
  double haunch;     /* m, THREE_CENTRED: radius of the smaller circle, 0 < haunch < rise;
                        0: all three arcs turn by 60 degrees */
  QnArchShape shape;
  int32_t voussoirs; /* >= 2, evenly along the intrados */
  QnSides sides;
  double springer; /* m: height of the springers below the ends; 0: none */
} QnArch;

/* A stack of drums, centred on x = 0, from y = 0. */
typedef struct QnColumn {
  double height;                        /* m, > 0: of the shaft */
  double bottom, top;                   /* m, > 0: widths of the shaft */
  int32_t drums;                        /* >= 1 */
  double plinth_width, plinth_height;   /* m; height 0: none */
  double capital_width, capital_height; /* m; height 0: none */
} QnColumn;

/* Courses between a vertical face on x = 0 and a battered one. */
typedef struct QnButtress {
  double height;
  double bottom, top; /* m, > 0: widths */
  int32_t courses;    /* >= 1 */
  bool leans_right;   /* the battered face: right of the vertical one, or left */
} QnButtress;

/* So many bays and piers, counted from the left, may have numbers of their own. */
#define QN_MOST_UNEQUAL 24

/* Piers of `pier_width`, `bays` openings of `span` between them, lintels or arches on top. The
 * left edge of the first pier is x = 0. */
typedef struct QnPortal {
  int32_t bays; /* >= 1 */
  double span;  /* m, > 0, clear */
  double pier_width, pier_height;
  int32_t courses; /* per pier, >= 1 */
  double
    lintel_height; /* m, > 0: lintels from middle to middle of the piers; 0: arches */
  QnArch arch;     /* with lintel_height 0; its span is the portal's; no springers;
                           the rings of two bays must fit on the pier between them */
  double backing;  /* m above the piers, up to which blocks fill the space between the
                     arches; 0: none; below the crown of the extrados */

  /* m; 0: as above */
  double spans[QN_MOST_UNEQUAL], rises[QN_MOST_UNEQUAL], rings[QN_MOST_UNEQUAL];
  double piers[QN_MOST_UNEQUAL]; /* widths */
} QnPortal;

/* Irregular stones: cells around seeded points, within a trapezium on y = 0. */
typedef struct QnRubble {
  double width, top, height; /* m, > 0: lower and upper width, centred on x = width / 2 */
  double stone;              /* m, > 0: mean size */
  double irregularity;       /* 0 (brick-like hexagons) … 1 */
  bool relaxed; /* every stone lies about its centroid, in no rows; `top` is `width` */
  uint32_t seed;
} QnRubble;

/* Greatest perturbation: two neighbours cannot pass each other. */
#define QN_MAX_PERTURBATION 0.4

typedef struct QnMasonry {
  QnMasonryKind kind;
  char *name; /* owned */
  QnVec2 origin;
  double rotation;    /* rad */
  double thickness;   /* m, > 0, out of plane */
  double unit_weight; /* N/m3; see QnBlock */
  double density;
  QnId law;
  QnId ring_law; /* of the joints between the rings of arches; QN_NONE: as the others */
  double foundation; /* m: depth of fixed blocks below; 0: none */
  double
    perturbation; /* how far corners are moved at random, part of their distance from what they
                          do not belong to; 0 … QN_MAX_PERTURBATION */
  uint32_t perturbation_seed;

  /* The one that belongs to `kind`. */
  QnMasonryWall wall;
  QnArch arch;
  QnColumn column;
  QnButtress buttress;
  QnPortal portal;
  QnRubble rubble;
} QnMasonry;

typedef struct QnMasonries {
  QnMasonry *items;
  size_t count, capacity;
} QnMasonries;

/* A circular arch that has become too high is pointed, and the other way round. */
static inline void
qn_arch_fit_shape (QnArch *arch)
{
  if (arch->shape == QN_ARCH_CIRCULAR || arch->shape == QN_ARCH_POINTED)
    arch->shape = arch->rise > 0.5 * arch->span ? QN_ARCH_POINTED : QN_ARCH_CIRCULAR;
}

/* An object with the defaults of the project file: one leaf, running bond, lap 1/2, minimum
 * piece 0.2, thickness 1, law QN_NONE. `masonry` is overwritten without being cleared. */
void qn_masonry_init (QnMasonry *masonry, QnMasonryKind kind, const char *name);
void qn_masonry_clear (QnMasonry *masonry);

/* A wall as a grid of so many whole cells; rubble as cells of Voronoi of so many m. */
void qn_masonry_set_grid (QnMasonryWall *wall, QnVec2 size, QnVec2 cells);
void qn_masonry_set_voronoi (QnRubble *rubble, QnVec2 size, double cell);

/* Zeroed but for the defaults. */
QnOpening *qn_masonry_add_opening (QnMasonry *masonry);
QnLeaf *qn_masonry_add_leaf (QnMasonry *masonry);

/* Moves `masonry` to the end of the list and zeroes it. */
void qn_masonries_take (QnMasonries *list, QnMasonry *masonry);
void qn_masonries_clear (QnMasonries *list);

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnMasonry, qn_masonry_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnMasonries, qn_masonries_clear)

/* Adds the blocks of one object to a model that is not prepared yet. `index` is for the
 * diagnostic (QN_ENTITY_MASONRY; `sub` the opening or `other` the leaf, `field` the key). On
 * failure the model may hold part of the blocks. */
QnStatus qn_masonry_expand (const QnMasonry *masonry, QnId index, QnModel *model,
                            QnDiag *diag);

/* The spelling in project files. */
extern const char *const qn_masonry_kind_names[QN_MASONRY_NAME_COUNT];
extern const char *const qn_bond_names[QN_BOND_COUNT];
extern const char *const qn_closer_names[QN_CLOSER_COUNT];
extern const char *const qn_edge_names[QN_EDGE_COUNT];
extern const char *const qn_head_names[QN_HEAD_COUNT];
extern const char *const qn_span_names[QN_SPAN_COUNT];
extern const char *const qn_sides_names[QN_SIDES_COUNT];
extern const char *const qn_arch_shape_names[QN_ARCH_SHAPE_COUNT];
