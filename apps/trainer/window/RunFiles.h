// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "request/PlayRequest.h"
#include "simulation/control/InputTrack.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/record/MotionLog.h"

namespace trainer
{

/// The files that a run in a window leaves: the table of motion and the inputs. A reset begins both anew;
/// those of the runs before it keep their names with -1, -2 … before the extension.
class RunFiles
{
public:
    /// Empty paths: not written.
    RunFiles(std::filesystem::path motionFile, std::filesystem::path inputsFile, std::string name)
        : _motionFile(std::move(motionFile)), _inputsFile(std::move(inputsFile)), _name(std::move(name))
    {
    }

    /// What the table of motion calls the play.
    void setName(const std::string& name) { _name = name; }

    bool recordsInputs() const { return !_inputsFile.empty(); }

    /// Takes the state before the first step, and after each.
    void add(const simulation::ScenarioPlayer& player);

    /// Writes what there is. `inputs`: what was recorded; nothing: none. Errors: a file that cannot be
    /// written.
    foundation::Outcome finish(const std::optional<simulation::InputTrack>& inputs);

    /// finish(), and the files step aside for the next run.
    foundation::Outcome next(const std::optional<simulation::InputTrack>& inputs);

private:
    std::filesystem::path _motionFile, _inputsFile;
    std::string _name;
    std::optional<simulation::MotionLog> _log;
    int _runs = 0;
    bool _hasSteps = false;
};

} // namespace trainer
