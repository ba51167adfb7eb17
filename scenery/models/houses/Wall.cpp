// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/houses/Wall.h"

#include <algorithm>

#include "scenery/models/mesh/Box.h"

namespace scenery::models
{

namespace
{

constexpr double kNear = 1e-6;

std::vector<double> columnsOf(const Wall& wall)
{
    std::vector<double> columns{0.0, wall.lengthM};
    for (const Opening& opening : wall.openings)
        columns.insert(columns.end(), {opening.from, opening.to});
    std::sort(columns.begin(), columns.end());
    columns.erase(
        std::unique(columns.begin(), columns.end(), [](double a, double b) { return b - a < kNear; }),
        columns.end());
    return columns;
}

bool isOpen(const Wall& wall, double atM, double heightM)
{
    return std::any_of(wall.openings.begin(), wall.openings.end(),
                       [&](const Opening& o)
                       { return atM > o.from && atM < o.to && heightM > o.bottom && heightM < o.top; });
}

Corner wallCorner(const Wall& wall, double atM, double heightM, float light, double behindM = 0.0)
{
    return {
        wall.place(atM, heightM, behindM),
        {static_cast<float>((atM + behindM) / kWallPictureM), static_cast<float>(heightM / kWallPictureM)},
        {},
        light};
}

/// Adds the sides of an opening. They have the rows and columns of the wall's face, so no T-junctions.
void addReveals(ModelBuilder& builder, const Wall& wall, const Opening& o, const std::vector<double>& columns)
{
    const auto at = [&](double atM, double heightM, bool isBehind)
    { return wallCorner(wall, atM, heightM, isBehind ? 0.55F : 0.85F, isBehind ? o.depthM : 0.0); };
    for (std::size_t r = 0; r + 1 < wall.rows.size(); ++r)
    {
        const double low = wall.rows[r];
        const double high = wall.rows[r + 1];
        if (low < o.bottom - kNear || high > o.top + kNear) continue;
        builder.quad(at(o.from, low, false), at(o.from, low, true), at(o.from, high, true),
                     at(o.from, high, false));
        builder.quad(at(o.to, low, true), at(o.to, low, false), at(o.to, high, false), at(o.to, high, true));
    }
    for (std::size_t c = 0; c + 1 < columns.size(); ++c)
    {
        const double left = columns[c];
        const double right = columns[c + 1];
        if (left < o.from - kNear || right > o.to + kNear) continue;
        builder.quad(at(left, o.bottom, false), at(right, o.bottom, false), at(right, o.bottom, true),
                     at(left, o.bottom, true));
        builder.quad(at(left, o.top, true), at(right, o.top, true), at(right, o.top, false),
                     at(left, o.top, false));
    }
}

} // namespace

glm::dvec3 Wall::place(double atM, double heightM, double behindM) const
{
    return start + along * atM - outward() * behindM + glm::dvec3(0.0, 0.0, heightM);
}

void addWallFace(ModelBuilder& builder, const Wall& wall)
{
    const std::vector<double> columns = columnsOf(wall);
    const auto lightAt = [&](std::size_t row) // walls are darker at the ground and the eaves
    { return row == 0 ? 0.80F : (row + 1 == wall.rows.size() && !wall.hasGable ? 0.66F : 1.0F); };
    for (std::size_t r = 0; r + 1 < wall.rows.size(); ++r)
        for (std::size_t c = 0; c + 1 < columns.size(); ++c)
        {
            const double left = columns[c], right = columns[c + 1];
            const double low = wall.rows[r], high = wall.rows[r + 1];
            if (isOpen(wall, 0.5 * (left + right), 0.5 * (low + high))) continue;
            builder.quad(wallCorner(wall, left, low, lightAt(r)), wallCorner(wall, right, low, lightAt(r)),
                         wallCorner(wall, right, high, lightAt(r + 1)),
                         wallCorner(wall, left, high, lightAt(r + 1)));
        }
    for (const Opening& opening : wall.openings)
        addReveals(builder, wall, opening, columns);
    if (!wall.hasGable) return;
    const Corner apex = wallCorner(wall, 0.5 * wall.lengthM, wall.rows.back() + wall.gableM, 0.75F);
    for (std::size_t c = 0; c + 1 < columns.size(); ++c)
        builder.triangle(wallCorner(wall, columns[c], wall.rows.back(), 1.0F),
                         wallCorner(wall, columns[c + 1], wall.rows.back(), 1.0F), apex);
}

bool isDoor(Detail detail)
{
    return detail == Detail::door || detail == Detail::glassDoor || detail == Detail::gate ||
           detail == Detail::barnDoor;
}

void addOpenings(ModelBuilder& builder, const Wall& wall, bool doors)
{
    const std::vector<double> columns = columnsOf(wall);
    for (const Opening& o : wall.openings)
    {
        if (isDoor(o.detail) != doors) continue;
        const CellUv uv = uvOf(o.detail);
        std::vector<std::vector<Corner>> pane; // has the rows and columns of the reveals
        for (const double heightM : wall.rows)
        {
            if (heightM < o.bottom - kNear || heightM > o.top + kNear) continue;
            const double up = (heightM - o.bottom) / (o.top - o.bottom);
            std::vector<Corner>& row = pane.emplace_back();
            for (const double atM : columns)
                if (atM > o.from - kNear && atM < o.to + kNear)
                    row.push_back(
                        {wall.place(atM, heightM, o.depthM),
                         uv.at(static_cast<float>((atM - o.from) / (o.to - o.from)), static_cast<float>(up)),
                         {},
                         static_cast<float>(1.0 - 0.15 * up)});
        }
        builder.grid(pane);
    }
}

void addSills(ModelBuilder& builder, const Wall& wall)
{
    constexpr double kProudM = 0.07;
    for (const Opening& o : wall.openings)
    {
        if (!o.hasSill) continue;
        const glm::dvec3 a = wall.place(o.from - 0.05, o.bottom - 0.08, -kProudM);
        const glm::dvec3 b = wall.place(o.to + 0.05, o.bottom + 0.012, o.depthM - 0.02);
        const CellUv uv = uvOf(Detail::stone);
        addBox(builder, {{std::min(a.x, b.x), std::min(a.y, b.y), a.z},
                         {std::max(a.x, b.x), std::max(a.y, b.y), b.z},
                         uv.at(0.0F, 0.4F),
                         uv.at(1.0F, 0.5F)});
    }
}

} // namespace scenery::models
