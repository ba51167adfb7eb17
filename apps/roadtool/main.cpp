// SPDX-License-Identifier: Apache-2.0
// roadtool: inspects, validates and draws OpenDRIVE networks.
#include <functional>

#include "roadtool/Commands.h"
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"

namespace
{

int run(int argc, char** argv)
{
    CLI::App app("Inspects, validates and draws road networks (OpenDRIVE 1.4 to 1.8).", "roadtool");
    app.set_version_flag("--version", OSGTRAINER_VERSION);
    app.require_subcommand(1);
    roadtool::Request request;
    std::filesystem::path jsonFile;
    std::function<foundation::Result<roadtool::Report>(const roadtool::Request&)> command;
    const auto add = [&](const char* name, const char* what, const auto& action)
    {
        CLI::App* sub = app.add_subcommand(name, what);
        sub->add_option("FILE", request.files, ".xodr files")->required();
        sub->add_option("--json", jsonFile, "also write the table to this file");
        sub->callback([&command, action] { command = action; });
        return sub;
    };
    add("info", "counts, lengths, bounds and what is not supported", roadtool::info);
    CLI::App* validate =
        add("validate", "mistakes, gaps and kinks at joints, lanes over each other", roadtool::validate);
    validate->add_flag_callback(
        "--all", [&] { request.mostLines = 0; }, "show every finding, not 20 of each kind");
    CLI::App* draw = add("draw", "the network seen from above", roadtool::draw);
    draw->add_option("--svg", request.svgFile, "write an SVG image to this file")
        ->check(terminal::extension(".svg"));
    draw->add_option("--png", request.pngFile, "write a PNG image to this file")
        ->check(terminal::extension(".png"));
    draw->add_option("--pixels", request.pixels, "pixels of the longer side (1600)")
        ->check(CLI::Range(16, 16384));
    if (const auto ends = terminal::parse(app, argc, argv)) return *ends;
    terminal::Places places{{request.svgFile, request.pngFile}, {}, {}};
    // A validation tells of each file what is wrong with it, and goes on.
    if (!validate->parsed()) places.read.assign(request.files.begin(), request.files.end());
    return terminal::report(
        "roadtool", jsonFile, [&] { return command(request); }, places);
}

} // namespace

int main(int argc, char** argv)
{
    return terminal::guarded("roadtool", [=] { return run(argc, argv); });
}
