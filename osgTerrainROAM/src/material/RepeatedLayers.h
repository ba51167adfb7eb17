// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace osgTerrainROAM
{

/// Replaces the line "// <marker>" of a shader's text, with its indentation, by generated lines.
/// A text without the marker is a fault of the program (asserted).
std::string withLines(std::string text, const std::string& marker, const std::string& lines);

/// shaders/Imagery.glsl for a number of layers: samplers imageryLayer0 … and imageryFromGrid[], coarsest
/// first.
std::string imageryText(int layers);

/// shaders/SheetNormals.glsl for a number of normal maps: samplers sheetNormals0 …, coarsest first.
std::string sheetNormalsText(int maps);

} // namespace osgTerrainROAM
