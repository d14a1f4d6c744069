// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/trafficlog.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace mb {

/// One row of the Bus page: the frame and what it means. `family` is nullptr when nobody knows it.
struct FrameRow {
    TrafficRecord record;
    double sinceSame = 0.0; ///< seconds since the last frame of this identifier; 0 for the first
    const Family *family = nullptr;
    std::optional<DecodedFrame> decoded;
};

/// Decides which rows are shown. Words separated by blanks, all must hold: `msg:STS*`, `dev:5`, `id:0206`, `fam:dmc60c`, `dir:tx`,
/// a `-` in front turns one round, a bare word is looked for in the message name and the identifier. Unknown keys match nothing
/// and are reported by problem().
class FrameFilter {
public:
    FrameFilter() = default;
    explicit FrameFilter(const QString &text);

    [[nodiscard]] bool passes(const FrameRow &row) const;
    [[nodiscard]] bool isEmpty() const { return m_terms.empty(); }
    /// What cannot be understood, for the user; empty when all is well.
    [[nodiscard]] const QString &problem() const { return m_problem; }

private:
    enum class Key { Any, Message, Device, Id, Family, Direction };
    struct Term {
        Key key = Key::Any;
        bool negated = false;
        QString pattern; ///< with * and ?
    };
    [[nodiscard]] static bool holds(const Term &term, const FrameRow &row);

    std::vector<Term> m_terms;
    QString m_problem;
};

/// "mode=velocity duty=29.3 % err=−4": the fields of a decoded frame in one line.
[[nodiscard]] QString fieldsLine(const DecodedFrame &frame);
[[nodiscard]] QString hexBytes(const CanFrame &frame);
[[nodiscard]] QString hexId(const CanFrame &frame);

} // namespace mb
