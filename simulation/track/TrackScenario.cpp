// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackScenario.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "simulation/track/TrackClearance.h"
#include "simulation/track/TrackEntity.h"
#include "simulation/track/TrackGaps.h"
#include "simulation/track/TrackGeoid.h"
#include "simulation/track/TrackMotion.h"
#include "simulation/track/TrackTrajectory.h"

namespace simulation
{
namespace
{

constexpr double kFirstDateS = 3.15e8; ///< 1980: smaller times are seconds of a recording without a date
constexpr double kStandS = 10.0;       ///< what a recording is shown for in which nothing moves
constexpr double kLateS = 1.0;         ///< what begins later than the recording is added by an event

bool flies(TrackKind kind)
{
    return kind == TrackKind::aircraft || kind == TrackKind::helicopter;
}

/// 0 for what flies, 1 for what moves, 2 for the others.
int rankOf(const FlightTrack& track)
{
    constexpr double kMovesM = 10.0;
    if (track.fixes.size() < 2 || lengthOf(track) < kMovesM) return 2;
    return flies(track.kind) ? 0 : 1;
}

Condition timeReached(double timeS)
{
    return {{},
            "at " + std::to_string(timeS) + " s",
            0.0,
            ConditionEdge::none,
            SimulationTimeCondition{timeS, Rule::greaterOrEqual}};
}

Event eventAt(const std::string& name, double timeS, std::vector<NamedAction> actions)
{
    Event event;
    event.name = name;
    event.actions = std::move(actions);
    event.startTrigger = Trigger{{}, {ConditionGroup{{timeReached(timeS)}}}};
    return event;
}

Position placeOf(const TrackFix& fix)
{
    GeoPosition position;
    position.latitudeDeg = fix.latitudeDeg;
    position.longitudeDeg = fix.longitudeDeg;
    position.heightM = fix.heightM;
    return position;
}

/// Puts one track after the other into a scenario.
class TrackScenarioBuilder
{
public:
    TrackScenarioBuilder(const SceneFrame& frame, double beginS) : _frame(frame), _beginS(beginS) {}

    void add(const FlightTrack& track)
    {
        const ScenarioObject entity = entityOf(track.kind, track.name);
        auto follow = trajectoryOf(track);
        if (!follow) // one fix: it stands there
        {
            _made.scenario.storyboard.init.privates.push_back(
                {{}, track.name, {TeleportAction{{}, placeOf(track.fixes.front())}}});
            _made.scenario.entities.push_back(entity);
            return;
        }
        if (entity.isAirborne() && _frame.hasGround()) clear(track, *follow);
        _made.scenario.entities.push_back(entity);
        track.hasTimes ? addTimed(track, std::move(*follow)) : addUntimed(track, std::move(*follow));
    }

    bool isEmpty() const { return _made.scenario.entities.empty(); }

    TrackScenario finish()
    {
        if (!(_made.durationS > 0.0)) _made.durationS = kStandS;
        if (!_story.acts.empty()) _made.scenario.storyboard.stories.push_back(std::move(_story));
        _made.scenario.storyboard.stopTrigger = Trigger{{}, {ConditionGroup{{timeReached(_made.durationS)}}}};
        return std::move(_made);
    }

private:
    void clear(const FlightTrack& track, FollowTrajectoryAction& follow)
    {
        const TrackClearance done = keepAboveGround(follow, _frame);
        if (done.addedVertices == 0) return;
        char text[200];
        std::snprintf(
            text, sizeof text,
            ": between fixes the way went below the ground, by %.1f m at most; %zu places were added on it",
            done.deepestM, done.addedVertices);
        _made.notes.push_back(track.name + text);
    }

    void addTimed(const FlightTrack& track, FollowTrajectoryAction follow)
    {
        const double beginS = track.fixes.front().timeS - _beginS;
        const double endS = track.fixes.back().timeS - _beginS;
        _made.durationS = std::max(_made.durationS, endS);
        Maneuver maneuver;
        maneuver.name = track.name;
        if (beginS > kLateS)
        {
            NamedAction add{
                {}, "add", GlobalAction{EntityAction{{}, track.name, false, placeOf(track.fixes.front())}}};
            NamedAction fly{{}, "follow", PrivateAction{std::move(follow)}};
            maneuver.events.push_back(eventAt("begin", beginS, {std::move(add), std::move(fly)}));
        }
        else
        {
            follow.timing->offsetS = beginS;
            _made.scenario.storyboard.init.privates.push_back({{}, track.name, {std::move(follow)}});
        }
        if (track.endS && *track.endS > _beginS)
        {
            NamedAction remove{{}, "delete", GlobalAction{EntityAction{{}, track.name, true, {}}}};
            maneuver.events.push_back(eventAt("end", *track.endS - _beginS, {std::move(remove)}));
        }
        if (maneuver.events.empty()) return;
        if (_story.acts.empty())
        {
            _story.name = "recording";
            _story.acts.push_back({});
            _story.acts.front().name = "recording";
        }
        _story.acts.front().groups.push_back({{}, track.name, 1, false, {track.name}, {std::move(maneuver)}});
    }

    void addUntimed(const FlightTrack& track, FollowTrajectoryAction follow)
    {
        const double speed = defaultSpeedMps(track.kind);
        _made.durationS = std::max(_made.durationS, lengthOf(track) / speed);
        char text[100];
        std::snprintf(text, sizeof text, ": has no times; it is followed at %.1f m/s", speed);
        _made.notes.push_back(track.name + text);
        _made.scenario.storyboard.init.privates.push_back(
            {{}, track.name, {std::move(follow), SpeedAction{{}, {}, AbsoluteTargetSpeed{speed}}}});
    }

