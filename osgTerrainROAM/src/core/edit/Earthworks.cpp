// SPDX-License-Identifier: Apache-2.0
// Beds and the slopes beside them. Of several works near a place the beds count first; the slopes are
// intersected, so that a river that flows into a lake is not dammed by the lake's shore.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include <osgTerrainROAM/core/edit/Earthworks.h>
#include <osgTerrainROAM/core/edit/NearestPlane.h>

#include "OutlineRows.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kSquareM = 128.0; ///< of the grid in which works are found
constexpr std::size_t kPiece = 24; ///< segments of a line that are one piece
constexpr double kShoreRise = 0.1; ///< of a shore, metres a metre
constexpr double kCrestM = 1.0;    ///< of level ground on top of a shore
constexpr double kLeastSlope = 0.02;
constexpr double kFirmShare = 0.3; ///< of the reach of slopes, where they hold
constexpr double kGives = 0.3;     ///< of the reach, how soon they give way beyond

} // namespace

/// The parts of Earthworks::Works.
namespace works
{

/// The heights that ground beside a bed may have.
struct Limits
{
    double lowM = -1e300, highM = 1e300;
};

/// The bed that a place lies in.
struct Bed
{
    std::size_t work;
    double outM, heightM;
    int river = 0;
    double awayM = 0.0; ///< from the line of a river

    /// Whether this bed counts where `other` was found before.
    bool isBefore(const Bed& other) const
    {
        if (river > 0 && river == other.river) return awayM < other.awayM;
        if (river > 0 && other.river > 0) return heightM < other.heightM;
        return work != other.work || outM < other.outM;
    }
};

/// One piece of a work.
class Piece
{
public:
    Piece(const Earthwork& work, std::vector<glm::dvec2> line, std::vector<double> heightsM)
        : _work(work), _line(std::move(line)), _heightsM(std::move(heightsM))
    {
    }
    explicit Piece(const Earthwork& work) : _work(work), _line({glm::dvec2(0.0), glm::dvec2(1.0)})
    {
        _outline.emplace(work.paths);
        for (std::size_t path = 0; path < work.paths.size(); ++path)
            for (std::size_t i = 0; i < work.paths[path].size(); ++i)
                _plane.add(work.paths[path][i], work.heightsM[path][i]);
        _plane.fit();
    }

    /// How far out a place lies from the bed (0 or less: within), and the height of the bed's edge there.
    struct Beside
    {
        double outM, edgeM;
        double awayM = 0.0; ///< from a line
    };
    int river() const { return _work.river; }
    Beside beside(const glm::dvec2& place) const
    {
        if (_outline)
            return {_outline->contains(place) ? 0.0
                                              : _outline->distanceM(place, 2.0 * Earthworks::kFarthestM),
                    _plane.heightM(place)};
        const PlanLine::Foot foot = _line.footOf(place);
        const double halfM = 0.5 * _work.widthM;
        const double edgeM = heightAt(foot.alongM) - _work.crossfall * std::min(foot.distanceM, halfM) -
                             _work.stripFall * std::clamp(foot.distanceM - halfM, 0.0, _work.stripM);
        return {foot.distanceM - halfM - _work.stripM, edgeM, foot.distanceM};
    }

    /// `slopesM`: how far slopes reach. Towards there they give way, so that ground that is steeper than they
    /// are is met without a wall.
    Limits limits(const Beside& at, double flatM, double slopesM) const
    {
        const double outM = std::max(at.outM - flatM, 0.0), slope = std::max(_work.slope, kLeastSlope);
        const double shoreM = _work.riseM / kShoreRise + (_work.riseM > 0.0 ? kCrestM : 0.0);
        const double share = std::clamp((outM / slopesM - kFirmShare) / (1.0 - kFirmShare), 0.0, 1.0 - 1e-9);
        const double givesM = kGives * slopesM * share * share / (1.0 - share);
        return {at.edgeM + std::min(kShoreRise * outM, _work.riseM) - slope * std::max(outM - shoreM, 0.0) -
                    givesM,
                at.edgeM + slope * outM + givesM};
    }

