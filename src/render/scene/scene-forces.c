/* Contact forces: a thin line for every pair, the resultant of every face as a bar on its
 * line of action. The bars of a course join up to the line of thrust. In nonlinear geometry all
 * of it is drawn where the blocks have moved to, at factor 1. */
#include "render/scene/scene-builder.h"
#include "render/scene/text.h"

#include <glib/gi18n-lib.h>

/* Length of the largest resultant in block sizes. */
#define LARGEST_BAR 1.5

/* Forces below this share of the largest are not drawn. */
#define LEAST_SHARE 2e-3

typedef struct FaceForce {
  QnVec2 force; /* on block a, N */
  QnVec2 at;    /* where the normal resultant acts, m */
} FaceForce;

/* Where a point of a joint is, half-way between its two sides. */
static QnVec2
joint_place (const QnSceneBuilder *b, const QnContactFace *face, QnVec2 p)
{
  return qn_vec2_lerp (qn_builder_place (b, face->a, p), qn_builder_place (b, face->b, p),
                       0.5);
}

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

/* Share of the normal forces that is left of them in their resultant: below, it is bending with
 * rounding, and its centre is anywhere. */
#define BENDING_SHARE 1e-3

/* Resultant of a face; its place is the centre of the normal forces, kept within the face
 * where tension would carry it off, or the middle of the face under bending alone. */
static FaceForce
face_resultant (const QnSceneBuilder *b, const QnContactFace *face)
{
  double normal = 0, shear = 0, moment = 0, total = 0;
  for (int32_t k = 0; k < face->pair_count; k++) {
    const QnPairResult *pair = &b->pairs[face->first_pair + k];
    normal += pair->normal_force;
    shear += pair->shear_force;
    total += fabs (pair->normal_force);
    moment += pair->normal_force * b->contacts->pairs[face->first_pair + k].abscissa;
  }
  bool bending = !(fabs (normal) > BENDING_SHARE * total);
  double s = bending ? 0.5 * face->length : moment / normal;
  s = fmin (fmax (s, 0), face->length);
  QnVec2 at =
    qn_vec2_lerp (face->start, face->end, face->length > 0 ? s / face->length : 0);
  return (FaceForce){ .force = joint_force (b, face, normal, shear),
                      .at = joint_place (b, face, at) };
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
    QnVec2 at = joint_place (b, face, b->contacts->pairs[index].point);
    QnVec2 tail = qn_vec2_add_scaled (at, -per_newton, force);
    qn_scene_arrow (b->scene, QN_LAYER_FORCES, tail, at, 0.5, color, QN_PICK_PAIR, index,
                    qn_vec2_length (force) * per_newton);
  }
}

static void
add_resultant (QnSceneBuilder *b, QnId face, const FaceForce *resultant,
               double per_newton, double largest)
{
  QnColor color = qn_builder_ink (b, QN_INK_FORCE);
  double share = qn_vec2_length (resultant->force) / largest;
  QnVec2 bar[2] = {
    qn_vec2_add_scaled (resultant->at, -0.5 * per_newton, resultant->force),
    qn_vec2_add_scaled (resultant->at, 0.5 * per_newton, resultant->force)
  };
  QnCommand *command =
    qn_scene_stroke (b->scene, QN_LAYER_FORCES, bar, 2, false, 0.6 + 1.6 * share, color);
  command->pick = QN_PICK_FACE;
  command->id = face;
  command = qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_DOT, resultant->at,
                             2.2 + 1.4 * share, 0, color);
  command->pick = QN_PICK_FACE;
  command->id = face;
  command->extent = (float) b->block_size;
  command->least = 6;
}

void
qn_build_forces (QnSceneBuilder *b)
{
  const QnContacts *contacts = b->contacts;
  g_autofree FaceForce *resultants = g_new0 (FaceForce, MAX (contacts->face_count, 1));
  double largest = 0, longest = 0;
  for (size_t f = 0; f < contacts->face_count; f++) {
    resultants[f] = face_resultant (b, &contacts->faces[f]);
    largest = fmax (largest, qn_vec2_length (resultants[f].force));
  }
  /* In bending the pairs carry more than their resultant. */
  for (size_t p = 0; p < contacts->pair_count && b->options->symbols; p++)
    longest = fmax (longest, hypot (b->pairs[p].normal_force, b->pairs[p].shear_force));
  if (!(largest > 0))
    return;
  double per_newton = LARGEST_BAR * b->block_size / fmax (largest, longest);
  for (size_t f = 0; f < contacts->face_count; f++) {
    if (b->options->symbols)
      add_pair_forces (b, &contacts->faces[f], per_newton, LEAST_SHARE * largest);
    if (qn_vec2_length (resultants[f].force) >= LEAST_SHARE * largest)
      add_resultant (b, (QnId) f, &resultants[f], per_newton, largest);
  }
  g_autofree char *number = qn_label_number ("%.4g", largest / 1000);
  qn_scene_legend (b->scene, QN_COMMAND_STROKE, qn_builder_ink (b, QN_INK_FORCE),
                   _ ("resultant of a joint, largest %s kN"), number)
    ->size = 2;
  if (b->options->symbols) {
    QnLegendEntry *entry =
      qn_scene_legend (b->scene, QN_COMMAND_MARKER, qn_builder_ink (b, QN_INK_FAINT),
                       "%s", _ ("force of a contact pair"));
    entry->marker = QN_MARKER_ARROW_HEAD;
    entry->size = 0.6f;
  }
}
