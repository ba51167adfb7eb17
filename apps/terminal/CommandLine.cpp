// SPDX-License-Identifier: Apache-2.0
#include "terminal/CommandLine.h"

#include <sstream>

#include "terminal/Terminal.h"

namespace terminal
{

namespace
{

/// "play, tour, check"
std::string commandsOf(const CLI::App& app)
{
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names += (names.empty() ? "" : ", ") + command->get_name();
    return names;
}

foundation::Error explained(const CLI::App& app, const CLI::ParseError& error)
{
    const std::vector<CLI::App*> commands = app.get_subcommands();
    if (commands.empty())
    {
        const std::vector<std::string> unknown = app.remaining();
        return {unknown.empty() ? "command line" : unknown.front(),
                unknown.empty() ? "no command" : "no such command or option",
                "use one of " + commandsOf(app) + ", or " + app.get_name() + " --help"};
    }
    const std::string message = error.what();
    const std::string remedy = "see " + app.get_name() + " " + commands.front()->get_name() + " --help";
    // "--fps: Value 0 not in range" says where; "SCENARIO is required" does not.
    const std::size_t colon = message.find(": ");
    if (message.find(' ') > colon) return {message.substr(0, colon), message.substr(colon + 2), remedy};
    return {"command line", message, remedy};
}

} // namespace

std::optional<int> parse(CLI::App& app, int argc, char** argv)
{
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& error)
    {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
        fail(app.get_name(), explained(app, error));
        return kWrongUse;
    }
    return {};
}

CLI::Validator between(double least, double most)
{
    std::ostringstream range;
    range << least << " to " << most;
    const auto check = [least, most, words = range.str()](const std::string& text)
    {
        double value = 0.0;
        const bool isWithin = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
        return isWithin ? std::string() : "'" + text + "' is no number from " + words;
    };
    return CLI::Validator(check, range.str());
}

CLI::Validator extension(const std::string& dotted)
{
    const auto check = [dotted](const std::string& text)
    { return text.ends_with(dotted) ? std::string() : "'" + text + "' does not end in " + dotted; };
    return CLI::Validator(check, "*" + dotted);
}

} // namespace terminal
