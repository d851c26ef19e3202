/* A drawing of ten thousand blocks, an edit of one of them, and what that costs. */
#pragma once

#include "doc/document/document.h"

/* The block that moves, amid the others. */
#define LARGE_DRAWING_BLOCK ((QnId) 5050)

/* Loads a running bond of 100 x 100 single blocks of 0.40 x 0.175 m, the lowest course fixed, with
 * dead and live loads. */
void large_drawing_load (QnDocument *document);

/* Moves the block by as many m up, as one step; aborts where it is refused. */
void large_drawing_move (QnDocument *document, double by);

/* s of processor time that this program has used. */
double large_drawing_seconds (void);
