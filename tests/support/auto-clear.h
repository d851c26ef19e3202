/* What the core makes is cleared where its variable goes out of scope: g_auto (QnModel). The core
 * itself knows no GLib. A variable is filled before the first return. */
#pragma once

#include "core/contact/contacts.h"
#include "core/limit/limit.h"
#include "core/modal/modal.h"
#include "core/model/model.h"
#include "core/result/result.h"

#include <glib.h>

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnModel, qn_model_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnContacts, qn_contacts_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnResult, qn_result_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnLimitSolution, qn_limit_solution_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnModes, qn_modes_clear)
