// SPDX-License-Identifier: Apache-2.0
#include <foundation/PlainBytes.h>

#include <osgPMObjects/core/field/FieldLevels.h>

namespace osgPMObjects::core
{

FieldLevels FieldLevels::of(const ProgressiveMesh& progressive, const LevelTable& table)
{
    FieldLevels levels;
    levels.ladder = LevelLadder::of(progressive, table);
    levels.growth = CrownGrowth::of(progressive, levels.ladder);
    return levels;
}

std::string bytesOf(const FieldLevels& levels)
{
    std::string bytes;
    foundation::appendValues(bytes, levels.ladder.rungs);
    foundation::appendValues(bytes, levels.ladder.steps);
    foundation::appendValue(bytes, levels.ladder.groups);
    foundation::appendValues(bytes, levels.ladder.ends);
    foundation::appendValues(bytes, levels.ladder.faces);
    foundation::appendValues(bytes, levels.growth.offsets);
    foundation::appendValues(bytes, levels.growth.scales);
    return bytes;
}

std::optional<FieldLevels> fieldLevelsIn(std::string_view bytes, const ProgressiveMesh& progressive)
{
    FieldLevels levels;
    LevelLadder& ladder = levels.ladder;
    foundation::ValueTaker taker(bytes);
    if (!taker.take(ladder.rungs) || !taker.take(ladder.steps) || !taker.take(ladder.groups) ||
        !taker.take(ladder.ends) || !taker.take(ladder.faces) || !taker.take(levels.growth.offsets) ||
        !taker.take(levels.growth.scales) || !taker.isEmpty())
        return std::nullopt;
    if (ladder.groups != progressive.groups.size() || !isLadder(ladder)) return std::nullopt;
    const std::size_t wedges = progressive.mesh.wedgeCount();
    for (const LevelLadder::Rung& rung : ladder.rungs)
        if (rung.wedges > wedges) return std::nullopt;
    const CrownGrowth& growth = levels.growth;
    const bool hasNone = growth.offsets.empty() && growth.scales.empty();
    if (!hasNone &&
        (growth.offsets.size() != wedges || growth.scales.size() != ladder.rungs.size() * ladder.groups))
        return std::nullopt;
    return levels;
}

} // namespace osgPMObjects::core
