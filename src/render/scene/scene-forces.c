/* Contact forces: a thin arrow for every pair, the resultant of every face and of every contact found on
 * the way (core/contact/contact-follow.h) as an arrow on its line of action, and the line of thrust where there is one (thrust.h), with the force and the kern at each
 * of its joints. In nonlinear geometry all of it is drawn where the blocks have moved to, at
 * factor 1. */
#include "core/base/integer.h"
#include "render/drawing/text.h"
#include "render/scene/reading.h"
#include "render/scene/scene-builder.h"
#include "render/scene/thrust.h"

#include <glib/gi18n-lib.h>

/* Length of the largest resultant in block sizes. */
#define LARGEST_BAR 1.5

/* Forces below this share of the largest are not drawn; of contacts found on the way. */
#define LEAST_SHARE       QN_THRUST_LEAST_SHARE
#define LEAST_FOUND_SHARE 1e-3

/* Of the dot where a corner lies on the side that it has found, pt. */
#define FOUND_SIZE 4.6F

/* Joints of the line of thrust that are closer on paper have no numbers, pt: above each other, and
 * beside each other, where numbers need their width. */
#define NUMBER_LEAST 16
#define NUMBER_WIDE  32

/* Size of the values of a joint, and the room that they need, pt. */
#define VALUE_SIZE   5.5
#define VALUES_LEAST 30

/* Part of a force, and of the length of its joint, below which numbers are rounding errors. */
#define NOTHING 1e-6

/* Of a number, so that it begins to the right of its place. */
#define BESIDE (-0.2F)

typedef struct FaceForce {
  QnVec2 force; /* on block a, N */
  QnVec2 at;    /* where the normal resultant acts, m */
} FaceForce;

/* A force by its parts along the frame of the joint, which turns with its blocks. */
static QnVec2
joint_force (const QnSceneBuilder *b, const QnContactFace *face, double normal,
             double shear)
{
  QnVec2 force = qn_vec2_add (qn_vec2_scale (normal, face->normal),
                              qn_vec2_scale (shear, face->tangent));
  const double *u = b->motion.displacements;
  if (u == NULL)
    return force;
  double turn = 0.5
                * (u[(size_t) face->a * QN_DOF_COUNT + QN_DOF_RZ]
                   + u[(size_t) face->b * QN_DOF_COUNT + QN_DOF_RZ]);
  return qn_vec2_rotate (force, cos (turn), sin (turn));
}

static void
add_pair_forces (QnSceneBuilder *b, const QnContactFace *face, double per_newton,
                 double least)
{
  QnColor color = qn_builder_ink (b, QN_INK_FAINT);
  for (int32_t k = 0; k < face->pair_count; k++) {
    QnId index = face->first_pair + k;
    QnVec2 force =
      joint_force (b, face, b->pairs[index].normal_force, b->pairs[index].shear_force);
    if (qn_vec2_length (force) < least)
      continue;
    QnVec2 at = qn_builder_place_joint (b, face, b->contacts->pairs[index].point);
    QnVec2 tail = qn_vec2_add_scaled (at, -per_newton, force);
    qn_scene_arrow (b->scene, QN_LAYER_FORCES, tail, at, 0.5, color, QN_PICK_PAIR, index,
                    qn_vec2_length (force) * per_newton);
  }
}

/* As arrows that point down, with the weight, along a line of thrust all the same way: the middle at a
 * place, the thicker the nearer to the largest, N. */
static void
add_resultant (QnSceneBuilder *b, QnVec2 force, QnVec2 at, double per_newton,
               double largest, QnPickKind pick, QnId id)
{
  QnColor color = qn_builder_ink (b, QN_INK_FORCE);
  double size = qn_vec2_length (force), share = size / largest;
  double half = (force.y > 0 ? -0.5 : 0.5) * per_newton;
  qn_scene_arrow (b->scene, QN_LAYER_FORCES, qn_vec2_add_scaled (at, -half, force),
                  qn_vec2_add_scaled (at, half, force), 0.5 + 1.2 * share, color, pick,
                  id, size * per_newton);
}

