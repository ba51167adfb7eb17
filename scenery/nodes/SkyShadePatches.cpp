// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SkyShadePatches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenery
{

namespace
{

/// Adds corners in rows of one length, each joined with the row before.
class Rows
{
public:
    Rows(const foundation::HeightInPlan& ground, std::size_t columns, bool isRound)
        : _ground(ground), _columns(columns), _isRound(isRound)
    {
    }

    void add(const glm::dvec2& place, double hidden)
    {
        const auto heightM = _ground(place);
        _isKnown = _isKnown && heightM.has_value();
        _patch.corners.push_back({{place, heightM.value_or(0.0)}, static_cast<float>(hidden)});
    }

    SkyShadePatch finish()
    {
        if (!_isKnown) return {};
        const auto number = [&](std::size_t row, std::size_t column)
        { return static_cast<std::uint32_t>(row * _columns + column % _columns); };
        const std::size_t cells = _isRound ? _columns : _columns - 1;
        for (std::size_t row = 0; (row + 1) * _columns < _patch.corners.size(); ++row)
            for (std::size_t column = 0; column < cells; ++column)
                for (const std::uint32_t corner :
                     {number(row, column), number(row, column + 1), number(row + 1, column + 1),
                      number(row, column), number(row + 1, column + 1), number(row + 1, column)})
                    _patch.triangles.push_back(corner);
        return std::move(_patch);
    }

private:
    const foundation::HeightInPlan& _ground;
    std::size_t _columns;
    bool _isRound;
    bool _isKnown = true;
    SkyShadePatch _patch;
};

} // namespace

SkyShadePatch patchBelow(const SkyOccluder& occluder, const foundation::HeightInPlan& ground)
{
    constexpr int kTurns = 12;
    const double radiusM = std::sqrt(occluder.halfM.x * occluder.halfM.y);
    const double soft = std::clamp(occluder.heightM / radiusM, 0.15, 1.0);
    const glm::dvec2 side(-occluder.ahead.y, occluder.ahead.x);
    Rows rows(ground, kTurns, true);
    const double outer = 1.0 + 2.0 * soft;
    for (const double share : {0.0, 0.5, 0.8, 1.0, 1.0 + 0.4 * soft, 1.0 + soft, outer})
        for (int turn = 0; turn < kTurns; ++turn)
        {
            const double angle = 2.0 * std::numbers::pi * turn / kTurns;
            const glm::dvec2 on = share * glm::dvec2(std::cos(angle), std::sin(angle)) * occluder.halfM;
            const double hidden =
                share == outer ? 0.0
                               : occluder.opaque * hiddenByDisc(share * radiusM, radiusM, occluder.heightM);
            rows.add(occluder.place + on.x * occluder.ahead + on.y * side, hidden);
        }
    return rows.finish();
}

SkyShadePatch patchBefore(const SkyWall& wall, const foundation::HeightInPlan& ground)
{
    constexpr double kEndM = 2.0, kColumnM = 4.0;
    const double lengthM = glm::length(wall.to - wall.from);
    if (lengthM < 0.3) return {};
    const glm::dvec2 along = (wall.to - wall.from) / lengthM, out(along.y, -along.x);
    // At its ends a wall hides half of what it hides before its middle.
    std::vector<glm::dvec2> columns{{-kEndM, 0.0}, {0.0, 0.5}};
    const int inner = std::max(1, static_cast<int>((lengthM - 2.0 * kEndM) / kColumnM) + 1);
    const double most = std::min(1.0, 0.5 + lengthM / (4.0 * kEndM));
    for (int i = 0; i <= inner && lengthM > 2.0 * kEndM; ++i)
        columns.emplace_back(kEndM + (lengthM - 2.0 * kEndM) * i / inner, 1.0);
    if (lengthM <= 2.0 * kEndM) columns.emplace_back(0.5 * lengthM, most);
    columns.emplace_back(lengthM, 0.5);
    columns.emplace_back(lengthM + kEndM, 0.0);
    const double farM = std::clamp(wall.heightM, 1.5, 5.0);
    Rows rows(ground, columns.size(), false);
    for (const double awayM : {0.02, 0.1 * farM, 0.35 * farM, farM})
        for (const glm::dvec2& column : columns)
            rows.add(wall.from + column.x * along + awayM * out,
                     awayM == farM ? 0.0 : column.y * hiddenByWall(awayM, wall.heightM));
    return rows.finish();
}

} // namespace scenery
