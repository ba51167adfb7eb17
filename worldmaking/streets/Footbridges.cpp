// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/Footbridges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <foundation/TagQuantity.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "scenery/buildings/Outline.h"
#include "scenery/structures/Footbridge.h"
#include "worldmaking/map/PlaceKey.h"
#include "worldmaking/plan/Waters.h"
#include "worldmaking/streets/FootLevels.h"
#include "worldmaking/streets/LaneLayout.h"
#include "worldmaking/streets/PathTags.h"
#include "worldmaking/streets/PlanPieces.h"

namespace worldmaking
{

namespace
{

constexpr double kFootStepM = 2.5;                           ///< between heights along a footbridge
constexpr double kOverWaterM = 0.9;                          ///< clear
constexpr std::array<double, 4> kRamps{0.1, 0.2, 0.35, 0.6}; ///< the last ones are stairs
constexpr double kStairGrade = 0.35;                         ///< as steep as this are stairs
constexpr double kStairsFall = 0.5;                          ///< of a way that the map says is stairs
constexpr double kTreadM = 0.17, kLowestTreadM = 0.1, kHighestTreadM = 0.25;
constexpr double kMostRampM = 90.0, kStraightRampM = 25.0, kOnGroundM = 0.05;
constexpr double kPierEveryM = 14.0, kPierSideM = 1.2;
constexpr double kTrackSideM = 2.5;
constexpr std::size_t kMostFootNotes = 10;

double footWidthOf(const Tags& tags)
{
    const double defaultM = isClosedStreet(tags) ? 4.0 : valueOf(tags, "highway") == "track" ? 3.0 : 2.5;
    const auto widthM = foundation::metresOfTag(valueOf(tags, "width"));
    return widthM && *widthM >= 0.8 && *widthM <= 15.0 ? *widthM : defaultM;
}

/// A line of paths in the plan.
struct FootLine
{
    std::vector<glm::dvec2> points;
    std::vector<PlaceKey> keys;   ///< of the points
    std::vector<WayLevel> levels; ///< of the stretches
    std::int64_t way = 0;
    double widthM = 2.5;
    bool isStairs = false;
    double stepCount = 0.0; ///< as the map says; 0: it does not

    double lengthM() const
    {
        double sumM = 0.0;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            sumM += glm::distance(points[i], points[i + 1]);
        return sumM;
    }
    /// Whether it passes over another somewhere.
    bool passesOver(const FootLine& other) const
    {
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            for (std::size_t j = 0; j + 1 < other.points.size(); ++j)
                if (aboveOf(levels[i], other.levels[j]) > 0 &&
                    crossingShares(points[i], points[i + 1], other.points[j], other.points[j + 1]))
                    return true;
        return false;
    }
    void reverse()
    {
        std::reverse(points.begin(), points.end());
        std::reverse(keys.begin(), keys.end());
        std::reverse(levels.begin(), levels.end());
    }
    /// Appends a line that begins where this one ends.
    void append(const FootLine& next)
    {
        points.insert(points.end(), next.points.begin() + 1, next.points.end());
        keys.insert(keys.end(), next.keys.begin() + 1, next.keys.end());
        levels.insert(levels.end(), next.levels.begin(), next.levels.end());
        widthM = std::max(widthM, next.widthM);
    }
};

/// A height that the surface must keep along a stretch about a place.
struct FootLimit
{
    double alongM = 0.0, halfM = 0.0, heightM = 0.0;
    bool takesPier = true; ///< what passes there has no room for a pier
};

/// What the surface keeps above, and what it keeps below.
struct FootLimits
{
    std::vector<FootLimit> least, most;
};

/// The course of a footbridge in pieces of 2.5 m at most.
struct DeckCourse
{
    explicit DeckCourse(const FootLine& line) : points{line.points.front()}
    {
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        {
            const double lengthM = glm::distance(line.points[i], line.points[i + 1]);
            if (lengthM < 1e-3)
            {
                nodes.push_back(points.size() - 1);
                continue;
            }
            const int steps = std::max(1, static_cast<int>(std::ceil(lengthM / kFootStepM)));
            const double startM = alongM.back();
            for (int step = 1; step <= steps; ++step)
            {
                const double share = static_cast<double>(step) / steps;
                points.push_back(glm::mix(line.points[i], line.points[i + 1], share));
                alongM.push_back(startM + share * lengthM);
            }
            nodes.push_back(points.size() - 1);
        }
    }

