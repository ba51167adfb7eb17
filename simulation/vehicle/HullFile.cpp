// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/HullFile.h"

#include <string>

namespace simulation
{

HullData readHull(VehicleFileReader& reader, pugi::xml_node node, std::size_t mostBoxes, double widestM)
{
    HullData hull;
    reader.onlyAttributes(node, "friction crashesAtMps");
    hull.friction = reader.number(node, "friction", 0.0, 2.0);
    hull.crashesAtMps = reader.number(node, "crashesAtMps", 0.1, 100.0);
    for (const pugi::xml_node box : node.children("box"))
    {
        reader.onlyAttributes(box, "lengthM widthM heightM xM yM zM");
        hull.boxes.push_back(
            {reader.name(box),
             {reader.number(box, "lengthM", 0.1, 50.0), reader.number(box, "widthM", 0.1, widestM),
              reader.number(box, "heightM", 0.1, 10.0)},
             reader.place(box)});
    }
    if (hull.boxes.empty() || hull.boxes.size() > mostBoxes)
        reader.fail(node, "<hull> has " + std::to_string(hull.boxes.size()) + " boxes",
                    "give 1 to " + std::to_string(mostBoxes) + ", the lowest first");
    return hull;
}

} // namespace simulation
