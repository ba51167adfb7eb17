// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// Lists the faults of a model; empty when it has none. Checked: the mesh (MeshCheck.h), unit normals, finite
/// texture coordinates and colours of wedges, a surface for each material, no degenerate face, sizes that
/// agree with the mesh. Cost: linear.
std::string defectOf(const Model& model);

inline bool isModel(const Model& model)
{
    return defectOf(model).empty();
}

/// Returns whether the faces of all parts with this name are closed: each edge occurs as often in one
/// direction as in the other. False without such faces.
bool isClosed(const osgPMObjects::core::Mesh& mesh, const std::string& partName);

} // namespace scenery::models
