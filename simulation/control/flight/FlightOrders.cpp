// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/FlightOrders.h"

#include <algorithm>
#include <array>

#include <foundation/Excerpt.h>

#include "simulation/parser/Expression.h"

namespace simulation
{
namespace
{

struct OrderWord
{
    std::string_view word;
    FlightOrderKind kind;
    bool hasValue;
    double least, most;
};

constexpr std::size_t kMostOrders = 1000;
constexpr std::array<OrderWord, 9> kOrderWords{
    {{"heading", FlightOrderKind::heading, true, -360.0, 360.0},
     {"altitude", FlightOrderKind::altitude, true, -500.0, 20000.0},
     {"speed", FlightOrderKind::speed, true, 10.0, 200.0},
     {"vertical_speed", FlightOrderKind::verticalSpeed, true, 0.1, 20.0},
     {"climb", FlightOrderKind::climb, true, -500.0, 20000.0},
     {"wait", FlightOrderKind::wait, true, 0.0, 1e5},
     {"takeoff", FlightOrderKind::takeOff, false, 0.0, 0.0},
     {"circuit", FlightOrderKind::circuit, false, 0.0, 0.0},
     {"land", FlightOrderKind::land, false, 0.0, 0.0}}};

std::string_view withoutBlanks(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

foundation::Result<FlightOrder> parseOrder(std::string_view text, const std::string& name)
{
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
    const auto known = std::find_if(kOrderWords.begin(), kOrderWords.end(),
                                    [&](const OrderWord& one) { return one.word == word; });
    if (known == kOrderWords.end())
    {
        std::string words;
        for (const OrderWord& one : kOrderWords)
            words += (words.empty() ? "" : ", ") + std::string(one.word);
        return foundation::Error{name, "'" + foundation::excerpt(word) + "' is no order",
                                 "write one of: " + words};
    }
    const std::string_view rest = withoutBlanks(text.substr(word.size()));
    if (!known->hasValue && rest.empty()) return FlightOrder{known->kind, 0.0};
    const auto value = parseNumber(rest);
    if (known->hasValue && value && *value >= known->least && *value <= known->most)
        return FlightOrder{known->kind, *value};
    return foundation::Error{name, "'" + foundation::excerpt(text) + "' is wrong",
                             known->hasValue ? "write a number from " + formatNumber(known->least) + " to " +
                                                   formatNumber(known->most) + " behind " + std::string(word)
                                             : "write " + std::string(word) + " alone"};
}

} // namespace

bool needsRunway(const std::vector<FlightOrder>& orders)
{
    return std::any_of(orders.begin(), orders.end(),
                       [](const FlightOrder& order) { return order.kind >= FlightOrderKind::takeOff; });
}

foundation::Result<std::vector<FlightOrder>> parseFlightOrders(std::string_view text, const std::string& name)
{
    std::vector<FlightOrder> orders;
    while (!text.empty())
    {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view one = withoutBlanks(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (one.empty()) continue;
        const auto order = parseOrder(one, name);
        if (!order) return order.error();
        orders.push_back(*order);
        if (orders.size() > kMostOrders)
            return foundation::Error{name, "more than 1000 orders", "write fewer"};
    }
    if (orders.empty()) return foundation::Error{name, "there is no order", "write one, such as wait 60"};
    return orders;
}

} // namespace simulation
