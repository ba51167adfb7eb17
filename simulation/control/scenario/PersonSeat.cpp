// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/scenario/PersonSeat.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/control/ManualControllerFor.h"
#include "simulation/control/RecordedInputs.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/scenario/Scenario.h"
#include "simulation/scenario/VisitActions.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{
namespace
{

constexpr const char* kPerson = "person"; ///< the column

bool isSeat(const ScenarioObject& object)
{
    return std::holds_alternative<Vehicle>(object.object) || object.isAirborne();
}

/// The columns of a track whose names fit.
template<class Fits>
InputTrack columnsOf(const InputTrack& track, const Fits& fits)
{
    InputTrack part;
    part.stepsPerSecond = track.stepsPerSecond;
    part.isRamped = track.isRamped;
    part.end = track.end;
    for (const std::string& name : track.names)
        if (fits(name)) part.names.push_back(name);
    for (const InputTrack::Row& row : track.rows)
    {
        InputTrack::Row taken{row.at, {}};
        for (std::size_t i = 0; i < row.values.size(); ++i)
            if (fits(track.names[i])) taken.values.push_back(row.values[i]);
        part.rows.push_back(std::move(taken));
    }
    return part;
}

} // namespace

foundation::Result<std::shared_ptr<PersonSeat>> PersonSeat::create(SeatSettings settings,
                                                                   const ScenarioObject& object, World world)
{
    if (!isSeat(object))
        return foundation::Error{object.name, "is neither a vehicle nor an aircraft", "name another entity"};
    if (settings.vehicle.empty()) settings.vehicle = vehicleFileFor(object);
    std::shared_ptr<PersonSeat> seat(new PersonSeat(std::move(settings), std::move(world)));
    seat->_isAirborne = object.isAirborne();
    auto model = seat->makeVehicle();
    if (!model) return model.error();
    seat->_model = std::move(*model);
    if (const bool flies = !dynamic_cast<const RoadVehicle*>(seat->_model.get()); flies != seat->_isAirborne)
        return foundation::Error{seat->_settings.vehicle.string(),
                                 std::string(flies ? "is an aircraft, but " : "is a road vehicle, but ") +
                                     object.name + (flies ? " drives" : " flies"),
                                 "give the data file of another"};
    if (const auto manual = manualControllerFor(*seat->_model); !manual) return manual.error();
    seat->_isAsked = seat->_settings.isTakenAtStart;
    if (const auto read = seat->readInputsFile(); !read) return read.error();
    const InputRecorder recorder(*seat->_model);
    seat->_record = recorder.track();
    seat->_record.names.insert(seat->_record.names.begin(), kPerson);
    return seat;
}

foundation::Outcome PersonSeat::readInputsFile()
{
    if (_settings.inputs.empty()) return foundation::success();
    auto read = readInputs(_settings.inputs);
    if (!read) return read.error();
    const auto isPerson = [](const std::string& name) { return name == kPerson; };
    _inputs = columnsOf(*read, std::not_fn(isPerson));
    InputTrack person = columnsOf(*read, isPerson);
    if (!person.names.empty())
    {
        person.isRamped = false;
        _person = std::move(person);
    }
    const auto usable = RecordedInputs::create(*_inputs, *_model, _settings.inputs.string());
    return usable ? foundation::success() : foundation::Outcome(usable.error());
}

foundation::Result<std::unique_ptr<DynamicVehicle>> PersonSeat::makeVehicle() const
{
    return openVehicle(_settings.vehicle, _world.origin, _settings.seed);
}

std::int64_t PersonSeat::stepAt(double timeS) const
{
    return std::llround(timeS / _model->stepSeconds());
}

/// Where a time of the play stands in the inputs.
double PersonSeat::placeOf(double timeS) const
{
    return _inputs->placeOf(stepAt(timeS), _model->stepSeconds());
}

std::string PersonSeat::giveToPerson(bool isByHand)
{
    if (!isByHand && _motion && _motion->vehicle().vehicle().status().condition != VehicleCondition::sound)
        return "it is not sound any more; BackSpace begins again";
    _refusal.clear();
    _hasHand = isByHand;
    if (!isByHand && !_inputs) _isAsked = false;
    if (_motion && _inputs) _controls->giveToPerson(isByHand);
    return {};
}

void PersonSeat::ask(bool isTaken)
{
    _refusal.clear();
    _isAsked = isTaken;
    if (!isTaken) _hasHand = false;
}

bool PersonSeat::isWanted(double timeS) const
{
    if (_motion && _motion->vehicle().vehicle().status().condition != VehicleCondition::sound) return true;
    if (!_refusal.empty()) return false;
    if (_hasHand) return true;
    if (!_person) return _isAsked;
    double value = 0.0;
    _person->valuesAt(placeOf(timeS), {&value, 1});
    return value >= 0.5;
}

foundation::Result<std::unique_ptr<VehicleController>> PersonSeat::makeControls(const DynamicVehicle& vehicle,
                                                                                std::int64_t firstStep) const
{
    auto manual = manualControllerFor(vehicle);
    if (!manual) return manual.error();
    std::unique_ptr<VehicleController> recorded;
    if (_inputs)
    {
        auto inputs = RecordedInputs::create(*_inputs, vehicle, _settings.inputs.string(), firstStep);
        if (!inputs) return inputs.error();
        recorded = std::make_unique<RecordedInputs>(std::move(*inputs));
    }
    return std::unique_ptr<VehicleController>(
        std::make_unique<ControlSwitch>(std::move(recorded), std::move(*manual), _hasHand || !_inputs));
}

