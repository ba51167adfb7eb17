// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TableMotion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include <foundation/Angle.h>
#include <foundation/Units.h>

#include "simulation/track/CellNumber.h"
#include "simulation/track/HeadingWords.h"
#include "simulation/track/TrackMotion.h"

namespace simulation
{
namespace
{

using MotionWords = std::vector<std::string>;

constexpr std::size_t kFewestCompared = 4; ///< stretches of a way
constexpr double kMovedM = 1.0;
constexpr double kLeastWayMps = 0.5;  ///< a way without times does not stop
constexpr double kOtherWayDeg = 60.0; ///< no body moves so far beside its nose, most of the time
constexpr double kSameSpeed = 1.25;   ///< ratio of speeds that still are the same
constexpr double kDegPerRad = 57.29577951308232;

struct SpeedUnit
{
    std::string_view name;
    double mps;
    std::array<std::string_view, 5> words; ///< any of these
    std::string_view first{}, second{};    ///< or these two in a row
};

const SpeedUnit kSpeedUnits[] = {{"m/s", 1.0, {"mps", "ms"}, "m", "s"},
                                 {"km/h", 1.0 / foundation::kKmhPerMps, {"kmh", "kph", "kmph"}, "km", "h"},
                                 {"knots", foundation::kMpsPerKnot, {"kt", "kts", "kn", "knot", "knots"}},
                                 {"mph", foundation::kMpsPerMph, {"mph"}, "mi", "h"},
                                 {"ft/s", foundation::kMetresPerFoot, {"fps"}, "ft", "s"},
                                 {"cm/s", 0.01, {}, "cm", "s"},
                                 {"mm/s", 0.001, {}, "mm", "s"}};

template<class Words>
bool contains(const Words& words, std::string_view word)
{
    return !word.empty() && std::find(words.begin(), words.end(), word) != words.end();
}

/// Takes the unit of a speed off the words of a heading.
std::optional<double> takeSpeedUnit(MotionWords& words)
{
    for (const SpeedUnit& unit : kSpeedUnits)
        for (std::size_t i = 1; i < words.size(); ++i)
        {
            const bool isPair = i + 1 < words.size() && words[i] == unit.first && words[i + 1] == unit.second;
            if (!isPair && !contains(unit.words, words[i])) continue;
            const auto at = words.begin() + static_cast<std::ptrdiff_t>(i);
            words.erase(at, at + (isPair ? 2 : 1));
            return unit.mps;
        }
    return std::nullopt;
}

/// Takes the unit of an angle off the words of a heading.
std::optional<double> takeAngleUnit(MotionWords& words)
{
    constexpr std::array<std::string_view, 3> kDegrees{"deg", "degree", "degrees"},
        kRadians{"rad", "radian", "radians"};
    for (std::size_t i = 1; i < words.size(); ++i)
    {
        const bool isInRadians = contains(kRadians, words[i]);
        if (!isInRadians && !contains(kDegrees, words[i])) continue;
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
        return isInRadians ? kDegPerRad : 1.0;
    }
    return std::nullopt;
}

/// Whether words have one of those wanted, and beside it only those that change nothing.
bool isOf(const MotionWords& words, std::initializer_list<std::string_view> wanted)
{
    constexpr std::array<std::string_view, 19> kPlain{
        "gps",      "ground", "gnd", "over", "uber", "ueber", "sur",   "true",    "osd",     "att",
        "attitude", "ahrs",   "imu", "ins",  "body", "euler", "angle", "vehicle", "aircraft"};
    bool isThere = false;
    for (const std::string& word : words)
    {
        if (contains(wanted, word))
            isThere = true;
        else if (!word.empty() && !contains(kPlain, word))
            return false;
    }
    return isThere;
}

double medianOf(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The direction from a fix to the next, clockwise from north; nothing: it has hardly moved.
std::optional<double> courseDeg(const FlightTrack& track, std::size_t i)
{
    const TrackFix &from = track.fixes[i], &to = track.fixes[i + 1];
    if (metresBetween(from, to) < kMovedM) return std::nullopt;
    const double north = to.latitudeDeg - from.latitudeDeg,
                 east = foundation::wrappedDeg(to.longitudeDeg - from.longitudeDeg) *
                        std::cos(foundation::radiansOf(from.latitudeDeg));
    const double sign = track.hasTimes && to.timeS < from.timeS ? -1.0 : 1.0;
    return foundation::degreesOf(std::atan2(sign * east, sign * north));
}

/// By how much yaws differ from the way, as a median; `unit`: of them. Nothing: too little to compare.
std::optional<double> besideTheWay(const FlightTrack& track, double unit)
{
    std::vector<double> differences;
    for (std::size_t i = 0; i + 1 < track.fixes.size(); ++i)
        if (const auto course = courseDeg(track, i))
        {
            const double from = unit * track.fixes[i].attitude->yawDeg,
                         turn = foundation::wrappedDeg(unit * track.fixes[i + 1].attitude->yawDeg - from);
            differences.push_back(std::fabs(foundation::wrappedDeg(from + 0.5 * turn - *course)));
        }
    if (differences.size() < kFewestCompared) return std::nullopt;
    return medianOf(differences);
}

/// Fills what single fixes lack with that of the fix before; of the first ones, of that behind. `get` returns
/// a reference to an optional value of a fix. Returns how many are filled.
template<class Get>
std::size_t fillForth(std::vector<TrackFix>& fixes, const Get& get)
{
    std::size_t lacking = 0;
    const auto known =
        std::find_if(fixes.begin(), fixes.end(), [&](TrackFix& fix) { return get(fix).has_value(); });
    if (known == fixes.end()) return 0;
    auto last = get(*known);
    for (TrackFix& fix : fixes)
    {
        if (!get(fix)) ++lacking, get(fix) = last;
        last = get(fix);
    }
    return lacking;
}

std::string inWords(const char* form, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

std::string filledWords(std::size_t filled, const std::vector<TrackFix>& fixes, const std::string& name)
{
    return std::to_string(filled) + " of " + std::to_string(fixes.size()) +
           " fixes have nothing in the column " + name + "; that of the fix before is taken";
}

} // namespace

TableMotion::TableMotion(const std::vector<std::string>& names) : _names(names)
{
    MeasuredColumn heading, course;
    bool isHeadingMagnetic = false;
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        const MotionWords words = inEnglish(headingWords(names[i]));
        MotionWords ofSpeed = words, ofAngle = words;
        const auto speedUnit = takeSpeedUnit(ofSpeed), angleUnit = takeAngleUnit(ofAngle);
        const auto take = [&](MeasuredColumn& column, std::optional<double> unit)
        {
            if (column.at < 0) column = {static_cast<int>(i), unit.value_or(1.0), unit.has_value()};
        };
        const auto isMagneticWord = [](const std::string& word)
        { return word == "mag" || word == "magnetic" || word == "compass"; };
        MotionWords withoutNorth = ofAngle;
        const bool isMagnetic = std::erase_if(withoutNorth, isMagneticWord) > 0;
        if (isOf(ofSpeed, {"speed", "velocity", "groundspeed", "gs", "sog", "spd"}) ||
            ofSpeed == MotionWords{"v"})
            take(_speed, speedUnit);
        else if (isOf(ofAngle, {"yaw"}))
            take(_yaw, angleUnit);
        else if (isOf(ofAngle, {"pitch"}))
            take(_pitch, angleUnit);
        else if (isOf(ofAngle, {"roll", "bank"}))
            take(_roll, angleUnit);
        else if (isOf(withoutNorth, {"heading", "hdg", "hding"}))
        {
            if (heading.at >= 0 && isHeadingMagnetic && !isMagnetic) heading = {}; // a true one is better
            if (heading.at < 0) isHeadingMagnetic = isMagnetic;
            take(heading, angleUnit);
        }
        else if (isOf(ofAngle, {"course", "cog", "track", "bearing", "direction"}))
            take(course, angleUnit);
    }
    if (_yaw.at < 0 && heading.at >= 0)
    {
        _yaw = heading;
        _isCourse = _pitch.at < 0 && _roll.at < 0;
        _isMagnetic = isHeadingMagnetic;
    }
    if (_yaw.at < 0 && course.at >= 0) _yaw = course, _isCourse = true;
    if (_yaw.at < 0 || _isCourse) _pitch = _roll = {};
}

void TableMotion::take(const std::vector<std::string>& cells, bool isDecimalComma, TrackFix& fix) const
{
    const auto numberIn = [&](const MeasuredColumn& column, bool isSpeed) -> std::optional<double>
    {
        if (column.at < 0 || static_cast<std::size_t>(column.at) >= cells.size()) return std::nullopt;
        const auto number = cellNumber(cells[static_cast<std::size_t>(column.at)], isDecimalComma);
        if (!number || !number->before.empty() || !(std::fabs(number->value) <= 1e6)) return std::nullopt;
        if (number->behind.empty()) return column.unit * number->value;
        if (!isSpeed) return number->behind == "°" ? std::optional(number->value) : std::nullopt;
        MotionWords words = headingWords("v " + number->behind);
        const auto unit = takeSpeedUnit(words);
        return unit && words.size() == 1 ? std::optional(*unit * number->value) : std::nullopt;
    };
    if (const auto speed = numberIn(_speed, true); speed && *speed >= 0.0) fix.speedMps = speed;
    if (const auto yaw = numberIn(_yaw, false))
        fix.attitude = TrackAttitude{*yaw, numberIn(_pitch, false), numberIn(_roll, false)};
}

std::vector<std::string> TableMotion::settle(FlightTrack& track) const
{
    std::vector<std::string> notes;
    settleAttitudes(track, notes);
    track.hasTimes ? compareSpeeds(track, notes) : timeBySpeeds(track, notes);
    return notes;
}

void TableMotion::settleAttitudes(FlightTrack& track, std::vector<std::string>& notes) const
{
    if (_yaw.at < 0) return;
    const auto leaveOut = [&]
    {
        for (TrackFix& fix : track.fixes)
            fix.attitude.reset();
    };
    const std::size_t filled = fillForth(
        track.fixes, [](TrackFix & fix) -> auto& { return fix.attitude; });
    if (track.fixes.empty() || !track.fixes.front().attitude) return;
    if (2 * filled > track.fixes.size())
    {
        leaveOut();
        if (!_isCourse)
            notes.push_back("the column " + nameOf(_yaw) +
                            " is empty for most fixes; attitudes are not read");
        return;
    }
    const auto beside = besideTheWay(track, 1.0);
    const auto asRadians = _yaw.hasUnit ? std::nullopt : besideTheWay(track, kDegPerRad);
    const bool isInRadians = beside && asRadians && *beside > 30.0 && *asRadians < 15.0;
    const bool isElsewhere = beside && *beside > kOtherWayDeg && !isInRadians;
    if (isElsewhere)
        notes.push_back("the column " + nameOf(_yaw) + " differs from the way by " +
                        inWords("%.0f", *beside) + " degrees (median); attitudes follow from the way");
    if (_isCourse || isElsewhere) return leaveOut();
    if (filled > 0) notes.push_back(filledWords(filled, track.fixes, nameOf(_yaw)));
    if (_isMagnetic)
        notes.push_back("the column " + nameOf(_yaw) + " counts from magnetic north; it is taken as true");
    if (isInRadians)
        notes.push_back("the column " + nameOf(_yaw) + " is read as radians: so it fits the way");
    for (TrackFix& fix : track.fixes)
    {
        if (!isInRadians) break;
        fix.attitude->yawDeg *= kDegPerRad;
        if (fix.attitude->pitchDeg && !_pitch.hasUnit) *fix.attitude->pitchDeg *= kDegPerRad;
        if (fix.attitude->rollDeg && !_roll.hasUnit) *fix.attitude->rollDeg *= kDegPerRad;
    }
    const std::size_t pitches = fillForth(
        track.fixes, [](TrackFix & fix) -> auto& { return fix.attitude->pitchDeg; });
    const std::size_t rolls = fillForth(
        track.fixes, [](TrackFix & fix) -> auto& { return fix.attitude->rollDeg; });
    if (pitches > 0) notes.push_back(filledWords(pitches, track.fixes, nameOf(_pitch)));
    if (rolls > 0) notes.push_back(filledWords(rolls, track.fixes, nameOf(_roll)));
}

void TableMotion::timeBySpeeds(FlightTrack& track, std::vector<std::string>& notes) const
{
    if (_speed.at < 0 || track.fixes.size() < 2) return;
    const std::size_t filled = fillForth(
        track.fixes, [](TrackFix & fix) -> auto& { return fix.speedMps; });
    const bool isMoving =
        std::any_of(track.fixes.begin(), track.fixes.end(),
                    [](const TrackFix& fix) { return fix.speedMps.value_or(0.0) >= kLeastWayMps; });
    if (!isMoving || 2 * filled > track.fixes.size()) return;
    track.fixes.front().timeS = 0.0;
    for (std::size_t i = 1; i < track.fixes.size(); ++i)
    {
        const double speedMps =
            std::max(kLeastWayMps, 0.5 * (*track.fixes[i - 1].speedMps + *track.fixes[i].speedMps));
        track.fixes[i].timeS =
            track.fixes[i - 1].timeS + metresBetween(track.fixes[i - 1], track.fixes[i]) / speedMps;
    }
    track.hasTimes = true;
    notes.push_back("no column tells times; they follow from the column " + nameOf(_speed) +
                    (_speed.hasUnit ? "" : ", taken as m/s"));
}

void TableMotion::compareSpeeds(const FlightTrack& track, std::vector<std::string>& notes) const
{
    std::vector<double> ratios;
    for (std::size_t i = 0; i + 1 < track.fixes.size(); ++i)
    {
        const TrackFix &from = track.fixes[i], &to = track.fixes[i + 1];
        const double wayM = metresBetween(from, to), spanS = std::fabs(to.timeS - from.timeS);
        if (!from.speedMps || !to.speedMps || wayM < kMovedM || !(spanS > 0.0)) continue;
        const double speedMps = 0.5 * (*from.speedMps + *to.speedMps);
        if (speedMps > kLeastWayMps) ratios.push_back(wayM / spanS / speedMps);
    }
    if (ratios.size() < kFewestCompared) return;
    const double ratio = medianOf(ratios);
    const auto isSame = [](double one) { return one < kSameSpeed && one > 1.0 / kSameSpeed; };
    for (const SpeedUnit& unit : kSpeedUnits)
        if (isSame(ratio * (_speed.hasUnit ? 1.0 : 1.0 / unit.mps))) return;
    notes.push_back(
        "the way is " + inWords("%.3g", ratio) + " times as fast as the column " + nameOf(_speed) +
        " says (median), which is told and not in effect; look at its unit and that of the times");
}

} // namespace simulation
