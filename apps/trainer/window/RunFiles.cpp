// SPDX-License-Identifier: Apache-2.0
#include "window/RunFiles.h"

#include <foundation/WholeFile.h>

#include "world/SuffixedFile.h"

namespace trainer
{

namespace
{

foundation::Outcome moveAside(const std::filesystem::path& file, const std::string& suffix)
{
    std::error_code failed;
    if (file.empty() || !std::filesystem::exists(file, failed)) return foundation::success();
    std::filesystem::rename(file, withSuffix(file, suffix), failed);
    if (failed) return foundation::Error{file.string(), failed.message(), "free its folder"};
    return foundation::success();
}

} // namespace

void RunFiles::add(const simulation::ScenarioPlayer& player)
{
    _hasSteps = _hasSteps || player.timeS() > 0.0;
    if (_motionFile.empty()) return;
    if (!_log) _log.emplace(_motionFile, player.scenario(), _name, !player.told().empty());
    _log->add(player.timeS(), player.entities(), player.told());
}

foundation::Outcome RunFiles::finish(const std::optional<simulation::InputTrack>& inputs)
{
    if (_log)
    {
        const auto finished = _log->finish();
        _log.reset();
        if (!finished) return finished;
    }
    if (!inputs || inputs->rows.empty() || !_hasSteps || _inputsFile.empty()) return foundation::success();
    return foundation::writeWholeFile(_inputsFile, simulation::writeInputs(*inputs));
}

foundation::Outcome RunFiles::next(const std::optional<simulation::InputTrack>& inputs)
{
    const bool hadSteps = std::exchange(_hasSteps, false);
    if (!hadSteps)
    {
        _log.reset();
        return foundation::success();
    }
    _hasSteps = true;
    const auto written = finish(inputs);
    _hasSteps = false;
    if (!written) return written;
    const std::string suffix = "-" + std::to_string(++_runs);
    for (const auto& file : {_motionFile, _inputsFile})
        if (const auto moved = moveAside(file, suffix); !moved) return moved;
    return foundation::success();
}

} // namespace trainer
