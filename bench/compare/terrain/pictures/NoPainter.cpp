// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/MeshPainter.h"

namespace terraintool
{

foundation::Result<std::unique_ptr<MeshPainter>> makePainter()
{
    return foundation::Error{"compare_terrain", "is built without OpenSceneGraph, so no pictures are drawn",
                             "build with OSGTRAINER_WITH_OSG"};
}

} // namespace terraintool
