// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>
#include <osgPMObjects/core/simplify/ErrorLadder.h>

namespace osgPMObjects::core
{

/// Measures the errors of levels of detail against one original, in both directions. Only the meshes are
/// read, whatever made the levels. The original must not change. Deterministic: the same for any number of
/// threads. Threads: measure() from any number at once; each call is parallel. Cost: some 20 ms a level of an
/// original of 20 000 triangles.
/// Source: Cignoni, Rocchini and Scopigno, *Metro: measuring error on simplified surfaces* (1998). Differs:
/// samples also at all corners and centres of faces; both directions count.
class LevelMeter
{
public:
    /// `samples`: as LadderSettings::samples. `speckSize`: connected parts of the original whose box has at
    /// most this diagonal are *specks*: they may vanish without an error. 0: everything counts. Units: as the
    /// positions.
    explicit LevelMeter(const Mesh& original, std::size_t samples = LadderSettings{}.samples,
                        double speckSize = 0.0);
    ~LevelMeter();

    /// Returns the errors of a level; they are infinite if only one of the two has a surface.
    MeasuredError measure(const Mesh& level) const;

    /// Returns the number of specks of which some corner is farther than `distance` from the level.
    std::uint32_t countVanished(const Mesh& level, double distance) const;

private:
    class Specks;

    std::size_t _samples;
    MeasuredSurface _original;
    std::unique_ptr<Specks> _specks; ///< null: everything counts
};

} // namespace osgPMObjects::core