    /// The heights of a surface between two ends that keeps above limits, `grade` steep before and behind
    /// them.
    std::vector<double> surfaceM(const std::pair<double, double>& endsM, const std::vector<FootLimit>& least,
                                 double grade) const
    {
        std::vector<double> heightsM;
        for (const double s : alongM)
        {
            double heightM = std::lerp(endsM.first, endsM.second, s / alongM.back());
            for (const FootLimit& limit : least)
                heightM =
                    std::max(heightM, limit.heightM -
                                          grade * std::max(0.0, std::fabs(s - limit.alongM) - limit.halfM));
            heightsM.push_back(heightM);
        }
        return heightsM;
    }

    std::vector<glm::dvec2> points;
    std::vector<double> alongM{0.0};
    std::vector<std::size_t> nodes{0}; ///< the points of the line
};

/// A piece of a footbridge that is made: its surface at both ends.
struct MadeStretch
{
    glm::dvec3 from{0.0}, to{0.0};
    WayLevel level;
    double halfM = 1.25;
};

/// Joins lines of bridges that go on in each other: where two ends meet, and no third.
std::vector<FootLine> joinedLines(std::vector<FootLine> lines)
{
    std::map<PlaceKey, std::vector<std::size_t>> ends;
    for (std::size_t i = 0; i < lines.size(); ++i)
        ends[lines[i].keys.front()].push_back(i), ends[lines[i].keys.back()].push_back(i);
    std::vector<char> isTaken(lines.size(), 0);
    const auto nextOf = [&](std::size_t at, const PlaceKey& end) -> std::optional<std::size_t>
    {
        const auto& both = ends[end];
        if (both.size() != 2) return std::nullopt;
        const std::size_t other = both[0] == at ? both[1] : both[0];
        return isTaken[other] ? std::nullopt : std::optional(other);
    };
    std::vector<FootLine> joined;
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        if (isTaken[i]) continue;
        isTaken[i] = 1;
        FootLine line = lines[i];
        for (int way = 0; way < 2; ++way, line.reverse())
        {
            std::size_t last = i;
            while (const auto next = nextOf(last, line.keys.back()))
            {
                isTaken[*next] = 1;
                FootLine more = lines[*next];
                if (more.keys.front() != line.keys.back()) more.reverse();
                line.append(more);
                last = *next;
            }
        }
        joined.push_back(std::move(line));
    }
    std::stable_sort(joined.begin(), joined.end(),
                     [](const FootLine& a, const FootLine& b) { return a.lengthM() > b.lengthM(); });
    return joined;
}

class FootbridgeBuilder
{
public:
    explicit FootbridgeBuilder(const FootbridgeSources& from) : _from(from), _pieces(from.graph, from.places)
    {
        std::vector<FootLine> bridges;
        for (std::size_t i = 0; i < from.land.shapes.size(); ++i)
        {
            const LandShape& shape = from.land.shapes[i];
            const bool isFoot = shape.form == ShapeForm::line && isFootway(shape.tags);
            const bool isOther = isWater(shape) || !valueOf(shape.tags, "waterway").empty();
            auto paths = isFoot || isOther ? from.plane.toPlan(shape.paths) : std::nullopt;
            if (!paths || paths->front().size() < 2) continue;
            _grid.add(_others.size(), boxOf(paths->front()));
            _others.push_back({i, std::move(*paths)});
            if (!isFoot) continue;
            FootLine line;
            line.points = _others.back().second.front();
            for (const glm::dvec2& degrees : shape.paths.front())
                line.keys.push_back(placeKeyOf(degrees));
            line.levels.assign(line.points.size() - 1, levelOf(shape.tags));
            line.way = shape.id;
            line.widthM = footWidthOf(shape.tags);
            line.isStairs = valueOf(shape.tags, "highway") == "steps";
            line.stepCount = foundation::numberOfTag(valueOf(shape.tags, "step_count")).value_or(0.0);
            if (levelOf(shape.tags).place == StreetPlace::bridge)
                bridges.push_back(std::move(line));
            else if (levelOf(shape.tags).place == StreetPlace::ground)
                addPath(std::move(line));
        }
        buildAll(joinedLines(std::move(bridges)));
        if (_lacking > kMostFootNotes)
            made.notes.push_back(std::to_string(_lacking) + " footbridges have too little room in all");
    }

