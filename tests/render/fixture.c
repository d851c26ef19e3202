#include "render/fixture.h"

#include "core/base/memory.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

static const double unit_length = 0.4, unit_height = 0.175;

/* The arrays are owned by core structures, which release them with free(). */
static char *
copy_text (const char *text)
{
  char *copy = qn_strdup (text);
  g_assert_nonnull (copy);
  return copy;
}

static QnId
add_block (Fixture *f, QnVec2 low, QnVec2 high, bool fixed)
{
  QnModel *m = &f->model;
  g_assert_true (qn_array_reserve (&m->vertices, &m->vertex_capacity, m->vertex_count + 4,
                                   sizeof *m->vertices));
  QnVec2 corners[4] = { low, { high.x, low.y }, high, { low.x, high.y } };
  memcpy (m->vertices + m->vertex_count, corners, sizeof corners);
  double area = (high.x - low.x) * (high.y - low.y);
  g_autofree char *name = g_strdup_printf ("b%zu", m->block_count);
  QnBlock block = {
    .name = copy_text (name),
    .first_vertex = (QnId) m->vertex_count,
    .vertex_count = 4,
    .thickness = 1,
    .unit_weight = 1e4,
    .density = -1,
    .support = { fixed, fixed, fixed },
    .law = QN_NONE,
    .wall = QN_NONE,
    .area = area,
    .centroid = qn_vec2_lerp (low, high, 0.5),
    .weight = 1e4 * area,
  };
  m->vertex_count += 4;
  g_assert_true (QN_ARRAY_PUSH (m->blocks, m->block_count, m->block_capacity, block));
  return (QnId) m->block_count - 1;
}

static void
add_pair (Fixture *f, QnId face, QnVec2 point, double abscissa, double tributary)
{
  QnContacts *c = &f->contacts;
  QnContactPair pair = { .face = face,
                         .bar = QN_NONE,
                         .point = point,
                         .abscissa = abscissa,
                         .tributary = tributary };
  g_assert_true (QN_ARRAY_PUSH (c->pairs, c->pair_count, c->pair_capacity, pair));
}

/* A face between blocks a < b along a side they share, if they share any. */
static void
add_face (Fixture *f, QnId a, QnId b)
{
  const QnVec2 *p = qn_model_block_vertices (&f->model, a);
  const QnVec2 *q = qn_model_block_vertices (&f->model, b);
  double x0 = MAX (p[0].x, q[0].x), x1 = MIN (p[2].x, q[2].x);
  double y0 = MAX (p[0].y, q[0].y), y1 = MIN (p[2].y, q[2].y);
  double eps = 1e-9;
  bool bed = x1 - x0 > eps && fabs (y1 - y0) < eps;
  bool head = y1 - y0 > eps && fabs (x1 - x0) < eps;
  if (!bed && !head)
    return;
  double sign = bed ? (q[0].y > p[0].y ? 1 : -1) : (q[0].x > p[0].x ? 1 : -1);
  QnVec2 normal = bed ? qn_vec2 (0, sign) : qn_vec2 (sign, 0);
  QnVec2 tangent = qn_vec2_perp (normal);
  QnVec2 ends[2] = { { x0, y0 }, { x1, y1 } };
  bool turn = qn_vec2_dot (qn_vec2_sub (ends[1], ends[0]), tangent) < 0;
  QnContacts *c = &f->contacts;
  g_assert_true (
    qn_array_reserve (&c->faces, &c->face_capacity, c->face_count + 1, sizeof *c->faces));
  QnContactFace face = {
    .a = a,
    .b = b,
    .start = ends[turn ? 1 : 0],
    .end = ends[turn ? 0 : 1],
    .normal = normal,
    .tangent = tangent,
    .length = bed ? x1 - x0 : y1 - y0,
    .thickness = 1,
    .first_pair = (QnId) c->pair_count,
    .pair_count = 2,
  };
  c->faces[c->face_count] = face;
  add_pair (f, (QnId) c->face_count, face.start, 0, 0.5 * face.length);
  add_pair (f, (QnId) c->face_count, face.end, face.length, 0.5 * face.length);
  c->face_count++;
}

