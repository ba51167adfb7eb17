// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/Airfields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <foundation/TagQuantity.h>
#include <glm/glm.hpp>

#include <osgTerrainROAM/core/edit/NearestPlane.h>

#include "scenery/buildings/Outline.h"
#include "worldmaking/earth/RunwayProfile.h"
#include "worldmaking/plan/PlanGrid.h"

namespace worldmaking
{

namespace
{

using osgTerrainROAM::core::Earthwork;
using osgTerrainROAM::core::Earthworks;

constexpr double kStationM = 10.0;
constexpr double kEarthworkSlope = 1.0 / 3.0; ///< of cuttings and embankments
constexpr double kSameM = 250.0;              ///< between the middles of a runway in two sources
constexpr double kTaxiwayM = 15.0;            ///< wide, where the map does not say
constexpr double kTaxiwayPenalty =
    50.0; ///< of second differences of stations 10 m apart: humps of 50 m vanish
constexpr double kPinned = 1e6;
constexpr double kTaxiwayStripM = 8.0, kTaxiwayStripFall = 0.015;
constexpr double kApronSlope = 0.01; ///< 3.13.4

double metresOf(const Tags& tags, std::string_view key, double otherwise)
{
    const auto number = foundation::metresOfTag(valueOf(tags, key));
    return number && *number >= 3.0 && *number <= 200.0 ? *number : otherwise;
}

/// A line of a map as a runway; nothing where it has no length.
std::optional<Runway> runwayOf(const LandShape& shape, const MapPlane& plane)
{
    Runway runway;
    runway.designators = valueOf(shape.tags, "ref");
    runway.surface =
        valueOf(shape.tags, "surface").empty() ? "" : std::string(valueOf(shape.tags, "surface"));
    runway.widthM = metresOf(shape.tags, "width", 0.0);
    if (shape.form == ShapeForm::line)
    {
        runway.from = shape.paths.front().front();
        runway.to = shape.paths.front().back();
        return runway.from == runway.to ? std::nullopt : std::optional(runway);
    }
    const auto rings = plane.toPlan(shape.paths);
    if (!rings) return std::nullopt;
    const scenery::PlanRectangle box = scenery::rectangleAround(rings->front());
    if (box.halfLengthM < 5.0 * box.halfWidthM) return std::nullopt;
    const auto from = plane.toDegrees(box.middle - box.halfLengthM * box.along);
    const auto to = plane.toDegrees(box.middle + box.halfLengthM * box.along);
    if (!from || !to) return std::nullopt;
    runway.from = *from;
    runway.to = *to;
    runway.widthM = 2.0 * box.halfWidthM;
    return runway;
}

struct PlanStrip
{
    glm::dvec2 from{0.0}, to{0.0};
};

std::optional<PlanStrip> placed(const Runway& runway, const MapPlane& plane)
{
    const auto from = plane.toPlan(runway.from), to = plane.toPlan(runway.to);
    return from && to ? std::optional(PlanStrip{*from, *to}) : std::nullopt;
}

/// Tells whether two runways are one.
bool isSame(const PlanStrip& a, const PlanStrip& b)
{
    const glm::dvec2 alongA = a.to - a.from, alongB = b.to - b.from;
    const double across = std::abs(alongA.x * alongB.y - alongA.y * alongB.x);
    return glm::distance(0.5 * (a.from + a.to), 0.5 * (b.from + b.to)) < kSameM &&
           across < 0.17 * glm::length(alongA) * glm::length(alongB);
}

/// Fills in what a runway of the map does not say.
void complete(Runway& runway, const PlanStrip& its, const Runway* known, const PlanStrip* theirs)
{
    if (known)
    {
        const bool isTurned = glm::dot(its.to - its.from, theirs->to - theirs->from) < 0.0;
        if (isTurned && runway.designators.empty()) std::swap(runway.from, runway.to);
        runway.airport = known->airport;
        if (runway.designators.empty()) runway.designators = known->designators;
        if (runway.widthM <= 0.0) runway.widthM = known->widthM;
        if (runway.surface.empty()) runway.surface = known->surface;
    }
    const double lengthM = glm::distance(its.from, its.to);
    if (runway.surface.empty()) runway.surface = lengthM < 700.0 ? "grass" : "asphalt";
    if (runway.widthM <= 0.0) runway.widthM = lengthM < 1200.0 ? 23.0 : lengthM < 2000.0 ? 30.0 : 45.0;
}

/// Points of a polyline every `stepM`, both ends among them.
std::vector<glm::dvec2> stationsOf(const std::vector<glm::dvec2>& line, double stepM)
{
    double lengthM = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        lengthM += glm::distance(line[i], line[i + 1]);
    const auto count = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(lengthM / stepM)));
    std::vector<glm::dvec2> points;
    std::size_t segment = 0;
    double before = 0.0;
    for (std::size_t i = 0; i <= count; ++i)
    {
        const double at = lengthM * static_cast<double>(i) / static_cast<double>(count);
        while (segment + 2 < line.size() && at > before + glm::distance(line[segment], line[segment + 1]))
        {
            before += glm::distance(line[segment], line[segment + 1]);
            ++segment;
        }
        const double pieceM = glm::distance(line[segment], line[segment + 1]);
        points.push_back(glm::mix(line[segment], line[segment + 1],
                                  pieceM > 0.0 ? std::clamp((at - before) / pieceM, 0.0, 1.0) : 0.0));
    }
    return points;
}

