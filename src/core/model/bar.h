/* Reinforcing bars are given by their area; people speak of the diameter of one round bar of it. */
#pragma once

/* Area of a round bar of that diameter, m2, m; and the other way round. */
double qn_bar_get_area (double diameter);
double qn_bar_get_diameter (double area);