/* ---- contacts found on the way ---- */

static QnVec2
found_place (const QnSceneBuilder *b, const QnTouch *touch)
{
  return qn_builder_place (b, touch->block[1], touch->at[1]);
}

void
qn_build_found (QnSceneBuilder *b)
{
  QnColor color = qn_builder_ink (b, QN_INK_FACE);
  for (size_t i = 0; i < b->touch_count; i++) {
    QnCommand *command =
      qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_DOT,
                       found_place (b, &b->touches[i]), FOUND_SIZE, 0, color);
    qn_command_set_pick (command, QN_PICK_FOUND, b->touches[i].found);
  }
  if (b->touch_count > 0)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, FOUND_SIZE, color, "%s",
                     _ ("contact found during the motion"));
}

/* ---- the line of thrust ---- */

/* The touch that the force of a cut passes through, or NULL: a joint as drawn. */
static const QnTouch *
touch_of (const QnSceneBuilder *b, const QnCut *cut)
{
  size_t faces = b->contacts->face_count;
  return (size_t) cut->face >= faces ? &b->touches[(size_t) cut->face - faces] : NULL;
}

static QnVec2
cut_place (const QnSceneBuilder *b, const QnCut *cut, QnVec2 p)
{
  const QnTouch *touch = touch_of (b, cut);
  if (touch != NULL)
    return qn_builder_place (b, touch->block[0], p);
  return qn_builder_place_joint (b, &b->contacts->faces[cut->face], p);
}

static void
pick_cut (const QnSceneBuilder *b, QnCommand *command, const QnCut *cut)
{
  const QnTouch *touch = touch_of (b, cut);
  qn_command_set_pick (command, touch != NULL ? QN_PICK_FOUND : QN_PICK_FACE,
                       touch != NULL ? touch->found : cut->face);
}

/* The middle third, within which the whole joint is pressed. */
static void
add_kern (QnSceneBuilder *b, const QnCut *cut)
{
  if (!(cut->length > 0))
    return;
  QnVec2 kern[2] = { cut_place (b, cut, qn_vec2_lerp (cut->start, cut->end, 1.0 / 3.0)),
                     cut_place (b, cut, qn_vec2_lerp (cut->start, cut->end, 2.0 / 3.0)) };
  QnCommand *command = qn_scene_stroke (b->scene, QN_LAYER_FORCES, kern, 2, false, 1.6,
                                        qn_builder_ink (b, QN_INK_FAINT));
  pick_cut (b, command, cut);
  qn_command_set_extent (command, cut->length, 12);
}

static QnMarker
place_marker (QnPressurePlace place)
{
  return place == QN_PLACE_EDGE     ? QN_MARKER_SQUARE
         : place == QN_PLACE_INSIDE ? QN_MARKER_RING
                                    : QN_MARKER_DOT;
}

static float
place_size (QnPressurePlace place)
{
  return place == QN_PLACE_INSIDE ? 3.6F : place == QN_PLACE_EDGE ? 3.4F : 3.0F;
}

/* A number that rounding has left where 0 is meant is 0. */
static double
legible (double value, double scale)
{
  return fabs (value) < NOTHING * scale ? 0 : value;
}

/* N, T, M and eccentricity beside a place, where there is room for them: of a joint of this length. */
static void
add_values (QnSceneBuilder *b, QnVec2 at, double normal, double shear, double moment,
            double eccentricity, double length, QnPressurePlace place, double room,
            QnColor color)
{
  double force = hypot (normal, shear);
  normal = legible (normal, force);
  shear = legible (shear, force);
  moment = legible (moment, force * length);
  eccentricity = legible (eccentricity, length);
  g_autofree char *n = qn_label_number ("%.3g", normal / 1000);
  g_autofree char *t = qn_label_number ("%.3g", shear / 1000);
  g_autofree char *m = qn_label_number ("%.3g", moment / 1000);
  g_autofree char *e = place != QN_PLACE_NOWHERE
                         ? qn_label_number ("%.3g", 1000 * eccentricity)
                         : g_strdup ("–");
  bool point = place == QN_PLACE_NOWHERE && moment == 0; /* a corner on a side */
  g_autofree char *text = point ? g_strdup_printf ("N %s\nT %s", n, t)
                                : g_strdup_printf ("N %s\nT %s\nM %s\ne %s", n, t, m, e);
  QnCommand *command =
    qn_scene_text (b->scene, QN_LAYER_LABELS, at, VALUE_SIZE, text, color);
  command->align_x = BESIDE;
  command->align_y = 0.5F;
  qn_command_set_extent (command, room, VALUES_LEAST);
}

