// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetSignals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <osgRoads/core/query/LaneSpan.h>

namespace worldmaking
{

namespace
{

using osgRoads::core::Controller;
using osgRoads::core::LaneSpan;
using osgRoads::core::LaneType;
using osgRoads::core::Road;
using osgRoads::core::RoadObject;
using osgRoads::core::Signal;

constexpr double kLeastLineM = 1.0, kStripesM = 3.0, kLineBeforeStripesM = 1.0;
constexpr double kBesidePavingM = 0.6, kBesideHeightM = 2.4, kFootHeightM = 2.2, kAboveHeightM = 4.8;
constexpr double kSignHeightM = 2.0, kLeastForStripesM = 12.0;

/// The lanes of one direction at one s. Units: metres across the road.
struct LanesOfDirection
{
    double fromT = 1e9, toT = -1e9;
    int lanes = 0;
    double pavedFromT = 1e9, pavedToT = -1e9; ///< of both directions, without sidewalks
};

LanesOfDirection lanesAt(const Road& road, double s, bool isForward)
{
    LanesOfDirection found;
    const auto* section = osgRoads::core::sectionAt(road, s);
    if (!section) return found;
    const auto take = [&](const LaneSpan& span)
    {
        if (span.lane->type == LaneType::sidewalk || span.width() <= 0.0) return true;
        const double from = std::min(span.innerT, span.outerT), to = std::max(span.innerT, span.outerT);
        found.pavedFromT = std::min(found.pavedFromT, from);
        found.pavedToT = std::max(found.pavedToT, to);
        const bool isBoth = span.lane->direction == osgRoads::core::LaneDirection::both;
        if (span.lane->type != LaneType::driving ||
            (!isBoth && osgRoads::core::runsForward(road, *span.lane) != isForward))
            return true;
        found.fromT = std::min(found.fromT, from);
        found.toT = std::max(found.toT, to);
        ++found.lanes;
        return true;
    };
    for (const int sign : {-1, 1})
        osgRoads::core::forLanesOutwards(road, *section, sign, s, take);
    return found;
}

/// Places signals on a road, and notes the lights for a controller.
class SignalPlacer
{
public:
    SignalPlacer(Road& road, StreetReport& report) : _road(road), _report(report) {}

    /// What stops those who come to an end of the road.
    void addArm(const ArmSignals& arm, bool isEnd, Controller* controller)
    {
        double lineM = std::max(arm.lineM.value_or(kLeastLineM), kLeastLineM);
        if (arm.footM && _road.length >= kLeastForStripesM && controller)
        {
            const double beforeM = std::clamp(*arm.footM, 0.5 * kStripesM + 0.3, _road.length - 5.0);
            addStripes(placeOf(beforeM, isEnd), *controller);
            lineM = std::max(lineM, beforeM + 0.5 * kStripesM + kLineBeforeStripesM);
        }
        const double s = placeOf(std::min(lineM, 0.8 * _road.length), isEnd);
        if (arm.isLit && controller)
            addLights(s, isEnd, *controller);
        else if (arm.sign != ArmSignals::Sign::none)
            addSign(s, isEnd, arm.sign == ArmSignals::Sign::stop);
    }

    void addBetween(const StreetLight& light, Controller& controller)
    {
        const bool hasStripes = light.isFoot && _road.length >= kLeastForStripesM;
        const double asideM = hasStripes ? 0.5 * kStripesM + kLineBeforeStripesM : 0.0;
        const double atM = hasStripes ? std::clamp(light.atM, asideM + 0.5, _road.length - asideM - 0.5)
                                      : std::clamp(light.atM, 0.1 * _road.length, 0.9 * _road.length);
        if (hasStripes) addStripes(atM, controller);
        if (light.isForward) addLights(atM - asideM, true, controller);
        if (light.isBackward) addLights(atM + asideM, false, controller);
    }

    /// Arrows that lie in a line or in stripes are taken out.
    void clearPaint()
    {
        constexpr double kArrowHalfM = 2.5;
        std::erase_if(
            _road.objects,
            [&](const RoadObject& object)
            {
                return object.subtype.starts_with("arrow") &&
                       std::any_of(_painted.begin(), _painted.end(),
                                   [&](const std::pair<double, double>& paint)
                                   { return std::abs(paint.first - object.s) < paint.second + kArrowHalfM; });
            });
    }

private:
    double placeOf(double beforeM, bool isEnd) const { return isEnd ? _road.length - beforeM : beforeM; }

    Signal& add(const char* type, double s, double t, char orientation)
    {
        Signal signal;
        signal.id = _road.id + "-s" + std::to_string(_road.signals.size());
        signal.type = type;
        signal.subtype = "-1";
        signal.country = "OpenDRIVE";
        signal.s = s;
        signal.t = t;
        signal.orientation = orientation;
        return _road.signals.emplace_back(std::move(signal));
    }

    /// Where a light stands: across the road, above it, turned against its direction.
    struct LightStand
    {
        double t = 0.0, heightM = 0.0, headingRad = 0.0;
        char orientation = '+';
    };

    void addLight(const char* type, double s, const LightStand& stand, Controller& controller)
    {
        Signal& light = add(type, s, stand.t, stand.orientation);
        light.isDynamic = true;
        light.zOffset = stand.heightM;
        light.headingRad = stand.headingRad;
        controller.controls.push_back({light.id, ""});
        ++_report.trafficLights;
    }

