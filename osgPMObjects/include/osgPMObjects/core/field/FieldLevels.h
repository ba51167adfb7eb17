// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <osgPMObjects/core/field/CrownGrowth.h>

namespace osgPMObjects::core
{

/// What fields draw a progressive mesh by, besides the mesh itself: it follows from the mesh alone.
struct FieldLevels
{
    LevelLadder ladder;
    CrownGrowth growth;

    /// Cost: that of LevelLadder::of() and CrownGrowth::of().
    static FieldLevels of(const ProgressiveMesh& progressive, const LevelTable& table);
};

/// Returns levels as bytes, for fieldLevelsIn(). Numbers are the machine's.
std::string bytesOf(const FieldLevels& levels);

/// Absent: bytesOf() wrote none of such a mesh. Faces and sizes are checked, so that what is returned can be
/// drawn.
std::optional<FieldLevels> fieldLevelsIn(std::string_view bytes, const ProgressiveMesh& progressive);

} // namespace osgPMObjects::core
