// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/filterterm.h"

#include <QCoreApplication>
#include <QStringList>

namespace mb {

/// Turns the text of a filter into its tree. Stops at the first mistake and names it.
class FrameFilterParser {
    Q_DECLARE_TR_FUNCTIONS(FrameFilterParser)
public:
    [[nodiscard]] FilterTree parse(const QString &text);
    /// Of the text that was parsed; empty when there is none.
    [[nodiscard]] const QString &problem() const { return m_problem; }

private:
    [[nodiscard]] bool atEnd() const { return m_next >= m_words.size(); }
    [[nodiscard]] bool isNext(const char *word) const;
    /// Each yields the place of its node; on a mistake the text of the problem is set and the place means nothing.
    std::size_t anyOf();
    std::size_t allOf();
    std::size_t one();
    std::size_t inner();
    std::size_t add(FilterTree::Node node);
    std::size_t addTerm(const QString &word);
    void fail(const QString &problem);

    FilterTree m_tree;
    QStringList m_words;
    int m_next = 0;
    int m_depth = 0; ///< brackets and negations around what is read
    QString m_problem;
};

} // namespace mb
