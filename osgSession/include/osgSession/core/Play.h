// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgSession/core/PlayState.h>

namespace osgSession::core
{

/// A scenario and how it is stepped.
struct PlaySettings
{
    std::filesystem::path scenario;                  ///< OpenSCENARIO XML
    std::map<std::string, std::string> parameters{}; ///< values in place of the scenario's
    int stepsPerSecond = 120;
    std::uint64_t seed = 0; ///< of what is left to chance: traffic, random routes, turbulence

    /// Entities that the host drives by set(), each with the data file of its vehicle
    /// (docs/reference/road-vehicle-file.md, docs/reference/aircraft-file.md).
    std::map<std::string, std::filesystem::path> driven{};

    bool isWithoutRoads = false; ///< a scenario whose LogicFile is not there is played without roads
};

/// A scenario that a host steps: it reads states and events, and drives entities. Nothing is printed, and no
/// state is shared: any number of plays may live in one process.
/// Determinism: the states depend on the scenario, the settings, the number of steps and on set() between
/// them. Threads: one play, one thread at a time.
/// Source: ASAM, *OpenSCENARIO XML* 1.3; what of it is played: docs/reference/openscenario.md.
class Play
{
public:
    /// Opens a scenario over its road network; without one, over level ground. The states are those of time
    /// 0. Errors, with file and line: a scenario, a network or a vehicle that cannot be used or is not
    /// there; a driven entity that the scenario has not.
    static foundation::Result<std::unique_ptr<Play>> open(const PlaySettings& settings);

    ~Play();
    Play(const Play&) = delete;
    Play& operator=(const Play&) = delete;

    /// Makes one step. Returns false, and stays where it is, once isFinished().
    bool step();

    double timeS() const;
    double stepS() const;

    /// The stop trigger has come, or all stories are complete.
    bool isFinished() const;

    /// In the order of the scenario.
    std::vector<Entity> entities() const;

    /// Errors: there is no entity of that name.
    foundation::Result<Entity> entity(const std::string& name) const;

    /// The names of what moves a driven entity: throttle, brake, steering …; empty: the host does not drive
    /// it.
    std::vector<std::string> inputs(const std::string& entity) const;

    /// Puts an input of a driven entity; it stays there. A number outside the range of the input counts as
    /// the nearest in it. Errors: an entity that is not driven, an input that it has not, NaN; each names
    /// what there is.
    foundation::Outcome set(const std::string& entity, const std::string& input, double value);

    /// Returns what has happened since the last call.
    std::vector<Event> takeEvents();

    /// What a person should know: content that is passed over, a crash. One line each.
    std::vector<std::string> notes() const;

    class Parts;
    explicit Play(std::unique_ptr<Parts> parts); ///< for osgSession::Session

private:
    std::unique_ptr<Parts> _parts;
};

} // namespace osgSession::core
