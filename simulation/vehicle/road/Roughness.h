// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// The height by which a kind of ground is uneven at a place: smooth noise of wavelengths of 1 to 8 m, the
/// same at every question. Amplitudes stand below what the drawn surface may differ by.
/// Units: metres. Source: ISO 8608, *Mechanical vibration – Road surface profiles*, 1995 (amplitude grows
/// with the wavelength); Perlin, *An image synthesizer*, 1985 (noise on a lattice).
double roughnessM(GroundKind kind, const glm::dvec3& place);

/// The largest amount of roughnessM().
double roughnessAmplitudeM(GroundKind kind);

} // namespace simulation
