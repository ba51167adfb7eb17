// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "request/PlayRequest.h"

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace trainer
{

/// The options of every command that shows pictures, as they stand in the command line. It must live as long
/// as the command.
class PlayOptions
{
public:
    void addTo(CLI::App& command);

    /// Writes into the request what the options' words mean; after the line is read.
    /// Errors: an option that --headless leaves without effect, --size that is no size, --eye-at without
    /// --eye free, an eye too high, an unknown --backend or
    /// --patch-exponent.
    foundation::Outcome complete();

    /// Returns what runs the command: complete(), checkBeforePlay(), then `work`.
    std::function<int()> running(std::function<foundation::Outcome()> work);

    PlayRequest request;

private:
    foundation::Outcome placeFreeEye();

    void addOutputOptions(CLI::App& command);
    void addFrameOptions(CLI::App& command);
    void addEyeOptions(CLI::App& command);
    void addTerrainOptions(CLI::App& command);
    void addWindowOptions(CLI::App& command);
    foundation::Outcome placeWindow();
    foundation::Outcome checkHeadless() const;

    std::string _size = "960x540";
    std::string _backend{osgOffscreen::backendName(osgOffscreen::defaultBackend())};
    std::string _eye = "own", _interior, _shadows = "on", _lights, _clouds, _metar, _ground;
    std::vector<double> _freeEye;
    std::string _patchExponent = "0";
    CLI::App* _command = nullptr;
    CLI::Option* _window = nullptr;
    CLI::Option *_samples = nullptr, *_tolerance = nullptr, *_quality = nullptr;
    std::vector<std::string> _windowPlace;
};

/// Returns the exit code of a command's work, and prints its error.
int exitCodeOf(const foundation::Outcome& outcome);

} // namespace trainer
