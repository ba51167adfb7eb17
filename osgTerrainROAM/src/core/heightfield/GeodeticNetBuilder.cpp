// SPDX-License-Identifier: Apache-2.0
#include "GeodeticNetBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;

constexpr double kPlaceToleranceM = 0.0005;
constexpr double kGeoidToleranceM = 0.01;
constexpr int kCoarsestStep = 64;
constexpr int kMostNodesPerSide = 2049;

GeodeticNet netOfStep(const GeodeticLocator& locator, int side, int step)
{
    GeodeticNet net;
    net.step = step;
    net.nodesPerSide = (side - 1) / step + 1;
    std::vector<glm::dvec2> grid;
    for (int b = 0; b < net.nodesPerSide; ++b)
        for (int a = 0; a < net.nodesPerSide; ++a)
            grid.emplace_back(static_cast<double>(a) * step, static_cast<double>(b) * step);
    net.nodes.resize(grid.size());
    locator.locate(grid, net.nodes);
    return net;
}

/// The number of nodes along one axis that cells of 3 by 3 nodes with data in them use.
int nodesInUse(const GeodeticNet& net, int samples)
{
    const int macro = 2 * net.step;
    return std::min(net.nodesPerSide, 2 * ((samples - 2) / macro + 1) + 1);
}

/// Positions on the ellipsoid; not a number where the net is undefined.
std::vector<glm::dvec3> geocentric(const GeodeticNet& net)
{
    const auto& earth = GeographicLib::Geocentric::WGS84();
    std::vector<glm::dvec3> places;
    places.reserve(net.nodes.size());
    for (const GeodeticNet::Node& node : net.nodes)
    {
        glm::dvec3 p(std::numeric_limits<double>::quiet_NaN());
        if (std::isfinite(node.latitudeDeg + node.longitudeDeg + node.geoidM))
            earth.Forward(node.latitudeDeg, node.longitudeDeg, 0.0, p.x, p.y, p.z);
        places.push_back(p);
    }
    return places;
}

/// Tells whether the biquadratic through every other node of `fine` is within the tolerances at the nodes
/// between, over the part with data. False when a node in use is not defined.
bool everyOtherSuffices(const GeodeticNet& fine, int columns, int rows)
{
    // At quarters of a cell, in units of its three nodes.
    static constexpr double kWeights[5][3] = {
        {1.0, 0.0, 0.0}, {0.375, 0.75, -0.125}, {0.0, 1.0, 0.0}, {-0.125, 0.75, 0.375}, {0.0, 0.0, 1.0}};
    const std::vector<glm::dvec3> places = geocentric(fine);
    const auto place = [&](int a, int b)
    { return places[static_cast<std::size_t>(b) * fine.nodesPerSide + a]; };
    const int lastMacro = (fine.nodesPerSide - 1) / 4 - 1;
    for (int b = 0; b < nodesInUse(fine, rows); ++b)
        for (int a = 0; a < nodesInUse(fine, columns); ++a)
        {
            const int west = 4 * std::min(a / 4, lastMacro), south = 4 * std::min(b / 4, lastMacro);
            glm::dvec3 sum(0.0);
            double geoidM = 0.0;
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i)
                {
                    const double w = kWeights[a - west][i] * kWeights[b - south][j];
                    sum += w * place(west + 2 * i, south + 2 * j);
                    geoidM += w * fine.node(west + 2 * i, south + 2 * j).geoidM;
                }
            const bool suffices = glm::length(sum - place(a, b)) <= kPlaceToleranceM &&
                                  std::abs(geoidM - fine.node(a, b).geoidM) <= kGeoidToleranceM;
            if (!suffices) return false; // also when one of them is not a number
        }
    return true;
}

