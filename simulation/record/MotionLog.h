// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <foundation/WholeFile.h>

#include "simulation/scenario/Scenario.h"
#include "simulation/state/EntityState.h"
#include "simulation/state/EntityTold.h"

namespace simulation
{

/// Writes what the entities of a play do as a table of text: the columns of esmini's --csv_logger, one row
/// for each step, and after them bank, road, airspeeds, condition, gear and controls; a name with a comma or
/// a quote in it stands between quotes. Accelerations and the heading rate are differences between rows. The
/// angle of the wheels is in radians, as esmini has it (its header says degrees).
class MotionLog
{
public:
    /// `tells`: each entity has columns of EntityTold, too.
    MotionLog(const std::filesystem::path& file, const Scenario& scenario, const std::string& scenarioName,
              bool tells = false);

    /// Writes the row of one step. `entities`, `told`: in the order of the scenario.
    void add(double timeS, const std::vector<EntityState>& entities,
             const std::vector<EntityTold>& told = {});

    /// Puts the file in place. Errors: it could not be written.
    foundation::Outcome finish();

private:
    struct Last
    {
        glm::dvec3 velocity{0.0};
        double headingRad = 0.0;
    };

    void writeHeader(const std::string& scenarioName, std::size_t count);
    void writeEntity(const EntityState& state, const BoundingBox& box, std::size_t index, double stepS);
    void writeOwn(const EntityState& state);
    void writeTold(const EntityTold& told);
    void textCell(const std::string& text);
    void cell(double value);
    void cell(const std::optional<double>& value);

    foundation::WholeFile _file;
    std::ofstream _stream;
    std::string _text; ///< of the row that is being written
    std::vector<BoundingBox> _boxes;
    std::vector<Last> _last;
    double _lastTimeS = 0.0;
    long _row = 0;
    bool _tells = false;
};

} // namespace simulation