    PlanBox boundsM() const
    {
        PlanBox box{glm::dvec2(1e300), glm::dvec2(-1e300)};
        const auto take = [&](const glm::dvec2& point) {
            box = {glm::min(box.low, point), glm::max(box.high, point)};
        };
        if (_outline)
            std::for_each(_work.paths.front().begin(), _work.paths.front().end(), take);
        else
            for (std::size_t i = 0; i < _line.size(); ++i)
                take(_line.at(_line.alongM(i)));
        return box;
    }

    /// How far slopes reach from the edge of the bed.
    double slopesM(const foundation::HeightInPlan& ground) const
    {
        double mostM = 0.0;
        const auto look = [&](const glm::dvec2& place)
        {
            if (const auto groundM = ground(place))
                mostM = std::max(mostM, std::abs(*groundM - beside(place).edgeM));
        };
        if (_outline)
            for (const auto& path : _work.paths)
                std::for_each(path.begin(), path.end(), look);
        else
            for (double at = 0.0; at <= _line.lengthM(); at += 10.0)
                look(_line.at(at));
        const double shoreM = _work.riseM / kShoreRise;
        return std::min(2.0 * (mostM + _work.riseM) / std::max(_work.slope, kLeastSlope) + 10.0 + shoreM,
                        Earthworks::kFarthestM);
    }

    /// From the outline or the middle of the line to the edge of the bed.
    double bedM() const { return _outline ? 0.0 : 0.5 * _work.widthM + _work.stripM; }

    std::vector<PlanBox> boxes(double reach, bool inside) const
    {
        if (!_outline) return _line.boxes(reach);
        if (inside) return {boundsM().grownBy(reach)};
        std::vector<PlanBox> made;
        for (auto path : _work.paths)
        {
            path.push_back(path.front());
            const auto along = PlanLine(std::move(path)).boxes(reach);
            made.insert(made.end(), along.begin(), along.end());
        }
        return made;
    }

private:
    double heightAt(double alongM) const
    {
        std::size_t i = 1;
        while (i + 1 < _line.size() && _line.alongM(i) < alongM)
            ++i;
        const double lengthM = _line.alongM(i) - _line.alongM(i - 1);
        const double share =
            lengthM > 0.0 ? std::clamp((alongM - _line.alongM(i - 1)) / lengthM, 0.0, 1.0) : 0.0;
        return std::lerp(_heightsM[i - 1], _heightsM[i], share);
    }

    Earthwork _work;
    PlanLine _line;
    std::vector<double> _heightsM;
    std::optional<OutlineRows> _outline;
    NearestPlane _plane;
};

} // namespace works

namespace
{

bool isWhole(const Earthwork& work)
{
    if (work.paths.empty() || work.paths.size() != work.heightsM.size()) return false;
    for (std::size_t i = 0; i < work.paths.size(); ++i)
        if (work.paths[i].size() < (work.isArea ? 3u : 2u) || work.paths[i].size() != work.heightsM[i].size())
            return false;
    return work.isArea || work.widthM > 0.0;
}

std::uint64_t squareAt(std::int64_t x, std::int64_t y)
{
    return (static_cast<std::uint64_t>(y) << 32U) ^ static_cast<std::uint32_t>(x);
}

} // namespace

using works::Bed;
using works::Limits;
using works::Piece;

struct Earthworks::Works
{
    std::vector<works::Piece> pieces; ///< in the order of the works
    std::vector<std::size_t> workOf;  ///< each piece's
    std::vector<double> slopesM;      ///< how far the slopes of each reach
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> squares;
    double flatM = 0.0;
    std::size_t count = 0; ///< of works

