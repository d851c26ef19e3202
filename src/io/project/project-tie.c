/* Ties of a project file. */
#include "io/project/project-members.h"
#include "io/project/project-parts.h"

#include <glib/gi18n-lib.h>

static const QnMember end_members[] = {
  QN_ENTITY ("block", OPTIONAL, BLOCK, QnTieEnd, block),
  QN_TWO ("at", REQUIRED, QnTieEnd, at),
  { 0 },
};

static const QnMember plate_members[] = {
  QN_NUMBER ("diameter", REQUIRED, POSITIVE, QnTiePlate, diameter),
  QN_NUMBER ("wall", OPTIONAL, NOT_NEGATIVE, QnTiePlate, wall),
  QN_NUMBER ("shear", OPTIONAL, NOT_NEGATIVE, QnTiePlate, shear),
  QN_NUMBER ("compression", OPTIONAL, NOT_NEGATIVE, QnTiePlate, compression),
  { 0 },
};

static const QnMember strip_members[] = {
  QN_NUMBER ("width", REQUIRED, POSITIVE, QnTieStrip, width),
  QN_NUMBER ("fracture_energy", OPTIONAL, NOT_NEGATIVE, QnTieStrip, fracture_energy),
  { 0 },
};

static const QnMember tie_members[] = {
  QN_KNOWN ("name"),
  QN_MEMBER_WITH ("ends", OBJECTS, REQUIRED, QnTie, ends, 2, .members = end_members,
                  .count = sizeof (QnTieEnd),
                  .refusal = N_ ("expected two values, one for each end")),
  QN_NUMBER ("area", REQUIRED, POSITIVE, QnTie, area),
  QN_NUMBER ("elasticity", REQUIRED, POSITIVE, QnTie, elasticity),
  QN_NUMBER ("yield", OPTIONAL, POSITIVE, QnTie, yield),
  QN_NUMBER ("prestress", OPTIONAL, NOT_NEGATIVE, QnTie, prestress),
  QN_NUMBER ("slack", OPTIONAL, NOT_NEGATIVE, QnTie, slack),
  QN_NUMBER ("anchor", OPTIONAL, POSITIVE, QnTie, anchor),
  QN_OBJECT ("plate", OPTIONAL, plate_members, QnTie, plate),
  QN_OBJECT ("strip", OPTIONAL, strip_members, QnTie, strip),
  { 0 },
};

const QnList qn_tie_list = { QN_LIST ("ties", QnTie, ties, tie_count),
                             .naming = QN_NAMING_NUMBERED, .members = tie_members,
                             .usual = &(const QnTie){ 0 } };
