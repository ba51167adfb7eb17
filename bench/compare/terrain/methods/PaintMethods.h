// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "compare/terrain/methods/MeasureRival.h"
#include "compare/terrain/methods/MeshPainter.h"

namespace terraintool
{

/// Measures what a picture takes by each method that programs draw, and writes `frameMs`. With a folder it
/// also writes the pictures of all meshes from the middle eye of the flight, at four times their tolerances,
/// where triangles are large enough to be seen, and tells their names. `stem`: begins their names. Errors: a
/// picture cannot be drawn or written.
foundation::Outcome paintMethods(MeshPainter& painter, const Rivals& rivals, const ComparedFlight& flight,
                                 const std::filesystem::path& folder, const std::string& stem,
                                 std::vector<MethodFigures>& methods);

} // namespace terraintool
