/* An analysis in time that takes long on any machine, for tests of what can be done meanwhile. */
#pragma once

#include "doc/document/document.h"

/* Asks for it, as one step of editing. Its live curve has a point every 200 steps. */
void long_analysis_ask (QnDocument *document);
