// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <limits>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

#include "LevelPlayer.h"

namespace osgPMObjects::core
{

ProgressiveLevel::Player::Player(const ProgressiveMesh& progressive)
    : _progressive(progressive),
      _steps(progressive.stepCount),
      _wedges(progressive.wedgesAfter(progressive.stepCount))
{
    for (const FaceBlock& block : progressive.blocks)
        _extents.push_back(block.extent);
}

ProgressiveLevel::ProgressiveLevel(const ProgressiveMesh& progressive)
    : _player(progressive.mesh.wedgeCount() < std::numeric_limits<std::uint16_t>::max()
                  ? makeNarrowPlayer(progressive)
                  : makeWidePlayer(progressive))
{
}

ProgressiveLevel::~ProgressiveLevel() = default;
ProgressiveLevel::ProgressiveLevel(ProgressiveLevel&&) noexcept = default;
ProgressiveLevel& ProgressiveLevel::operator=(ProgressiveLevel&&) noexcept = default;

void ProgressiveLevel::moveTo(std::uint32_t steps)
{
    assert(steps <= _player->progressive().stepCount);
    _player->moveTo(steps);
}

std::uint32_t ProgressiveLevel::steps() const
{
    return _player->steps();
}

std::uint32_t ProgressiveLevel::faceCount() const
{
    return _player->faceCount();
}

std::uint32_t ProgressiveLevel::wedgeCount() const
{
    return _player->wedgeCount();
}

bool ProgressiveLevel::hasNarrowIndices() const
{
    return _player->wideIndices().empty();
}

std::span<const std::uint16_t> ProgressiveLevel::narrowIndices() const
{
    return _player->narrowIndices();
}

std::span<const std::uint32_t> ProgressiveLevel::wideIndices() const
{
    return _player->wideIndices();
}

Triangle ProgressiveLevel::face(std::uint32_t slot) const
{
    const auto at = [&](const auto& indices) -> Triangle
    {
        return {indices[3 * std::size_t{slot}], indices[3 * std::size_t{slot} + 1],
                indices[3 * std::size_t{slot} + 2]};
    };
    return hasNarrowIndices() ? at(narrowIndices()) : at(wideIndices());
}

void ProgressiveLevel::appendRanges(std::uint32_t group, std::vector<SlotRange>& ranges) const
{
    const ProgressiveMesh& progressive = _player->progressive();
    const std::size_t begin = ranges.size();
    const std::uint32_t end = progressive.endBlock(group);
    for (std::uint32_t block = progressive.groups[group].firstBlock; block < end; ++block)
    {
        const std::uint32_t first = progressive.blocks[block].firstSlot, count = _player->extents()[block];
        if (count == 0) continue;
        if (ranges.size() > begin && ranges.back().first + ranges.back().count == first)
            ranges.back().count += count;
        else
            ranges.push_back({first, count});
    }
}

void ProgressiveLevel::takeChanges(std::vector<SlotRange>& changes)
{
    _player->takeChanges(changes);
}

const StepStatistics& ProgressiveLevel::statistics() const
{
    return _player->statistics();
}

} // namespace osgPMObjects::core