    Footbridges made;

private:
    void addPath(FootLine line)
    {
        _pathEnds[line.keys.front()].push_back(_paths.size());
        _pathEnds[line.keys.back()].push_back(_paths.size());
        _paths.push_back(std::move(line));
    }

    /// Builds bridges, the longest first, but each after those that it passes over.
    void buildAll(const std::vector<FootLine>& bridges)
    {
        PlanGrid grid;
        for (std::size_t i = 0; i < bridges.size(); ++i)
            grid.add(i, boxOf(bridges[i].points));
        std::vector<char> isBegun(bridges.size(), 0);
        const std::function<void(std::size_t)> visit = [&](std::size_t i)
        {
            if (isBegun[i] != 0) return;
            isBegun[i] = 1;
            grid.near(boxOf(bridges[i].points),
                      [&](std::size_t other)
                      {
                          if (other != i && bridges[i].passesOver(bridges[other])) visit(other);
                      });
            build(bridges[i]);
        };
        for (std::size_t i = 0; i < bridges.size(); ++i)
            visit(i);
    }

    /// The height at the end of a bridge: of the bridge that it joins, the street that it ends on, the
    /// ground.
    std::optional<double> endM(const PlaceKey& key, const glm::dvec2& place) const
    {
        if (const auto found = _decks.find(key); found != _decks.end()) return found->second;
        const auto groundM = _from.ground(place);
        if (!groundM) return std::nullopt;
        const auto streetM = _from.streetAt(place, StreetPlace::ground, *groundM);
        return streetM ? streetM : groundM;
    }

    void build(const FootLine& line)
    {
        const DeckCourse course(line);
        const auto& points = course.points;
        const auto startM = endM(line.keys.front(), points.front()),
                   lastM = endM(line.keys.back(), points.back());
        if (!startM || !lastM || points.size() < 2) return;
        FootLimits limits = limitsOf(line);
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            if (const auto groundM = _from.ground(points[i]))
                limits.least.push_back({course.alongM[i], 0.0, *groundM + kOnGroundM, false});
        std::vector<double> heightsM;
        std::array<std::optional<Footbridge>, 2> ramps;
        for (const double grade : kRamps)
        {
            heightsM = course.surfaceM({*startM, *lastM}, limits.least, grade);
            ramps = {rampFrom(line, false, heightsM.front(), *startM, grade),
                     rampFrom(line, true, heightsM.back(), *lastM, grade)};
            if (ramps[0] && ramps[1]) break;
        }
        for (const bool isEnd : {false, true})
            if (!ramps[isEnd ? 1 : 0])
                note(line, isEnd ? points.back() : points.front(),
                     "its end stands " +
                         metres(isEnd ? heightsM.back() - *lastM : heightsM.front() - *startM) +
                         " above the ground: there is no room for a ramp; give it stairs (highway=steps)");
        noteCrossings(line, course, heightsM, limits.most);
        keep(line, course, heightsM, piersOf(course.alongM.back(), limits.least));
        for (auto& ramp : ramps)
            if (ramp && !ramp->points.empty()) made.made.push_back(std::move(*ramp));
    }

