// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/framefilter.h"

#include <QCoreApplication>
#include <QStringList>

namespace mb {

/// Turns the text of a filter into its tree. Stops at the first mistake and names it.
class FrameFilterParser {
    Q_DECLARE_TR_FUNCTIONS(FrameFilterParser)
public:
    explicit FrameFilterParser(FrameFilter &filter)
        : m_filter(filter)
    {
    }
    /// The problem, empty when there is none.
    [[nodiscard]] QString parse(const QString &text);
    [[nodiscard]] static QString help();

private:
    using Term = FrameFilter::Term;
    using Test = FrameFilter::Test;

    [[nodiscard]] bool atEnd() const { return m_next >= m_words.size(); }
    [[nodiscard]] bool isNext(const char *word) const;
    /// Each yields the place of its node; on a mistake the text of the problem is set and the place means nothing.
    std::size_t anyOf();
    std::size_t allOf();
    std::size_t one();
    std::size_t add(FrameFilter::Join join, std::size_t left, std::size_t right);
    std::size_t addTerm(const QString &word);

    void readField(const QString &word, Term &term);
    void readKeyed(const QString &key, const QString &value, Term &term);
    void readIds(const QString &value, Term &term);
    void readDevices(const QString &value, Term &term);
    void readData(const QString &value, Term &term);
    void readFamilies(const QString &value, Term &term);
    /// Yields whether the meaning is turned round, as `dir:rx` is not `dir:tx`.
    bool readState(const QString &key, const QString &value, Term &term);
    void fail(const QString &problem);

    FrameFilter &m_filter;
    QStringList m_words;
    int m_next = 0;
    QString m_problem;
};

} // namespace mb
