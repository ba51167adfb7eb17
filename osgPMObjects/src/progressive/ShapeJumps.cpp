// SPDX-License-Identifier: Apache-2.0
#include "ShapeJumps.h"

#include <cstring>

namespace osgPMObjects
{

namespace
{

template<class Index>
core::Triangle triangleAt(const std::vector<std::byte>& indices, std::uint32_t triangle)
{
    std::array<Index, 3> corners{};
    std::memcpy(corners.data(), indices.data() + triangle * sizeof corners, sizeof corners);
    return {corners[0], corners[1], corners[2]};
}

} // namespace

core::Triangle JumpedLevel::triangle(std::uint32_t index) const
{
    return isNarrow ? triangleAt<std::uint16_t>(indices, index) : triangleAt<std::uint32_t>(indices, index);
}

JumpedLevelPtr ShapeJumps::to(std::uint32_t steps)
{
    const auto made = std::make_shared<JumpedLevel>();
    made->steps = steps;
    const std::lock_guard lock(_mutex);
    _level.moveTo(steps);
    made->isNarrow = _level.hasNarrowIndices();
    const auto bytes =
        made->isNarrow ? std::as_bytes(_level.narrowIndices()) : std::as_bytes(_level.wideIndices());
    made->indices.assign(bytes.begin(), bytes.end());
    for (std::uint32_t group = 0; group < _level.groupCount(); ++group)
        made->groups.push_back(_level.rangeOf(group));
    return made;
}

} // namespace osgPMObjects
