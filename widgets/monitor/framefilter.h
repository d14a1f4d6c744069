// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/filterterm.h"

#include <QString>

namespace mb {

/// Decides which records are shown. The language, for people: help(). Terms stand behind each other and must all hold;
/// `or`, `not` (or a minus) and brackets join them.
///   id:0x2041* id:100..1FF family:dmc60c message:STS* device:5 dir:tx data:A1* is:error field.trgt>0.5 WORD
/// Upper and lower case are one; `*` and `?` stand for any characters; a comma gives alternatives.
class FrameFilter {
public:
    FrameFilter() = default; ///< passes everything
    explicit FrameFilter(const QString &text);

    /// What both pass.
    [[nodiscard]] static FrameFilter both(FrameFilter a, const FrameFilter &b);

    [[nodiscard]] bool passes(const FrameFacts &facts) const { return isEmpty() || holds(m_tree.root, facts); }
    [[nodiscard]] bool isEmpty() const { return m_tree.nodes.empty(); }
    /// What is wrong with the text and what would be right; empty when all is well. A filter with a problem passes
    /// everything.
    [[nodiscard]] const QString &problem() const { return m_problem; }
    /// The language on one page, as rich text.
    [[nodiscard]] static QString help();

private:
    [[nodiscard]] bool holds(std::size_t node, const FrameFacts &facts) const;

    FilterTree m_tree;
    QString m_problem;
};

} // namespace mb