static QnVec2
along (QnVec2 v)
{
  double length = qn_vec2_length (v);
  return length > 0 ? qn_vec2_scale (1 / length, v) : v;
}

/* Places a number into the corner between the joint and the line of thrust that points to the
 * right most: neither runs through it. `way` is that of its pieces which leads to the right. */
static void
set_beside (QnCommand *number, QnVec2 joint, QnVec2 way)
{
  QnVec2 corner = { 0, 0 };
  for (int i = 0; i < 4; i++) {
    QnVec2 d = along (qn_vec2_add (qn_vec2_scale (i % 2 ? -1 : 1, joint),
                                   qn_vec2_scale (i / 2 ? -1 : 1, way)));
    if (d.x + 0.1 * d.y > corner.x + 0.1 * corner.y)
      corner = d;
  }
  number->align_x = BESIDE;
  number->align_y = (float) (0.5 - 0.85 * corner.y);
}

/* Three digits that count, zeros too: "1.70" beside "1.37". */
static char *
dup_three_digits (double number)
{
  int decimals = number > 0 ? (int) qn_to_integer (2 - floor (log10 (number)), 0, 6) : 0;
  g_autofree char *format = g_strdup_printf ("%%.%df", decimals);
  return qn_label_number (format, number);
}

/* A point of the line, with the force there, at a distance from the nearest one; `stride` from the
 * next one of its rank, `way` as above, of unit length. */
static void
add_cut (QnSceneBuilder *b, const QnCut *cut, double spacing, int stride, QnVec2 way)
{
  QnColor color = qn_builder_ink (b, QN_INK_THRUST);
  QnVec2 at = cut_place (b, cut, cut->at);
  add_kern (b, cut);
  QnCommand *command =
    qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, place_marker (cut->place), at,
                     place_size (cut->place), 0, color);
  pick_cut (b, command, cut);
  qn_command_set_extent (command, spacing, 4);
  if (b->options->values) {
    add_values (b, at, qn_vec2_dot (cut->force, cut->normal),
                qn_vec2_dot (cut->force, qn_vec2_perp (cut->normal)), cut->moment,
                cut->eccentricity, cut->length, cut->place, spacing, color);
    return;
  }
  g_autofree char *number = dup_three_digits (qn_vec2_length (cut->force) / 1000);
  g_autofree char *text = g_strdup_printf (_ ("%s kN"), number);
  command = qn_scene_text (b->scene, QN_LAYER_LABELS, at, 6.5, text, color);
  QnVec2 joint =
    qn_vec2_sub (cut_place (b, cut, cut->end), cut_place (b, cut, cut->start));
  set_beside (command, along (joint), way);
  qn_command_set_extent (
    command, stride * spacing,
    (float) (NUMBER_LEAST + (NUMBER_WIDE - NUMBER_LEAST) * fabs (way.x)));
}

/* How many joints lie from one that has its number to the next one that has: of a line of thrust
 * every one has its number where there is room, else every second, every fourth. */
