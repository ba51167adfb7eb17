// SPDX-License-Identifier: Apache-2.0
#include "simulation/record/MotionLog.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>

#include <foundation/Angle.h>
#include <foundation/CsvCells.h>

namespace simulation
{
namespace
{

constexpr std::array kColumns = {"Entity_Name [-]",
                                 "Entity_ID [-]",
                                 "Current_Speed [m/s]",
                                 "Wheel_Angle [deg]",
                                 "Wheel_Rotation [-]",
                                 "bb_x [m]",
                                 "bb_y [m]",
                                 "bb_z [m]",
                                 "bb_length [m]",
                                 "bb_width [m]",
                                 "bb_height [m]",
                                 "World_Position_X [m]",
                                 "World_Position_Y [m]",
                                 "World_Position_Z [m]",
                                 "Vel_X [m/s]",
                                 "Vel_Y [m/s]",
                                 "Vel_Z [m/s]",
                                 "Acc_X [m/s2]",
                                 "Acc_Y [m/s2]",
                                 "Acc_Z [m/s2]",
                                 "Distance_Travelled_Along_Road_Segment [m]",
                                 "Lateral_Distance_Lanem [m]",
                                 "lane_id",
                                 "lane_offset [m]",
                                 "World_Heading_Angle [rad]",
                                 "Heading_Angle_Rate [rad/s]",
                                 "Relative_Heading_Angle [rad]",
                                 "Relative_Heading_Angle_Drive_Direction [rad]",
                                 "World_Pitch_Angle [rad]",
                                 "Road_Curvature [1/m]",
                                 "collision_ids"};

/// After esmini's columns: what a debrief needs. Controls follow, by their names in inputs files.
constexpr std::array kOwnColumns = {"World_Roll_Angle [rad]",    "road_id",   "True_Airspeed [m/s]",
                                    "Calibrated_Airspeed [m/s]", "Condition", "Engaged_Gear [-]"};

/// After the controls, in a play with a person in it.
constexpr std::array kToldColumns = {"Driven_By", "Impact_Speed [m/s]", "Impact_Closing_Speed [m/s]",
                                     "Impact_Course [rad]", "Impact_With"};

/// Returns an angle within 0 and 2π.
double turned(double angleRad)
{
    const double rest = std::fmod(angleRad, 2.0 * std::numbers::pi);
    return rest < 0.0 ? rest + 2.0 * std::numbers::pi : rest;
}

} // namespace

MotionLog::MotionLog(const std::filesystem::path& file, const Scenario& scenario,
                     const std::string& scenarioName, bool tells)
    : _file(file), _stream(_file.written(), std::ios::binary), _tells(tells)
{
    for (const ScenarioObject& object : scenario.entities)
        _boxes.push_back(object.box());
    _last.resize(_boxes.size());
    writeHeader(scenarioName, _boxes.size());
}

void MotionLog::writeHeader(const std::string& scenarioName, std::size_t count)
{
    _stream << "osgTrainer\nScenario File Name: " << scenarioName << "\nNumber of Vehicles: " << count
            << "\nIndex [-], TimeStamp [s], ";
    for (std::size_t i = 1; i <= count; ++i)
    {
        for (const char* column : kColumns)
            _stream << '#' << i << ' ' << column << ", ";
        for (const char* column : kOwnColumns)
            _stream << '#' << i << ' ' << column << ", ";
        for (const std::string_view control : kControlNames)
            _stream << '#' << i << " Input_" << control << " [-], ";
        for (const char* column : kToldColumns)
            if (_tells) _stream << '#' << i << ' ' << column << ", ";
    }
    _stream << '\n';
}

void MotionLog::add(double timeS, const std::vector<EntityState>& entities,
                    const std::vector<EntityTold>& told)
{
    const double stepS = timeS - _lastTimeS;
    _text = std::to_string(_row) + ", ";
    cell(timeS);
    for (std::size_t i = 0; i < entities.size() && i < _boxes.size(); ++i)
    {
        if (!entities[i].isPresent) continue; // it has no columns, as in esmini
        writeEntity(entities[i], _boxes[i], i, stepS);
        if (_tells) writeTold(i < told.size() ? told[i] : EntityTold());
    }
    _stream << _text << '\n';
    _lastTimeS = timeS;
    ++_row;
}

void MotionLog::writeEntity(const EntityState& state, const BoundingBox& box, std::size_t index, double stepS)
{
    Last& last = _last[index];
    const double heading = foundation::radiansOf(state.headingDeg);
    const bool hasRate = _row > 0 && stepS > 0.0;
    const glm::dvec3 acceleration = hasRate ? (state.velocity - last.velocity) / stepS : glm::dvec3(0.0);
    const double turn = foundation::wrappedRad(heading - last.headingRad);
    // The lane is the one under the entity, as in esmini.
    const RoadPlace place = state.laneUnder.value_or(state.place.value_or(RoadPlace{}));
    const double towards = place.lane > 0 ? std::numbers::pi : 0.0;
    // A quote counts at the begin of a cell only, so no blank may stand before it.
    if (foundation::needsCsvQuotes(state.name)) _text.pop_back();
    _text += foundation::csvCell(state.name) + ", " + std::to_string(index) + ", ";
    for (const double value : {state.speedMps,
                               foundation::radiansOf(state.steeringDeg),
                               turned(foundation::radiansOf(state.wheelRotationDeg)),
                               box.centre.x,
                               box.centre.y,
                               box.centre.z,
                               box.lengthM,
                               box.widthM,
                               box.heightM,
                               state.position.x,
                               state.position.y,
                               state.position.z,
                               state.velocity.x,
                               state.velocity.y,
                               state.velocity.z,
                               acceleration.x,
                               acceleration.y,
                               acceleration.z,
                               place.s,
                               place.t})
        cell(value);
    _text += std::to_string(place.lane) + ", ";
    for (const double value :
         {place.laneOffsetM, turned(heading), hasRate ? turn / stepS : 0.0, turned(place.relativeHeadingRad),
          turned(place.relativeHeadingRad - towards), foundation::radiansOf(state.pitchDeg), place.curvature})
        cell(value);
    for (const int other : state.collidesWith)
        _text += std::to_string(other) + " ";
    _text += ", ";
    writeOwn(state);
    last = {state.velocity, heading};
}

/// Empty cells: there is no such thing.
void MotionLog::writeOwn(const EntityState& state)
{
    cell(foundation::radiansOf(state.rollDeg));
    if (foundation::needsCsvQuotes(state.roadUnder)) _text.pop_back();
    _text += foundation::csvCell(state.roadUnder) + ", ";
    const VehicleReadings readings = state.readings.value_or(VehicleReadings{.condition = ""});
    cell(readings.trueAirspeedMps);
    cell(readings.calibratedAirspeedMps);
    _text += std::string(readings.condition) + ", ";
    if (readings.gear) _text += std::to_string(*readings.gear);
    _text += ", ";
    for (const std::optional<double>& control : readings.controls)
        cell(control);
}

void MotionLog::textCell(const std::string& text)
{
    // A quote counts at the begin of a cell only, so no blank may stand before it.
    if (foundation::needsCsvQuotes(text)) _text.pop_back();
    _text += foundation::csvCell(text) + ", ";
}

void MotionLog::writeTold(const EntityTold& told)
{
    textCell(told.drivenBy);
    if (!told.blow)
    {
        _text += ", , , , ";
        return;
    }
    cell(told.blow->speedMps);
    cell(told.blow->closingMps);
    cell(turned(told.blow->courseRad));
    textCell(told.blow->with);
}

void MotionLog::cell(const std::optional<double>& value)
{
    if (value) return cell(*value);
    _text += ", ";
}

void MotionLog::cell(double value)
{
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.6f, ", value);
    _text += text.data();
}

foundation::Outcome MotionLog::finish()
{
    _stream.close();
    if (!_stream)
        return foundation::Error{_file.written().string(), "cannot be written",
                                 "free space, or name another file"};
    return _file.commit();
}

} // namespace simulation
