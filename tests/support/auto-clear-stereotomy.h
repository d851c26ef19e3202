/* The same as auto-clear.h for masonry and rings. */
#pragma once

#include "stereotomy/masonry.h"
#include "stereotomy/ring.h"

#include <glib.h>

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnMasonry, qn_masonry_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnMasonries, qn_masonries_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnRing, qn_ring_clear)
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnRings, qn_rings_clear)