static void
add_loads (Fixture *f)
{
  QnModel *m = &f->model;
  m->dead_loads = qn_alloc (1, sizeof (QnLoad));
  m->live_loads = qn_alloc (1, sizeof (QnLoad));
  m->dead_loads[0] =
    (QnLoad){ .kind = QN_LOAD_WEIGHT, .vector = { 0, -1 }, .block = QN_NONE };
  m->live_loads[0] =
    (QnLoad){ .kind = QN_LOAD_WEIGHT, .vector = { 1, 0 }, .block = QN_NONE };
  m->dead_load_count = m->live_load_count = 1;
  m->dead_load_capacity = m->live_load_capacity = 1;
}

static void
begin (Fixture *f, const char *title)
{
  memset (f, 0, sizeof *f);
  f->model.title = copy_text (title);
  f->model.gravity = 9.81;
  f->model.laws = qn_alloc (1, sizeof (QnLaw));
  f->model.laws[0] = (QnLaw){ .name = copy_text ("dry joint"),
                              .kind = QN_LAW_COULOMB,
                              .kn = 1e7,
                              .ks = 1e7,
                              .friction = 0.65 };
  f->model.law_count = f->model.law_capacity = 1;
  f->model.analysis.control.block = QN_NONE;
  f->model.analysis.control.node = QN_NONE;
  f->model.characteristic_length = sqrt (unit_length * unit_height);
  add_loads (f);
}

static void
allocate_result (Fixture *f, size_t steps)
{
  QnResult *r = &f->result;
  r->block_count = f->model.block_count;
  r->pair_count = f->contacts.pair_count;
  r->steps = qn_alloc (steps, sizeof *r->steps);
  r->step_count = r->step_capacity = steps;
  r->displacement_capacity = steps * r->block_count * QN_DOF_COUNT;
  r->displacements = qn_alloc (r->displacement_capacity, sizeof (double));
  r->pairs = qn_alloc (r->pair_count, sizeof *r->pairs);
  r->mechanism = qn_alloc (r->block_count * QN_DOF_COUNT, sizeof (double));
  r->outcome = QN_OUTCOME_COLLAPSE;
  r->has_collapse_multiplier = true;
  r->collapse_multiplier = 0.3558;
  for (size_t s = 0; s < steps; s++)
    r->steps[s].multiplier = r->collapse_multiplier * (double) s / (double) (steps - 1);
  r->steps[steps - 1].event = QN_EVENT_COLLAPSE;
}

/* Steps grow quadratically towards a thousandth of the mechanism. */
static void
scale_steps (Fixture *f)
{
  QnResult *r = &f->result;
  size_t n = r->block_count * QN_DOF_COUNT;
  for (size_t s = 0; s < r->step_count; s++) {
    double share = (double) s / (double) (r->step_count - 1);
    for (size_t i = 0; i < n; i++)
      r->displacements[s * n + i] = 1e-3 * share * share * r->mechanism[i];
  }
}

static QnVec2
velocity (const Fixture *f, QnId block, QnVec2 p)
{
  const double *v = f->result.mechanism + (size_t) block * QN_DOF_COUNT;
  QnVec2 arm = qn_vec2_sub (p, f->model.blocks[block].centroid);
  return qn_vec2_add_scaled (qn_vec2 (v[0], v[1]), v[2], qn_vec2_perp (arm));
}

/* Pair forces of a column: compression by what stands above, friction to the right. Pairs that
 * the mechanism opens carry nothing. */
