// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/SignalProgrammes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <foundation/Angle.h>

#include "simulation/road/FootLights.h"
#include "simulation/road/LightApproaches.h"

namespace simulation
{
namespace
{

constexpr double kRedAmberS = 1.0, kLeastGreenS = 10.0;
constexpr double kWalkS = 15.0; ///< of people on foot alone: 8 m of road at 1.2 m/s, and as long to begin
constexpr double kWalkMps = 1.2, kLeastWalkS = 5.0;
constexpr double kSpreadS = 17.0; ///< from one controller to the next: they do not all change at once

/// Those who have green together. Empty: people on foot.
using SignalStage = std::vector<const LightApproach*>;

double yellowS(const SignalStage& stage)
{
    constexpr double kUpTo50Mps = 14.0, kUpTo60Mps = 16.8;
    double limitMps = 0.0;
    for (const LightApproach* const approach : stage)
        limitMps = std::max(limitMps, approach->limitMps);
    return limitMps < kUpTo50Mps ? 3.0 : limitMps < kUpTo60Mps ? 4.0 : 5.0;
}

bool shareLight(const LightApproach& a, const LightApproach& b)
{
    return std::any_of(a.lights.begin(), a.lights.end(),
                       [&](const std::string& light)
                       { return std::find(b.lights.begin(), b.lights.end(), light) != b.lights.end(); });
}

/// The programme of the lights of one place.
class PlaceProgramme
{
public:
    PlaceProgramme(JunctionTable& table, const std::vector<const LightApproach*>& approaches,
                   std::vector<FootLight> people)
        : _table(table), _approaches(approaches), _people(std::move(people))
    {
        formStages();
        if (_stages.size() == 1) _stages.emplace_back();
        for (const FootLight& light : _people)
            _walkS = std::max(_walkS, kLeastWalkS + std::ceil(light.wideM / kWalkMps));
    }

    std::vector<SignalPhase> phases() const
    {
        const std::size_t count = _stages.size();
        std::vector<double> betweenS;
        double restS = std::min(60.0 + 15.0 * static_cast<double>(count - 2), 90.0);
        for (std::size_t i = 0; i < count; ++i)
        {
            betweenS.push_back(secondsBetween(_stages[i], _stages[(i + 1) % count]));
            restS -= betweenS.back() + (_stages[i].empty() ? _walkS : 0.0);
        }
        const auto driven = std::count_if(_stages.begin(), _stages.end(),
                                          [](const SignalStage& stage) { return !stage.empty(); });
        const double greenS = std::max(kLeastGreenS, std::floor(restS / static_cast<double>(driven)));
        std::vector<SignalPhase> phases;
        for (std::size_t i = 0; i < count; ++i)
        {
            const SignalStage &stage = _stages[i], &next = _stages[(i + 1) % count];
            const std::string number = std::to_string(i + 1);
            const double clearS = betweenS[i] - (stage.empty() ? 0.0 : yellowS(stage)) - kRedAmberS;
            addGreen(number, stage.empty() ? _walkS : greenS, stage, betweenS[i], phases);
            if (!stage.empty()) phases.push_back(phase("yellow " + number, yellowS(stage), stage, "yellow"));
            if (clearS > 0.0) phases.push_back(phase("red " + number, clearS, {}, ""));
            phases.push_back(phase("attention " + number, kRedAmberS, next, "attention"));
        }
        return phases;
    }

private:
    /// People who may cross go with the stage; they have red so early that the last one has crossed when
    /// the next stage begins.
    void addGreen(const std::string& number, double greenS, const SignalStage& stage, double betweenS,
                  std::vector<SignalPhase>& phases) const
    {
        double clearS = 0.0;
        std::vector<std::string> crossing;
        for (const FootLight& light : _people)
        {
            const double ownClearS = std::max(std::ceil(light.wideM / kWalkMps - betweenS), 0.0);
            const bool mayCross = std::all_of(stage.begin(), stage.end(),
                                              [&](const LightApproach* approach)
                                              { return goesWith(light, *approach, _table); });
            if (!mayCross || greenS - ownClearS < kLeastWalkS) continue;
            crossing.push_back(light.light);
            clearS = std::max(clearS, ownClearS);
        }
        phases.push_back(phase("green " + number, greenS - clearS, stage, "green"));
        for (auto& [light, state] : phases.back().states)
            if (std::find(crossing.begin(), crossing.end(), light) != crossing.end()) state = "green";
        if (clearS > 0.0) phases.push_back(phase("green " + number + " cleared", clearS, stage, "green"));
    }

    SignalPhase phase(const std::string& name, double durationS, const SignalStage& stage,
                      const std::string& word) const
    {
        SignalPhase made{name, durationS, {}};
        for (const LightApproach* const approach : _approaches)
        {
            const bool isOn = std::find(stage.begin(), stage.end(), approach) != stage.end();
            for (const std::string& light : approach->lights)
                if (std::none_of(made.states.begin(), made.states.end(),
                                 [&](const auto& state) { return state.first == light; }))
                    made.states.emplace_back(light, isOn ? word : "red");
        }
        for (const FootLight& light : _people)
            made.states.emplace_back(light.light, "red");
        return made;
    }

