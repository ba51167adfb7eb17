// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <osgPMObjects/core/simplify/CollapseSequence.h>
#include <osgPMObjects/core/simplify/LevelMeter.h>

namespace osgPMObjects::core
{

/// Finds coarse levels of a sequence whose measured largest distance from the original keeps a tolerance.
/// Estimates (LevelError) play no part. Each level is measured once. The mesh, the sequence and the meter (of
/// the same mesh) must outlive it. Threads: one at a time; measuring is parallel.
class ToleranceSearch
{
public:
    /// The share of a tolerance that a measured distance may reach; the rest covers what lies between
    /// samples.
    static constexpr double kShare = 0.98;

    ToleranceSearch(const Mesh& mesh, const CollapseSequence& sequence, const LevelMeter& meter);

    /// Returns the number of steps to the coarsest level of a ladder that keeps the tolerance (units of
    /// positions), or to a level that is still coarser and keeps it, too; 0 if no coarser level keeps it.
    /// Steps that belong together (`goesOn`) are not separated.
    /// Cost: LevelMeter::measure() for some 80 levels at the first call with a small tolerance, then for a
    /// few.
    std::size_t coarsestWithin(double tolerance);

private:
    double errorAfter(std::size_t steps) const;
    std::size_t wholeSteps(std::size_t steps) const;
    std::size_t refined(std::size_t keeps, std::size_t exceeds, double tolerance) const;

    const Mesh& _mesh;
    const CollapseSequence& _sequence;
    const LevelMeter& _meter;
    std::vector<std::uint32_t> _ladder;         ///< in steps
    std::vector<std::optional<double>> _errors; ///< by level of the ladder, once measured
};

} // namespace osgPMObjects::core
