// SPDX-License-Identifier: Apache-2.0
#include "QualifyCommand.h"

#include <cstdio>
#include <cstdlib>

#include "simulation/qualification/DriveChecks.h"
#include "simulation/qualification/FlightChecks.h"
#include "simulation/vehicle/flight/AircraftFile.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"
#include "terminal/Report.h"

namespace trainer
{

namespace
{

using simulation::AircraftData;
using simulation::QualificationCheck;
using simulation::QualificationChecks;

foundation::Result<QualificationChecks> recordedChecks(const std::shared_ptr<const AircraftData>& aircraft,
                                                       const std::filesystem::path& folder)
{
    QualificationChecks all;
    for (auto checks : {steadyFlightChecks(*aircraft, folder), responseChecks(aircraft, folder),
                        oscillationChecks(aircraft, folder)})
    {
        if (!checks) return checks.error();
        all.insert(all.end(), checks->begin(), checks->end());
    }
    return all;
}

nlohmann::ordered_json jsonOf(const QualificationCheck& check)
{
    return {{"name", check.name},           {"value", terminal::numberOrNull(check.value)},
            {"unit", check.unit},           {"expected", check.expected},
            {"tolerance", check.tolerance}, {"source", check.source},
            {"pass", check.passes()}};
}

/// Prints the figures and makes their table. `subject`: what is told of when some are missed.
terminal::Report tell(const QualificationChecks& checks, const std::string& subject)
{
    terminal::Report report;
    std::size_t missed = 0;
    report.json["checks"] = nlohmann::ordered_json::array();
    for (const QualificationCheck& check : checks)
    {
        std::printf("%s  %-58s %10.4g %-6s of %10.4g +- %.4g\n", check.passes() ? "PASS" : "FAIL",
                    check.name.c_str(), check.value, check.unit.c_str(), check.expected, check.tolerance);
        report.json["checks"].push_back(jsonOf(check));
        missed += !check.passes();
    }
    report.sound = missed == 0;
    if (missed > 0)
        std::fprintf(stderr, "trainer: %s: %zu of %zu figures are missed, see FAIL above\n", subject.c_str(),
                     missed, checks.size());
    return report;
}

foundation::Result<terminal::Report> reportOf(const QualifyRequest& request)
{
    const auto aircraft = simulation::readAircraft(request.aircraft);
    if (!aircraft) return aircraft.error();
    QualificationChecks checks = simulation::handbookChecks(*aircraft);
    const char* const data = std::getenv("OSGTRAINER_REAL_DATA");
    if (data && *data)
    {
        const auto recorded = recordedChecks(std::make_shared<const AircraftData>(*aircraft),
                                             std::filesystem::path(data) / "jsbsim/c172p-response");
        if (!recorded) return recorded.error();
        checks.insert(checks.end(), recorded->begin(), recorded->end());
    }
    else
        std::printf("no recorded flights: set OSGTRAINER_REAL_DATA to the folder of real data\n");
    return tell(checks, request.aircraft.string());
}

foundation::Result<terminal::Report> reportOf(const QualifyDriveRequest& request)
{
    QualificationChecks all;
    std::string subject;
    for (const std::filesystem::path& file : request.vehicles)
    {
        const auto read = simulation::readRoadVehicle(file);
        if (!read) return read.error();
        const auto vehicle = std::make_shared<const simulation::RoadVehicleData>(*read);
        for (const QualificationChecks& checks :
             {performanceChecks(vehicle), steeringChecks(vehicle), frictionChecks(vehicle),
              holdingChecks(vehicle, request.standsS)})
            all.insert(all.end(), checks.begin(), checks.end());
        subject += (subject.empty() ? "" : ", ") + file.string();
    }
    return tell(all, subject);
}

} // namespace

int qualifyFlight(const QualifyRequest& request)
{
    return terminal::report("trainer", request.jsonFile, [&] { return reportOf(request); });
}

int qualifyDrive(const QualifyDriveRequest& request)
{
    return terminal::report("trainer", request.jsonFile, [&] { return reportOf(request); });
}

} // namespace trainer