    /// Each one joins the first stage in which it meets nobody.
    void formStages()
    {
        std::vector<bool> isDone(_approaches.size(), false);
        for (std::size_t i = 0; i < _approaches.size(); ++i)
        {
            if (isDone[i]) continue;
            SignalStage& stage = _stages.emplace_back(SignalStage{_approaches[i]});
            for (std::size_t j = i + 1; j < _approaches.size(); ++j)
            {
                const bool mayJoin =
                    std::all_of(stage.begin(), stage.end(),
                                [&](const LightApproach* of) { return areCompatible(*of, *_approaches[j]); });
                const bool mustJoin =
                    std::any_of(stage.begin(), stage.end(),
                                [&](const LightApproach* of) { return shareLight(*of, *_approaches[j]); });
                if (isDone[j] || (!mayJoin && !mustJoin)) continue;
                stage.push_back(_approaches[j]);
                isDone[j] = true;
            }
        }
    }

    bool areCompatible(const LightApproach& a, const LightApproach& b) const
    {
        constexpr double kFacingRad = 2.5;
        if (a.junction < 0) return true;
        // Who turns across the way of others lets them pass.
        if (std::abs(foundation::wrappedRad(a.headingRad - b.headingRad)) > kFacingRad) return true;
        for (const LightLane& one : a.lanes)
            for (const LightLane& other : b.lanes)
                if (_table.conflict(one.lane, other.lane)) return false;
        return true;
    }

    /// From the end of a green to the begin of the next one.
    double secondsBetween(const SignalStage& ends, const SignalStage& begins) const
    {
        if (ends.empty()) return kRedAmberS;
        double most = 0.0;
        for (const LightApproach* const a : ends)
            for (const LightApproach* const b : begins)
                most = std::max(most, clearsAfterS(*a, *b));
        return std::max(yellowS(ends) + kRedAmberS, std::ceil(most));
    }

    /// Negative: they do not meet.
    double clearsAfterS(const LightApproach& ends, const LightApproach& begins) const
    {
        constexpr double kTurnRad = 0.5, kEntersMps = 40.0 / 3.6;
        constexpr double kAxleM = 3.5; ///< from the front of a car to its rear axle
        double most = -1.0;
        for (const LightLane& one : ends.lanes)
            for (const LightLane& other : begins.lanes)
            {
                const LaneConflict* const meet = _table.conflict(one.lane, other.lane);
                if (!meet) continue;
                const bool turns = std::abs(_table.turnRad(one.lane)) > kTurnRad;
                const double clearM = ends.lineM + kAxleM + one.startM + meet->ownToM;
                const double enterM = std::max(0.0, begins.lineM + kAxleM + other.startM + meet->otherFromM);
                most =
                    std::max(most, (turns ? 2.0 : 3.0) + clearM / (turns ? 7.0 : 10.0) - enterM / kEntersMps);
            }
        return most;
    }

    JunctionTable& _table;
    std::vector<const LightApproach*> _approaches;
    std::vector<FootLight> _people;
    std::vector<SignalStage> _stages;
    double _walkS = kWalkS;
};

/// Those of one place among the lights for people on foot.
std::vector<FootLight> peopleAt(const std::vector<FootLight>& lights, int place)
{
    std::vector<FootLight> people;
    std::copy_if(lights.begin(), lights.end(), std::back_inserter(people),
                 [&](const FootLight& light) { return light.place == place; });
    return people;
}

} // namespace

std::vector<TrafficSignalController> signalProgrammes(const RoadScene& roads)
{
    const std::vector<LightApproach> approaches = lightApproaches(roads);
    const osgRoads::core::RoadNetwork& network = roads.network();
    const std::vector<FootLight> people = footLights(roads, approaches);
    JunctionTable table(roads);
    std::vector<TrafficSignalController> controllers;
    for (std::size_t first = 0; first < approaches.size();)
    {
        std::vector<const LightApproach*> ofPlace{&approaches[first]};
        std::size_t next = first + 1;
        for (; next < approaches.size() && approaches[first].place == approaches[next].place; ++next)
            ofPlace.push_back(&approaches[next]);
        TrafficSignalController controller;
        const LightApproach& of = approaches[first];
        controller.name = of.junction >= 0 ? "lights of junction " +
                                                 network.junctions[static_cast<std::size_t>(of.junction)].id
                                           : "light " + of.lights.front();
        controller.phases = PlaceProgramme(table, ofPlace, peopleAt(people, of.place)).phases();
        controller.delayS = kSpreadS * static_cast<double>(controllers.size());
        controllers.push_back(std::move(controller));
        first = next;
    }
    return controllers;
}

} // namespace simulation
