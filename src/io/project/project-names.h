/* Words of the project file for the enumerations of the model. Those of laws, beams and
 * ground motions stand beside the enumerations. */
#pragma once

#include "core/model/model.h"

extern const char *const qn_placement_names[QN_PLACEMENT_COUNT];
extern const char *const qn_load_kind_names[QN_LOAD_KIND_COUNT];
extern const char *const qn_dispersal_names[QN_DISPERSAL_COUNT];
extern const char *const qn_earth_names[QN_EARTH_COUNT];
extern const char *const qn_procedure_names[QN_PROCEDURE_COUNT];
extern const char *const qn_bound_choice_names[QN_BOUND_CHOICE_COUNT];
extern const char *const qn_geometry_names[QN_GEOMETRY_COUNT];
extern const char *const qn_snap_names[QN_SNAP_THROUGH_COUNT];
extern const char *const qn_flow_names[QN_FLOW_COUNT];
extern const char *const qn_follow_names[2]; /* of contacts: that of false first */
extern const char *const qn_dof_names[QN_DOF_COUNT];
