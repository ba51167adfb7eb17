// SPDX-License-Identifier: Apache-2.0
#include <osgDB/FileUtils>
#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>
#include <osgDB/Registry>

#include <osgTerrainROAM/RoamTechnique>
#include <osgTerrainROAM/RoamTerrain>
#include <osgTerrainROAM/Serializers>

#include "SettingsLines.h"

namespace osgTerrainROAM
{

namespace
{

void writeSettingsLines(osgDB::OutputStream& out, const auto& settings)
{
    SettingsWriter writer;
    visitFields(settings, writer);
    out.writeSize(writer.lines.size());
    out << out.BEGIN_BRACKET << std::endl;
    for (const std::string& line : writer.lines)
        out << line << std::endl;
    out << out.END_BRACKET << std::endl;
}

/// Reads settings and hands them to set(settings); the stream has an exception when they are no settings or are refused.
template<class Settings, class Set>
bool readSettingsLines(osgDB::InputStream& in, const Set& set)
{
    std::vector<std::string> lines;
    const std::size_t count = in.readSize();
    in >> in.BEGIN_BRACKET;
    while (lines.size() < count && !in.getException())
        in >> lines.emplace_back();
    in >> in.END_BRACKET;
    if (in.getException()) return false;
    Settings settings;
    SettingsReader reader(lines);
    visitFields(settings, reader);
    foundation::Outcome done = foundation::success();
    if (const std::string complaint = reader.complaint(); !complaint.empty())
        done = foundation::Error{"settings in a scene file", complaint,
                                 "correct the line, or write the scene again"};
    else
        done = set(settings);
    if (!done) in.throwException(done.error().message());
    return static_cast<bool>(done);
}

} // namespace

/// A RoamTerrain in a scene file: its source, settings and atmosphere. It is written as a Node, not as a Group: the drawable
/// is made anew when the source is opened again.
struct TerrainSerializer
{
    static bool isTerrain(const RoamTerrain&) { return true; }

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
        if (terrain.getNumChildren() != 1)
            return foundation::Error{name, "has children besides its drawable",
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
        writeSettingsLines(out, terrain.settings());
        return true;
    }
    static bool readSettings(osgDB::InputStream& in, RoamTerrain& terrain)
    {
        return readSettingsLines<RoamDrawableSettings>(in, [&](const RoamDrawableSettings& settings)
                                                       { return terrain.setSettings(settings); });
    }

    static bool hasAtmosphere(const RoamTerrain& terrain) { return terrain.atmosphere() != nullptr; }
    static bool writeAtmosphere(osgDB::OutputStream& out, const RoamTerrain& terrain)
    {
        writeSettingsLines(out, terrain.atmosphere()->settings());
        return true;
    }
    static bool readAtmosphere(osgDB::InputStream& in, RoamTerrain& terrain)
    {
        const osg::ref_ptr<Atmosphere> atmosphere = new Atmosphere;
        terrain.setAtmosphere(atmosphere);
        return readSettingsLines<AtmosphereSettings>(in, [&](const AtmosphereSettings& settings)
                                                     { return atmosphere->setSettings(settings); });
    }
};

namespace
{

bool writeTechnique(osgDB::OutputStream& out, const RoamTechnique& technique)
{
    writeSettingsLines(out, technique.settings());
    return true;
}

bool readTechnique(osgDB::InputStream& in, RoamTechnique& technique)
{
    return readSettingsLines<RoamTechniqueSettings>(in, [&](const RoamTechniqueSettings& settings)
                                                    { return technique.setSettings(settings); });
}

bool isTechnique(const RoamTechnique&)
{
    return true;
}

bool isDrawable(const RoamDrawable&)
{
    return true;
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

/// Makes the wrapper of a class, unless one is registered already; null then.
template<class Class>
osg::ref_ptr<osgDB::ObjectWrapper> wrapperOf(osgDB::ObjectWrapperManager& manager, const std::string& name,
                                             const std::string& bases)
{
    if (manager.getWrapperMap().count(name) > 0) return nullptr;
    const osg::ref_ptr<osgDB::ObjectWrapper> wrapper =
        new osgDB::ObjectWrapper([]() -> osg::Object* { return new Class; }, name, bases + " " + name);
    manager.addWrapper(wrapper);
    return wrapper;
}

} // namespace

bool registerSerializers()
{
    osgDB::ObjectWrapperManager& manager = *osgDB::Registry::instance()->getObjectWrapperManager();
    constexpr auto kUser = osgDB::BaseSerializer::RW_USER;
    if (const auto terrain =
            wrapperOf<RoamTerrain>(manager, "osgTerrainROAM::RoamTerrain", "osg::Object osg::Node"))
    {
        using Serializer = osgDB::UserSerializer<RoamTerrain>;
        using Terrain = TerrainSerializer;
        terrain->addSerializer(
            new Serializer("Source", &Terrain::isTerrain, &Terrain::readSource, &Terrain::writeSource),
            kUser);
        terrain->addSerializer(
            new Serializer("Settings", &Terrain::isTerrain, &Terrain::readSettings, &Terrain::writeSettings),
            kUser);
        terrain->addSerializer(new Serializer("Atmosphere", &Terrain::hasAtmosphere, &Terrain::readAtmosphere,
                                              &Terrain::writeAtmosphere),
                               kUser);
    }
    if (const auto technique =
            wrapperOf<RoamTechnique>(manager, "osgTerrainROAM::RoamTechnique", "osg::Object"))
        technique->addSerializer(new osgDB::UserSerializer<RoamTechnique>("Settings", &isTechnique,
                                                                          &readTechnique, &writeTechnique),
                                 kUser);
    if (const auto drawable = wrapperOf<RoamDrawable>(manager, "osgTerrainROAM::RoamDrawable", "osg::Object"))
        drawable->addSerializer(
            new osgDB::UserSerializer<RoamDrawable>("Tile", &isDrawable, &refuseToRead, &refuseToWrite),
            kUser);
    return true;
}

} // namespace osgTerrainROAM
