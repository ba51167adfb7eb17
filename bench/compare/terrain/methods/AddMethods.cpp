// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/AddMethods.h"

#include <memory>

#include "compare/terrain/methods/MethodsRequest.h"
#include "terminal/CommandLine.h"

namespace terraintool
{

void addMethods(CLI::App& app, Chosen& chosen)
{
    CLI::App* sub = app.add_subcommand("methods", "compare all methods at equal true error");
    const auto request = std::make_shared<MethodsRequest>();
    sub->add_option("DEM", request->files, "elevation rasters")->required();
    sub->add_option("--flight", request->flight, "a scenario (.xosc) to fly")->check(CLI::ExistingFile);
    sub->add_option("--json", chosen.jsonFile, "also write the table to this file");
    sub->add_option("--html", request->html, "write a report to this file");
    sub->add_option("--markdown", request->markdown, "write its tables to this file");
    sub->add_option("--error", request->errorPx, "true error, pixels (2)")
        ->check(terminal::between(0.01, 1000.0));
    sub->add_option("--frames", request->frames, "frames of the flight (48)")->check(CLI::Range(2, 100000));
    sub->add_option("--check-every", request->framesBetweenChecks, "frames between checks (12)")
        ->check(CLI::Range(1, 100000));
    sub->add_option("--crop", request->square.crop, "SIDE [COLUMN ROW] of the square")
        ->expected(1, 3)
        ->check(CLI::Range(0, 65536));
    sub->add_option("--cell", request->square.cellM, "metres between samples")
        ->check(terminal::between(0.001, 1e5));
    sub->add_option("--spacing", request->import.spacingM, "metres between samples without georeference")
        ->check(terminal::between(0.001, 1e5));
    sub->add_option("--external", request->external, "NAME=COMMAND: adds a program that makes meshes")
        ->check([](const std::string& text)
                { return text.find('=') + 1 > 1 ? "" : "NAME=COMMAND is expected, not " + text; });
    sub->callback([request, &chosen] { chosen.work = [request] { return compareMethods(*request); }; });
}

} // namespace terraintool
