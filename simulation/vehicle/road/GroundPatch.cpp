// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/GroundPatch.h"

#include <algorithm>
#include <cmath>

#include <BulletCollision/CollisionShapes/btTriangleCallback.h>

namespace simulation
{

namespace
{

constexpr double kRoomM = 1.0;       ///< that a body may move before its patch is laid anew
constexpr double kLargeReachM = 4.0; ///< from which on cells are larger
constexpr double kFarM = 1e8;        ///< beyond it no body is computed

int cellOf(double metres, double cellM)
{
    return static_cast<int>(std::floor(std::clamp(metres, -kFarM, kFarM) / cellM));
}

} // namespace

void GroundPatches::lay(int body, const Ground& ground, const glm::dvec3& middle, double reachM)
{
    auto found =
        std::find_if(_patches.begin(), _patches.end(), [body](const Patch& p) { return p.body == body; });
    if (found == _patches.end())
        found = _patches.insert(_patches.end(), Patch{body, glm::dvec3(0.0), 0.5, 0, 0, 0, {}});
    Patch& patch = *found;
    if (!patch.ground.empty() && glm::length(middle - patch.middle) < kRoomM) return;
    reachM += kRoomM;
    patch.middle = middle;
    patch.cellM = reachM > kLargeReachM ? 1.0 : 0.5;
    patch.column = cellOf(middle.x - reachM, patch.cellM);
    patch.row = cellOf(middle.y - reachM, patch.cellM);
    patch.points = static_cast<int>(std::ceil(2.0 * reachM / patch.cellM)) + 2;
    std::vector<glm::dvec3> points;
    for (int row = 0; row < patch.points; ++row)
        for (int column = 0; column < patch.points; ++column)
            points.emplace_back((patch.column + column) * patch.cellM, (patch.row + row) * patch.cellM,
                                middle.z);
    patch.ground.resize(points.size());
    ground.heightsBelow(points, patch.ground);
}

void GroundPatches::lift(int body)
{
    std::erase_if(_patches, [body](const Patch& patch) { return patch.body == body; });
}

btVector3 GroundPatches::cornerOf(const Patch& patch, int column, int row) const
{
    const auto index = static_cast<std::size_t>(row * patch.points + column);
    return {(patch.column + column) * patch.cellM, (patch.row + row) * patch.cellM,
            patch.ground[index].heightM};
}

void GroundPatches::processAllTriangles(btTriangleCallback* callback, const btVector3& least,
                                        const btVector3& most) const
{
    const double middleX = 0.5 * (least.x() + most.x()), middleY = 0.5 * (least.y() + most.y());
    const auto patch = std::find_if(_patches.begin(), _patches.end(),
                                    [&](const Patch& p)
                                    {
                                        const int column = cellOf(middleX, p.cellM) - p.column;
                                        const int row = cellOf(middleY, p.cellM) - p.row;
                                        return column >= 0 && row >= 0 && column < p.points && row < p.points;
                                    });
    if (patch == _patches.end()) return;
    const auto range = [&](double from, double to, int first)
    {
        return std::pair(std::clamp(cellOf(from, patch->cellM) - first, 0, patch->points - 2),
                         std::clamp(cellOf(to, patch->cellM) - first, 0, patch->points - 2));
    };
    const auto [left, right] = range(least.x(), most.x(), patch->column);
    const auto [low, high] = range(least.y(), most.y(), patch->row);
    for (int row = low; row <= high; ++row)
        for (int column = left; column <= right; ++column)
        {
            const auto isKnown = [&](int c, int r)
            { return patch->ground[static_cast<std::size_t>(r * patch->points + c)].isKnown; };
            if (!isKnown(column, row) || !isKnown(column + 1, row) || !isKnown(column, row + 1) ||
                !isKnown(column + 1, row + 1))
                continue;
            btVector3 first[3] = {cornerOf(*patch, column, row), cornerOf(*patch, column + 1, row),
                                  cornerOf(*patch, column + 1, row + 1)};
            btVector3 second[3] = {first[0], first[2], cornerOf(*patch, column, row + 1)};
            const int triangle = (row * patch->points + column) * 2;
            callback->processTriangle(first, 0, triangle);
            callback->processTriangle(second, 0, triangle + 1);
        }
}

void GroundPatches::getAabb(const btTransform& /*transform*/, btVector3& least, btVector3& most) const
{
    least.setValue(-kFarM, -kFarM, -kFarM);
    most.setValue(kFarM, kFarM, kFarM);
}

} // namespace simulation