static void
set_forces (Fixture *f, double top)
{
  for (size_t i = 0; i < f->contacts.face_count; i++) {
    const QnContactFace *face = &f->contacts.faces[i];
    bool bed = fabs (face->normal.y) > 0.5;
    for (int k = 0; k < 2; k++) {
      QnPairResult *pair = &f->result.pairs[face->first_pair + k];
      QnVec2 at = f->contacts.pairs[face->first_pair + k].point;
      QnVec2 jump = qn_vec2_sub (velocity (f, face->b, at), velocity (f, face->a, at));
      bool opens = qn_vec2_dot (jump, face->normal) > 1e-6;
      bool slides = fabs (qn_vec2_dot (jump, face->tangent)) > 1e-6;
      pair->state = opens ? QN_PAIR_OPEN : slides ? QN_PAIR_SLIP : QN_PAIR_STICK;
      if (opens || !bed)
        continue;
      double depth = top - face->start.y + unit_height;
      bool right = (k == 1) == (face->tangent.x > 0);
      pair->normal_force = -1e4 * depth * face->length * (right ? 0.8 : 0.2);
      pair->shear_force = 0.3 * pair->normal_force * (face->tangent.x > 0 ? -1 : 1);
    }
  }
}

void
fixture_init_wall (Fixture *f, int columns, int courses)
{
  begin (f, "Running bond");
  double length = columns * unit_length;
  add_block (f, qn_vec2 (0, -unit_height), qn_vec2 (length, 0), true);
  int *first = g_new (int, courses + 2);
  first[0] = 1;
  for (int c = 0; c < courses; c++) {
    double x = 0, y = c * unit_height;
    for (int i = 0; x < length - 1e-9; i++) {
      double half = c % 2 == 0 && i == 0 ? 0.5 : 1;
      double right = fmin (x + half * unit_length, length);
      add_block (f, qn_vec2 (x, y), qn_vec2 (right, y + unit_height), false);
      x = right;
    }
    first[c + 1] = (int) f->model.block_count;
  }
  for (int c = 0; c < courses; c++) {
    for (int i = first[c]; i < first[c + 1]; i++) {
      if (i + 1 < first[c + 1])
        add_face (f, i, i + 1);
      if (c == 0)
        add_face (f, 0, i);
      /* Only the neighbours above can touch. */
      int above = c + 1 < courses ? first[c + 1] + (i - first[c]) : 0;
      for (int j = above - 1; c + 1 < courses && j <= above + 1; j++)
        if (j >= first[c + 1] && j < first[c + 2])
          add_face (f, i, j);
    }
  }
  allocate_result (f, 4);
  /* What lies above a crack from the right toe rocks about that toe; the top course also
   * slides. */
  for (size_t i = 1; i < f->model.block_count; i++) {
    QnVec2 c = f->model.blocks[i].centroid;
    double *v = f->result.mechanism + 3 * i;
    bool rocks = c.y > 0.8 * (length - c.x);
    bool top = c.y > (courses - 1) * unit_height;
    double turn = rocks ? 0.3 : 0;
    v[0] = turn * c.y + (top ? 0.12 : 0);
    v[1] = turn * (length - c.x);
    v[2] = -turn;
  }
  g_free (first);
  scale_steps (f);
  set_forces (f, courses * unit_height);
}

void
fixture_init_block (Fixture *f, double width, double height)
{
  begin (f, "One block");
  f->model.characteristic_length = sqrt (width * height);
  add_block (f, qn_vec2 (-0.5 * width, -0.2 * height), qn_vec2 (1.5 * width, 0), true);
  add_block (f, qn_vec2 (0, 0), qn_vec2 (width, height), false);
  add_face (f, 0, 1);
  allocate_result (f, 2);
  double *v = f->result.mechanism + 3;
  v[2] = -0.2;
  v[0] = 0.2 * 0.5 * height;
  v[1] = 0.2 * 0.5 * width;
  scale_steps (f);
  set_forces (f, height);
}

void
fixture_clear (Fixture *f)
{
  QnModel *m = &f->model;
  for (size_t i = 0; i < m->block_count; i++)
    free (m->blocks[i].name);
  free (m->title);
  free (m->laws[0].name);
  free (m->laws);
  free (m->blocks);
  free (m->vertices);
  free (m->dead_loads);
  free (m->live_loads);
  free (m->ground);
  free (f->contacts.faces);
  free (f->contacts.pairs);
  free (f->contacts.findings.items);
  free (f->result.steps);
  free (f->result.displacements);
  free (f->result.pairs);
  free (f->result.mechanism);
  free (f->result.found);
  free (f->result.found_forces);
  free (f->result.left);
  memset (f, 0, sizeof *f);
}
