// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "compare/terrain/methods/JudgedFigures.h"
#include "compare/terrain/methods/LightChange.h"
#include "compare/terrain/methods/Verdicts.h"

namespace terraintool
{

namespace
{

using Figure = std::optional<double> (*)(const MethodFigures&, const DemComparison&);

/// A property that figures can tell. Advantages of one method are drawbacks of another.
struct Property
{
    const char* name;
    const char* unit; ///< of the figure
    HeldRange has;    ///< where a method has the property
    HeldRange lacks;  ///< where it does not
    Figure of;
};

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

HeldRange upTo(double most)
{
    return {-kNoLimit, most};
}

HeldRange beyond(double limit)
{
    return {std::nextafter(limit, kNoLimit), kNoLimit};
}

Property atMost(const char* name, const char* unit, double limit, Figure of)
{
    return {name, unit, upTo(limit), beyond(limit), of};
}

Property moreThan(const char* name, const char* unit, double limit, Figure of)
{
    return {name, unit, beyond(limit), upTo(limit), of};
}

double fewestTrianglesOf(const DemComparison& dem)
{
    double fewest = kNoLimit;
    for (const MethodFigures& m : dem.methods)
        fewest = std::min(fewest, m.triangles);
    return fewest;
}

std::optional<double> spikePerLevel(const MethodFigures& m, const DemComparison&)
{
    return m.spikeTriangles ? std::optional(*m.spikeTriangles / std::log2(m.sideSamples)) : std::nullopt;
}

std::optional<double> ceilingMissed(const MethodFigures& m, const DemComparison&)
{
    if (!m.ceiling) return std::nullopt;
    const double above = std::max(m.ceiling->ceiling / m.ceiling->asked - 1.0, 0.0);
    return 100.0 * std::max(above, 1.0 - m.ceiling->leastShare) + (m.ceiling->framesAbove > 0 ? 100.0 : 0.0);
}

std::optional<double> toRoam(double MethodFigures::*figure, const MethodFigures& m, const DemComparison& dem)
{
    const MethodFigures* roam = dem.of("roam");
    return roam && roam->*figure > 0.0 ? std::optional(m.*figure / (roam->*figure)) : std::nullopt;
}

const Property kDetailVaries =
    moreThan("different detail in different places", " between areas of triangles", 1.0,
             [](const MethodFigures& m, const DemComparison&) { return std::optional(m.areaRatio); });
const Property kSteady = atMost("steady time of a frame", " times the median at the 99th percentile", 4.0,
                                [](const MethodFigures& m, const DemComparison&)
                                { return std::optional(m.adaptUsP99 / m.adaptUsP50); });
const Property kUnbroken =
    atMost("no breaks in the geometry", " T-junctions and cracks", 0.0,
           [](const MethodFigures& m, const DemComparison&) { return std::optional(double(m.breaks)); });
const Property kCulls = atMost("leaves out what is not in view", " % of the triangles are left", 50.0,
                               [](const MethodFigures& m, const DemComparison&) { return m.visiblePercent; });
const Property kStrips =
    moreThan("long triangle strips (made by the dual graph)", " triangles a strip", 10.0,
             [](const MethodFigures& m, const DemComparison&) { return m.dualStripLength; });
const Property kSlotStrips =
    moreThan("long triangle strips (in the order of its slots)", " triangles a strip", 10.0,
             [](const MethodFigures& m, const DemComparison&) { return m.stripLength; });
const Property kQualitySet = atMost(
    "quality can be set while it runs", " % off the error asked for", 10.0,
    [](const MethodFigures& m, const DemComparison& dem)
    {
        const MethodFigures* roam = dem.of("roam");
        return roam ? std::optional(100.0 * std::abs(m.trueErrorPx / roam->trueErrorPx - 1.0)) : std::nullopt;
    });
const Property kLean = atMost("minimal redundancy", " times the fewest triangles", 1.15,
                              [](const MethodFigures& m, const DemComparison& dem)
                              { return std::optional(m.triangles / fewestTrianglesOf(dem)); });
const Property kCalmGeometry =
    atMost("small changes of the geometry", " px moved in a frame", 1.0,
           [](const MethodFigures& m, const DemComparison&) { return std::optional(m.popPx); });
const Property kCalmLight =
    atMost("the light stays, with normals of vertices", " times ROAM's largest turn of a normal", 1.0,
           [](const MethodFigures& m, const DemComparison& dem)
           { return toRoam(&MethodFigures::lightDeg, m, dem); });
const Property kSteadyLight =
    atMost("no breaks in the light, with normals of vertices", " degrees turned in a frame", kSeenDeg,
           [](const MethodFigures& m, const DemComparison&) { return std::optional(m.lightDeg); });
const Property kLocal =
    atMost("local features stay local", " triangles a level added by a spike", 32.0, spikePerLevel);
const Property kDynamic =
    moreThan("follows changes of the ground", " of the terrains", 0.5,
             [](const MethodFigures& m, const DemComparison&)
             { return m.followsEdits ? std::optional(*m.followsEdits ? 1.0 : 0.0) : std::nullopt; });
const Property kIrregular =
    atMost("an irregular triangulation", " % are right and isosceles", 50.0,
           [](const MethodFigures& m, const DemComparison&) { return std::optional(m.regularPercent); });
const Property kSimple = atMost("hardly any work while it runs", " times the time of ROAM's wheel", 1.0,
                                [](const MethodFigures& m, const DemComparison& dem)
                                { return toRoam(&MethodFigures::adaptUsP50, m, dem); });
const Property kSimplerThanWalk = atMost(
    "hardly any work while it runs, beside the paper's ROAM", " times the time of the paper's loop", 1.0,
    [](const MethodFigures& m, const DemComparison& dem)
    {
        const MethodFigures* walk = dem.of("roam-walk");
        return walk ? std::optional(m.adaptUsP50 / walk->adaptUsP50) : std::nullopt;
    });
const Property kComplexitySet =
    atMost("complexity can be set directly", " % off the number of triangles", 1.0, ceilingMissed);
const Property kMorphs = moreThan("morphs", " µs a frame", 0.0,
                                  [](const MethodFigures& m, const DemComparison&)
                                  { return std::optional(m.morph ? m.morph->us : 0.0); });
const Property kSmall = atMost("needs little memory", " times ROAM's", 10.0,
                               [](const MethodFigures& m, const DemComparison& dem)
                               { return toRoam(&MethodFigures::memoryMB, m, dem); });
const Property kFollowsChange =
    moreThan("its time follows what changes", " % of what is not constant", 50.0,
             [](const MethodFigures& m, const DemComparison&)
             {
                 const bool tells = m.fit && m.fit->changePercent + m.fit->sizePercent > 0.0;
                 return tells ? std::optional(m.fit->changePercent) : std::nullopt;
             });
const Property kFillsCard =
    moreThan("can keep the renderer busy", " times the time of adaptation", 1.0,
             [](const MethodFigures& m, const DemComparison&)
             { return m.frameMs ? std::optional(1e3 * *m.frameMs / m.adaptUsP50 - 1.0) : std::nullopt; });

const Property kInParts =
    moreThan("can be loaded from disk block by block", " parts of what is prepared", 1.0,
             [](const MethodFigures& m, const DemComparison&) { return std::optional(m.parts); });

/// The paper's list: `isAdvantage` says that a method has the property.
struct Listed
{
    const char* section;
    const char* method;
    bool isAdvantage;
    const Property& property;
};

constexpr const char *kDecimation = "regular-decimation", *kVipm = "vipm-locked",
                     *kOverlapping = "vipm-overlapping", *kVdpm = "vdpm", *kRoam = "roam",
                     *kWalk = "roam-walk"; // the paper's own loop

const Listed kListed[] = {{"3.3", kDecimation, true, kDetailVaries},
                          {"3.3", kDecimation, true, kSteady},
                          {"3.3", kDecimation, true, kUnbroken},
                          {"3.3", kDecimation, true, kCulls},
                          {"3.3", kDecimation, true, kStrips},
                          {"3.3", kDecimation, true, kSlotStrips},
                          {"3.3", kDecimation, true, kQualitySet},
                          {"3.3", kDecimation, false, kLean},
                          {"3.3", kDecimation, false, kCalmGeometry},
                          {"3.3", kDecimation, false, kCalmLight},
                          {"3.3", kDecimation, false, kLocal},
                          {"3.3", kDecimation, false, kDynamic},
                          {"3.3", kDecimation, false, kIrregular},
                          {"4.3", kVipm, true, kDetailVaries},
                          {"4.3", kVipm, true, kSimple},
                          {"4.3", kVipm, true, kSimplerThanWalk},
                          {"4.3", kVipm, true, kStrips},
                          {"4.3", kVipm, true, kSlotStrips},
                          {"4.3", kVipm, true, kQualitySet},
                          {"4.3", kVipm, true, kSmall},
                          {"4.3", kVipm, false, kLean},
                          {"4.3", kVipm, false, kUnbroken},
                          {"4.3", kVipm, false, kComplexitySet},
                          {"4.3", kVipm, false, kDynamic},
                          {"4.3", kOverlapping, true, kDetailVaries},
                          {"4.3", kOverlapping, true, kSimple},
                          {"4.3", kOverlapping, true, kSimplerThanWalk},
                          {"4.3", kOverlapping, true, kStrips},
                          {"4.3", kOverlapping, true, kSlotStrips},
                          {"4.3", kOverlapping, true, kQualitySet},
                          {"4.3", kOverlapping, true, kSmall},
                          {"4.3", kOverlapping, false, kLean},
                          {"4.3", kOverlapping, false, kUnbroken},
                          {"4.3", kOverlapping, false, kComplexitySet},
                          {"4.3", kOverlapping, false, kDynamic},
                          {"4.5", kVdpm, true, kDetailVaries},
                          {"4.5", kVdpm, true, kLean},
                          {"4.5", kVdpm, true, kUnbroken},
                          {"4.5", kVdpm, true, kSteadyLight},
                          {"4.5", kVdpm, true, kMorphs},
                          {"4.5", kVdpm, true, kLocal},
                          {"4.5", kVdpm, true, kStrips},
                          {"4.5", kVdpm, true, kSlotStrips},
                          {"4.5", kVdpm, true, kQualitySet},
                          {"4.5", kVdpm, false, kFollowsChange},
                          {"4.5", kVdpm, false, kDynamic},
                          {"4.5", kVdpm, false, kSmall},
                          {"4.5", kVdpm, false, kComplexitySet},
                          {"4.5", kVdpm, false, kInParts},
                          {"5.3", kRoam, true, kDetailVaries},
                          {"5.3", kRoam, true, kLean},
                          {"5.3", kRoam, true, kUnbroken},
                          {"5.3", kRoam, true, kSteadyLight},
                          {"5.3", kRoam, true, kFollowsChange},
                          {"5.3", kWalk, true, kFollowsChange},
                          {"5.3", kRoam, true, kLocal},
                          {"5.3", kRoam, true, kStrips},
                          {"5.3", kRoam, true, kSlotStrips},
                          {"5.3", kRoam, true, kCulls},
                          {"5.3", kRoam, false, kIrregular},
                          {"5.3", kRoam, false, kFillsCard},
                          {"5.3", kRoam, false, kInParts}};

} // namespace

std::vector<QualityVerdict> qualityVerdicts(const std::vector<DemComparison>& dems)
{
    std::vector<QualityVerdict> verdicts;
    for (const Listed& row : kListed)
    {
        std::vector<double> figures;
        for (const DemComparison& dem : dems)
            if (const MethodFigures* method = dem.of(row.method))
                if (const auto figure = row.property.of(*method, dem)) figures.push_back(*figure);
        auto [verdict, figure] =
            judgeFigures(figures, row.isAdvantage ? row.property.has : row.property.lacks, row.property.unit);
        verdicts.push_back({row.section, row.method, row.isAdvantage ? "advantage" : "drawback",
                            std::string(row.isAdvantage ? "" : "not: ") + row.property.name,
                            std::move(verdict), std::move(figure)});
    }
    return verdicts;
}

} // namespace terraintool
