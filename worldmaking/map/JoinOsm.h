// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include <foundation/Result.h>

#include "worldmaking/map/MapSources.h"

namespace worldmaking
{

/// What became of the objects of several files.
struct JoinReport
{
    std::size_t files = 0, objects = 0; ///< objects: those that stay
    std::size_t repeated = 0;           ///< other states of them: at seams, older ones
    std::size_t deleted = 0;            ///< by an editor or a change
    std::size_t renumbered = 0;         ///< new ones of an editor, with ids below 1
    std::size_t middles = 0;            ///< ways and relations that are a middle alone: they have no place
    bool isJoined = false;              ///< else the one file is used as it is
};

/// Makes one plain file of OpenStreetMap of several, or of one that is not plain: as editors keep it (JOSM:
/// ids below 1, deleted objects), changes (OsmChange), histories, objects in any order, nodes within ways
/// (Overpass, `out geom`); middles of ways and relations (`out center`) are passed over. Of the states of an
/// object the one of the highest version stays; with equal versions a change, then the one with more tags and
/// nodes, then the later one. New objects of two files are two.
/// `joined`: the file to write, .osm.pbf; beside it parts of archives are unpacked. Returns `joined`, or the
/// one source that is plain. Errors: a file that cannot be read, is damaged, or does not fit into memory;
/// `joined` cannot be written.
/// Memory: some 300 B an object. Source: libosmium; the OpenStreetMap wiki, *OsmChange*, *JOSM file format*.
foundation::Result<std::filesystem::path> joinOsm(const std::vector<MapSource>& sources,
                                                  const std::filesystem::path& joined, JoinReport& report);

} // namespace worldmaking
