#include "io/project/project-names.h"

#include "core/model/model.h"

const char *const qn_placement_names[QN_PLACEMENT_COUNT] = {
  [QN_PLACEMENT_DEFAULT] = "default",       [QN_PLACEMENT_ENDS] = "ends",
  [QN_PLACEMENT_LOBATTO] = "gauss-lobatto", [QN_PLACEMENT_UNIFORM] = "uniform",
  [QN_PLACEMENT_GAUSS] = "gauss",           [QN_PLACEMENT_EXPLICIT] = "explicit",
};

const char *const qn_load_kind_names[QN_LOAD_KIND_COUNT] = {
  [QN_LOAD_WEIGHT] = "weight",
  [QN_LOAD_FORCE] = "force",
  [QN_LOAD_SETTLEMENT] = "settlement",
  [QN_LOAD_LINE] = "line",
  [QN_LOAD_NODE] = "force",
  [QN_LOAD_EDGE] = "edge",
  [QN_LOAD_SURCHARGE] = "surcharge",
  [QN_LOAD_BACKFILL] = "backfill",
  [QN_LOAD_FILL] = "fill",
  [QN_LOAD_VEHICLE] = "vehicle",
};

const char *const qn_dispersal_names[QN_DISPERSAL_COUNT] = {
  [QN_DISPERSAL_HALF] = "1:2",
  [QN_DISPERSAL_CS_454] = "cs-454",
  [QN_DISPERSAL_NR_025] = "nr-gn-civ-025",
  [QN_DISPERSAL_EN_1991] = "en-1991-2",
  [QN_DISPERSAL_BOUSSINESQ] = "boussinesq",
};

const char *const qn_earth_names[QN_EARTH_COUNT] = {
  [QN_EARTH_GIVEN] = "given",
  [QN_EARTH_AT_REST] = "at-rest",
  [QN_EARTH_ACTIVE] = "active",
};

const char *const qn_procedure_names[QN_PROCEDURE_COUNT] = {
  [QN_PROCEDURE_LOAD] = "load",   [QN_PROCEDURE_DISPLACEMENT] = "displacement",
  [QN_PROCEDURE_WORK] = "work",   [QN_PROCEDURE_ARC_LENGTH] = "arc-length",
  [QN_PROCEDURE_LIMIT] = "limit", [QN_PROCEDURE_DYNAMIC] = "dynamic",
};

const char *const qn_bound_choice_names[QN_BOUND_CHOICE_COUNT] = {
  [QN_BOUND_AUTO] = "auto",
  [QN_BOUND_ALWAYS] = "always",
  [QN_BOUND_NEVER] = "never",
};

const char *const qn_geometry_names[QN_GEOMETRY_COUNT] = {
  [QN_GEOMETRY_LINEAR] = "linear",
  [QN_GEOMETRY_NONLINEAR] = "nonlinear",
};

const char *const qn_snap_names[QN_SNAP_THROUGH_COUNT] = {
  [QN_SNAP_THROUGH_JUMP] = "jump",
  [QN_SNAP_THROUGH_STOP] = "stop",
};

const char *const qn_flow_names[QN_FLOW_COUNT] = {
  [QN_FLOW_ASSOCIATIVE] = "associative",
  [QN_FLOW_NON_ASSOCIATIVE] = "non-associative",
};

const char *const qn_follow_names[2] = { "fixed", "follow" };

const char *const qn_dof_names[QN_DOF_COUNT] = {
  [QN_DOF_UX] = "ux",
  [QN_DOF_UY] = "uy",
  [QN_DOF_RZ] = "rz",
};