    /// Notes what crosses above too low.
    void noteCrossings(const FootLine& line, const DeckCourse& course, const std::vector<double>& heightsM,
                       const std::vector<FootLimit>& most)
    {
        for (const FootLimit& limit : most)
            for (std::size_t i = 0; i < course.alongM.size(); ++i)
                if (std::fabs(course.alongM[i] - limit.alongM) < kFootStepM &&
                    heightsM[i] > limit.heightM + 0.4)
                {
                    note(line, course.points[i],
                         "passes too close under what crosses it: by " + metres(heightsM[i] - limit.heightM) +
                             "; give it a lower layer's course");
                    break;
                }
    }

    /// Adds a bridge to those that are made, which others join and pass over.
    void keep(const FootLine& line, const DeckCourse& course, const std::vector<double>& heightsM,
              std::vector<double> piersM)
    {
        const auto& points = course.points;
        const auto& nodes = course.nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            _decks.try_emplace(line.keys[i], heightsM[nodes[i]]);
        for (std::size_t i = 0, stretch = 0; i + 1 < points.size(); ++i)
        {
            while (stretch + 1 < line.levels.size() && nodes[stretch + 1] <= i)
                ++stretch;
            _madeGrid.add(_stretches.size(), boxOf({points[i], points[i + 1]}));
            _stretches.push_back({glm::dvec3(points[i], heightsM[i]),
                                  glm::dvec3(points[i + 1], heightsM[i + 1]), line.levels[stretch],
                                  0.5 * line.widthM});
        }
        Footbridge bridge{line.way, false, points, heightsM, line.widthM, {}};
        bridge.piersM = std::move(piersM);
        made.made.push_back(std::move(bridge));
    }

    double heightOf(std::size_t chain, double alongM) const
    {
        return _from.heights.profiles[chain].elevation.value(
            std::max(0.0, alongM - _from.cuts[chain].startM));
    }

    /// What the surface keeps from streets, railways, paths and water.
    FootLimits limitsOf(const FootLine& line) const
    {
        FootLimits limits;
        double startM = 0.0;
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        {
            const glm::dvec2 from = line.points[i], to = line.points[i + 1];
            const double lengthM = glm::distance(from, to);
            const auto take = [&](const PlanPiece& piece, const glm::dvec2& shares) {
                addWay(line.levels[i], piece, shares, {from, to}, startM, limits);
            };
            _pieces.crossing(from, to, take);
            const auto look = [&](std::size_t other) { addOther(line, i, other, startM, limits.least); };
            _grid.near({glm::min(from, to), glm::max(from, to)}, look);
            const auto lookAbove = [&](std::size_t below)
            { addMade(line, i, _stretches[below], startM, limits.least); };
            _madeGrid.near({glm::min(from, to), glm::max(from, to)}, lookAbove);
            startM += lengthM;
        }
        return limits;
    }

    void addWay(const WayLevel& level, const PlanPiece& piece, const glm::dvec2& shares,
                const std::pair<glm::dvec2, glm::dvec2>& stretch, double startM, FootLimits& limits) const
    {
        const StreetTraits& traits = _from.graph.traitsAt(_from.graph.chains[piece.chain], piece.piece);
        const int above = aboveOf(level, traits.level());
        if (above == 0 || (above > 0 && traits.place == StreetPlace::tunnel)) return;
        const auto& pointsM = _from.lines[piece.chain].pointsM();
        const double heightM =
            heightOf(piece.chain, std::lerp(pointsM[piece.piece], pointsM[piece.piece + 1], shares.x));
        const glm::dvec2 way = stretch.second - stretch.first;
        const double sine = std::max(0.3, sineBetween(piece.to - piece.from, way));
        const double halfM = (traits.isTrack ? kTrackSideM : layoutOf(traits).halfWidthM()) / sine;
        const double alongM = startM + shares.y * glm::length(way);
        if (above < 0)
        {
            limits.most.push_back({alongM, halfM, heightM - footbridgeBelowM(traits)});
            return;
        }
        limits.least.push_back({alongM, halfM, heightM + footbridgeAboveM(traits)});
    }

