// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <foundation/Result.h>

namespace osgPMObjects::core
{

/// The measured error that a tolerance bounds.
enum class ErrorKind : std::uint8_t
{
    maximum,        ///< the largest distance: the tolerance holds at every point
    rootMeanSquare, ///< the root of the mean squared distance: small and thin parts may be farther off
};

inline constexpr std::size_t kErrorKinds = 2;

/// The distance between a level and its original, measured by samples on both surfaces. Units: as the
/// positions.
struct MeasuredError
{
    float maximum = 0.0f;        ///< the largest distance of a sample from the other surface
    float rootMeanSquare = 0.0f; ///< over points spread by area; of the direction in which it is larger

    float of(ErrorKind kind) const { return kind == ErrorKind::maximum ? maximum : rootMeanSquare; }
    bool operator==(const MeasuredError&) const = default;
};

/// A level whose error is measured.
struct MeasuredLevel
{
    std::uint32_t steps = 0; ///< from the finest level
    MeasuredError error;
    bool operator==(const MeasuredLevel&) const = default;
};

/// Tells whether levels are a ladder: none, or the finest level and coarser ones in order, with finite
/// errors.
bool areMeasured(std::span<const MeasuredLevel> levels);

/// The settings of a ladder of measured levels. Invariant: checkSettings().
struct LadderSettings
{
    static constexpr double kMostRatio = 1.25;
    static constexpr std::uint32_t kLeastSamples = 100, kMostSamples = 10'000'000;

    /// The most triangles of a level divided by those of the next coarser one: above 1, at most kMostRatio. A
    /// single step that removes more is kept whole.
    double ratio = 1.125;
    /// The most points spread by area on each surface, besides all corners and centres of faces; a mesh with
    /// f faces gets 3000 + f.
    std::uint32_t samples = 10'000;
};

/// Tells whether levels can be measured by these settings: else an error that names the field and its range.
foundation::Outcome checkSettings(const LadderSettings& settings);

/// Returns the levels of a ladder in steps, from 0 to the last level with faces. `faces`: by level, never
/// growing.
std::vector<std::uint32_t> ladderSteps(std::span<const std::uint32_t> faces, double ratio);

/// The measured errors of a ladder of levels, for the selection of levels. A level between two measured ones
/// counts as the coarser of them. Measured errors may fall from a level to a coarser one, so the ladder also
/// keeps, for each level, the least error of all levels from there on.
/// Invariant: areMeasured(levels()). Memory: 20 B a measured level.
class ErrorLadder
{
public:
    ErrorLadder() = default;
    explicit ErrorLadder(std::vector<MeasuredLevel> levels); ///< areMeasured()

    bool isEmpty() const { return _levels.empty(); }
    const std::vector<MeasuredLevel>& levels() const { return _levels; }

    /// Returns the error of the first measured level with at least so many steps; infinity beyond the last
    /// one.
    /// Cost: logarithmic in the measured levels.
    float errorAfter(std::uint32_t steps, ErrorKind kind) const;

    /// Returns the most steps, at most `most`, whose error is at most `tolerance`; 0 if there are none. The
    /// ladder must not be empty. Cost: logarithmic, where `most` does not exclude the answer; else linear in
    /// the measured levels.
    std::uint32_t coarsestWithin(double tolerance, ErrorKind kind,
                                 std::uint32_t most = std::numeric_limits<std::uint32_t>::max()) const;

private:
    std::size_t levelOf(std::uint32_t steps) const; ///< the first with at least so many steps

    std::vector<MeasuredLevel> _levels;
    std::vector<std::array<float, kErrorKinds>> _least; ///< by level: of it and all coarser ones
};

} // namespace osgPMObjects::core