foundation::Result<std::shared_ptr<ExternalMotion>> PersonSeat::take(const ScenarioObject& object,
                                                                     const MotionStart& start)
{
    auto vehicle = makeVehicle();
    if (!vehicle) return vehicle.error();
    (*vehicle)->meet(_world.obstacles);
    auto controls = makeControls(**vehicle, stepAt(start.timeS));
    if (!controls) return controls.error();
    auto* const seat = static_cast<ControlSwitch*>(controls->get());
    auto driven = std::make_unique<ControlledVehicle>(std::move(*vehicle), std::move(*controls));
    if (_settings.isRecorded) driven->record();
    auto motion = std::make_shared<VehicleMotion>(std::move(driven), _world.ground,
                                                  std::make_shared<const WeatherAir>());
    motion->followWeather(_world.origin ? _world.origin->heightM : 0.0, 0.0);
    const auto* const towing = std::get_if<Vehicle>(&object.object);
    motion->meetOthers(towing ? towing->trailerEntity : std::string());
    if (auto begun = motion->begin(start.state, start.isAirborne, start.timeS, start.environment); !begun)
        return begun.error();
    _motion = std::move(motion);
    _controls = seat;
    _firstStep = stepAt(start.timeS);
    return std::shared_ptr<ExternalMotion>(_motion);
}

/// What the motion of now has done, behind what those before it did.
void PersonSeat::addRows(InputTrack& track) const
{
    const InputRecorder* const recorder = _motion ? _motion->vehicle().recorder() : nullptr;
    if (!recorder) return;
    for (const InputTrack::Row& row : recorder->track().rows)
    {
        InputTrack::Row added{row.at + static_cast<double>(_firstStep), {1.0}};
        added.values.insert(added.values.end(), row.values.begin(), row.values.end());
        if (!track.rows.empty() && track.rows.back().at == added.at) track.rows.pop_back();
        track.rows.push_back(std::move(added));
    }
}

void PersonSeat::leave(double timeS)
{
    addRows(_record);
    std::vector<double> values(_record.names.size(), kInputNotGiven);
    values.front() = 0.0;
    const auto at = static_cast<double>(stepAt(timeS));
    if (!_record.rows.empty() && _record.rows.back().at == at) _record.rows.pop_back();
    _record.rows.push_back({at, std::move(values)});
    _motion.reset();
    _controls = nullptr;
}

InputTrack PersonSeat::recorded(double timeS) const
{
    InputTrack track = _record;
    addRows(track);
    if (track.rows.empty() || track.rows.front().at > 0.0)
    {
        std::vector<double> values(track.names.size(), kInputNotGiven);
        values.front() = 0.0;
        track.rows.insert(track.rows.begin(), {0.0, std::move(values)});
    }
    track.end = static_cast<double>(stepAt(timeS));
    return track;
}

void PersonSeat::refuse(const foundation::Error& error)
{
    _refusal = error.message();
    _hasHand = false;
    _motion.reset();
    _controls = nullptr;
}

bool PersonSeat::isDone(double timeS) const
{
    return _inputs && !_hasHand && _inputs->end && placeOf(timeS) >= *_inputs->end;
}

foundation::Result<std::size_t> seatIn(const Scenario& scenario, const std::string& entity)
{
    std::string names;
    for (std::size_t i = 0; i < scenario.entities.size(); ++i)
    {
        const ScenarioObject& object = scenario.entities[i];
        if (!isSeat(object)) continue;
        if (object.name == entity) return i;
        names += (names.empty() ? "" : ", ") + object.name;
    }
    const bool isThere = scenario.entityIndex(entity) >= 0;
    return foundation::Error{"--drive",
                             isThere ? "'" + entity + "' is neither a vehicle nor an aircraft"
                                     : "there is no entity '" + entity + "'",
                             names.empty() ? "the scenario has none to drive" : "write one of: " + names};
}

std::optional<std::size_t> manualEntity(const Scenario& scenario)
{
    std::optional<std::size_t> first;
    const auto look = [&](int entity, const Controller& controller)
    {
        if (entity < 0 || !controller.isManual()) return;
        const auto index = static_cast<std::size_t>(entity);
        if (isSeat(scenario.entities[index])) first = std::min(first.value_or(index), index);
    };
    for (int i = 0; i < static_cast<int>(scenario.entities.size()); ++i)
        for (const Controller& controller : scenario.entities[static_cast<std::size_t>(i)].controllers)
            look(i, controller);
    const auto lookAt = [&](const std::string& actor, const PrivateAction& action)
    {
        if (const auto* const assigned = std::get_if<AssignControllerAction>(&action))
            look(scenario.entityIndex(actor), assigned->controller);
    };
    for (const InitPrivate& initial : scenario.storyboard.init.privates)
        for (const PrivateAction& action : initial.actions)
            lookAt(initial.entity, action);
    visitGroups(scenario,
                [&](const ManeuverGroup& group, const Action& action)
                {
                    if (const auto* const own = std::get_if<PrivateAction>(&action))
                        for (const std::string& actor : group.actors)
                            lookAt(actor, *own);
                });
    return first;
}

} // namespace simulation
