// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace osgPMObjects
{

/// Tells whether a Wavefront .obj has so many faces for its positions that OSG's loader must neither smooth
/// normals nor put the faces in order for a vertex cache: the time of both grows with the square of the faces
/// at a vertex. Cost: reads the file once.
bool isCrowdedObj(const std::filesystem::path& file);

} // namespace osgPMObjects