/// Nothing: a point lies beyond the ground.
std::optional<std::vector<double>> heightsAt(const std::vector<glm::dvec2>& places,
                                             const foundation::HeightInPlan& ground)
{
    std::vector<double> heights;
    for (const glm::dvec2& place : places)
    {
        const auto height = ground(place);
        if (!height) return std::nullopt;
        heights.push_back(*height);
    }
    return heights;
}

Earthwork lineWork(std::vector<glm::dvec2> line, std::vector<double> heightsM, double widthM)
{
    Earthwork work;
    work.paths = {std::move(line)};
    work.heightsM = {std::move(heightsM)};
    work.widthM = widthM;
    work.slope = kEarthworkSlope;
    return work;
}

/// The mean of the ground over the width of a strip: one sample says little.
std::optional<double> across(const foundation::HeightInPlan& ground, const glm::dvec2& place,
                             const glm::dvec2& left)
{
    double sum = 0.0;
    for (const double outM : {-20.0, 0.0, 20.0})
    {
        const auto height = ground(place + outM * left);
        if (!height) return std::nullopt;
        sum += *height / 3.0;
    }
    return sum;
}

std::optional<Earthwork> runwayWork(const Runway& runway, const PlanStrip& strip,
                                    const foundation::HeightInPlan& ground, AirfieldReport& report)
{
    const glm::dvec2 along = glm::normalize(strip.to - strip.from), left(-along.y, along.x);
    const RunwayLimits limits = runwayLimits(glm::distance(strip.from, strip.to));
    auto points = stationsOf({strip.from, strip.to}, kStationM);
    const auto heights =
        heightsAt(points, [&](const glm::dvec2& place) { return across(ground, place, left); });
    if (!heights) return std::nullopt;
    const double stationM = glm::distance(points[0], points[1]);
    RunwayProfile profile = runwayProfile(*heights, stationM, limits);
    report.steepRunways += profile.isSteep;
    // The strip goes on beyond the ends as the runway ends, less by what the bed's half width adds there.
    const auto& h = profile.heightsM;
    const std::size_t last = h.size() - 1;
    const double first = (h[0] - h[1]) / stationM, second = (h[last] - h[last - 1]) / stationM;
    std::vector<glm::dvec2> line{strip.from - limits.stripEndM * along};
    std::vector<double> made{h[0] + limits.stripEndM * first};
    line.insert(line.end(), points.begin(), points.end());
    made.insert(made.end(), h.begin(), h.end());
    line.push_back(strip.to + limits.stripEndM * along);
    made.push_back(h[last] + limits.stripEndM * second);
    Earthwork work = lineWork(std::move(line), std::move(made), runway.widthM);
    work.crossfall = limits.crossfall;
    work.stripM = std::max(limits.stripHalfM - 0.5 * runway.widthM, 10.0);
    work.stripFall = limits.stripFall;
    return work;
}

/// Pinned where it lies on what has been levelled before.
std::optional<Earthwork> taxiwayWork(const std::vector<glm::dvec2>& line, double widthM,
                                     const foundation::HeightInPlan& shaped, const Earthworks& before)
{
    auto points = stationsOf(line, kStationM);
    const auto heights = heightsAt(points, shaped);
    if (!heights) return std::nullopt;
    std::vector<double> weights;
    for (const glm::dvec2& place : points)
        weights.push_back(before.bedM(place) ? kPinned : 1.0);
    Earthwork work = lineWork(points, smoothedHeights(*heights, weights, kTaxiwayPenalty), widthM);
    work.stripM = kTaxiwayStripM;
    work.stripFall = kTaxiwayStripFall;
    return work;
}

/// An apron: the plane of the ground, no steeper than kApronSlope.
std::optional<Earthwork> apronWork(const PlanRings& rings, const foundation::HeightInPlan& ground)
{
    osgTerrainROAM::core::NearestPlane plane;
    const MapBox box = boxOf(rings.front());
    const double stepM = std::max(5.0, glm::length(box.high - box.low) / 40.0);
    for (double north = box.low.y; north <= box.high.y; north += stepM)
        for (double east = box.low.x; east <= box.high.x; east += stepM)
            if (const glm::dvec2 place(east, north); scenery::isWithin(rings, place))
                if (const auto height = ground(place)) plane.add(place, *height);
    for (const glm::dvec2& corner : rings.front())
    {
        const auto height = ground(corner);
        if (!height) return std::nullopt;
        plane.add(corner, *height);
    }
    plane.fit();
    const glm::dvec2 middle = 0.5 * (box.low + box.high);
    const double middleM = plane.heightM(middle);
    glm::dvec2 slope(plane.heightM(middle + glm::dvec2(1, 0)) - middleM,
                     plane.heightM(middle + glm::dvec2(0, 1)) - middleM);
    slope *= std::min(1.0, kApronSlope / std::max(glm::length(slope), 1e-9));
    Earthwork work;
    work.isArea = true;
    work.slope = kEarthworkSlope;
    work.paths = rings;
    for (const auto& ring : rings)
    {
        work.heightsM.emplace_back();
        for (const glm::dvec2& corner : ring)
            work.heightsM.back().push_back(middleM + glm::dot(slope, corner - middle));
    }
    return work;
}

