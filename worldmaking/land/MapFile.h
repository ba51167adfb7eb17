// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <foundation/Result.h>

#include "worldmaking/map/LandMap.h"

namespace worldmaking
{

/// Writes a GeoPackage of WGS84, layer after layer. It appears under its name when finish() has succeeded, as
/// a whole. The same calls give the same bytes. Threads: one.
class MapFile
{
public:
    explicit MapFile(std::filesystem::path file);
    ~MapFile();
    MapFile(const MapFile&) = delete;
    MapFile& operator=(const MapFile&) = delete;

    /// Begins a layer; add() writes to the last one. `keys`: its attributes, all of them texts. `hasHeights`:
    /// of its points.
    void beginLayer(const std::string& name, ShapeForm form, const std::vector<std::string>& keys,
                    bool hasHeights = false);

    /// Adds a feature with the tags that the layer has attributes for. Units: degrees. `heightsM`: of each
    /// point of each path; none: 0.
    void add(const std::vector<std::vector<glm::dvec2>>& paths, const Tags& tags,
             const std::vector<std::vector<double>>& heightsM = {});

    /// Ends writing. Errors: the first that GDAL has told; a file that cannot be written.
    foundation::Outcome finish();

private:
    struct Open;
    std::filesystem::path _file, _part;
    std::unique_ptr<Open> _open;
};

} // namespace worldmaking
