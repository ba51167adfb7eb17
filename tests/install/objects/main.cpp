// SPDX-License-Identifier: Apache-2.0
// Uses the object core in a program without a scene graph: checks a triangle.
#include <cstdio>

#include <osgPMObjects/core/mesh/MeshCheck.h>

using namespace osgPMObjects::core;

int main()
{
    Mesh mesh;
    mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    mesh.wedgePositions = {0, 1, 2};
    mesh.materials.resize(1);
    mesh.parts.resize(1);
    mesh.faces.push_back({{0, 1, 2}, 0, 0});
    const bool isWhole = isValid(mesh);
    mesh.faces[0].wedges[2] = 3;
    std::printf("%s\n", defectOf(mesh).c_str());
    return isWhole && !isValid(mesh) ? 0 : 1;
}
