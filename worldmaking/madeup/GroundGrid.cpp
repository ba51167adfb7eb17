// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/GroundGrid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <foundation/ForEachAtOnce.h>

namespace worldmaking
{

namespace
{

constexpr double kSeaShare = 0.01;
constexpr int kStripRows = 64; ///< asked by one thread in one go

} // namespace

GroundGrid::GroundGrid(const MapBox& box, double cellM, const HeightMaker& heights)
    : _box(box),
      _cellM(cellM),
      _columns(std::max(2, static_cast<int>((box.high.x - box.low.x) / cellM) + 1)),
      _rows(std::max(2, static_cast<int>((box.high.y - box.low.y) / cellM) + 1)),
      _heights(static_cast<std::size_t>(_columns) * static_cast<std::size_t>(_rows), 2.0F * kNoGround)
{
    std::atomic<std::size_t> known{0}, low{0};
    const auto strips = static_cast<std::size_t>((_rows + kStripRows - 1) / kStripRows);
    foundation::forEachAtOnce(strips,
                              [&](std::size_t strip)
                              {
                                  const foundation::HeightInPlan height = heights();
                                  const int first = static_cast<int>(strip) * kStripRows;
                                  std::size_t knownHere = 0, lowHere = 0;
                                  for (int row = first; row < std::min(first + kStripRows, _rows); ++row)
                                      for (int column = 0; column < _columns; ++column)
                                      {
                                          const auto heightM = height(placeOf(column, row));
                                          if (!heightM) continue;
                                          _heights[index(column, row)] = static_cast<float>(*heightM);
                                          ++knownHere;
                                          lowHere += *heightM <= 0.0 ? 1 : 0;
                                      }
                                  known += knownHere;
                                  low += lowHere;
                              });
    _hasSea = static_cast<double>(low) > kSeaShare * static_cast<double>(known);
}

std::optional<double> GroundGrid::heightM(const glm::dvec2& place) const
{
    const glm::dvec2 at = (place - _box.low) / _cellM;
    if (!(at.x >= 0.0 && at.y >= 0.0 && at.x <= _columns - 1 && at.y <= _rows - 1)) return std::nullopt;
    const int column = std::min(static_cast<int>(at.x), _columns - 2),
              row = std::min(static_cast<int>(at.y), _rows - 2);
    for (const int dy : {0, 1})
        for (const int dx : {0, 1})
            if (!hasGround(column + dx, row + dy)) return std::nullopt;
    const double u = at.x - column, v = at.y - row;
    return (heightAt(column, row) * (1.0 - u) + heightAt(column + 1, row) * u) * (1.0 - v) +
           (heightAt(column, row + 1) * (1.0 - u) + heightAt(column + 1, row + 1) * u) * v;
}

glm::dvec2 GroundGrid::gradient(const glm::dvec2& place) const
{
    const glm::dvec2 low = _box.low, high = _box.low + _cellM * glm::dvec2(_columns - 1, _rows - 1);
    const auto at = [&](double dx, double dy) { return glm::clamp(place + glm::dvec2(dx, dy), low, high); };
    const glm::dvec2 runM(at(_cellM, 0.0).x - at(-_cellM, 0.0).x, at(0.0, _cellM).y - at(0.0, -_cellM).y);
    const auto east = heightM(at(_cellM, 0.0)), west = heightM(at(-_cellM, 0.0)),
               north = heightM(at(0.0, _cellM)), south = heightM(at(0.0, -_cellM));
    if (!east || !west || !north || !south || runM.x <= 0.0 || runM.y <= 0.0) return glm::dvec2(0.0);
    return glm::dvec2(*east - *west, *north - *south) / runM;
}

bool GroundGrid::isLand(const glm::dvec2& place) const
{
    const auto height = heightM(place);
    return height && (!_hasSea || *height > kShoreM);
}

} // namespace worldmaking
