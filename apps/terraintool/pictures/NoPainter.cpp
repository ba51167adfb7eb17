// SPDX-License-Identifier: Apache-2.0
#include "terraintool/compare/MeshPainter.h"

namespace terraintool
{

foundation::Result<std::unique_ptr<MeshPainter>> makePainter()
{
    return foundation::Error{"terraintool", "was built without OpenSceneGraph and draws no pictures",
                             "build it with OSGTRAINER_WITH_OSG"};
}

} // namespace terraintool
