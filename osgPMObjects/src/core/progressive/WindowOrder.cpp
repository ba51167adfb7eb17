// SPDX-License-Identifier: Apache-2.0
#include "WindowOrder.h"

#include <algorithm>
#include <span>
#include <utility>

#include <osgPMObjects/core/order/TriangleOrders.h>
#include <osgPMObjects/core/order/VertexCacheCost.h>

#include "LaterOrder.h"

namespace osgPMObjects::core
{

namespace
{

/// The share of the faces that vanishes until the last level of which the cost counts: most of the time
/// between two orderings.
constexpr double kShareGone = 0.4;

/// The level that an order is made for, faces of finer levels being inserted. An order for the present level
/// is taken only if it costs less by this share: it leaves single faces behind, which later windows inherit.
constexpr std::size_t kLaterLevel = FutureLevels::kLevels / 2;
constexpr double kLeastGain = 0.01;

/// localityOrder() takes most of the time and is best on regular meshes only. A list of more faces than this
/// is tried on a piece first. After an order that costs more than the best by this share some windows go
/// without it, twice as many each time.
constexpr std::size_t kPieceFaces = 4096;
constexpr double kMostLoss = 0.03;
constexpr std::uint32_t kMostSkipped = 15, kFullSearchEvery = 8;

} // namespace

std::vector<std::uint32_t> WindowOrder::ordered(const std::vector<std::uint32_t>& faces)
{
    if (faces.size() < 2) return faces;
    _future.take(faces, kShareGone);
    _best = orderForLater();
    _least = _future.costOf(_best);
    consider(libraryOrder(_future.present(), _future.wedgeCount()));
    tryLocality();
    for (std::uint32_t& number : _best)
        number = faces[number];
    return std::move(_best);
}

/// Takes an order if it is better than the best; returns its cost over that of the best before.
double WindowOrder::consider(Numbers order)
{
    const std::uint64_t cost = _future.costOf(order);
    const double share = static_cast<double>(cost) / static_cast<double>(_least);
    if (share * (1.0 + kLeastGain) >= 1.0) return share;
    _least = cost;
    _best = std::move(order);
    return share;
}

void WindowOrder::tryLocality()
{
    if (_skipped < _toSkip)
    {
        ++_skipped;
        return;
    }
    const bool isPromising = _best.size() <= kPieceFaces || costOfPiece() < 1.0 + kMostLoss;
    const bool isGood =
        isPromising && consider(localityOrder(_future.present(), _future.wedgeCount(), _cacheSize,
                                              kFullSearchEvery)) < 1.0 + kMostLoss;
    _toSkip = isGood ? 0 : std::min(2 * _toSkip + 1, kMostSkipped);
    _skipped = 0;
}

/// Returns an order for the faces left at a later level, with the others inserted.
WindowOrder::Numbers WindowOrder::orderForLater()
{
    Numbers left;
    std::vector<Triangle> triangles;
    for (std::uint32_t face = 0; face < _future.present().size(); ++face)
        if (_future.isLive(kLaterLevel, face))
        {
            left.push_back(face);
            triangles.push_back(_future.triangle(kLaterLevel, face));
        }
    Numbers order = libraryOrder(triangles, _future.wedgeCount());
    for (std::uint32_t& number : order)
        number = left[number];
    return withTrianglesLeftOut(_future.present(), _future.wedgeCount(), order, _cacheSize);
}

/// Returns what localityOrder() costs on a piece of the best order, over what the piece costs as it is.
double WindowOrder::costOfPiece() const
{
    const std::size_t first = (_best.size() - kPieceFaces) / 2;
    std::vector<Triangle> piece;
    for (std::size_t i = first; i < first + kPieceFaces; ++i)
        piece.push_back(_future.present()[_best[i]]);
    const std::uint32_t wedges = _future.wedgeCount();
    const auto order = localityOrder(piece, wedges, _cacheSize, kFullSearchEvery);
    return static_cast<double>(fifoTransforms(inOrder(piece, order), wedges, _cacheSize)) /
           static_cast<double>(fifoTransforms(piece, wedges, _cacheSize));
}

} // namespace osgPMObjects::core