    void add(Piece piece, const foundation::HeightInPlan& ground)
    {
        const double slopes = piece.slopesM(ground);
        const PlanBox box = piece.boundsM().grownBy(slopes + flatM + piece.bedM());
        const auto number = static_cast<std::uint32_t>(pieces.size());
        const auto at = [](double m) { return static_cast<std::int64_t>(std::floor(m / kSquareM)); };
        for (std::int64_t y = at(box.low.y); y <= at(box.high.y); ++y)
            for (std::int64_t x = at(box.low.x); x <= at(box.high.x); ++x)
                squares[squareAt(x, y)].push_back(number);
        pieces.push_back(std::move(piece));
        workOf.push_back(count);
        slopesM.push_back(slopes);
    }

    void addLine(const Earthwork& work, const foundation::HeightInPlan& ground)
    {
        const auto& line = work.paths.front();
        const auto& heights = work.heightsM.front();
        for (std::size_t from = 0; from + 1 < line.size(); from += kPiece)
        {
            const auto first = static_cast<std::ptrdiff_t>(from);
            const auto last = static_cast<std::ptrdiff_t>(std::min(from + kPiece + 1, line.size()));
            add(Piece(work, {line.begin() + first, line.begin() + last},
                      {heights.begin() + first, heights.begin() + last}),
                ground);
        }
    }
};

Earthworks::Earthworks(const std::vector<Earthwork>& works, double flatM,
                       const foundation::HeightInPlan& ground)
    : _works(std::make_unique<Works>())
{
    _works->flatM = flatM;
    for (const Earthwork& work : works)
    {
        if (!isWhole(work)) continue;
        if (work.isArea)
            _works->add(Piece(work), ground);
        else
            _works->addLine(work, ground);
        ++_works->count;
    }
}

Earthworks::~Earthworks() = default;
Earthworks::Earthworks(Earthworks&&) noexcept = default;
Earthworks& Earthworks::operator=(Earthworks&&) noexcept = default;

std::optional<double> Earthworks::bedM(const glm::dvec2& place) const
{
    constexpr double kNowhereM = 1e9; // no slope reaches there
    const double height = heightM(place, kNowhereM), again = heightM(place, -kNowhereM);
    return height == again ? std::optional(height) : std::nullopt;
}

bool Earthworks::isEmpty() const
{
    return _works->pieces.empty();
}

double Earthworks::heightM(const glm::dvec2& place, double groundM) const
{
    const auto found =
        _works->squares.find(squareAt(static_cast<std::int64_t>(std::floor(place.x / kSquareM)),
                                      static_cast<std::int64_t>(std::floor(place.y / kSquareM))));
    if (found == _works->squares.end()) return groundM;
    std::optional<Bed> bed;
    Limits all;
    Limits nearest;
    double nearestM = 1e300;
    for (const std::uint32_t number : found->second)
    {
        const Piece& piece = _works->pieces[number];
        const Piece::Beside at = piece.beside(place);
        const Bed its{_works->workOf[number], at.outM, at.edgeM, piece.river(), at.awayM};
        if (at.outM <= _works->flatM && (!bed || its.isBefore(*bed))) bed = its;
        if (bed || at.outM - _works->flatM >= _works->slopesM[number]) continue;
        const Limits limits = piece.limits(at, _works->flatM, _works->slopesM[number]);
        all = {std::max(all.lowM, limits.lowM), std::min(all.highM, limits.highM)};
        if (at.outM >= nearestM) continue;
        nearest = limits;
        nearestM = at.outM;
    }
    if (bed) return bed->heightM;
    if (all.lowM > all.highM) all = nearest; // two works at different heights: the nearer one decides
    return std::clamp(groundM, all.lowM, all.highM);
}

std::vector<PlanBox> Earthworks::boxes(bool inside) const
{
    std::vector<PlanBox> made;
    for (std::size_t i = 0; i < _works->pieces.size(); ++i)
    {
        const Piece& piece = _works->pieces[i];
        const auto its = piece.boxes(_works->slopesM[i] + _works->flatM + piece.bedM(), inside);
        made.insert(made.end(), its.begin(), its.end());
    }
    return made;
}

} // namespace osgTerrainROAM::core
