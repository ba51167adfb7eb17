// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Noise.h"

namespace islandgen
{

/// Frame: kilometres east and north of the island's south-west corner.
struct PlaceKm
{
    float x;
    float y;
};

/// The place, moved by noise of this largest wavelength, about as far as the amplitude.
PlaceKm warped(PlaceKm place, Noise noise, float wavelengthKm, float amplitudeKm, int octaves);

/// Distance from the drawn coast, made uneven by noise; negative at sea, and in a strip along the border.
float plannedInlandKm(PlaceKm place, Noise noise);

/// Uplift over erodibility: high along the drawn range, less in the hills, least in the plain.
float steepnessM(PlaceKm place, Noise noise);

} // namespace islandgen
