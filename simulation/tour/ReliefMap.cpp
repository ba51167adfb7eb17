// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/ReliefMap.h"

#include <algorithm>
#include <cmath>

#include <foundation/Earth.h>

namespace simulation
{
namespace
{

constexpr int kCellsAlong = 160;
constexpr int kSamplesPerCell = 3;
constexpr int kWindow = 2; ///< cells to each side in which ruggedness is measured
constexpr double kHeightShare = 0.3;
constexpr double kProminenceShare = 0.7;
constexpr int kSurroundings = 10; ///< tenths of the longer side, to each side
constexpr double kSmallestReliefM = 1.0;

} // namespace

ReliefMap::ReliefMap(const TourTerrain& terrain)
    : _westM(terrain.westM),
      _southM(terrain.southM),
      _eastM(terrain.eastM),
      _northM(terrain.northM),
      _cellM(std::max(terrain.sampleSpacingM, std::max(terrain.widthM(), terrain.depthM()) / kCellsAlong)),
      _columns(std::max(1, static_cast<int>(terrain.widthM() / _cellM))),
      _rows(std::max(1, static_cast<int>(terrain.depthM() / _cellM)))
{
    sampleHeights(terrain);
    rateRuggedness();
    rateProminence();
    blur();
    dropFilled();
}

glm::dvec2 ReliefMap::centre(int column, int row) const
{
    return {_westM + (column + 0.5) * (_eastM - _westM) / _columns,
            _southM + (row + 0.5) * (_northM - _southM) / _rows};
}

bool ReliefMap::contains(double eastM, double northM) const
{
    return eastM >= _westM && eastM <= _eastM && northM >= _southM && northM <= _northM;
}

std::size_t ReliefMap::indexAt(double eastM, double northM) const
{
    const int column = static_cast<int>((eastM - _westM) / (_eastM - _westM) * _columns);
    const int row = static_cast<int>((northM - _southM) / (_northM - _southM) * _rows);
    return index(std::min(column, _columns - 1), std::min(row, _rows - 1));
}

double ReliefMap::interestAt(double eastM, double northM) const
{
    return contains(eastM, northM) ? _interest[indexAt(eastM, northM)] : 0.0;
}

double ReliefMap::measuredAt(double eastM, double northM) const
{
    return contains(eastM, northM) ? _measured[indexAt(eastM, northM)] : 0.0;
}

void ReliefMap::sampleHeights(const TourTerrain& terrain)
{
    _heights.resize(static_cast<std::size_t>(_columns) * static_cast<std::size_t>(_rows));
    _lows.resize(_heights.size());
    _measured.resize(_heights.size());
    for (int row = 0; row < _rows; ++row)
        for (int column = 0; column < _columns; ++column)
        {
            double high = -1e300;
            double low = 1e300;
            int measured = 0;
            for (int k = 0; k < kSamplesPerCell * kSamplesPerCell; ++k)
            {
                const int across = k % kSamplesPerCell;
                const int up = k / kSamplesPerCell;
                const glm::dvec2 offset((across + 0.5) / kSamplesPerCell - 0.5,
                                        (up + 0.5) / kSamplesPerCell - 0.5);
                const glm::dvec2 place = centre(column, row) + offset * _cellM;
                const double bend =
                    terrain.origin ? glm::dot(place, place) / (2.0 * foundation::kEarthRadiusM) : 0.0;
                const double height = terrain.heightM(place.x, place.y) + bend;
                _isFinite = _isFinite && std::isfinite(height);
                high = std::max(high, height);
                low = std::min(low, height);
                measured += !terrain.isMeasured || terrain.isMeasured(place.x, place.y) ? 1 : 0;
            }
            _heights[index(column, row)] = high;
            _lows[index(column, row)] = low;
            _measured[index(column, row)] =
                static_cast<double>(measured) / (kSamplesPerCell * kSamplesPerCell);
        }
}

void ReliefMap::rateRuggedness()
{
    std::vector<double> sorted = _heights;
    std::sort(sorted.begin(), sorted.end());
    const double lowest = sorted[sorted.size() / 20];
    const double highest = sorted[sorted.size() - 1 - sorted.size() / 200];
    _reliefM = std::max(kSmallestReliefM, highest - lowest);
    std::vector<double> ruggedness(_heights.size());
    for (int row = 0; row < _rows; ++row)
        for (int column = 0; column < _columns; ++column)
        {
            double high = -1e300;
            double low = 1e300;
            for (int r = std::max(0, row - kWindow); r <= std::min(_rows - 1, row + kWindow); ++r)
                for (int c = std::max(0, column - kWindow); c <= std::min(_columns - 1, column + kWindow);
                     ++c)
                {
                    high = std::max(high, _heights[index(c, r)]);
                    low = std::min(low, _lows[index(c, r)]);
                }
            ruggedness[index(column, row)] = high - low;
        }
    sorted = ruggedness;
    std::sort(sorted.begin(), sorted.end());
    const double mostRugged = std::max(kSmallestReliefM, sorted[sorted.size() - 1 - sorted.size() / 200]);
    _interest.resize(_heights.size());
    for (std::size_t i = 0; i < _interest.size(); ++i)
        _interest[i] = std::clamp(ruggedness[i] / mostRugged, 0.0, 1.0) +
                       kHeightShare * std::clamp((_heights[i] - lowest) / _reliefM, 0.0, 1.0);
}

/// Against the mean of the surroundings, from a table of sums.
void ReliefMap::rateProminence()
{
    std::vector<double> sums(static_cast<std::size_t>(_columns + 1) * static_cast<std::size_t>(_rows + 1),
                             0.0);
    const auto sum = [&](int column, int row) -> double&
    {
        return sums[static_cast<std::size_t>(row) * static_cast<std::size_t>(_columns + 1) +
                    static_cast<std::size_t>(column)];
    };
    for (int row = 0; row < _rows; ++row)
        for (int column = 0; column < _columns; ++column)
            sum(column + 1, row + 1) =
                _heights[index(column, row)] + sum(column, row + 1) + sum(column + 1, row) - sum(column, row);
    const int reach = std::max(1, std::max(_columns, _rows) / kSurroundings);
    _prominence.resize(_heights.size());
    for (int row = 0; row < _rows; ++row)
        for (int column = 0; column < _columns; ++column)
        {
            const int west = std::max(0, column - reach);
            const int east = std::min(_columns, column + reach + 1);
            const int south = std::max(0, row - reach);
            const int north = std::min(_rows, row + reach + 1);
            const double mean = (sum(east, north) - sum(west, north) - sum(east, south) + sum(west, south)) /
                                ((east - west) * (north - south));
            const double share = std::clamp((_heights[index(column, row)] - mean) / _reliefM, 0.0, 1.0);
            _prominence[index(column, row)] = share;
            _interest[index(column, row)] += kProminenceShare * share;
        }
}

/// Mean over three by three cells, so that one odd sample is no highlight.
void ReliefMap::blur()
{
    const std::vector<double> sharp = _interest;
    for (int row = 0; row < _rows; ++row)
        for (int column = 0; column < _columns; ++column)
        {
            double sum = 0.0;
            int count = 0;
            for (int r = std::max(0, row - 1); r <= std::min(_rows - 1, row + 1); ++r)
                for (int c = std::max(0, column - 1); c <= std::min(_columns - 1, column + 1); ++c, ++count)
                    sum += sharp[index(c, r)];
            _interest[index(column, row)] = sum / count;
        }
}

/// Takes interest and prominence from ground that was not measured: the fill of a void is no landmark.
void ReliefMap::dropFilled()
{
    for (std::size_t i = 0; i < _measured.size(); ++i)
    {
        _interest[i] *= _measured[i];
        _prominence[i] *= _measured[i];
    }
}

} // namespace simulation
