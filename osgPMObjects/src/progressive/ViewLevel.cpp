// SPDX-License-Identifier: Apache-2.0
#include "ViewLevel.h"

#include <algorithm>

namespace osgPMObjects
{

namespace
{

std::span<const std::byte> bytesOf(const core::ProgressiveLevel& level)
{
    return level.hasNarrowIndices() ? std::as_bytes(level.narrowIndices())
                                    : std::as_bytes(level.wideIndices());
}

std::size_t indexBytesOf(const core::ProgressiveLevel& level)
{
    return level.hasNarrowIndices() ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
}

} // namespace

ViewLevel::ViewLevel(osg::ref_ptr<const ProgressiveShape> shape)
    : _shape(std::move(shape)), _level(_shape->progressive())
{
}

DrawnLevelPtr ViewLevel::at(std::uint32_t steps, unsigned int frame, std::optional<unsigned int> contextId)
{
    const std::lock_guard lock(_levelMutex);
    const bool moves = _serial == 0 || steps != _level.steps();
    if (moves) advance(steps);
    IndexPacketPtr packet = contextId ? packetFor(*contextId, frame) : nullptr;
    if (moves || packet != _drawn->packet) _drawn = drawnWith(std::move(packet));
    return _drawn;
}

void ViewLevel::advance(std::uint32_t steps)
{
    _level.moveTo(steps);
    ++_serial;
    _whole = nullptr;
    std::vector<core::SlotRange> changes;
    _level.takeChanges(changes);
    // At first everything has changed; whoever draws is given the whole then.
    _changed = _serial == 1 ? nullptr : packetOf(std::move(changes), false);
}

/// What a context needs that has what it was given; none once a frame has passed since, for then it has it.
IndexPacketPtr ViewLevel::packetFor(unsigned int contextId, unsigned int frame)
{
    Given& given = _given[contextId];
    if (given.serial != _serial)
    {
        const bool follows = given.serial != 0 && given.serial + 1 == _serial;
        given = {_serial, frame, follows ? _changed : wholeNow()};
    }
    else if (given.frame != frame)
        given.packet = nullptr;
    return given.packet;
}

IndexPacketPtr ViewLevel::packetOf(std::vector<core::SlotRange> ranges, bool isWhole) const
{
    const std::span<const std::byte> indices = bytesOf(_level);
    const std::size_t slotBytes = 3 * indexBytesOf(_level);
    const auto packet = std::make_shared<IndexPacket>();
    packet->serial = _serial;
    packet->isWhole = isWhole;
    packet->ranges = std::move(ranges);
    for (const core::SlotRange& range : packet->ranges)
    {
        const auto part = indices.subspan(range.first * slotBytes, range.count * slotBytes);
        packet->bytes.insert(packet->bytes.end(), part.begin(), part.end());
    }
    return packet;
}

IndexPacketPtr ViewLevel::wholeNow()
{
    if (!_whole) _whole = packetOf({{0, _shape->progressive().slotCount}}, true);
    return _whole;
}

DrawnLevelPtr ViewLevel::drawnWith(IndexPacketPtr packet) const
{
    const auto drawn = std::make_shared<DrawnLevel>();
    drawn->serial = _serial;
    drawn->packet = std::move(packet);
    drawn->steps = _level.steps();
    drawn->faces = _level.faceCount();
    for (std::uint32_t group = 0; group < _shape->groups().size(); ++group)
    {
        _level.appendRanges(group, drawn->ranges);
        drawn->groupEnds.push_back(static_cast<std::uint32_t>(drawn->ranges.size()));
    }
    return drawn;
}

GpuIndices& ViewLevel::gpuIndices(unsigned int contextId)
{
    const std::lock_guard lock(_gpuMutex);
    auto& slot = _gpu[contextId];
    if (!slot)
        slot = std::make_unique<GpuIndices>(contextId, _shape->progressive().slotCount, indexBytesOf(_level));
    return *slot;
}

/// The present state instead of one that the context cannot come to any more.
DrawnLevelPtr ViewLevel::repair(osg::State& state, GpuIndices& gpu)
{
    IndexPacketPtr whole;
    DrawnLevelPtr present;
    {
        const std::lock_guard lock(_levelMutex);
        if (gpu.serial() != _serial) whole = wholeNow();
        present = drawnWith(whole);
    }
    if (whole)
    {
        const std::size_t bytes = gpu.upload(state, *whole);
        const std::lock_guard lock(_gpuMutex);
        _bytesUploaded += bytes;
    }
    return present;
}

void ViewLevel::draw(osg::State& state, const DrawnLevel& drawn, std::uint32_t group)
{
    GpuIndices& gpu = gpuIndices(state.getContextID());
    if (gpu.serial() != drawn.serial)
    {
        if (!drawn.packet || !gpu.canTake(*drawn.packet))
            return gpu.draw(state, repair(state, gpu)->rangesOf(group));
        const std::size_t bytes = gpu.upload(state, *drawn.packet);
        const std::lock_guard lock(_gpuMutex);
        _bytesUploaded += bytes;
    }
    gpu.draw(state, drawn.rangesOf(group));
}

void ViewLevel::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_gpuMutex);
    for (auto& [contextId, gpu] : _gpu)
        if (!state || state->getContextID() == contextId) gpu->release();
}

void ViewLevel::addTo(ProgressiveViewStatistics& statistics) const
{
    {
        const std::lock_guard lock(_levelMutex);
        statistics.steps = _level.steps();
        statistics.triangles = _level.faceCount();
        statistics.played = _level.statistics();
    }
    const std::lock_guard lock(_gpuMutex);
    statistics.bytesUploaded = _bytesUploaded;
}

} // namespace osgPMObjects