    /// Paths and water below.
    void addOther(const FootLine& line, std::size_t stretch, std::size_t other, double startM,
                  std::vector<FootLimit>& least) const
    {
        const auto& [number, paths] = _others[other];
        const LandShape& shape = _from.land.shapes[number];
        const glm::dvec2 from = line.points[stretch], to = line.points[stretch + 1];
        const double lengthM = glm::distance(from, to);
        const WayLevel level = levelOf(shape.tags);
        if (level.place == StreetPlace::tunnel) return;
        const auto add = [&](double share, double halfM, double clearM, bool takesPier)
        {
            if (const auto groundM = _from.ground(glm::mix(from, to, share)))
                least.push_back(
                    {startM + share * lengthM, halfM, *groundM + clearM + scenery::kFootDeckM, takesPier});
        };
        if (isWater(shape))
        {
            const int steps = std::max(1, static_cast<int>(std::ceil(lengthM / kFootStepM)));
            for (int step = 0; step < steps; ++step)
                if (scenery::isWithin(paths, glm::mix(from, to, (step + 0.5) / steps)))
                    add((step + 0.5) / steps, 0.5 * lengthM / steps, kOverWaterM, false);
            return;
        }
        if (shape.form != ShapeForm::line) return;
        const bool isPath = isFootway(shape.tags);
        if (isPath && (level.place == StreetPlace::bridge || aboveOf(line.levels[stretch], level) <= 0))
            return;
        const auto& path = paths.front();
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
        {
            const auto shares = crossingShares(from, to, path[i], path[i + 1]);
            if (!shares) continue;
            const glm::dvec2 at = glm::mix(from, to, shares->x);
            const bool isJoint =
                glm::distance(at, line.points.front()) < 0.1 || glm::distance(at, line.points.back()) < 0.1;
            if (!(isPath && isJoint))
                add(shares->x, isPath ? 1.5 : 1.0, isPath ? kWalkersClearM : kOverWaterM, isPath);
        }
    }

    /// A footbridge of a lower layer, which is made already.
    static void addMade(const FootLine& line, std::size_t stretch, const MadeStretch& below, double startM,
                        std::vector<FootLimit>& least)
    {
        const glm::dvec2 from = line.points[stretch], to = line.points[stretch + 1];
        const auto shares = crossingShares(from, to, glm::dvec2(below.from), glm::dvec2(below.to));
        if (!shares || aboveOf(line.levels[stretch], below.level) <= 0) return;
        const double heightM = glm::mix(below.from.z, below.to.z, shares->y);
        least.push_back({startM + shares->x * glm::distance(from, to), below.halfM,
                         heightM + kWalkersClearM + scenery::kFootDeckM});
    }

    /// A way down from an end of a bridge: empty where it needs none; nothing where there is no room.
    std::optional<Footbridge> rampFrom(const FootLine& line, bool isEnd, double heightM, double groundM,
                                       double grade) const
    {
        Footbridge ramp{line.way, true, {}, {}, line.widthM, {}};
        if (heightM - groundM <= 2.0 * kOnGroundM) return ramp;
        const PlaceKey& key = isEnd ? line.keys.back() : line.keys.front();
        if (_decks.contains(key)) return std::nullopt;
        const glm::dvec2 end = isEnd ? line.points.back() : line.points.front();
        std::vector<FootLine> courses;
        if (const auto found = _pathEnds.find(key); found != _pathEnds.end())
            for (const std::size_t path : found->second)
            {
                courses.push_back(_paths[path]);
                if (_paths[path].keys.front() != key) courses.back().reverse();
            }
        if (courses.empty())
        {
            const std::size_t count = line.points.size();
            const glm::dvec2 before = isEnd ? line.points[count - 2] : line.points[1];
            courses.emplace_back().points = {end, end + kStraightRampM * glm::normalize(end - before)};
        }
        for (const FootLine& course : courses)
        {
            ramp.points.clear(), ramp.heightsM.clear();
            const double fall = course.isStairs ? std::max(grade, kStairsFall) : grade;
            if (!leadDown(course.points, heightM, fall, ramp)) continue;
            if (course.isStairs || grade >= kStairGrade)
                ramp.treads = treadsOf(ramp.heightsM.front() - ramp.heightsM.back(), course.stepCount);
            return ramp;
        }
        return std::nullopt;
    }