    const SceneFrame& _frame;
    double _beginS;
    Story _story;
    TrackScenario _made;
};

/// Leaves out what is no body.
void dropMarks(std::vector<FlightTrack>& tracks, std::vector<std::string>& notes)
{
    const std::size_t marks =
        std::erase_if(tracks, [](const FlightTrack& track) { return track.kind == TrackKind::mark; });
    if (marks > 0) notes.push_back(std::to_string(marks) + " objects that are no bodies are left out");
}

/// Fits each track to the ground, and tells what was done.
void fitTracks(std::vector<FlightTrack>& tracks, const foundation::HeightOnEarth& ground, bool isMadeGround,
               std::vector<std::string>& notes)
{
    for (FlightTrack& track : tracks)
    {
        const auto outside =
            std::count_if(track.fixes.begin(), track.fixes.end(),
                          [&](const TrackFix& fix) { return !ground(fix.latitudeDeg, fix.longitudeDeg); });
        const TrackHeights done = fitToGround(track, ground, 0.0, !isMadeGround);
        track.kind = kindByMotion(track, ground, isMadeGround);
        notes.push_back(track.name + ": " + std::to_string(track.fixes.size()) + " fixes, " + done.message());
        if (const auto gaps = gapsOf(track)) notes.push_back(track.name + ": " + *gaps);
        if (outside > 0)
            notes.push_back(track.name + ": " + std::to_string(outside) + " of them are outside the terrain");
    }
}

/// Without ground heights stay; those above the ground count from `levelM`, the sea at the scene's origin.
void leaveTracks(std::vector<FlightTrack>& tracks, double levelM, std::vector<std::string>& notes)
{
    for (FlightTrack& track : tracks)
    {
        double lowM = levelM;
        for (TrackFix& fix : track.fixes)
        {
            const bool isAboveGround = fix.datum.value_or(track.datum) == HeightDatum::ground;
            if (isAboveGround || !fix.heightM) fix.heightM = levelM + fix.heightM.value_or(0.0);
            lowM = &fix == &track.fixes.front() ? *fix.heightM : std::min(lowM, *fix.heightM);
            fix.datum.reset();
        }
        track.kind = kindByMotion(
            track, [&](double, double) { return std::optional(lowM); }, true);
        notes.push_back(track.name + ": " + std::to_string(track.fixes.size()) + " fixes, heights above " +
                        nameOf(track.datum));
        if (const auto gaps = gapsOf(track)) notes.push_back(track.name + ": " + *gaps);
        track.datum = HeightDatum::ellipsoid;
    }
}

foundation::Outcome checkCover(const std::vector<FlightTrack>& tracks,
                               const foundation::HeightOnEarth& ground, const std::string& sceneFile)
{
    for (const FlightTrack& track : tracks)
        for (const TrackFix& fix : track.fixes)
            if (ground(fix.latitudeDeg, fix.longitudeDeg)) return foundation::success();
    char text[200];
    const TrackFix& first = tracks.front().fixes.front();
    std::snprintf(
        text, sizeof text,
        "does not lie below the recording, which begins at %.4f degrees of latitude, %.4f of longitude",
        first.latitudeDeg, first.longitudeDeg);
    return foundation::Error{sceneFile, text, "give --terrain a file of that place"};
}

} // namespace

foundation::Result<TrackScenario> scenarioOf(std::vector<FlightTrack> tracks, const SceneFrame& frame,
                                             const TrackScenarioOptions& options)
{
    std::vector<std::string> notes;
    if (auto note = countFromEllipsoid(tracks)) notes.push_back(std::move(*note));
    if (frame.hasGround())
    {
        const foundation::HeightOnEarth ground = groundHeightOf(frame);
        if (const auto covered = checkCover(tracks, ground, options.sceneFile); !covered)
            return covered.error();
        dropMarks(tracks, notes);
        fitTracks(tracks, ground, options.isMadeGround, notes);
    }
    else
    {
        dropMarks(tracks, notes);
        leaveTracks(tracks, frame.frame()->geodeticFromLocal({0.0, 0.0, 0.0}).heightM, notes);
    }
    if (tracks.empty())
        return foundation::Error{options.description, "holds nothing that can be shown",
                                 "name another recording"};
    std::stable_sort(tracks.begin(), tracks.end(),
                     [](const FlightTrack& a, const FlightTrack& b) { return rankOf(a) < rankOf(b); });
    double firstS = 1e300;
    for (const FlightTrack& track : tracks)
        if (track.hasTimes) firstS = std::min(firstS, track.fixes.front().timeS);
    if (firstS == 1e300) firstS = 0.0;
    const double beginS = firstS + options.startS;
    TrackScenarioBuilder builder(frame, beginS);
    for (const FlightTrack& track : tracks)
        if (!track.hasTimes || track.fixes.back().timeS > beginS ||
            (track.fixes.size() == 1 && options.startS == 0.0))
            builder.add(track);
    if (builder.isEmpty())
        return foundation::Error{"--start", "the recording is over by then",
                                 "give a smaller number of seconds"};
    TrackScenario made = builder.finish();
    made.scenario.header = {1, 3, "2024-01-01T00:00:00", "osgTrainer", options.description};
    made.scenario.roadNetwork.sceneGraphFile = options.sceneFile;
    if (firstS > kFirstDateS)
    {
        Environment environment;
        environment.name = "recording";
        environment.timeOfDay =
            TimeOfDay{DateTime{static_cast<std::int64_t>(std::llround(1000.0 * beginS))}, true};
        made.scenario.storyboard.init.globals.push_back(EnvironmentAction{{}, std::move(environment)});
    }
    made.notes.insert(made.notes.begin(), notes.begin(), notes.end());
    return made;
}

} // namespace simulation