/// Fills undefined nodes that only padding uses with the nearest node that data use. Returns whether all
/// nodes that data use are defined.
bool completePadding(GeodeticNet& net, int columns, int rows)
{
    const int lastA = nodesInUse(net, columns) - 1, lastB = nodesInUse(net, rows) - 1;
    for (int b = 0; b < net.nodesPerSide; ++b)
        for (int a = 0; a < net.nodesPerSide; ++a)
        {
            GeodeticNet::Node& node = net.nodes[static_cast<std::size_t>(b) * net.nodesPerSide + a];
            if (std::isfinite(node.latitudeDeg + node.longitudeDeg + node.geoidM)) continue;
            if (a <= lastA && b <= lastB) return false;
            node = net.node(std::min(a, lastA), std::min(b, lastB));
        }
    return true;
}

/// Finds the coarsest net that is exact enough; the finest allowed one when none is.
GeodeticNet chooseNet(const GeodeticLocator& locator, int side, int columns, int rows)
{
    int step = std::min((side - 1) / 2, kCoarsestStep);
    step = std::max(step, (side - 1) / (kMostNodesPerSide - 1));
    GeodeticNet net = netOfStep(locator, side, step);
    while (net.step > 1 && (side - 1) / (net.step / 2) + 1 <= kMostNodesPerSide)
    {
        GeodeticNet finer = netOfStep(locator, side, net.step / 2);
        if (everyOtherSuffices(finer, columns, rows)) break;
        net = std::move(finer);
    }
    return net;
}

/// Mean distance between neighbouring samples along a line through the grid.
double meanSpacingM(const GeodeticLocator& locator, glm::dvec2 from, glm::dvec2 to)
{
    constexpr int kPieces = 16;
    std::vector<glm::dvec2> grid;
    for (int i = 0; i <= kPieces; ++i)
        grid.push_back(from + (to - from) * (static_cast<double>(i) / kPieces));
    std::vector<GeodeticNet::Node> nodes(grid.size());
    locator.locate(grid, nodes);
    double total = 0.0;
    for (int i = 0; i < kPieces; ++i)
    {
        double metres = 0.0;
        GeographicLib::Geodesic::WGS84().Inverse(nodes[i].latitudeDeg, nodes[i].longitudeDeg,
                                                 nodes[i + 1].latitudeDeg, nodes[i + 1].longitudeDeg, metres);
        total += metres;
    }
    return total / glm::length(to - from);
}

/// Tells whether columns, rows and the zenith form a right-handed system at the data's middle.
bool isRightHanded(const GeodeticLocator& locator, glm::dvec2 middle)
{
    GeodeticNet net;
    net.nodes.resize(3);
    locator.locate(
        std::vector<glm::dvec2>{middle, middle + glm::dvec2(1.0, 0.0), middle + glm::dvec2(0.0, 1.0)},
        net.nodes);
    const std::vector<glm::dvec3> p = geocentric(net);
    return glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[0]) > 0.0;
}

} // namespace

Outcome georeference(HeightField& field, const GeodeticLocator& locator)
{
    GeodeticNet net = chooseNet(locator, field.tileSide(), field.columns, field.rows);
    if (!completePadding(net, field.columns, field.rows))
        return Error{field.name, "reaches to where its map projection, or the geoid, is not defined",
                     "cut that part off with gdal_translate -projwin"};
    const glm::dvec2 last(field.columns - 1, field.rows - 1);
    if (!isRightHanded(locator, 0.5 * last))
        return Error{field.name, "is a mirrored grid", "reproject it with gdalwarp -t_srs EPSG:4326"};
    field.spacingEastM = meanSpacingM(locator, {0.0, 0.5 * last.y}, {last.x, 0.5 * last.y});
    field.spacingNorthM = meanSpacingM(locator, {0.5 * last.x, 0.0}, {0.5 * last.x, last.y});
    if (!(field.spacingEastM > 0.0) || !(field.spacingNorthM > 0.0))
        return Error{field.name, "has samples that lie on top of each other",
                     "check its georeference with gdalinfo"};
    field.net = std::move(net);
    return foundation::success();
}

} // namespace osgTerrainROAM::core