static uint8_t *
dup_strides (const QnThrust *thrust)
{
  uint8_t *strides = g_new0 (uint8_t, thrust->count + 1);
  for (size_t c = 0; c < thrust->count; c++) {
    const QnId *next = thrust->cuts[c].next;
    QnId before = QN_NONE, at = (QnId) c;
    if (strides[c] > 0 || (next[0] == QN_NONE) == (next[1] == QN_NONE))
      continue;
    for (unsigned index = 0; at != QN_NONE && strides[at] == 0; index++) {
      unsigned stride = 1;
      while (index % (2 * stride) == 0 && stride < 64)
        stride *= 2;
      strides[at] = (uint8_t) stride;
      next = thrust->cuts[at].next;
      QnId after = next[0] != before ? next[0] : next[1];
      before = at;
      at = after;
    }
  }
  return strides;
}

/* From every joint to the next, each way once. */
static void
add_thrust (QnSceneBuilder *b, const QnThrust *thrust, bool places[QN_PLACE_COUNT])
{
  QnColor color = qn_builder_ink (b, QN_INK_THRUST);
  g_autofree uint8_t *strides = dup_strides (thrust);
  for (size_t c = 0; c < thrust->count; c++) {
    const QnCut *cut = &thrust->cuts[c];
    double spacing = INFINITY;
    QnVec2 way = { 0, 0 };
    for (int side = 0; side < 2; side++) {
      if (cut->next[side] == QN_NONE)
        continue;
      const QnCut *next = &thrust->cuts[cut->next[side]];
      QnVec2 line[2] = { cut_place (b, cut, cut->at), cut_place (b, next, next->at) };
      QnVec2 piece = qn_vec2_sub (line[1], line[0]);
      spacing = fmin (spacing, qn_vec2_length (piece));
      if (qn_vec2_length (way) == 0 || along (piece).x > way.x)
        way = along (piece);
      if ((size_t) cut->next[side] > c)
        qn_scene_stroke (b->scene, QN_LAYER_FORCES, line, 2, false, 2.2, color);
    }
    if (!isfinite (spacing))
      continue;
    add_cut (b, cut, spacing, MAX (strides[c], 1), way);
    places[cut->place] = true;
  }
}

static bool
has_next (const QnCut *cut)
{
  return cut->next[0] != QN_NONE || cut->next[1] != QN_NONE;
}

/* Of joints through which no line passes. */
static void
add_face_values (QnSceneBuilder *b, const QnThrust *thrust, double least)
{
  for (size_t f = 0; f < b->contacts->face_count; f++) {
    const QnContactFace *face = &b->contacts->faces[f];
    QnJointReading r = qn_joint_reading (b->contacts, (QnId) f, b->pairs);
    if (!has_next (&thrust->cuts[thrust->cut_of[f]])
        && (fabs (r.normal) > least || fabs (r.shear) > least
            || fabs (r.moment) > least * face->length))
      add_values (b, qn_builder_place_joint (b, face, r.at), r.normal, r.shear, r.moment,
                  r.eccentricity, face->length, r.place, face->length,
                  qn_builder_ink (b, QN_INK_FORCE));
  }
  for (size_t i = 0; i < b->touch_count; i++) {
    const QnTouch *touch = &b->touches[i];
    if (!has_next (&thrust->cuts[thrust->cut_of[b->contacts->face_count + i]]))
      add_values (b, qn_builder_place (b, touch->block[0], touch->at[0]), touch->force,
                  touch->shear, 0, 0, 0, QN_PLACE_NOWHERE, b->block_size,
                  qn_builder_ink (b, QN_INK_FORCE));
  }
  qn_scene_legend (b->scene, QN_COMMAND_TEXT, 0, qn_builder_ink (b, QN_INK_LINE), "%s",
                   _ ("N, T (kN), M (kN·m), e (mm), where there is room"));
}

