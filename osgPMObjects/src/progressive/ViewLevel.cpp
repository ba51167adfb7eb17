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
    : _shape(shape), _level(_shape->progressive())
{
}

DrawnLevelPtr ViewLevel::at(std::uint32_t steps, unsigned int frame, std::optional<unsigned int> contextId)
{
    const std::lock_guard lock(_levelMutex);
    const bool moves = advance(steps, frame);
    IndexPacketPtr packet = contextId ? packetFor(*contextId, frame) : nullptr;
    if (moves || packet != _drawn->packet) _drawn = drawnWith(std::move(packet));
    return _drawn;
}

bool ViewLevel::isFar(std::uint32_t steps) const
{
    const std::uint32_t here = _level.steps();
    return _shape->jumps() &&
           std::max(steps, here) - std::min(steps, here) > ShapeJumps::shortest(_shape->progressive());
}

/// Makes the level; returns whether another one is shown from now on.
bool ViewLevel::advance(std::uint32_t steps, unsigned int frame)
{
    if (_jumped) followJump(steps, frame);
    const bool isThere = _serial != 0 && steps == this->steps();
    const bool far = isFar(steps);
    if (isThere && (far || !_jumped)) return false;
    ++_serial;
    _whole = _changed = nullptr;
    if (!far)
        playTo(steps);
    else
    {
        _jumped = _shape->jumps()->to(steps);
        _jumpFrame = frame;
        ++_jumps;
    }
    return true;
}

/// Applies, once a frame, as many steps as take as long as a pass; advance() then applies the rest, if it is
/// no more than that.
void ViewLevel::followJump(std::uint32_t steps, unsigned int frame)
{
    if (frame == _jumpFrame || !isFar(steps)) return;
    _jumpFrame = frame;
    const std::uint32_t here = _level.steps(), most = ShapeJumps::shortest(_shape->progressive());
    _level.moveTo(here < steps ? here + most : here - most);
}

void ViewLevel::playTo(std::uint32_t steps)
{
    // At first, and after a pass, everything has changed; contexts are then given the whole buffer.
    const bool follows = _serial > 1 && !_jumped;
    _jumped = nullptr;
    _level.moveTo(steps);
    std::vector<core::SlotRange> changes;
    _level.takeChanges(changes);
    if (follows) _changed = packetOf(std::move(changes), false);
}

/// Returns what takes a context from what it was given to the present state; null once a frame has passed
/// since, as it has that by then.
IndexPacketPtr ViewLevel::packetFor(unsigned int contextId, unsigned int frame)
{
    Given& given = _given[contextId];
    if (given.serial != _serial)
    {
        const bool follows = _changed && given.serial != 0 && given.serial + 1 == _serial;
        given = {_serial, frame, follows ? _changed : wholeNow()};
    }
    else if (given.frame != frame)
        given.packet = nullptr;
    return given.packet;
}

IndexPacketPtr ViewLevel::packetOf(std::vector<core::SlotRange> ranges, bool isWhole) const
{
    const std::span<const std::byte> indices = _jumped ? std::span(_jumped->indices) : bytesOf(_level);
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
    const std::uint32_t slots = _jumped ? _jumped->triangleCount() : _shape->progressive().slotCount;
    if (!_whole) _whole = packetOf({{0, slots}}, true);
    return _whole;
}

DrawnLevelPtr ViewLevel::drawnWith(IndexPacketPtr packet) const
{
    const auto drawn = std::make_shared<DrawnLevel>();
    drawn->serial = _serial;
    drawn->packet = std::move(packet);
    drawn->steps = steps();
    drawn->faces = faceCount();
    for (std::uint32_t group = 0; group < _shape->groups().size(); ++group)
    {
        appendRanges(group, drawn->ranges);
        drawn->groupEnds.push_back(static_cast<std::uint32_t>(drawn->ranges.size()));
    }
    return drawn;
}

void ViewLevel::appendRanges(std::uint32_t group, std::vector<core::SlotRange>& ranges) const
{
    if (!_jumped)
        _level.appendRanges(group, ranges);
    else if (_jumped->groups[group].count > 0)
        ranges.push_back(_jumped->groups[group]);
}

GpuIndices& ViewLevel::gpuIndices(unsigned int contextId)
{
    const std::lock_guard lock(_gpuMutex);
    auto& slot = _gpu[contextId];
    if (!slot)
        slot = std::make_unique<GpuIndices>(contextId, _shape->progressive().slotCount, indexBytesOf(_level));
    return *slot;
}

/// Returns the present state, for a context that can no longer reach the state it was to draw.
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
        statistics.steps = steps();
        statistics.triangles = faceCount();
        statistics.jumps = _jumps;
        statistics.played = _level.statistics();
    }
    const std::lock_guard lock(_gpuMutex);
    statistics.bytesUploaded = _bytesUploaded;
}

} // namespace osgPMObjects
