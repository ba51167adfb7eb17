// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec3.hpp>

namespace simulation
{

/// Where an entity is in one row of a table of motion. Units: metres, radians, m/s.
struct MotionSample
{
    glm::dvec3 position{0.0};
    double headingRad = 0.0;
    double speedMps = 0.0;
    int lane = 0;                    ///< lane_id; 0 where the table has none
    bool collides = false;           ///< with any other entity
    std::optional<double> rollRad{}; ///< positive right side down; nothing: the table does not tell
};

struct MotionTrack
{
    std::string entity;
    std::vector<std::optional<MotionSample>>
        samples; ///< one for each row; nothing where the entity is not there
};

/// A table of motion: what the entities of a play did, row by row.
struct MotionTable
{
    std::vector<double> timeS; ///< ascending
    std::vector<MotionTrack> tracks;

    /// Returns the track of an entity, or nullptr.
    const MotionTrack* find(const std::string& entity) const;
};

/// Reads a table as `trainer play --csv_logger` writes it and esmini does: lines of text, then a line that
/// begins with `Index` and names the columns of each entity, then rows. The file may be compressed by gzip.
/// Errors, as file:line: not readable, no such header, a column missing, a cell that is no number, times that
/// fall.
foundation::Result<MotionTable> readMotionTable(const std::filesystem::path& file);

/// Reads the text of a table. `name`: for errors.
foundation::Result<MotionTable> parseMotionTable(const std::string& text, const std::string& name);

} // namespace simulation
