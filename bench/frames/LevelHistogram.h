// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>

namespace framebench
{

/// A histogram of differences of colour values. Units: levels of 255.
class LevelHistogram
{
public:
    /// Counts a difference by its magnitude, at most 510.
    void add(int levels)
    {
        ++_counts[static_cast<std::size_t>(std::abs(levels))];
        ++_total;
    }

    /// Returns the least number of levels that `share` of all values does not exceed; 0 without values.
    int percentile(double share) const
    {
        const double wanted = share * static_cast<double>(_total);
        std::uint64_t below = 0;
        for (std::size_t i = 0; i < _counts.size(); ++i)
        {
            below += _counts[i];
            if (below > 0 && static_cast<double>(below) >= wanted) return static_cast<int>(i);
        }
        return 0;
    }

    std::uint64_t total() const { return _total; }

    /// Returns the share of the values above `levels`; 0 without values.
    double shareAbove(int levels) const
    {
        std::uint64_t above = 0;
        for (std::size_t i = static_cast<std::size_t>(levels) + 1; i < _counts.size(); ++i)
            above += _counts[i];
        return _total > 0 ? static_cast<double>(above) / static_cast<double>(_total) : 0.0;
    }

private:
    std::array<std::uint64_t, 511> _counts{}; ///< two differences of 255 apart at most
    std::uint64_t _total = 0;
};

} // namespace framebench
