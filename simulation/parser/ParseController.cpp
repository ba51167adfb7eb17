// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{

Controller parseController(ElementReader reader)
{
    if (reader.is("CatalogReference"))
    {
        CatalogVisit visit(reader, "the actions of the scenario move the entity");
        return visit.entry() ? parseController({reader.context, visit.entry()}) : Controller{};
    }
    const ParameterScope scope(reader.context, reader.node);
    reader.textOr("controllerType", "");
    Controller controller{reader.context.line(reader.node), reader.name(), parseProperties(reader)};
    if (!controller.played()) reader.context.controllerNotPlayed(reader.node, controller.kind());
    return controller;
}

} // namespace simulation
