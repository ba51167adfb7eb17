// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/LayRecordings.h"

#include <algorithm>
#include <cstdio>

#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackClearance.h"
#include "simulation/track/TrackGaps.h"
#include "simulation/track/TrackGeoid.h"
#include "simulation/track/TrackTrajectory.h"

namespace simulation
{
namespace
{

using foundation::Error;

/// Lays one recording after the other, and keeps the first error.
class RecordingLayer
{
public:
    RecordingLayer(const Scenario& scenario, const RecordingPlace& place) : _scenario(scenario), _place(place)
    {
    }

    void visit(PrivateAction& action, const std::vector<std::string>& actors)
    {
        auto* const follow = std::get_if<FollowTrajectoryAction>(&action);
        if (!follow || !follow->trajectory.recording || _error) return;
        if (const auto laid = lay(*follow, actors); !laid)
            _error = Error{_place.scenario.string() + ":" + std::to_string(follow->trajectory.source.line) +
                               ", " + laid.error().place,
                           laid.error().what, laid.error().remedy};
    }

    const std::optional<Error>& error() const { return _error; }
    std::vector<std::string>& notes() { return _notes; }

private:
    foundation::Outcome lay(FollowTrajectoryAction& follow, const std::vector<std::string>& actors)
    {
        const Recording recording = *follow.trajectory.recording;
        auto reading = readTracks(_place.scenario.parent_path() / recording.file);
        if (!reading) return reading.error();
        if (reading->problemCount > 0)
            _notes.push_back(recording.file + ": " + std::to_string(reading->problemCount) +
                             " damaged records are passed over");
        for (const TrackProblem& note : reading->notes)
            _notes.push_back(recording.file + ":" + std::to_string(note.line) + ": " + note.what);
        if (auto note = countFromEllipsoid(reading->tracks)) _notes.push_back(std::move(*note));
        FlightTrack* const track = trackOf(*reading, recording.track);
        if (!track)
            return Error{recording.file, "there is no track '" + recording.track + "'",
                         "write as entryName one of: " + namesOf(*reading)};
        if (follow.timing && !track->hasTimes)
            return Error{recording.file, "the track " + track->name + " has no times",
                         "write <None/> as its TimeReference"};
        return fill(follow, *track, isAnyAirborne(actors));
    }

    static FlightTrack* trackOf(TrackReading& reading, const std::string& name)
    {
        const auto found = std::find_if(reading.tracks.begin(), reading.tracks.end(),
                                        [&](const FlightTrack& track) {
                                            return name.empty() ? track.fixes.size() > 1 : track.name == name;
                                        });
        return found == reading.tracks.end() ? nullptr : &*found;
    }

    static std::string namesOf(const TrackReading& reading)
    {
        constexpr std::size_t kTold = 10;
        std::string names;
        for (std::size_t i = 0; i < std::min(kTold, reading.tracks.size()); ++i)
            names += (i > 0 ? ", " : "") + reading.tracks[i].name;
        return names + (reading.tracks.size() > kTold ? ", …" : "");
    }

    bool isAnyAirborne(const std::vector<std::string>& actors) const
    {
        return std::any_of(actors.begin(), actors.end(),
                           [&](const std::string& actor)
                           {
                               const int entity = _scenario.entityIndex(actor);
                               return entity >= 0 &&
                                      _scenario.entities[static_cast<std::size_t>(entity)].isAirborne();
                           });
    }

    foundation::Outcome fill(FollowTrajectoryAction& follow, FlightTrack& track, bool isAirborne)
    {
        if (const auto gaps = gapsOf(track)) _notes.push_back(track.name + ": " + *gaps);
        const bool hasGround = _place.frame && _place.frame->frame() && _place.frame->hasGround();
        if (hasGround && isAirborne)
            _notes.push_back(track.name + ": " + fitToGround(track, groundHeightOf(*_place.frame)).message());
        if (!isAirborne)
            for (TrackFix& fix : track.fixes)
                fix.heightM.reset(); // it stands on the ground
        auto made = trajectoryOf(track);
        if (!made) return made.error();
        follow.trajectory.shape = std::move(made->trajectory.shape);
        if (!hasGround || !isAirborne) return foundation::success();
        const TrackClearance cleared = keepAboveGround(follow, *_place.frame);
        if (cleared.addedVertices == 0) return foundation::success();
        char text[120];
        std::snprintf(text, sizeof text,
                      ": between fixes its way went below the ground, by %.1f m at most; it was raised",
                      cleared.deepestM);
        _notes.push_back(track.name + text);
        return foundation::success();
    }

    const Scenario& _scenario;
    const RecordingPlace& _place;
    std::optional<Error> _error;
    std::vector<std::string> _notes;
};

/// Calls `visit(PrivateAction&, actors)` for every private action of a scenario that may be changed.
template<class Visit>
void visitPrivate(Storyboard& storyboard, Visit visit)
{
    for (InitPrivate& initial : storyboard.init.privates)
        for (PrivateAction& action : initial.actions)
            visit(action, std::vector<std::string>{initial.entity});
    for (Story& story : storyboard.stories)
        for (Act& act : story.acts)
            for (ManeuverGroup& group : act.groups)
                for (Maneuver& maneuver : group.maneuvers)
                    for (Event& event : maneuver.events)
                        for (NamedAction& named : event.actions)
                            if (auto* const own = std::get_if<PrivateAction>(&named.action))
                                visit(*own, group.actors);
}

} // namespace

foundation::Result<std::vector<std::string>> layRecordings(Scenario& scenario, const RecordingPlace& place)
{
    RecordingLayer layer(scenario, place);
    visitPrivate(scenario.storyboard, [&](PrivateAction& action, const std::vector<std::string>& actors)
                 { layer.visit(action, actors); });
    if (layer.error()) return *layer.error();
    return std::move(layer.notes());
}

} // namespace simulation