    static int treadsOf(double fallM, double stepCount)
    {
        const double riseM = stepCount >= 2.0 ? fallM / stepCount : 0.0;
        const bool isGiven = riseM >= kLowestTreadM && riseM <= kHighestTreadM;
        return static_cast<int>(isGiven ? stepCount : std::max(1.0, std::round(fallM / kTreadM)));
    }

    bool leadDown(const std::vector<glm::dvec2>& course, double heightM, double grade, Footbridge& ramp) const
    {
        double alongM = 0.0;
        ramp.points.push_back(course.front());
        ramp.heightsM.push_back(heightM);
        for (std::size_t i = 0; i + 1 < course.size(); ++i)
        {
            const double lengthM = glm::distance(course[i], course[i + 1]);
            const int steps = std::max(1, static_cast<int>(std::ceil(lengthM / 1.0)));
            for (int step = 1; step <= steps; ++step)
            {
                const glm::dvec2 place =
                    glm::mix(course[i], course[i + 1], static_cast<double>(step) / steps);
                const double atM = alongM + lengthM * step / steps;
                const auto groundM = _from.ground(place);
                if (!groundM || atM > kMostRampM || _from.streetAt(place, StreetPlace::ground, *groundM))
                    return false;
                const double rampM = heightM - grade * atM;
                ramp.points.push_back(place);
                ramp.heightsM.push_back(std::max(rampM, *groundM + kOnGroundM));
                if (rampM <= *groundM + kOnGroundM) return true;
            }
            alongM += lengthM;
        }
        return false;
    }

    static std::vector<double> piersOf(double lengthM, const std::vector<FootLimit>& least)
    {
        std::vector<double> piersM;
        const auto isFree = [&](double s)
        {
            return std::none_of(least.begin(), least.end(),
                                [&](const FootLimit& limit) {
                                    return limit.takesPier &&
                                           std::fabs(s - limit.alongM) < limit.halfM + kPierSideM;
                                });
        };
        const int spans = static_cast<int>(std::ceil(lengthM / kPierEveryM));
        for (int i = 1; i < spans; ++i)
            for (double awayM = 0.0; awayM < 0.45 * kPierEveryM; awayM += 0.5)
            {
                const double s = lengthM * i / spans;
                const auto side = isFree(s + awayM)   ? std::optional(s + awayM)
                                  : isFree(s - awayM) ? std::optional(s - awayM)
                                                      : std::nullopt;
                if (!side) continue;
                piersM.push_back(*side);
                break;
            }
        return piersM;
    }

    static std::string metres(double value)
    {
        char text[32];
        std::snprintf(text, sizeof text, "%.1f m", value);
        return text;
    }

    void note(const FootLine& line, const glm::dvec2& place, const std::string& what)
    {
        if (++_lacking > kMostFootNotes) return;
        char at[64] = "a place off the map";
        if (const auto degrees = _from.plane.toDegrees(place))
            std::snprintf(at, sizeof at, "%.5f, %.5f", degrees->y, degrees->x);
        made.notes.push_back("footbridge (way " + std::to_string(line.way) + ") at " + at + ": " + what);
    }

    const FootbridgeSources& _from;
    PlanPieces _pieces;
    PlanGrid _grid;
    std::vector<std::pair<std::size_t, std::vector<std::vector<glm::dvec2>>>> _others; ///< paths and water
    std::vector<FootLine> _paths;
    std::map<PlaceKey, std::vector<std::size_t>> _pathEnds;
    std::map<PlaceKey, double> _decks;   ///< of bridges that are made
    std::vector<MadeStretch> _stretches; ///< likewise
    PlanGrid _madeGrid;                  ///< of them
    std::size_t _lacking = 0;
};

} // namespace

Footbridges footbridgesOf(const FootbridgeSources& from)
{
    FootbridgeBuilder builder(from);
    return std::move(builder.made);
}

} // namespace worldmaking
