// SPDX-License-Identifier: Apache-2.0
#include "WaterMask.h"

namespace osgTerrainROAM
{

namespace
{

constexpr std::uint8_t kWater = 255;
constexpr std::uint8_t kShore = 80;    ///< land next to water
constexpr std::uint8_t kFarShore = 24; ///< land one texel farther
constexpr double kLowerRimShare = 0.04;

/// Fills a connected area, with a stack of texels; visits each texel once.
class WaterSearch
{
public:
    WaterSearch(const MapField& heights, const MapGrid& grid, double seaLevelM, bool hasLakes)
        : _heights(heights),
          _width(grid.width),
          _height(grid.height),
          _seaLevel(static_cast<float>(seaLevelM) + 0.01f),
          _hasLakes(hasLakes),
          _visited(heights.size(), 0)
    {
    }

    std::vector<std::uint8_t> mask()
    {
        std::vector<std::uint8_t> result(_heights.size(), 0);
        for (std::size_t start = 0; start < _heights.size(); ++start)
        {
            if (_visited[start] || !startsWater(start)) continue;
            fill(start);
            const bool sea = isSea(start);
            const bool calm =
                sea || static_cast<double>(_lowerRim) <= kLowerRimShare * static_cast<double>(_rim);
            if (_component.size() < kLeastWaterSamples || !calm) continue;
            for (const std::size_t at : _component)
                result[at] = kWater;
        }
        return result;
    }

private:
    bool isSea(std::size_t at) const { return _heights[at] <= _seaLevel; }

    /// A lake's sample has an equal neighbour; this keeps rough land out of the fill.
    bool startsWater(std::size_t at) const
    {
        return isSea(at) || (_hasLakes && at + 1 < _heights.size() && _heights[at + 1] == _heights[at]);
    }

    bool joins(std::size_t from, std::size_t to) const
    {
        return isSea(from) ? isSea(to) : _heights[to] == _heights[from];
    }

    void fill(std::size_t start)
    {
        _component.assign(1, start);
        _visited[start] = 1;
        _rim = _lowerRim = 0;
        for (std::size_t next = 0; next < _component.size(); ++next)
        {
            const std::size_t at = _component[next];
            const int x = static_cast<int>(at % _width);
            const int y = static_cast<int>(at / _width);
            if (x > 0) look(at, at - 1);
            if (x + 1 < _width) look(at, at + 1);
            if (y > 0) look(at, at - _width);
            if (y + 1 < _height) look(at, at + _width);
        }
    }

    void look(std::size_t from, std::size_t to)
    {
        if (joins(from, to))
        {
            if (_visited[to]) return;
            _visited[to] = 1;
            _component.push_back(to);
            return;
        }
        ++_rim;
        if (_heights[to] < _heights[from]) ++_lowerRim;
    }

    const MapField& _heights;
    int _width, _height;
    float _seaLevel;
    bool _hasLakes;
    std::vector<std::uint8_t> _visited;
    std::vector<std::size_t> _component;
    std::size_t _rim = 0;
    std::size_t _lowerRim = 0;
};

/// Gives every texel that has a neighbour of at least `next` and is lower than `value` that value.
void grow(std::vector<std::uint8_t>& mask, const MapGrid& grid, std::uint8_t next, std::uint8_t value)
{
    const std::vector<std::uint8_t> before = mask;
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
        {
            const std::size_t at = static_cast<std::size_t>(y) * grid.width + x;
            if (before[at] >= value) continue;
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, grid.height - 1); ++j)
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, grid.width - 1); ++i)
                    if (before[static_cast<std::size_t>(j) * grid.width + i] >= next) mask[at] = value;
        }
}

} // namespace

std::vector<std::uint8_t> waterMask(const MapField& heights, const MapGrid& grid, double seaLevelM,
                                    bool hasLakes)
{
    std::vector<std::uint8_t> mask = WaterSearch(heights, grid, seaLevelM, hasLakes).mask();
    grow(mask, grid, kWater, kShore);
    grow(mask, grid, kShore, kFarShore);
    return mask;
}

} // namespace osgTerrainROAM
