// SPDX-License-Identifier: Apache-2.0
#include "LightReport.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "measurement/light/CloudFigures.h"
#include "measurement/light/FallFigures.h"
#include "measurement/light/LampFigures.h"
#include "measurement/light/SkyFigures.h"
#include "measurement/light/UnmeasuredGoals.h"
#include "measurement/light/view/DrawnFigures.h"
#include "scene/SceneWeather.h"
#include "scenery/nodes/NightSky.h"

namespace trainer
{

namespace
{

using measurement::LightFigure;
using measurement::LightFigures;
using terminal::numberOrNull;

nlohmann::ordered_json jsonOfFigure(const LightFigure& figure)
{
    return {{"goal", figure.goal},
            {"name", figure.name},
            {"value", numberOrNull(figure.value)},
            {"unit", figure.unit},
            {"least", numberOrNull(figure.least)},
            {"most", numberOrNull(figure.most)},
            {"source", figure.source},
            {"pass", figure.passes()}};
}

std::string limitsOf(const LightFigure& figure)
{
    char text[64];
    const bool hasLeast = std::isfinite(figure.least), hasMost = std::isfinite(figure.most);
    if (hasLeast && hasMost)
        std::snprintf(text, sizeof text, "%.4g to %.4g", figure.least, figure.most);
    else
        std::snprintf(text, sizeof text, "%s %.4g", hasLeast ? "least" : "most",
                      hasLeast ? figure.least : figure.most);
    return text;
}

void printFigure(const LightFigure& figure)
{
    std::printf("%s  %-3s  %-66s %9.4g %-7s %-16s %s\n", figure.passes() ? "PASS" : "FAIL",
                figure.goal.c_str(), figure.name.c_str(), figure.value, figure.unit.c_str(),
                limitsOf(figure).c_str(), figure.source.c_str());
    std::fflush(stdout); // the next group may take a while
}

/// The visibility of a scene in which something falls and nothing else is told.
double visibilityIn(const char* type, double mmPerHour)
{
    simulation::EnvironmentState environment;
    environment.precipitation = simulation::Precipitation{type, mmPerHour};
    return airOf(environment).visibilityM;
}

} // namespace

foundation::Result<terminal::Report> lightReport()
{
    measurement::LampParts lamps;
    lamps.position = measurement::drawnPositionLamps();
    lamps.lowBeam = measurement::drawnLowBeam();
    measurement::SkyParts sky;
    sky.faintestSeen = scenery::NightSky::faintestSeen;
    const measurement::SceneParts scenes{visibilityIn, greyUnder};
    using Group = std::function<foundation::Result<LightFigures>()>;
    const Group groups[]{[&] { return measurement::drawnAirFigures(scenes); },
                         [&] { return foundation::Result<LightFigures>(measurement::lampFigures(lamps)); },
                         [&] { return measurement::drawnLampFigures(lamps); },
                         [] { return foundation::Result<LightFigures>(measurement::cloudFigures()); },
                         [&] { return measurement::drawnCloudFigures(scenes); },
                         [&] { return foundation::Result<LightFigures>(measurement::skyFigures(sky)); },
                         [] { return foundation::Result<LightFigures>(measurement::fallFigures()); },
                         [] { return measurement::drawnSkyFigures(); }};
    terminal::Report report;
    report.json["figures"] = nlohmann::ordered_json::array();
    std::size_t all = 0, missed = 0;
    for (const Group& group : groups)
    {
        const auto figures = group();
        if (!figures) return figures.error();
        for (const LightFigure& figure : *figures)
        {
            printFigure(figure);
            report.json["figures"].push_back(jsonOfFigure(figure));
            missed += figure.passes() ? 0 : 1;
            ++all;
        }
    }
    report.json["notMeasured"] = nlohmann::ordered_json::array();
    for (const auto& [goal, what, why] : measurement::unmeasuredGoals())
    {
        std::printf("none  %-3s  %s: not measured, %s\n", goal, what, why);
        report.json["notMeasured"].push_back({{"goal", goal}, {"what", what}, {"why", why}});
    }
    report.sound = missed == 0;
    if (missed > 0)
        std::fprintf(stderr, "trainer: light: %zu of %zu figures are missed, see FAIL above\n", missed, all);
    return report;
}

} // namespace trainer
