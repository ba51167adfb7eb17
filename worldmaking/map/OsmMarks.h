// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <set>
#include <utility>

#include <osmium/io/file.hpp>

namespace worldmaking
{

/// A type of OpenStreetMap's objects ('n', 'w', 'r') and an id.
using OsmKey = std::pair<char, std::int64_t>;

/// What an editor notes in a file of OpenStreetMap besides its objects.
struct OsmMarks
{
    bool isPlain = true;               ///< each object once, by type and id, ids above 0, none deleted
    std::set<OsmKey> deleted, changed; ///< by their attribute `action`
    std::set<OsmKey> centred;          ///< ways and relations with a middle (Overpass, `out center`)
};

/// Reads the marks of a file; of XML all of it, of other formats what its header and its objects tell. Throws
/// what libosmium throws where the file cannot be read.
/// Source: the OpenStreetMap wiki, *JOSM file format*, *OsmChange*.
OsmMarks marksOf(const osmium::io::File& file);

} // namespace worldmaking
