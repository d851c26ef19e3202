#include "render/scene/render-error.h"

/* The formatter would set spaces around dashes that are part of the name. */
/* clang-format off */
G_DEFINE_QUARK (qn-render-error-quark, qn_render_error)
/* clang-format on */
