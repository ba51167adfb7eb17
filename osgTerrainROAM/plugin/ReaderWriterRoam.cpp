// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <system_error>

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>

#include <osgTerrainROAM/RoamTechnique>
#include <osgTerrainROAM/RoamTerrain>
#include <osgTraversal/NodeReader>

namespace
{

/// osgDB's way to our terrains. An existing file that ends in .roam is a text that describes one; of any
/// other name the suffix is taken off and the rest opened as elevation raster: osgviewer dem.tif.roam,
/// osgviewer /vsigzip/dem.hgt.gz.roam. What GDAL does not know and osgDB does is a database: its osgTerrain
/// tiles, those of paged files as well, are drawn by RoamTechnique: osgviewer db.osgb.roam.
class ReaderWriterRoam : public osgTraversal::NodeReader
{
public:
    ReaderWriterRoam()
    {
        supportsExtension("roam",
                          "terrain description, or suffix of an elevation raster (dem.tif.roam) or of a "
                          "database with osgTerrain tiles (db.osgb.roam)");
    }

    const char* className() const override { return "osgTerrainROAM reader"; }

protected:
    ReadResult open(const std::string& name, const Options* options) const override
    {
        const std::filesystem::path file = name;
        const auto terrain = osgTerrainROAM::openTerrain(file);
        if (!terrain && file.extension() == ".roam") return ReadResult(terrain.error().message());
        if (!terrain) return readDatabase(file.string(), options, terrain.error());
        return resultOf(terrain);
    }

    /// osgDB's search path applies to plain names; it knows nothing of GDAL's /vsi names.
    std::string fileToOpen(const std::string& name, const Options* options) const override
    {
        if (const std::string found = osgDB::findDataFile(name, options); !found.empty()) return found;
        const std::string stripped = osgDB::getNameLessExtension(name);
        if (stripped.starts_with("/vsi")) return stripped;
        const std::string found = osgDB::findDataFile(stripped, options);
        return found.empty() ? stripped : found;
    }

private:
    /// `asRaster`: why the file is no elevation raster.
    static ReadResult readDatabase(const std::string& file, const Options* options,
                                   const foundation::Error& asRaster)
    {
        ReadResult read = osgDB::Registry::instance()->readNode(file, options);
        if (!read.getNode())
            return ReadResult(
                read.status() == ReadResult::ERROR_IN_READING_FILE
                    ? foundation::Error{file, "osgDB cannot read it: " + read.message(), ""}.message()
                    : asRaster.message());
        const osg::ref_ptr<osgTerrainROAM::RoamTechnique> technique = new osgTerrainROAM::RoamTechnique;
        const auto count = osgTerrainROAM::installTechnique(*read.getNode(), *technique);
        if (count.tiles + count.pagedFiles > 0) return read;
        return ReadResult(
            foundation::Error{file, "has no osgTerrain tile and pages no file in", "open it without .roam"}
                .message());
    }
};

} // namespace

REGISTER_OSGPLUGIN(roam, ReaderWriterRoam)
