/* An analysis that takes seconds on any machine, for tests of what can be done meanwhile. */
#pragma once

#include "doc/document/document.h"

/* Asks for a hundred thousand increments per unit of the multiplier, none of which is to grow, as
 * one step of editing. */
void long_analysis_ask (QnDocument *document);
