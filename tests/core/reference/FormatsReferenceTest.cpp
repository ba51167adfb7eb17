// SPDX-License-Identifier: Apache-2.0
// docs/reference/formats.md against the lists in the readers' sources: endings, units, extensions.
#include <gmock/gmock.h>

#include "SourceNames.h"

namespace
{

using reference::differences;
using reference::literalsOfStatement;
using reference::Names;
using reference::Page;
using reference::sourceText;

const Page& page()
{
    static const Page read = Page::read("formats.md");
    return read;
}

/// The endings with a dot before each.
Names dotted(const Names& endings)
{
    Names names;
    for (const std::string& ending : endings)
        names.insert("." + ending);
    return names;
}

Names joined(Names names, Names others)
{
    names.merge(others);
    return names;
}

TEST(FormatsReference, UnitsOfHeightsAreThoseOfTheReader)
{
    const Names code =
        literalsOfStatement(sourceText("osgTerrainROAM/src/core/heightfield/SampleDecoder.cpp"), "kUnits");
    EXPECT_THAT(code, testing::Contains("us survey foot"));
    EXPECT_EQ(differences(code, page().column("Units of heights", 0)), "");
    EXPECT_NE(differences(code, page().with("Units of heights", "cubit").column("Units of heights", 0)), "");
}

TEST(FormatsReference, FilesThatAreNoElevationAreThoseThatTheReaderNames)
{
    const Names code = literalsOfStatement(sourceText("osgTerrainROAM/src/core/heightfield/RasterSource.cpp"),
                                           "kOtherKinds", ".");
    EXPECT_THAT(code, testing::Contains(".osm.bz2"));
    EXPECT_EQ(differences(code, page().column("Files that are no elevation", 0)), "");
    EXPECT_NE(differences(code, page().without(".xosc").column("Files that are no elevation", 0)), "");
}

TEST(FormatsReference, SurfacesAreThoseOfMtBuild)
{
    const Names code = joined(
        literalsOfStatement(sourceText("osgMultiTriangulation/src/core/input/TinFile.cpp"),
                            "return extension ==", "."),
        literalsOfStatement(sourceText("apps/terraintool/mt/BuildMt.cpp"), "return extension ==", "."));
    EXPECT_THAT(code, testing::IsSupersetOf({".ply", ".xyz"}));
    EXPECT_EQ(differences(code, page().column("Triangulated surfaces", 0)), "");
    EXPECT_NE(
        differences(code, page().with("Triangulated surfaces", ".abc").column("Triangulated surfaces", 0)),
        "");
}

TEST(FormatsReference, MapsAreThoseOfWorldtool)
{
    const std::string source = sourceText("worldmaking/map/MapSources.cpp");
    const Names code = joined(literalsOfStatement(source, "kOsm"), literalsOfStatement(source, "kVector"));
    EXPECT_THAT(code, testing::IsSupersetOf({".pbf", ".gpkg"}));
    EXPECT_EQ(differences(code, page().column("Maps", 0)), "");
    EXPECT_NE(differences(code, page().with("Maps", ".abc").column("Maps", 0)), "");
    const Names refused = literalsOfStatement(source, "kArchives");
    EXPECT_THAT(refused, testing::Contains(".7z"));
    for (const std::string& ending : refused)
        EXPECT_THAT(sourceText("docs/reference/formats.md"), testing::HasSubstr("`" + ending + "`"));
}

TEST(FormatsReference, RecordingsAreThoseThatThePlayerTakes)
{
    const Names code = literalsOfStatement(sourceText("simulation/scenario/Trajectory.cpp"), "kExtensions");
    EXPECT_THAT(code, testing::Contains(".kmz"));
    EXPECT_EQ(differences(code, page().column("Recordings", 0)), "");
    EXPECT_NE(differences(code, page().without(".acmi").column("Recordings", 0)), "");
}

TEST(FormatsReference, ModelsAreThoseThatAFolderMayHave)
{
    const Names code =
        dotted(literalsOfStatement(sourceText("osgSession/scene/SceneScenery.cpp"), "kModels"));
    EXPECT_THAT(code, testing::Contains(".glb"));
    EXPECT_EQ(differences(code, page().column("Models", 0)), "");
    EXPECT_NE(differences(code, page().without(".pm").column("Models", 0)), "");
}

TEST(FormatsReference, ExtensionsOfGltfAreThoseOfTheReader)
{
    const Names code = joined(
        literalsOfStatement(sourceText("osgPMObjects/src/core/gltf/GltfExtensions.cpp"),
                            "constexpr std::array kWhole"),
        literalsOfStatement(sourceText("osgPMObjects/src/core/gltf/GltfMeshopt.h"), "kMeshoptExtensions"));
    EXPECT_THAT(code, testing::Contains("KHR_mesh_quantization"));
    EXPECT_EQ(differences(code, page().column("Extensions of glTF", 0)), "");
    EXPECT_NE(differences(code, page().without("KHR_texture_transform").column("Extensions of glTF", 0)), "");
}

} // namespace