/// Calls `use(shape, paths in the plane)` for the shapes of an aeroway.
template<class Use>
void forShapes(const LandMap& map, const MapPlane& plane, ShapeForm form, std::string_view aeroway,
               const Use& use)
{
    for (const LandShape& shape : map.shapes)
        if (shape.form == form && valueOf(shape.tags, "aeroway") == aeroway)
            if (const auto paths = plane.toPlan(shape.paths)) use(shape, *paths);
}

} // namespace

std::vector<Runway> runwaysOf(const LandMap& map, const MapPlane& plane, std::span<const Runway> table)
{
    std::vector<Runway> runways;
    std::vector<PlanStrip> strips;
    std::vector<char> isTaken(table.size(), 0);
    const auto hasAlready = [&](const PlanStrip& strip)
    {
        return std::any_of(strips.begin(), strips.end(),
                           [&](const PlanStrip& other) { return isSame(strip, other); });
    };
    for (const ShapeForm form : {ShapeForm::line, ShapeForm::area})
        for (const LandShape& shape : map.shapes)
        {
            if (shape.form != form || valueOf(shape.tags, "aeroway") != "runway") continue;
            auto runway = runwayOf(shape, plane);
            const auto strip = runway ? placed(*runway, plane) : std::nullopt;
            if (!strip || glm::distance(strip->from, strip->to) < 100.0 || hasAlready(*strip)) continue;
            const Runway* known = nullptr;
            std::optional<PlanStrip> theirs;
            for (std::size_t i = 0; i < table.size() && !known; ++i)
                if (theirs = placed(table[i], plane); theirs && isSame(*strip, *theirs))
                {
                    known = &table[i];
                    isTaken[i] = 1;
                }
            complete(*runway, *strip, known, known ? &*theirs : nullptr);
            runways.push_back(*runway);
            strips.push_back(*strip);
        }
    for (std::size_t i = 0; i < table.size(); ++i)
        if (const auto strip = isTaken[i] ? std::nullopt : placed(table[i], plane);
            strip && !hasAlready(*strip))
        {
            runways.push_back(table[i]);
            strips.push_back(*strip);
        }
    return runways;
}

std::vector<Earthwork> airfieldWorks(const LandMap& map, std::span<const Runway> runways,
                                     const MapPlane& plane, const foundation::HeightInPlan& ground,
                                     AirfieldReport& report)
{
    std::vector<Earthwork> ofRunways;
    for (const Runway& runway : runways)
    {
        const auto strip = placed(runway, plane);
        auto work = strip ? runwayWork(runway, *strip, ground, report) : std::nullopt;
        ++(work ? report.runways : report.beyondGround);
        if (work) ofRunways.push_back(std::move(*work));
    }
    const auto shapedBy = [&](const Earthworks& earth) -> foundation::HeightInPlan
    {
        return [&](const glm::dvec2& place) -> std::optional<double>
        {
            const auto height = ground(place);
            return height ? std::optional(earth.heightM(place, *height)) : std::nullopt;
        };
    };
    const auto take = [&](std::optional<Earthwork> work, std::size_t& count, std::vector<Earthwork>& into)
    {
        ++(work ? count : report.beyondGround);
        if (work) into.push_back(std::move(*work));
    };
    const Earthworks runwaysOnly(ofRunways, 0.0, ground);
    std::vector<Earthwork> works;
    forShapes(map, plane, ShapeForm::area, "apron",
              [&](const LandShape&, const PlanRings& rings)
              { take(apronWork(rings, shapedBy(runwaysOnly)), report.aprons, works); });
    std::vector<Earthwork> before = works;
    before.insert(before.end(), ofRunways.begin(), ofRunways.end());
    const Earthworks levelled(before, 0.0, ground);
    forShapes(map, plane, ShapeForm::line, "taxiway",
              [&](const LandShape& shape, const PlanRings& paths)
              {
                  const double widthM = metresOf(shape.tags, "width", kTaxiwayM);
                  take(taxiwayWork(paths.front(), widthM, shapedBy(levelled), levelled), report.taxiways,
                       works);
              });
    std::move(ofRunways.begin(), ofRunways.end(), std::back_inserter(works));
    return works;
}

} // namespace worldmaking
