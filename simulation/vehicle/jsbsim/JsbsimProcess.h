// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "simulation/vehicle/jsbsim/ChildProcess.h"
#include "simulation/vehicle/jsbsim/JsbsimFiles.h"
#include "simulation/vehicle/jsbsim/JsbsimRow.h"
#include "simulation/vehicle/jsbsim/TimedReader.h"

namespace simulation
{

/// What was wrong with an answer of JSBSim.
enum class JsbsimFault
{
    none,
    late,       ///< it did not answer in time
    ended,      ///< it runs no more
    unreadable, ///< it answered no row of numbers
    notFinite,  ///< its numbers are NaN or infinite
    outOfStep   ///< its clock is not one step further
};

/// A JSBSim in lockstep: it makes a step when it is told to, and waits without work meanwhile. What it is
/// told acts with the step after: it has moved on when it takes orders.
///
/// Orders go by TCP to its port on the loopback; its answers there have six digits only, so the numbers of
/// each step come by a pipe of its own, with all digits. The port is one that was free; since JSBSim opens it
/// later, another program may have taken it meanwhile, which shows (the row of the first step stays away) and
/// is tried again. Cost: some 50 µs a step, its own work included.
/// Source: how Debian's JSBSim (FlightGear 2020.3.16) behaves; docs/decisions/0036-jsbsim-as-a-process.md.
class JsbsimProcess
{
public:
    static constexpr int kStepsPerSecond = 120;

    /// Starts JSBSim and makes the first step, which a trim stands before.
    /// Errors: no such program, root or aircraft; it does not answer in time, or ends (with its last words).
    static foundation::Result<std::unique_ptr<JsbsimProcess>> start(const JsbsimData& data,
                                                                    const JsbsimStart& start);

    ~JsbsimProcess();
    JsbsimProcess(const JsbsimProcess&) = delete;
    JsbsimProcess& operator=(const JsbsimProcess&) = delete;

    /// The value of a property that was asked for at the start, after the last step; nothing where the
    /// aircraft lacks it, or it is no number.
    std::optional<double> value(const std::string& property) const;

    /// Sets properties (lines `set PROPERTY VALUE`, which must exist) and makes one step.
    JsbsimFault advance(const std::string& orders);

    /// After the last step.
    const JsbsimRow& row() const { return _row; }

    /// For tests.
    pid_t id() const { return _child.id(); }

private:
    JsbsimProcess(const JsbsimData& data, std::vector<std::string> asked, TemporaryFolder folder,
                  ChildProcess child);
    foundation::Outcome open(int port);
    bool send(const std::string& text);
    JsbsimFault order(const std::string& orders, bool& hasMoved);
    JsbsimFault readFirstRow();
    JsbsimFault readRow(bool& hasMoved);
    foundation::Error refusal(const std::string& what);

    JsbsimData _data;
    TemporaryFolder _folder;
    ChildProcess _child;
    int _socket = -1;
    TimedReader _replies, _rows;
    std::optional<JsbsimTable> _table;
    JsbsimRow _row;
    std::vector<std::string> _asked;
    double _patienceS = 0.0; ///< with the next answer
    bool _isHeld = true;     ///< it stands still until it is woken
};

} // namespace simulation
