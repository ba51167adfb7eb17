// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "input/KeyTable.h"
#include "simulation/control/ManualController.h"

namespace trainer
{

/// A key that goes down or comes up.
struct KeyStroke
{
    int key = 0; ///< of keyOf()
    bool isDown = false;
};

/// A test aid: a person who sees what an autopilot or driver would do and presses the keys of the table that
/// lead there. A key knows no half, so each moment it takes for every input the one of "up", "down" and "let
/// go" after which the input is nearest to the wish. It trims the elevator away like a pilot. Determinism: by
/// its calls alone. Threads: one.
class KeyPresser
{
public:
    /// `vehicle`: flight or drive.
    explicit KeyPresser(KeyScope vehicle) : _vehicle(vehicle) {}

    /// What it does now. `wishes`: in the order of `names`, those of the vehicle's inputs; empty: it waits.
    /// `nextS`: until the next moment.
    std::vector<KeyStroke> decide(const simulation::ManualController& manual, std::span<const double> wishes,
                                  std::span<const std::string_view> names, double nextS);

private:
    void push(std::string_view input, double direction, std::vector<KeyStroke>& strokes);
    void add(std::string_view input, double missing, std::vector<KeyStroke>& strokes) const;
    double owing(const simulation::InputAxis& axis, double wish, double value, double nextS);
    double trimDirection(double elevator, double nextS);

    KeyScope _vehicle;
    std::map<std::string_view, double> _pushed; ///< directions by input
    std::map<std::string_view, double> _owed;   ///< by input, what pushes fell short of the wishes
    double _elevator = 0.0;                     ///< wished for, in the mean
};

} // namespace trainer
