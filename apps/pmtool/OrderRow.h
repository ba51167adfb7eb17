// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pmtool/OrderSubject.h"

namespace pmtool
{

/// The names of all orders, as in tables.
std::vector<std::string> orderNames();

/// A computed order of a subject's triangles.
struct OrderedSubject
{
    std::vector<std::vector<osgPMObjects::core::Triangle>> calls; ///< by draw call
    double ms = 0.0;                                              ///< processor time for the order alone
    std::size_t strips = 0, sentVertices = 0;                     ///< of orders made of strips
};

OrderedSubject orderSubject(const OrderSubject& subject, const std::string& order);

/// Vertices transformed for each triangle, by each model of a cache. Every draw call begins with an empty one.
nlohmann::ordered_json transformsPerTriangle(const OrderSubject& subject, const OrderedSubject& ordered);

} // namespace pmtool
