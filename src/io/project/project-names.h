/* Words of the project file for the enumerations of the model. Each takes the enumeration's
 * value and returns a static string. */
#ifndef QN_IO_PROJECT_NAMES_H
#define QN_IO_PROJECT_NAMES_H

#include "core/model/model.h"

const char *qn_name_of_law_kind (int kind);
const char *qn_name_of_basis (int basis);
const char *qn_name_of_placement (int placement);
const char *qn_name_of_load_kind (int kind);
const char *qn_name_of_beam_kind (int kind);
const char *qn_name_of_block_side (int side);
const char *qn_name_of_procedure (int procedure);
const char *qn_name_of_geometry (int geometry);
const char *qn_name_of_snap (int snap);
const char *qn_name_of_flow (int flow);
const char *qn_name_of_dof (int dof);
const char *qn_name_of_pulse (int kind);
const char *qn_name_of_damping (int of);

/* The switches of QnShortcuts by number, and their words. */
#define QN_SHORTCUT_COUNT 6
const char *qn_name_of_shortcut (int shortcut);
bool *qn_shortcut (QnShortcuts *shortcuts, int shortcut);

#endif
