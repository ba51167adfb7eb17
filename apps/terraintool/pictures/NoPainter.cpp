// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <foundation/DataFile.h>
#include <unistd.h>

#include "terraintool/compare/MeshPainter.h"

namespace terraintool
{

void becomeProgramWithPainter(char** argv)
{
    const std::string program = (foundation::programFolder() / "terraintool-pictures").string();
    execv(program.c_str(), argv); // returns where there is none
}

foundation::Result<std::unique_ptr<MeshPainter>> makePainter()
{
    return foundation::Error{"terraintool-pictures", "is not there, so no pictures are drawn",
                             "build with OSGTRAINER_WITH_OSG"};
}

} // namespace terraintool
