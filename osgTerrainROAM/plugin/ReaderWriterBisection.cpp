// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/BisectionDrawable>
#include <osgTraversal/NodeReader>

namespace
{

/// osgDB's way to ROAM over any mesh: osgviewer sphere.bisection.
class ReaderWriterBisection : public osgTraversal::NodeReader
{
public:
    ReaderWriterBisection() { supportsExtension("bisection", "ROAM over a coarse mesh of any form"); }

    const char* className() const override { return "osgTerrainROAM bisection reader"; }

protected:
    ReadResult open(const std::string& file, const Options*) const override
    {
        return resultOf(osgTerrainROAM::openBisectionNode(file));
    }
};

} // namespace

REGISTER_OSGPLUGIN(bisection, ReaderWriterBisection)
