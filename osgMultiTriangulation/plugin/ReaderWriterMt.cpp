// SPDX-License-Identifier: Apache-2.0
#include <osgMultiTriangulation/OpenMultiTriangulation>
#include <osgTerrainROAM/FirstLook>
#include <osgTraversal/NodeReader>

namespace
{

/// osgDB's way to multi-triangulations: osgviewer hills.mt.
class ReaderWriterMt : public osgTraversal::NodeReader
{
public:
    ReaderWriterMt() { supportsExtension("mt", "multi-triangulation, as terraintool mt-build writes it"); }

    const char* className() const override { return "osgMultiTriangulation reader"; }

protected:
    ReadResult open(const std::string& file, const Options*) const override
    {
        const auto opened = osgMultiTriangulation::openMultiTriangulation(file);
        if (!opened) return ReadResult(opened.error().message());
        opened->terrain->addEventCallback(new osgTerrainROAM::FirstLook);
        return ReadResult(opened->terrain.get(), ReadResult::FILE_LOADED);
    }
};

} // namespace

REGISTER_OSGPLUGIN(mt, ReaderWriterMt)