static void
add_thrust_legend (QnSceneBuilder *b, const bool places[QN_PLACE_COUNT])
{
  static const char *const words[QN_PLACE_COUNT] = {
    [QN_PLACE_KERN] = N_ ("resultant within the kern"),
    [QN_PLACE_INSIDE] = N_ ("resultant outside the kern"),
    [QN_PLACE_EDGE] = N_ ("resultant at the edge"),
  };
  QnColor color = qn_builder_ink (b, QN_INK_THRUST);
  if (!places[QN_PLACE_KERN] && !places[QN_PLACE_INSIDE] && !places[QN_PLACE_EDGE])
    return;
  qn_scene_legend (b->scene, QN_COMMAND_STROKE, 2.2F, color, "%s", _ ("line of thrust"));
  qn_scene_legend (b->scene, QN_COMMAND_STROKE, 1.6F, qn_builder_ink (b, QN_INK_FAINT),
                   "%s", _ ("kern: middle third of a joint"));
  for (int place = QN_PLACE_KERN; place < QN_PLACE_COUNT; place++) {
    if (!places[place])
      continue;
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, place_size ((QnPressurePlace) place),
                     color, "%s", _ (words[place]))
      ->marker = (uint8_t) place_marker ((QnPressurePlace) place);
  }
}

/* ---- all of it ---- */

void
qn_build_forces (QnSceneBuilder *b)
{
  const QnContacts *contacts = b->contacts;
  double largest = 0, longest = 0;
  g_autofree FaceForce *resultants = g_new0 (FaceForce, MAX (contacts->face_count, 1));
  for (size_t f = 0; f < contacts->face_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    QnJointReading reading = qn_joint_reading (contacts, (QnId) f, b->pairs);
    resultants[f] = (FaceForce){ joint_force (b, face, reading.normal, reading.shear),
                                 qn_builder_place_joint (b, face, reading.at) };
    largest = fmax (largest, qn_vec2_length (resultants[f].force));
  }
  /* In bending the pairs carry more than their resultant. */
  for (size_t p = 0; p < contacts->pair_count && b->options->symbols; p++)
    longest = fmax (longest, hypot (b->pairs[p].normal_force, b->pairs[p].shear_force));
  for (size_t i = 0; i < b->touch_count; i++)
    largest = fmax (largest, hypot (b->touches[i].force, b->touches[i].shear));
  if (!(largest > 0))
    return;
  double per_newton = LARGEST_BAR * b->block_size / fmax (largest, longest);
  for (size_t f = 0; f < contacts->face_count; f++) {
    if (b->options->symbols)
      add_pair_forces (b, &contacts->faces[f], per_newton, LEAST_SHARE * largest);
    if (qn_vec2_length (resultants[f].force) >= LEAST_SHARE * largest)
      add_resultant (b, resultants[f].force, resultants[f].at, per_newton, largest,
                     QN_PICK_FACE, (QnId) f);
  }
  const double *u = b->motion.displacements;
  for (size_t i = 0; i < b->touch_count; i++) {
    const QnTouch *touch = &b->touches[i];
    double turn = u != NULL ? u[(size_t) touch->block[0] * QN_DOF_COUNT + QN_DOF_RZ] : 0;
    if (hypot (touch->force, touch->shear) >= LEAST_FOUND_SHARE * largest)
      add_resultant (b, qn_vec2_rotate (touch->on[0], cos (turn), sin (turn)),
                     found_place (b, touch), per_newton, largest, QN_PICK_FOUND,
                     touch->found);
  }
  g_autofree char *number = qn_label_number ("%.4g", largest / 1000);
  qn_scene_legend (b->scene, QN_COMMAND_STROKE, 2, qn_builder_ink (b, QN_INK_FORCE),
                   _ ("resultant of a joint, largest %s kN"), number);
  QnThrust thrust;
  bool places[QN_PLACE_COUNT] = { false };
  qn_thrust_find (&thrust, b->model, contacts, b->pairs, b->touches, b->touch_count);
  add_thrust (b, &thrust, places);
  if (b->options->values)
    add_face_values (b, &thrust, LEAST_SHARE * largest);
  qn_thrust_clear (&thrust);
  add_thrust_legend (b, places);
  if (b->options->symbols)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 0.6f, qn_builder_ink (b, QN_INK_FAINT),
                     "%s", _ ("force of a contact pair"))
      ->marker = QN_MARKER_ARROW_HEAD;
}
