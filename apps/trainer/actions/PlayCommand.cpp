// SPDX-License-Identifier: Apache-2.0
#include "PlayCommand.h"

#include <iostream>
#include <variant>

#include <foundation/WholeFile.h>

#include "PlayPlaces.h"
#include "PlaySeats.h"
#include "ScenarioProblems.h"
#include "SceneTour.h"
#include "play/PlaySession.h"
#include "scene/ScenarioStage.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/writer/WriteScenario.h"
#include "terminal/Progress.h"
#include "view/HtmlReport.h"
#include "view/StatisticsFile.h"
#include "view/WatchedEntity.h"
#include "window/WindowSession.h"

namespace trainer
{

namespace
{

foundation::Outcome saveScenario(const simulation::Scenario& scenario, const std::filesystem::path& file)
{
    if (file.empty()) return foundation::success();
    const auto text = simulation::scenarioText(scenario);
    if (!text) return text.error();
    return foundation::writeWholeFile(file, *text);
}

foundation::Outcome tellInputs(const simulation::Scenario& scenario, const PlayRequest& request)
{
    if (!request.seat) return foundation::success();
    const int entity = scenario.entityIndex(request.seat->entity);
    const bool drives = entity >= 0 && !scenario.entities[static_cast<std::size_t>(entity)].isAirborne();
    return drives ? trainer::tellInputs(request.seat->inputs) : foundation::success();
}

foundation::Outcome playToTheEnd(PlaySession& session, const PlayRequest& request)
{
    const int limit =
        request.frames.count.value_or(static_cast<int>(request.longestS * request.frames.perSecond));
    terminal::Progress progress("frames", request.frames.count ? static_cast<std::size_t>(limit) : 0);
    for (int frame = 0; frame < limit && (request.frames.count || !session.isFinished()); ++frame)
    {
        if (const auto drawn = session.frame(); !drawn) return drawn;
        progress.advance();
    }
    return session.finish();
}

/// The report refers to images beside it by the names that ./demo gives them.
ReportContent reportOf(const PlaySession& session, const PlayRequest& request)
{
    ReportContent content;
    const simulation::FileHeader& header = session.player().scenario().header;
    content.title = header.description.empty() ? request.scenario.stem().string() : header.description;
    content.facts = {
        request.scenario.empty()
            ? std::pair<std::string, std::string>{"Tour over", request.terrain.file.filename().string()}
            : std::pair<std::string, std::string>{"Scenario", request.scenario.filename().string()},
        {"Simulated", std::to_string(session.statistics().size()) + " frames at " +
                          std::to_string(request.frames.perSecond) + " per second"},
        {"Picture", request.frames.viewFile.empty() ? std::to_string(request.frames.widthPx) + " x " +
                                                          std::to_string(request.frames.heightPx)
                                                    : request.frames.viewFile.filename().string()},
        {"Error target", std::to_string(request.terrain.errorTolerancePx) + " px anywhere in the picture"},
        {"Triangle ceiling", std::to_string(request.terrain.maxTriangles.value_or(kDefaultMaxTriangles))}};
    content.contactSheet = request.output.contactSheet;
    content.video = request.output.video;
    return content;
}

foundation::Outcome leaveResults(const PlaySession& session, const PlayRequest& request)
{
    if (!request.output.statsFile.empty())
        if (const auto written = writeStatistics(session.statistics(), request.terrain.opening->stages(),
                                                 request.output.statsFile);
            !written)
            return written;
    if (session.parts())
    {
        std::cout << partsText(session.parts()->costs());
        if (const auto written = writeParts(session.parts()->costs(), request.output.partsFile); !written)
            return written;
    }
    if (!request.output.reportFile.empty())
        return writeReport(reportOf(session, request), session.statistics(), request.output.reportFile);
    return foundation::success();
}

/// The request with the seat that it asks for; in a window somebody may always sit in the watched entity.
foundation::Result<PlayRequest> withSeat(const simulation::Scenario& scenario, const PlayRequest& asked)
{
    PlayRequest request = asked;
    const SeatRequest seat = asked.seat.value_or(SeatRequest());
    if (!asked.seat && !asked.window.isWanted) return request;
    std::string watched;
    if (asked.window.isWanted && asked.motions.empty())
        if (const auto entity = watchedEntity(scenario, asked.frames.eyeEntity);
            entity && *entity < scenario.entities.size())
            watched = scenario.entities[*entity].name;
    auto seated = seatFor(scenario, seat, watched);
    if (!seated) return seated.error();
    request.seat = std::move(*seated);
    request.terrain.wantsObstacles = request.seat.has_value();
    if (request.seat && request.frames.eyeEntity.empty()) request.frames.eyeEntity = request.seat->entity;
    return request;
}

/// A scenario that is read, who sits in it, and what it is played on.
struct OpenedPlay
{
    simulation::Scenario scenario;
    PlayRequest request;
    SceneTerrain terrain;
};

/// Reads the scenario of a request, and opens its stage.
foundation::Result<OpenedPlay> openPlay(const PlayRequest& asked)
{
    auto parsed =
        simulation::readScenario(asked.scenario, {.tolerant = true, .parameters = asked.parameters});
    if (!parsed) return parsed.error();
    if (const auto sound = tellProblems(parsed->problems); !sound) return sound.error();
    auto seated = withSeat(parsed->scenario, asked);
    if (!seated) return seated.error();
    if (const auto told = tellInputs(parsed->scenario, *seated); !told) return told.error();
    auto terrain = openStage(parsed->scenario, *seated);
    if (!terrain) return terrain.error();
    return OpenedPlay{std::move(parsed->scenario), std::move(*seated), std::move(*terrain)};
}

/// Lays the recordings that the scenario names over its stage.
foundation::Outcome layRecordingsOf(OpenedPlay& opened)
{
    const simulation::SceneFrame frame(opened.terrain.origin(), opened.terrain.ground());
    return tellRecordings(opened.scenario, {opened.request.scenario, &frame});
}

/// As playOver(), by a request that has its seat.
foundation::Outcome playSeated(SceneTerrain terrain, simulation::Scenario scenario,
                               const PlayRequest& request)
{
    if (request.window.isWanted)
    {
        auto window =
            WindowSession::create(std::move(scenario), std::move(terrain), request, nullptr,
                                  request.seat ? request.seat->recordInputs : std::filesystem::path());
        return window ? (*window)->run() : window.error();
    }
    auto session = PlaySession::create(std::move(scenario), std::move(terrain), request);
    if (!session) return session.error();
    tellWarnings((*session)->player());
    for (const std::string& note : (*session)->notes())
        std::cout << "note: " << note << '\n';
    if (const auto played = playToTheEnd(**session, request); !played) return played;
    for (const std::string& note : (*session)->player().notes())
        std::cout << "note: " << note << '\n';
    return leaveResults(**session, request);
}

/// Whether Init says where the sun stands, by the time of day or by itself.
bool saysSun(const simulation::Scenario& scenario)
{
    for (const simulation::GlobalAction& action : scenario.storyboard.init.globals)
        if (const auto* const sky = std::get_if<simulation::EnvironmentAction>(&action))
            if (sky->environment.timeOfDay || (sky->environment.weather && sky->environment.weather->sun))
                return true;
    return false;
}

} // namespace

foundation::Outcome playOver(SceneTerrain terrain, simulation::Scenario scenario, const PlayRequest& asked)
{
    const auto request = withSeat(scenario, asked);
    if (!request) return request.error();
    return playSeated(std::move(terrain), std::move(scenario), *request);
}

foundation::Outcome play(const PlayRequest& request)
{
    if (const auto usable = terminal::checkPlaces(placesOf(request)); !usable) return usable;
    if (!request.terrain.opening->stages().empty()) request.terrain.opening->restart();
    auto opened = openPlay(request);
    if (!opened) return opened.error();
    if (!saysSun(opened->scenario))
        std::cout << "note: the scenario has no TimeOfDay in Init; "
                  << (opened->terrain.air.sun ? "the sun stands as the world file says"
                                              : "it is 10 o'clock in June, by whole hours of longitude")
                  << '\n';
    if (const auto laid = layRecordingsOf(*opened); !laid) return laid;
    return playSeated(std::move(opened->terrain), std::move(opened->scenario), opened->request);
}

foundation::Outcome playSeatHeadless(const PlayRequest& asked, const HeadlessRequest& headless)
{
    auto opened = openPlay(asked);
    if (!opened) return opened.error();
    if (const auto laid = layRecordingsOf(*opened); !laid) return laid;
    const PlayRequest& request = opened->request;
    addWeather(opened->scenario, request);
    auto options = playerOptionsOf(opened->scenario, opened->terrain, request,
                                   simulation::FixedClock(kSeatStepsPerSecond));
    if (!options) return options.error();
    const auto seat = seatOf(*options);
    auto player = simulation::ScenarioPlayer::create(std::move(opened->scenario), std::move(*options));
    if (!player) return player.error();
    if (const auto played = playOut(**player, headless); !played || !seat) return played;
    return writeRecorded(*seat, request.seat->recordInputs, (*player)->timeS());
}

foundation::Outcome playScene(SceneTerrain terrain, simulation::Scenario scenario, const PlayRequest& request)
{
    if (const auto usable = terminal::checkPlaces(placesOf(request)); !usable) return usable;
    return playOver(std::move(terrain), std::move(scenario), request);
}

foundation::Outcome tour(const PlayRequest& request, const std::filesystem::path& saveFile, double durationS)
{
    TerrainRequest wanted = request.terrain;
    wanted.wantsObstacles = request.window.isWanted; // somebody may take over what tours
    auto terrain = openElevation(wanted.file, wanted);
    if (!terrain) return terrain.error();
    const auto laid = layTourFor(*terrain, request, durationS);
    if (!laid) return laid.error();
    if (const auto saved = saveScenario(laid->tour.scenario, saveFile); !saved) return saved;
    std::cout << laid->summary;
    return playOver(std::move(*terrain), laid->tour.scenario, request);
}

} // namespace trainer
