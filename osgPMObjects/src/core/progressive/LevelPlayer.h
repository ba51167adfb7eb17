// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects::core
{

/// Plays steps forth and back on an index buffer; one implementation for each width of indices.
class ProgressiveLevel::Player
{
public:
    virtual ~Player() = default;

    virtual void moveTo(std::uint32_t steps) = 0;
    virtual void takeChanges(std::vector<SlotRange>& changes) = 0;
    virtual std::span<const std::uint16_t> narrowIndices() const = 0;
    virtual std::span<const std::uint32_t> wideIndices() const = 0;

    const ProgressiveMesh& progressive() const { return _progressive; }
    std::uint32_t steps() const { return _steps; }
    std::uint32_t faceCount() const { return _faces; }
    std::uint32_t wedgeCount() const { return _wedges; }
    const std::vector<std::uint32_t>& extents() const { return _extents; }
    const StepStatistics& statistics() const { return _statistics; }

protected:
    explicit Player(const ProgressiveMesh& progressive);

    const ProgressiveMesh& _progressive;
    std::uint32_t _steps, _faces = 0, _wedges;
    std::vector<std::uint32_t> _extents; ///< by block
    StepStatistics _statistics;
};

std::unique_ptr<ProgressiveLevel::Player> makeNarrowPlayer(const ProgressiveMesh& progressive);
std::unique_ptr<ProgressiveLevel::Player> makeWidePlayer(const ProgressiveMesh& progressive);

} // namespace osgPMObjects::core
