// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

#include "GeodeticLocator.h"

namespace osgTerrainROAM::core
{

/// Gives a field, whose columns and rows are known, its net and its mean spacings on the ground. The net is
/// the coarsest whose biquadratic interpolation (GeodeticLattice) leaves every data sample within half a
/// millimetre of its true position on the ellipsoid and within a centimetre of the geoid grid; at most 2049²
/// nodes. (PROJ interpolates the geoid's 15' grid bilinearly, with creases that the geoid does not have;
/// EGM96 itself is accurate to half a metre.)
/// Errors: part of the data lies where its map projection is not defined; the grid is mirrored.
foundation::Outcome georeference(HeightField& field, const GeodeticLocator& locator);

} // namespace osgTerrainROAM::core
