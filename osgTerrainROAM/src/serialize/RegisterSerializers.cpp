// SPDX-License-Identifier: Apache-2.0
#include <osgDB/FileUtils>

#include <osgTerrainROAM/RoamTechnique>
#include <osgTerrainROAM/RoamTerrain>
#include <osgTerrainROAM/Serializers>
#include <osgTraversal/SceneFile>

#include "SettingsFields.h"

namespace osgTerrainROAM
{

/// A RoamTerrain in a scene file: its source, settings and atmosphere. It is written as a Node, not as a
/// Group: the drawable is made anew when the source is opened again.
struct TerrainSerializer
{
    /// Why a terrain cannot be stored; empty: it can.
    static std::string refusal(const RoamTerrain& terrain)
    {
        const std::string name = "RoamTerrain '" + terrain.getName() + "'";
        if (terrain.source().empty())
            return foundation::Error{name, "was not opened from a file, and a scene file stores no heights",
                                     "write its raster and a .roam file, and open that with openTerrain()"}
                .message();
        if (terrain.tile() && terrain.tile()->revision() != 0)
            return foundation::Error{name, "has been edited, and a scene file stores no edits",
                                     "write the scene before the edits, and repeat them after reading"}
                .message();
        if (terrain.getNumChildren() != (terrain.showsSurroundings() ? 2 : 1))
            return foundation::Error{name, "has children besides its drawables",
                                     "put them beside the terrain, into a group above both"}
                .message();
        return {};
    }

    static bool writeSource(osgDB::OutputStream& out, const RoamTerrain& terrain)
    {
        if (const std::string reason = refusal(terrain); !reason.empty())
        {
            out.throwException(reason);
            return false;
        }
        out.writeWrappedString(terrain.source().string());
        out << std::endl;
        return true;
    }
    static bool readSource(osgDB::InputStream& in, RoamTerrain& terrain)
    {
        std::string source;
        in.readWrappedString(source);
        if (in.getException()) return false;
        const std::string found = osgDB::findDataFile(source, in.getOptions());
        const auto opened = openTerrain(found.empty() ? source : found);
        if (!opened) in.throwException(opened.error().message());
        if (!opened) return false;
        // The file has the state set; a terrain without an atmosphere keeps it.
        const osg::ref_ptr<osg::StateSet> stateSet = terrain.getStateSet();
        terrain.takeContents(**opened);
        terrain.setAtmosphere(nullptr);
        terrain.setStateSet(stateSet);
        return true;
    }

    static bool writeSettings(osgDB::OutputStream& out, const RoamTerrain& terrain)
    {
        osgTraversal::writeLines(out, osgTraversal::linesOf(terrain.settings()));
        return true;
    }
    static bool readSettings(osgDB::InputStream& in, RoamTerrain& terrain)
    {
        return osgTraversal::readSettings<RoamDrawableSettings>(in, [&](const RoamDrawableSettings& settings)
                                                                { return terrain.setSettings(settings); });
    }

    static bool hasAtmosphere(const RoamTerrain& terrain) { return terrain.atmosphere() != nullptr; }
    static bool writeAtmosphere(osgDB::OutputStream& out, const RoamTerrain& terrain)
    {
        osgTraversal::writeLines(out, osgTraversal::linesOf(terrain.atmosphere()->settings()));
        return true;
    }
    static bool readAtmosphere(osgDB::InputStream& in, RoamTerrain& terrain)
    {
        const osg::ref_ptr<osgSky::Atmosphere> atmosphere = new osgSky::Atmosphere;
        terrain.setAtmosphere(atmosphere);
        return osgTraversal::readSettings<osgSky::AtmosphereSettings>(
            in,
            [&](const osgSky::AtmosphereSettings& settings) { return atmosphere->setSettings(settings); });
    }
};

namespace
{

bool writeTechnique(osgDB::OutputStream& out, const RoamTechnique& technique)
{
    osgTraversal::writeLines(out, osgTraversal::linesOf(technique.settings()));
    return true;
}

bool readTechnique(osgDB::InputStream& in, RoamTechnique& technique)
{
    return osgTraversal::readSettings<RoamTechniqueSettings>(in, [&](const RoamTechniqueSettings& settings)
                                                             { return technique.setSettings(settings); });
}

const char* const kDrawableRefusal = "RoamDrawable: a scene file stores no heights; write its RoamTerrain, "
                                     "which names the file it was read from";

bool refuseToWrite(osgDB::OutputStream& out, const RoamDrawable&)
{
    out.throwException(kDrawableRefusal);
    return false;
}

bool refuseToRead(osgDB::InputStream& in, RoamDrawable&)
{
    in.throwException(kDrawableRefusal);
    return false;
}

} // namespace

bool registerSerializers()
{
    using Terrain = TerrainSerializer;
    using osgTraversal::addClass;
    using osgTraversal::isAlwaysThere;
    addClass<RoamTerrain>(
        "osgTerrainROAM::RoamTerrain", "osg::Object osg::Node osgTerrainROAM::RoamTerrain",
        {{"Source", &isAlwaysThere<RoamTerrain>, &Terrain::readSource, &Terrain::writeSource},
         {"Settings", &isAlwaysThere<RoamTerrain>, &Terrain::readSettings, &Terrain::writeSettings},
         {"Atmosphere", &Terrain::hasAtmosphere, &Terrain::readAtmosphere, &Terrain::writeAtmosphere}});
    addClass<RoamTechnique>("osgTerrainROAM::RoamTechnique", "osg::Object osgTerrainROAM::RoamTechnique",
                            {{"Settings", &isAlwaysThere<RoamTechnique>, &readTechnique, &writeTechnique}});
    addClass<RoamDrawable>("osgTerrainROAM::RoamDrawable", "osg::Object osgTerrainROAM::RoamDrawable",
                           {{"Tile", &isAlwaysThere<RoamDrawable>, &refuseToRead, &refuseToWrite}});
    return true;
}

} // namespace osgTerrainROAM
