// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/looks/ReadLookShape.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace scenery::models
{

namespace
{

constexpr double kFarthestM = 20.0;
constexpr std::size_t kMostPoints = 200;
constexpr double kLeastBetweenM = 0.001;

/// A curve's limits: the half length of the vehicle and the range of its values.
struct CurveLimits
{
    double halfLengthM, least, most;
};

Curve readCurve(JsonFields& fields, const char* name, const CurveLimits& limits)
{
    Complaint& complaint = fields.complaint();
    std::vector<double> numbers;
    if (!fields.numbers(name, numbers, -kFarthestM, kFarthestM))
    {
        sayMissing(fields, name);
        return {};
    }
    if (numbers.size() < 4 || numbers.size() % 2 != 0 || numbers.size() > 2 * kMostPoints)
        complaint.say(fields.at(name), "is no curve", "write [x, value, x, value …], 2 to 200 points");
    std::vector<Curve::Point> points;
    for (std::size_t i = 0; i + 1 < numbers.size() && !complaint.error; i += 2)
    {
        const Curve::Point point{numbers[i], numbers[i + 1]};
        const std::string place = fields.at(name) + "/" + std::to_string(i);
        if (std::abs(point.at) > limits.halfLengthM + 1e-9)
            complaint.say(place, "lies beyond the vehicle's ends",
                          "give an x within half of size/lengthM, or another length");
        if (!points.empty() && point.at < points.back().at + kLeastBetweenM)
            complaint.say(place, "does not lie before the point before it", "let x rise by 0.001 or more");
        if (point.value < limits.least || point.value > limits.most)
            complaint.say(fields.at(name) + "/" + std::to_string(i + 1), "is out of range",
                          "give one from " + std::to_string(limits.least) + " to " +
                              std::to_string(limits.most));
        points.push_back(point);
    }
    return complaint.error ? Curve() : Curve(std::move(points));
}

void readProfile(JsonFields& fields, VehicleForm& form)
{
    const double half = 0.5 * form.lengthM;
    form.top = readCurve(fields, "top", {half, 0.1, form.heightM + 0.02});
    form.belt = readCurve(fields, "belt", {half, 0.1, form.heightM});
    form.half = readCurve(fields, "halfWidth", {half, 0.2 * form.widthM, 0.5 * form.widthM});
    form.lean = readCurve(fields, "lean", {half, 0.0, 0.6});
    form.bottom = readCurve(fields, "bottom", {half, 0.05, 1.5});
    readNeeded(fields, "railShare", form.railShare, 0.5, 0.98);
    readNeeded(fields, "roofPower", form.roofPower, 1.5, 12.0);
}

void readWheels(JsonFields& fields, VehicleForm& form)
{
    readNeeded(fields, "radiusM", form.wheelRadiusM, 0.1, 1.0);
    readNeeded(fields, "widthM", form.wheelWidthM, 0.05, 0.6);
    readNeeded(fields, "archRadiusM", form.archRadiusM, 0.1, 1.2);
    readNeeded(fields, "frontXM", form.axles.x, 0.0, kFarthestM);
    readNeeded(fields, "rearXM", form.axles.y, -kFarthestM, 0.0);
}

void readRange(JsonFields& fields, const char* name, double& least, double& most, const StretchRange& allowed)
{
    std::vector<double> ends;
    if (!fields.numbers(name, ends, allowed.least, allowed.most)) return;
    if (ends.size() != 2 || ends[0] > ends[1])
        return fields.complaint().say(fields.at(name), "is no range", "write [least, most]");
    least = ends[0];
    most = ends[1];
}

/// The arches must lie on the body and apart, however seeds stretch it.
void checkWheels(JsonFields& root, const VehicleLook& look)
{
    const VehicleForm& form = look.form;
    const double arch = form.archRadiusM * std::max(1.4, 1.1 * look.height.most / look.length.least);
    const std::string wheels = root.at("wheels");
    Complaint& complaint = root.complaint();
    if (form.archRadiusM < form.wheelRadiusM)
        complaint.say(wheels + "/archRadiusM", "is less than the wheel's radius",
                      "give some centimetres more");
    if (form.axles.x + arch > 0.5 * form.lengthM)
        complaint.say(wheels + "/frontXM", "leaves no room for the arch before the axle", "give less");
    if (-form.axles.y + arch > 0.5 * form.lengthM)
        complaint.say(wheels + "/rearXM", "leaves no room for the arch behind the axle", "give more");
    if (form.axles.x - form.axles.y < 2.0 * arch)
        complaint.say(wheels + "/frontXM", "is so near the rear axle that the arches meet", "give more");
    if (0.5 * form.widthM - form.wheelWidthM < 0.2)
        complaint.say(wheels + "/widthM", "leaves no room between the wheels", "give less");
    if (2.0 * form.archRadiusM > form.heightM)
        complaint.say(wheels + "/archRadiusM", "is as high as the vehicle", "give less");
}

/// Above the lower edge there must be a belt, and above that a roof, all along.
void checkProfile(JsonFields& root, const VehicleForm& form)
{
    constexpr int kChecked = 400;
    constexpr double kLeastSideM = 0.12, kLeastRoofM = 0.03, kHeightWithinM = 0.05, kWidthWithinM = 0.1;
    const std::string profile = root.at("profile");
    double topM = 0.0, halfM = 0.0;
    for (int i = 0; i <= kChecked && !root.complaint().error; ++i)
    {
        const double x = form.lengthM * (static_cast<double>(i) / kChecked - 0.5);
        const std::string at = " at x = " + std::to_string(x);
        if (form.belt(x) < form.bottom(x) + kLeastSideM)
            root.complaint().say(profile + "/belt", "lies less than 0.12 m above the lower edge" + at,
                                 "give more, or less in bottom");
        if (form.top(x) < form.belt(x) + kLeastRoofM)
            root.complaint().say(profile + "/top", "lies less than 0.03 m above the belt" + at,
                                 "give more, or less in belt");
        topM = std::max(topM, form.top(x));
        halfM = std::max(halfM, form.half(x));
    }
    if (topM < form.heightM - kHeightWithinM)
        root.complaint().say(profile + "/top", "does not reach size/heightM", "give the height of the roof");
    if (halfM < 0.5 * form.widthM - kWidthWithinM)
        root.complaint().say(profile + "/halfWidth", "does not reach half of size/widthM",
                             "give the width of the widest part");
}

/// Bounds that are absent follow from the size.
void readBounds(JsonFields& root, VehicleLook& look)
{
    const VehicleForm& form = look.form;
    const double low = form.heightM * look.height.least, high = form.heightM * look.height.most;
    const double radius =
        std::hypot(0.5 * form.lengthM * look.length.most, 0.5 * form.widthM * look.width.most);
    constexpr double kRoofM = 0.1, kMirrorsM = 0.3;
    look.bounds = {low - kRoofM, high + kRoofM, radius + kMirrorsM};
    const nlohmann::json* const found = root.find("bounds");
    if (!found) return;
    JsonFields fields(*found, root.at("bounds"), root.complaint());
    readRange(fields, "heightM", look.bounds.leastHeightM, look.bounds.mostHeightM, {0.5, 10.0});
    fields.number("radiusM", look.bounds.mostRadiusM, 0.5, kFarthestM);
    if (look.bounds.leastHeightM > low || look.bounds.mostHeightM < high)
        root.complaint().say(fields.at("heightM"), "does not contain the vehicle as seeds stretch it",
                             "contain " + std::to_string(low) + " to " + std::to_string(high));
    if (look.bounds.mostRadiusM < radius)
        root.complaint().say(fields.at("radiusM"), "does not contain the vehicle as seeds stretch it",
                             "give at least " + std::to_string(radius));
}

} // namespace

void sayMissing(JsonFields& fields, const std::string& name)
{
    fields.complaint().say(fields.at(name), "is missing",
                           "give it, or begin with the members of another look: \"like\": \"saloon\"");
}

void readNeeded(JsonFields& fields, const char* name, double& value, double least, double most)
{
    if (!fields.number(name, value, least, most)) sayMissing(fields, name);
}

void readLookShape(JsonFields& root, VehicleLook& look)
{
    VehicleForm& form = look.form;
    readPart(root, "size",
             [&](JsonFields& fields)
             {
                 readNeeded(fields, "lengthM", form.lengthM, 2.4, 25.0);
                 readNeeded(fields, "widthM", form.widthM, 1.0, 3.5);
                 readNeeded(fields, "heightM", form.heightM, 0.9, 5.0);
             });
    if (const nlohmann::json* const found = root.find("stretch"))
    {
        constexpr StretchRange kAllowed{0.8, 1.25};
        JsonFields fields(*found, root.at("stretch"), root.complaint());
        readRange(fields, "length", look.length.least, look.length.most, kAllowed);
        readRange(fields, "width", look.width.least, look.width.most, kAllowed);
        readRange(fields, "height", look.height.least, look.height.most, kAllowed);
    }
    readPart(root, "profile", [&](JsonFields& fields) { readProfile(fields, form); });
    readPart(root, "wheels", [&](JsonFields& fields) { readWheels(fields, form); });
    readBounds(root, look);
    if (root.complaint().error) return;
    checkWheels(root, look);
    checkProfile(root, form);
}

} // namespace scenery::models
