// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Checks a mesh; returns a description of the first defect, or an empty string. Defects are an index out of
/// range, an attribute array of another length than the wedges, a coordinate or attribute that is not finite,
/// and more than 2^32 - 2 positions or wedges. Shape is not checked: degenerate faces and open edges are
/// allowed. Cost: linear.
std::string defectOf(const Mesh& mesh);

inline bool isValid(const Mesh& mesh)
{
    return defectOf(mesh).empty();
}

} // namespace osgPMObjects::core
