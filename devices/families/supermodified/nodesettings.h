// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/node.h"
#include "model/parameterstore.h"

namespace mb::supermodified {

/// Reads and writes the settings of one node, and notes in the roster what others must know of them. Engine thread; outlives its
/// tasks.
class NodeSettings {
public:
    /// All outlive it; `codes` gets what the node reports in place of answers.
    NodeSettings(Line &line, const Node &node, const ParameterStore &known, CodeSink codes);

    /// The node's dialect has it.
    [[nodiscard]] bool offers(ParameterIndex index) const;
    /// Raw value in force.
    [[nodiscard]] Task<std::int64_t> read(ParameterIndex index);
    /// OutOfRange: what the dialect does not take, or an id that another node has or will have.
    [[nodiscard]] Task<void> mayWrite(ParameterIndex index, std::int64_t raw);
    /// Yields what was sent. A set is answered after its EEPROM was written (README.md#time-outs).
    [[nodiscard]] Task<std::int64_t> write(ParameterIndex index, std::int64_t raw);
    /// One exchange with the node: node.h.
    [[nodiscard]] Task<Frame> talk(Line::Request request);
    /// The node has restarted, and reports what it stored.
    void restarted() { m_owedLimit.reset(); }

private:
    [[nodiscard]] Result<Line::Request> request(Command command, std::int64_t raw) const;
    [[nodiscard]] Task<void> mayTake(int id);
    [[nodiscard]] Task<std::int64_t> readNumber(Command command);
    [[nodiscard]] Task<void> writeNumber(Command command, std::int64_t raw);
    [[nodiscard]] Task<void> writeDuration(std::int64_t raw);
    void noteWritten(const Parameter &row, std::int64_t raw);
    void noteRead(const Parameter &row, std::int64_t raw);

    Line &m_line;
    const Node &m_node;
    const ParameterStore &m_known;
    CodeSink m_codes;
    std::optional<std::int64_t> m_owedLimit; ///< the stored current limit, while the node takes a duration for it
};

} // namespace mb::supermodified