    void addLights(double s, bool isForward, Controller& controller)
    {
        const LanesOfDirection lanes = lanesAt(_road, s, isForward);
        if (lanes.lanes == 0) return;
        const double t = isForward ? lanes.pavedFromT - kBesidePavingM : lanes.pavedToT + kBesidePavingM;
        const char orientation = isForward ? '+' : '-';
        addLight("1000001", s, {t, kBesideHeightM, 0.0, orientation}, controller);
        if (lanes.lanes > 1)
            addLight("1000001", s, {aboveT(s, isForward, lanes), kAboveHeightM, 0.0, orientation},
                     controller);
        addLine("stopLine", s, lanes);
    }

    /// Where a light hangs above lanes: in their middle, but nearer to the right edge of the road than to the
    /// left one. Its post stands beside the nearer one, and on the left may be another carriageway.
    double aboveT(double s, bool isForward, const LanesOfDirection& lanes) const
    {
        constexpr double kNearerM = 0.25;
        const auto road = osgRoads::core::extentAt(_road, s);
        const double middleT = 0.5 * (lanes.fromT + lanes.toT), roadT = 0.5 * (road.leftT + road.rightT);
        return isForward ? std::min(middleT, roadT - kNearerM) : std::max(middleT, roadT + kNearerM);
    }

    void addSign(double s, bool isForward, bool isStop)
    {
        const LanesOfDirection lanes = lanesAt(_road, s, isForward);
        if (lanes.lanes == 0) return;
        const double t = isForward ? lanes.pavedFromT - kBesidePavingM : lanes.pavedToT + kBesidePavingM;
        Signal& sign = add(isStop ? "206" : "205", s, t, isForward ? '+' : '-');
        sign.country = "DE";
        sign.zOffset = kSignHeightM;
        addLine(isStop ? "stopLine" : "yieldLine", s, lanes);
        ++_report.waitSigns;
    }

    RoadObject& addObject(const char* type, const char* subtype, double s)
    {
        RoadObject object;
        object.id = _road.id + "-p" + std::to_string(_road.objects.size());
        object.type = type;
        object.subtype = subtype;
        object.name = subtype;
        object.s = s;
        return _road.objects.emplace_back(std::move(object));
    }

    void addLine(const char* subtype, double s, const LanesOfDirection& lanes)
    {
        RoadObject& line = addObject("roadMark", subtype, s);
        line.t = 0.5 * (lanes.fromT + lanes.toT);
        line.length = 0.5;
        line.width = lanes.toT - lanes.fromT;
        _painted.emplace_back(s, 0.25);
    }

    /// A crossing for people on foot, with a light for each side.
    void addStripes(double s, Controller& controller)
    {
        const LanesOfDirection lanes = lanesAt(_road, s, true);
        if (lanes.pavedToT <= lanes.pavedFromT) return;
        RoadObject& stripes = addObject("crosswalk", "", s);
        stripes.t = 0.5 * (lanes.pavedFromT + lanes.pavedToT);
        stripes.length = kStripesM;
        stripes.width = lanes.pavedToT - lanes.pavedFromT;
        _painted.emplace_back(s, 0.5 * kStripesM);
        // Who comes from the left sees the one on the right.
        const double quarterRad = 0.5 * std::numbers::pi;
        addLight("1000002", s, {lanes.pavedFromT - kBesidePavingM, kFootHeightM, -quarterRad}, controller);
        addLight("1000002", s, {lanes.pavedToT + kBesidePavingM, kFootHeightM, quarterRad}, controller);
    }

    Road& _road;
    StreetReport& _report;
    std::vector<std::pair<double, double>> _painted; ///< s, and half the length
};

} // namespace

void addSignals(const SignalPlan& plan, osgRoads::core::RoadNetwork& network, StreetReport& report)
{
    std::vector<Controller> controllers(static_cast<std::size_t>(plan.places));
    std::size_t between = 0;
    for (std::size_t chain = 0; chain < plan.arms.size(); ++chain)
    {
        Road& road = network.roads[chain];
        SignalPlacer placer(road, report);
        for (const bool isEnd : {false, true})
        {
            const ArmSignals& arm = plan.arms[chain][isEnd ? 1 : 0];
            placer.addArm(arm, isEnd,
                          arm.place >= 0 ? &controllers[static_cast<std::size_t>(arm.place)] : nullptr);
        }
        for (const StreetLight& light : plan.between)
            if (light.chain == chain)
            {
                Controller controller;
                controller.name = "crossing " + std::to_string(++between);
                placer.addBetween(light, controller);
                controllers.push_back(std::move(controller));
            }
        placer.clearPaint();
    }
    for (std::size_t i = 0; i < controllers.size(); ++i)
    {
        Controller& controller = controllers[i];
        if (controller.controls.empty()) continue;
        controller.id = std::to_string(i + 1);
        if (controller.name.empty()) controller.name = "junction lights " + controller.id;
        for (std::size_t crossing = 0; crossing < plan.placeOf.size(); ++crossing)
            if (plan.placeOf[crossing] == static_cast<int>(i))
                network.junctions[crossing].controllerIds.push_back(controller.id);
        network.controllers.push_back(std::move(controller));
        ++report.litPlaces;
    }
}

} // namespace worldmaking
