// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <unistd.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "SyntheticField.h"

namespace featuretext
{

/// A folder that exists for one test.
class Folder
{
public:
    explicit Folder(const std::string& name)
        : _path(std::filesystem::temp_directory_path() /
                ("osgtrainer-" + name + "-" + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(_path);
    }
    ~Folder() { std::filesystem::remove_all(_path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& text) const
    {
        std::ofstream(_path / name) << text;
        return _path / name;
    }
    const std::filesystem::path& path() const { return _path; }

private:
    std::filesystem::path _path;
};

inline std::string coordinates(const std::vector<glm::dvec2>& points)
{
    std::string text;
    for (const glm::dvec2& point : points)
        text += (text.empty() ? "[" : ",[") + std::to_string(point.x) + "," + std::to_string(point.y) + "]";
    return text;
}

/// A GeoJSON feature; `properties` as in R"("kind":"road")".
inline std::string lineFeature(const std::string& properties, const std::vector<glm::dvec2>& points)
{
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"LineString","coordinates":[)" + coordinates(points) + "]}}";
}

inline std::string areaFeature(const std::string& properties, std::vector<glm::dvec2> ring)
{
    ring.push_back(ring.front());
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"Polygon","coordinates":[[)" + coordinates(ring) + "]]}}";
}

inline std::string collection(const std::vector<std::string>& features)
{
    std::string text;
    for (const std::string& feature : features)
        text += (text.empty() ? "" : ",\n") + feature;
    return R"({"type":"FeatureCollection","features":[)" + text + "]}";
}

inline osgTerrainROAM::core::PlacedTile planarTile()
{
    return osgTerrainROAM::core::PlacedTile(testsupport::hills(65, 65),
                                            osgTerrainROAM::core::Placement::planar);
}

/// In the Alps, at 46° north and 8° east.
inline osgTerrainROAM::core::PlacedTile curvedTile()
{
    return osgTerrainROAM::core::PlacedTile(testsupport::onTheEarth(testsupport::hills(65, 65)));
}

} // namespace featuretext
