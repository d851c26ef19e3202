#include "io/project/project-names.h"

#include "core/model/model.h"

const char *
qn_name_of_law_kind (int kind)
{
  return qn_law_kind_name ((QnLawKind) kind);
}

const char *
qn_name_of_basis (int basis)
{
  return qn_basis_name ((QnBasis) basis);
}

const char *
qn_name_of_placement (int placement)
{
  static const char *const names[QN_PLACEMENT_COUNT] = {
    [QN_PLACEMENT_ENDS] = "ends",
    [QN_PLACEMENT_UNIFORM] = "uniform",
    [QN_PLACEMENT_GAUSS] = "gauss",
    [QN_PLACEMENT_EXPLICIT] = "explicit",
  };
  return names[placement];
}

const char *
qn_name_of_load_kind (int kind)
{
  static const char *const names[QN_LOAD_KIND_COUNT] = {
    [QN_LOAD_WEIGHT] = "weight",
    [QN_LOAD_FORCE] = "force",
    [QN_LOAD_SETTLEMENT] = "settlement",
    [QN_LOAD_LINE] = "line",
    [QN_LOAD_NODE] = "force",
  };
  return names[kind];
}

const char *
qn_name_of_beam_kind (int kind)
{
  return qn_beam_kind_name ((QnBeamKind) kind);
}

const char *
qn_name_of_block_side (int side)
{
  return qn_block_side_name ((QnBlockSide) side);
}

const char *
qn_name_of_procedure (int procedure)
{
  static const char *const names[QN_PROCEDURE_COUNT] = {
    [QN_PROCEDURE_LOAD] = "load",   [QN_PROCEDURE_DISPLACEMENT] = "displacement",
    [QN_PROCEDURE_WORK] = "work",   [QN_PROCEDURE_ARC_LENGTH] = "arc-length",
    [QN_PROCEDURE_LIMIT] = "limit", [QN_PROCEDURE_DYNAMIC] = "dynamic",
  };
  return names[procedure];
}

const char *
qn_name_of_geometry (int geometry)
{
  static const char *const names[QN_GEOMETRY_COUNT] = {
    [QN_GEOMETRY_LINEAR] = "linear",
    [QN_GEOMETRY_NONLINEAR] = "nonlinear",
  };
  return names[geometry];
}

const char *
qn_name_of_snap (int snap)
{
  static const char *const names[QN_SNAP_THROUGH_COUNT] = {
    [QN_SNAP_THROUGH_JUMP] = "jump",
    [QN_SNAP_THROUGH_STOP] = "stop",
  };
  return names[snap];
}

const char *
qn_name_of_flow (int flow)
{
  static const char *const names[QN_FLOW_COUNT] = {
    [QN_FLOW_ASSOCIATIVE] = "associative",
    [QN_FLOW_NON_ASSOCIATIVE] = "non-associative",
  };
  return names[flow];
}

const char *
qn_name_of_dof (int dof)
{
  static const char *const names[QN_DOF_COUNT] = {
    [QN_DOF_UX] = "ux",
    [QN_DOF_UY] = "uy",
    [QN_DOF_RZ] = "rz",
  };
  return names[dof];
}

/* --- Shortcuts -------------------------------------------------------------------------- */

static const struct {
  const char *name;
  size_t offset;
} shortcuts[QN_SHORTCUT_COUNT] = {
  { "same_tangent", offsetof (QnShortcuts, same_tangent) },
  { "partial_elimination", offsetof (QnShortcuts, partial_elimination) },
  { "early_failure", offsetof (QnShortcuts, early_failure) },
  { "mechanism_estimate", offsetof (QnShortcuts, mechanism_estimate) },
  { "growing_increments", offsetof (QnShortcuts, growing_increments) },
  { "unchanged_joints", offsetof (QnShortcuts, unchanged_joints) },
};

const char *
qn_name_of_shortcut (int shortcut)
{
  return shortcuts[shortcut].name;
}

bool *
qn_shortcut (QnShortcuts *values, int shortcut)
{
  return (bool *) ((char *) values + shortcuts[shortcut].offset);
}

const char *
qn_name_of_pulse (int kind)
{
  return qn_pulse_kind_name ((QnPulseKind) kind);
}

const char *
qn_name_of_damping (int of)
{
  return qn_damping_stiffness_name ((QnDampingStiffness) of);
}
